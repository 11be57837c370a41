// Instructions executed so far, when QEMU runs with `-icount shift=0`: one instruction is one nanosecond of
// virtual time and the FPGAIO counter ticks every 40 of them.
#pragma once

#include <cstdint>

namespace spangle::mps2 {

inline std::uint32_t ticks() {
    return *reinterpret_cast<volatile std::uint32_t*>(0x40028018);
}

inline constexpr std::uint32_t instructions_per_tick = 40;

} // namespace spangle::mps2
