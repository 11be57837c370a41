// Cortex-A9: its global timer, and its data cache where others read memory. Cortex-A9 MPCore TRM, 4.4;
// Armv7-A ARM, B4.2.
#pragma once

#include <cstddef>
#include <cstdint>

#include <spangle/mcu/registers.hpp>

#if defined(__ARM_ARCH_PROFILE) && __ARM_ARCH_PROFILE == 'A'

namespace spangle::mcu {

/// The global timer, which counts half the processor's clock.
struct GlobalTimer {
    /// The timer's clock in Hz, at least 1 MHz.
    std::uint32_t clock_hz = 0;

    /// Lets the timer run.
    void start() const { reg(base() + 0x208) = 1; }
    /// The low 32 bits of the timer.
    std::uint32_t ticks() const { return reg(base() + 0x200); }
    /// Microseconds, which wrap where ticks() do.
    std::uint32_t micros() const { return ticks() / (clock_hz / 1000000); }

  private:
    static std::uintptr_t base() {
        std::uintptr_t value;
        asm volatile("mrc p15, 4, %0, c15, c0, 0" : "=r"(value)); // CBAR
        return value;
    }
};

/// The data cache, whose lines have 32 bytes.
struct DataCache {
    /// Writes cached bytes to memory, line by line.
    void clean(const std::uint8_t* from, std::size_t bytes) const {
        constexpr std::uintptr_t line = 32;
        const std::uintptr_t end = reinterpret_cast<std::uintptr_t>(from) + bytes;
        for (std::uintptr_t at = reinterpret_cast<std::uintptr_t>(from) & ~(line - 1); at < end; at += line)
            asm volatile("mcr p15, 0, %0, c7, c10, 1" : : "r"(at) : "memory"); // DCCMVAC
        asm volatile("dsb" : : : "memory");
    }
};

} // namespace spangle::mcu

#endif
