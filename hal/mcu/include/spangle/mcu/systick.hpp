// SysTick, the timer every Cortex-M has: pauses. Armv7-M ARM, B3.3.
#pragma once

#include <cstdint>

#include <spangle/mcu/registers.hpp>

namespace spangle::mcu {

/// The timer, for pauses.
struct SysTick {
    std::uint32_t clock_hz; ///< clock of the processor, below 4.29 GHz

    /// Addresses of the timer's registers.
    static constexpr std::uintptr_t control = 0xE000E010, reload = 0xE000E014, current = 0xE000E018;
    /// The longest count: it has 24 bits.
    static constexpr std::uint32_t most_ticks = 0xFFFFFF;
    /// Bits of the control register.
    static constexpr std::uint32_t enable = 1u << 0, processor_clock = 1u << 2, reached_zero = 1u << 16;

    /// The clocks of at least this time, which is a millisecond at most, so that words hold the product.
    constexpr std::uint32_t ticks_of(std::uint32_t micros) const {
        const std::uint32_t a_milli = (clock_hz + 999) / 1000; // below 2^32 / 1000, so products with 1000 fit
        return (micros * a_milli + 999) / 1000;
    }

    /// Pauses at least this long.
    void pause(std::uint32_t micros) const {
        while (micros != 0) {
            const std::uint32_t step = micros < 1000 ? micros : 1000;
            micros -= step;
            reg(control) = 0;
            reg(reload) = ticks_of(step);
            reg(current) = 0; // this write clears reached_zero, too
            reg(control) = enable | processor_clock;
            while ((reg(control) & reached_zero) == 0) {
            }
        }
        reg(control) = 0;
    }
};

static_assert(SysTick{16000000}.ticks_of(1) == 16 && SysTick{3999999999}.ticks_of(999) == 3996000 &&
              SysTick{3999999999}.ticks_of(1000) == 4000000 && SysTick{32768}.ticks_of(500) == 17 &&
              4000000 <= SysTick::most_ticks);

} // namespace spangle::mcu
