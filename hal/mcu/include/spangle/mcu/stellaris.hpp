// TI (Luminary) Stellaris LM3S: clocks of the blocks, and pins. LM3S6965 data sheet, chapters 5 and 8.
#pragma once

#include <cstdint>

#include <spangle/mcu/registers.hpp>

namespace spangle::mcu::stellaris {

inline constexpr std::uintptr_t system_control = 0x400FE000;
inline constexpr std::uintptr_t clock_config = system_control + 0x060;  ///< RCC
inline constexpr std::uintptr_t serial_clocks = system_control + 0x104; ///< RCGC1
inline constexpr std::uintptr_t port_clocks = system_control + 0x108;   ///< RCGC2: bit 0 is port A

/// A GPIO port: a PL061.
struct Port {
    std::uintptr_t base;

    /// These pins belong to a block (SSI, I2C), not to software.
    void give_away(std::uint32_t pins) const {
        set_bits(base + alternate, pins);
        set_bits(base + digital, pins);
    }
    void output(std::uint32_t pins) const {
        set_bits(base + direction, pins);
        set_bits(base + digital, pins);
    }
    void open_drain(std::uint32_t pins) const { set_bits(base + drain, pins); }

  private:
    static constexpr std::uintptr_t direction = 0x400, alternate = 0x420, drain = 0x50C, digital = 0x51C;
};

/// The address carries a mask of the pins that a write changes.
struct Pin {
    Port port;
    unsigned bit;

    void set(bool high) const { reg(port.base + (std::uintptr_t{1} << bit << 2)) = high ? 1u << bit : 0; }
};

/// After a block's clock is turned on it may be spoken to three clocks later.
inline void turn_on(std::uintptr_t clocks, std::uint32_t bits) {
    set_bits(clocks, bits);
    [[maybe_unused]] const std::uint32_t settled = reg(clocks);
}

} // namespace spangle::mcu::stellaris
