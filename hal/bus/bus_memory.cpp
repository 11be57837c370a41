#include <spangle/hal/bus_memory.hpp>

namespace spangle::hal {

Result<Buffer> BusMemory::take(std::size_t size) {
    const auto address = reinterpret_cast<std::uintptr_t>(memory_.bytes) + used_;
    const std::size_t gap = (alignment - address % alignment) % alignment;
    if (memory_.bytes == nullptr || memory_.size - used_ < gap || memory_.size - used_ - gap < size)
        return Error{Fault::unsupported, "bus: the memory is smaller than the buffers asked for"};
    used_ += gap + size;
    return Buffer{memory_.bytes + used_ - size, size};
}

} // namespace spangle::hal
