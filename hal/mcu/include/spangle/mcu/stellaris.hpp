// TI (Luminary) Stellaris LM3S: clocks of the blocks, and pins. LM3S6965 data sheet, chapters 5 and 8.
#pragma once

#include <cstdint>

#include <spangle/mcu/registers.hpp>

namespace spangle::mcu::stellaris {

/// The system control block.
inline constexpr std::uintptr_t system_control = 0x400FE000;
inline constexpr std::uintptr_t raw_interrupts = system_control + 0x050; ///< raw interrupt status, RIS
inline constexpr std::uintptr_t clock_config = system_control + 0x060;  ///< run-mode clock configuration, RCC
inline constexpr std::uintptr_t serial_clocks = system_control + 0x104; ///< clocks of serial blocks, RCGC1
inline constexpr std::uintptr_t port_clocks = system_control + 0x108;   ///< clocks of GPIO ports, RCGC2

/// A GPIO port: a PL061.
struct Port {
    /// The port's address.
    std::uintptr_t base;

    /// Hands these pins to a block (SSI, I2C) instead of software.
    void give_away(std::uint32_t pins) const {
        set_bits(base + alternate, pins);
        set_bits(base + digital, pins);
    }
    /// Makes these pins outputs.
    void output(std::uint32_t pins) const {
        set_bits(base + direction, pins);
        set_bits(base + digital, pins);
    }
    /// Makes these pins open drain, as I2C's SDA asks for.
    void open_drain(std::uint32_t pins) const { set_bits(base + drain, pins); }

  private:
    static constexpr std::uintptr_t direction = 0x400, alternate = 0x420, drain = 0x50C, digital = 0x51C;
};

/// The address carries a mask of the pins that a write changes.
struct Pin {
    /// The port.
    Port port;
    /// The pin, 0 to 7.
    unsigned bit;

    /// Drives the line by one store.
    void set(bool high) const { reg(port.base + (std::uintptr_t{1} << bit << 2)) = high ? 1u << bit : 0; }
};

/// Turns on a block's clock, and waits: the block may be accessed only three clocks later.
inline void turn_on(std::uintptr_t clocks, std::uint32_t bits) {
    set_bits(clocks, bits);
    [[maybe_unused]] const std::uint32_t settled = reg(clocks);
}

/// Sets the clock from a crystal of 6 MHz: the PLL's 200 MHz / 16. LM3S811 data sheet, 5.3.
inline void run_at_12500_khz() {
    constexpr std::uint32_t divide_by_16 = 15u << 23, use_divider = 1u << 22, bypass_pll = 1u << 11,
                            crystal_6_mhz = 0xBu << 6, pll_locked = 1u << 6;
    reg(clock_config) = divide_by_16 | bypass_pll | crystal_6_mhz; // this write powers the PLL up, too
    reg(clock_config) = divide_by_16 | use_divider | bypass_pll | crystal_6_mhz;
    while ((reg(raw_interrupts) & pll_locked) == 0) {
    }
    reg(clock_config) = divide_by_16 | use_divider | crystal_6_mhz;
}

} // namespace spangle::mcu::stellaris
