// Waiting with a TIMER of Nordic's nRF51, which has no SysTick. nRF51 Series Reference Manual, chapter 18.
#pragma once

#include <cstdint>

#include <spangle/mcu/registers.hpp>

namespace spangle::mcu {

/// A TIMER block, which counts microseconds.
struct Nrf51Timer {
    /// The block's address.
    std::uintptr_t base;

    /// Sets the block up and lets it run.
    void start() const {
        constexpr std::uint32_t bits_32 = 3, divide_by_16 = 4; // 16 MHz become 1 MHz
        reg(base + mode) = 0;
        reg(base + bitmode) = bits_32;
        reg(base + prescaler) = divide_by_16;
        reg(base + task_clear) = 1;
        reg(base + task_start) = 1;
    }
    /// Lets at least `micros` microseconds pass.
    void pause(std::uint32_t micros) const {
        for (const std::uint32_t from = now(); now() - from <= micros;) {
        }
    }

    /// Offsets of the block's registers.
    static constexpr std::uintptr_t task_start = 0x000, task_clear = 0x00C, task_capture = 0x040,
                                    mode = 0x504, bitmode = 0x508, prescaler = 0x510, cc = 0x540;

  private:
    std::uint32_t now() const {
        reg(base + task_capture) = 1;
        return reg(base + cc);
    }
};

} // namespace spangle::mcu
