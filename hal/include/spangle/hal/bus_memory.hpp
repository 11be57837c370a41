// The memory a bus hands out buffers of.
#pragma once

#include <cstddef>
#include <cstdint>

#include <spangle/hal/bus.hpp>

namespace spangle::hal {

class BusMemory {
  public:
    /// Buffers begin at multiples of this: whole lines of the data caches there are.
    static constexpr std::size_t alignment = 32;

    explicit BusMemory(Buffer memory) : memory_(memory) {}
    /// The next `size` bytes, for good.
    Result<Buffer> take(std::size_t size);

  private:
    Buffer memory_;
    std::size_t used_ = 0;
};

} // namespace spangle::hal
