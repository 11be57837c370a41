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

    /// Clocks of so long at least. No 64-bit division: a library has some 700 bytes for it.
    constexpr std::uint64_t ticks_of(std::uint32_t micros) const {
        const std::uint32_t a_milli = clock_hz / 1000 + (clock_hz % 1000 != 0 ? 1 : 0); // below 2^32 / 1000
        return std::uint64_t{micros / 1000} * a_milli + (micros % 1000 * a_milli + 999) / 1000;
    }

    /// At least so long.
    void pause(std::uint32_t micros) const {
        for (std::uint64_t left = ticks_of(micros); left != 0;) {
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

static_assert(SysTick{16000000}.ticks_of(1) == 16 && SysTick{16000000}.ticks_of(0xFFFFFFFF) == 68719476720 &&
              SysTick{3999999999}.ticks_of(999) == 3996000 && SysTick{32768}.ticks_of(1500) == 50);

} // namespace spangle::mcu
