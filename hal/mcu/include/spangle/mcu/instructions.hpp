// Instructions executed, when QEMU runs with `-icount shift=0`: one instruction is one nanosecond of [virtual
// time](docs/glossary.md#virtual-time), which some timer of each processor counts. On a real chip these count
// clocks.
#pragma once

#include <cstdint>

#include <spangle/mcu/cortex_a9.hpp>
#include <spangle/mcu/systick.hpp>

namespace spangle::mcu {

/// Only one count may run at a time, of less than 2^32 instructions. On Cortex-M it has less than 2^24
/// clocks, and no pause may happen meanwhile.
class InstructionCount {
  public:
    /// `clock_hz` is the clock of the timer that counts.
    explicit InstructionCount(std::uint32_t clock_hz) : clock_hz_(clock_hz) {}

    /// Begins to count.
    void begin() {
#if defined(__ARM_ARCH_PROFILE) && __ARM_ARCH_PROFILE == 'M'
        reg(SysTick::control) = 0;
        reg(SysTick::reload) = SysTick::most_ticks;
        reg(SysTick::current) = 0;
        reg(SysTick::control) = SysTick::enable | SysTick::processor_clock;
#endif
        begin_ = now();
    }
    /// The number of instructions since begin().
    std::uint32_t end() const {
        const std::uint32_t after = now();
#if defined(__ARM_ARCH_PROFILE) && __ARM_ARCH_PROFILE == 'M'
        const std::uint32_t ticks = (begin_ - after) & SysTick::most_ticks; // SysTick counts down
        return static_cast<std::uint32_t>(std::uint64_t{ticks} * 1000000000u / clock_hz_);
#elif defined(__riscv)
        return after - begin_;
#else
        return static_cast<std::uint32_t>(std::uint64_t{after - begin_} * 1000000000u / clock_hz_);
#endif
    }

  private:
    static std::uint32_t now() {
#if defined(__ARM_ARCH_PROFILE) && __ARM_ARCH_PROFILE == 'M'
        return reg(SysTick::current);
#elif defined(__riscv)
        std::uint32_t value;
        asm volatile(".option push\n.option arch, +zicsr\nrdinstret %0\n.option pop" : "=r"(value));
        return value;
#else
        return GlobalTimer().ticks();
#endif
    }

    [[maybe_unused]] std::uint32_t clock_hz_;
    std::uint32_t begin_ = 0;
};

} // namespace spangle::mcu
