// Clocks of STM32F405/407: RM0090, 7.3 (RCC) and 3.9 (flash latency).
#pragma once

#include <cstdint>

#include <spangle/mcu/registers.hpp>

namespace spangle::mcu::stm32f4 {

/// The blocks of clocks and of flash.
inline constexpr std::uintptr_t rcc = 0x40023800, flash_acr = 0x40023C00;

/// Turns clocks of blocks on. `ahb1`: GPIO ports, bit 0 is port A. `apb2`: bit 12 is SPI1.
inline void turn_on(std::uint32_t ahb1, std::uint32_t apb2) {
    set_bits(rcc + 0x30, ahb1);
    set_bits(rcc + 0x44, apb2);
    [[maybe_unused]] const std::uint32_t settled = reg(rcc + 0x44); // this read takes two clocks (7.3.1)
}

/// Sets 168 MHz from a crystal of `mhz` MHz, APB2 84 MHz, APB1 42 MHz. False: the crystal or the PLL did not
/// start, and the 16 MHz oscillator goes on: everything works, ten times slower.
inline bool run_at_168_mhz(std::uint32_t mhz) {
    constexpr std::uintptr_t cr = rcc + 0x00, pllcfgr = rcc + 0x04, cfgr = rcc + 0x08;
    constexpr std::uint32_t hse_on = 1u << 16, hse_ready = 1u << 17, pll_on = 1u << 24, pll_ready = 1u << 25;
    constexpr std::uint32_t longest = 100000; // 100000 polls take some 50 ms at 16 MHz
    const auto ready = [](std::uintptr_t at, std::uint32_t mask, std::uint32_t value) {
        for (std::uint32_t i = 0; i < longest; ++i)
            if ((reg(at) & mask) == value)
                return true;
        return false;
    };
    set_bits(cr, hse_on);
    if (!ready(cr, hse_ready, hse_ready))
        return false;
    constexpr std::uint32_t from_hse = 1u << 22, times_336 = 336u << 6,
                            by_7 = 7u << 24; // VCO at 336 MHz, system 168 MHz, USB 48 MHz
    reg(pllcfgr) = mhz | times_336 | from_hse | by_7;
    set_bits(cr, pll_on);
    if (!ready(cr, pll_ready, pll_ready))
        return false;
    reg(flash_acr) = 5 | 7u << 8; // five wait states, prefetch, caches
    constexpr std::uint32_t apb1_by_4 = 5u << 10, apb2_by_2 = 4u << 13, pll = 2, chosen = 3u << 2;
    reg(cfgr) = apb1_by_4 | apb2_by_2 | pll;
    return ready(cfgr, chosen, pll << 2);
}

} // namespace spangle::mcu::stm32f4
