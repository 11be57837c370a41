// Registers of a microcontroller's blocks.
#pragma once

#include <cstdint>

namespace spangle::mcu {

/// The 32-bit register at an address.
inline volatile std::uint32_t& reg(std::uintptr_t address) {
    return *reinterpret_cast<volatile std::uint32_t*>(address);
}

inline void set_bits(std::uintptr_t address, std::uint32_t bits) {
    reg(address) = reg(address) | bits;
}
inline void clear_bits(std::uintptr_t address, std::uint32_t bits) {
    reg(address) = reg(address) & ~bits;
}

/// A line that is one bit of an output register.
struct RegisterPin {
    std::uintptr_t address;
    unsigned bit;

    void set(bool high) const {
        const std::uint32_t others = reg(address) & ~(1u << bit);
        reg(address) = others | std::uint32_t{high} << bit;
    }
};

/// A line that is not wired.
struct NoPin {
    void set(bool) const {}
};

} // namespace spangle::mcu
