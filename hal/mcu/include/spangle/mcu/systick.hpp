// SysTick, the timer every Cortex-M has: pauses. Armv7-M ARM, B3.3.
#pragma once

#include <cstdint>

#include <spangle/mcu/registers.hpp>

namespace spangle::mcu {

struct SysTick {
    std::uint32_t clock_hz; ///< of the processor, below 4 GHz

    static constexpr std::uintptr_t control = 0xE000E010, reload = 0xE000E014, current = 0xE000E018;
    static constexpr std::uint32_t most_ticks = 0xFFFFFF;
    static constexpr std::uint32_t enable = 1u << 0, processor_clock = 1u << 2, reached_zero = 1u << 16;

    /// At least so long.
    void pause(std::uint32_t micros) const {
        for (std::uint64_t left = (std::uint64_t{micros} * clock_hz + 999999) / 1000000; left != 0;) {
            const auto ticks = static_cast<std::uint32_t>(left < most_ticks ? left : most_ticks);
            left -= ticks;
            reg(control) = 0;
            reg(reload) = ticks;
            reg(current) = 0; // clears reached_zero too
            reg(control) = enable | processor_clock;
            while ((reg(control) & reached_zero) == 0) {
            }
        }
        reg(control) = 0;
    }
};

} // namespace spangle::mcu
