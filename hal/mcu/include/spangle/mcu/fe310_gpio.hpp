// GPIO of SiFive's FE310. FE310-G002 manual, chapter 17.
#pragma once

#include <cstdint>

#include <spangle/mcu/registers.hpp>

namespace spangle::mcu {

/// The GPIO block.
struct Fe310Gpio {
    /// The block's address.
    std::uintptr_t base;

    /// Makes the pin an output.
    void output(unsigned pin) const { set_bits(base + output_en, 1u << pin); }
    /// Hands the pins to their first hardware function: SPI, UART.
    void hardware(std::uint32_t pins) const {
        clear_bits(base + iof_sel, pins);
        set_bits(base + iof_en, pins);
    }
    /// An output line.
    constexpr RegisterPin pin(unsigned bit) const { return {base + output_val, bit}; }

    /// Offsets of the block's registers.
    static constexpr std::uintptr_t output_en = 0x08, output_val = 0x0C, iof_en = 0x38, iof_sel = 0x3C;
};

} // namespace spangle::mcu
