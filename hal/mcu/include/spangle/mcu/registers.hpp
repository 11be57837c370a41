// Registers of a microcontroller's blocks.
#pragma once

#include <cstdint>

namespace spangle::mcu {

/// The 32-bit register at an address.
inline volatile std::uint32_t& reg(std::uintptr_t address) {
    return *reinterpret_cast<volatile std::uint32_t*>(address);
}

/// Sets bits by a read and a write; an interrupt in between must not change the register.
inline void set_bits(std::uintptr_t address, std::uint32_t bits) {
    reg(address) = reg(address) | bits;
}
/// Clears bits by a read and a write; an interrupt in between must not change the register.
inline void clear_bits(std::uintptr_t address, std::uint32_t bits) {
    reg(address) = reg(address) & ~bits;
}

/// A line that is one bit of an output register.
struct RegisterPin {
    /// The register's address.
    std::uintptr_t address;
    /// The bit, 0 to 31.
    unsigned bit;

    /// Drives the line by a read and a write.
    void set(bool high) const {
        const std::uint32_t others = reg(address) & ~(1u << bit);
        reg(address) = others | std::uint32_t{high} << bit;
    }
};

/// A line that is not wired.
struct NoPin {
    /// Does nothing.
    void set(bool) const {}
};

} // namespace spangle::mcu
