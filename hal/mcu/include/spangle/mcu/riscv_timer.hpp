// The timer every RISC-V core has: mtime (Privileged specification, 3.2.1).
#pragma once

#include <cstdint>

#include <spangle/mcu/registers.hpp>

namespace spangle::mcu {

/// The timer, which always runs.
struct RiscvTimer {
    /// The register's address.
    std::uintptr_t mtime;
    /// The clock of the timer in Hz.
    std::uint32_t clock_hz;

    /// The low 32 bits of the timer.
    std::uint32_t ticks() const { return reg(mtime); }
    /// Microseconds, which wrap where ticks() do.
    std::uint32_t micros() const {
        return static_cast<std::uint32_t>(std::uint64_t{ticks()} * 1000000 / clock_hz);
    }
    /// Pauses at least this long.
    void pause(std::uint32_t micros) const {
        const std::uint64_t wanted = (std::uint64_t{micros} * clock_hz + 999999) / 1000000;
        std::uint64_t passed = 0;
        for (std::uint32_t last = ticks(); passed <= wanted;) {
            const std::uint32_t now = ticks();
            passed += now - last;
            last = now;
        }
    }
};

} // namespace spangle::mcu
