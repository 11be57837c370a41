// The memory from which a bus hands out buffers.
#pragma once

#include <cstddef>
#include <cstdint>

#include <spangle/hal/bus.hpp>

namespace spangle::hal {

/// Hands out a block of memory piece by piece.
class BusMemory {
  public:
    /// Buffers begin at multiples of this, which are whole lines of the data caches there are.
    static constexpr std::size_t alignment = 32;

    /// `memory` must outlive what is taken from it, and begin at a multiple of `alignment`.
    explicit BusMemory(Buffer memory) : memory_(memory) {}
    /// Hands out the next `size` bytes, which are never given back. Fault::unsupported: fewer are left.
    Result<Buffer> take(std::size_t size);

  private:
    Buffer memory_;
    std::size_t used_ = 0;
};

} // namespace spangle::hal
