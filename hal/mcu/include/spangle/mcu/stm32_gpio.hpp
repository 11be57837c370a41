// GPIO of STM32F2/F4: RM0090 (STM32F405), 8.4.
#pragma once

#include <cstdint>

#include <spangle/mcu/registers.hpp>

namespace spangle::mcu {

/// A GPIO port, whose clock must run already (RCC_AHB1ENR).
struct Stm32Gpio {
    /// The port's address.
    std::uintptr_t base;

    /// Makes the pin a push-pull output.
    void output(unsigned pin) const { mode(pin, 1); }

    /// Hands the pin to a block: alternate function 0 to 15, at high speed.
    void alternate(unsigned pin, std::uint32_t function) const {
        field(afrl + (pin >> 3) * 4, (pin & 7) * 4, 0xF, function);
        field(ospeedr, pin * 2, 3, 2);
        mode(pin, 2);
    }

    /// Offsets of the block's registers.
    static constexpr std::uintptr_t moder = 0x00, ospeedr = 0x08, bsrr = 0x18, afrl = 0x20;

  private:
    void mode(unsigned pin, std::uint32_t value) const { field(moder, pin * 2, 3, value); }
    void field(std::uintptr_t offset, unsigned shift, std::uint32_t mask, std::uint32_t value) const {
        reg(base + offset) = (reg(base + offset) & ~(mask << shift)) | value << shift;
    }
};

/// An output line: one store to BSRR, which sets by its low half and resets by its high one.
struct Stm32Pin {
    /// The port's address.
    std::uintptr_t gpio;
    /// The pin, 0 to 15.
    unsigned bit;

    /// Drives the line.
    void set(bool high) const { reg(gpio + Stm32Gpio::bsrr) = 1u << (high ? bit : bit + 16); }
};

} // namespace spangle::mcu
