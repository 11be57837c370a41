// How a program ends that cannot go on: with a record of why, in one place.
#pragma once

#include <cstdint>

namespace spangle::mcu {

/// Why a program ends.
enum class Cause : std::uint32_t {
    fault,          ///< the processor could not execute or access something
    stack_overflow, ///< the stack's lower end was passed
    interrupt,      ///< an interrupt that nothing handles
    returned,       ///< main() returned; `status` is its value
};

/// The record that panic() gets.
struct Panic {
    /// The reason.
    Cause cause;
    std::uint32_t pc;     ///< address of the instruction; 0 where the stack could not take it
    std::uint32_t status; ///< CFSR (Cortex-M), DFSR (Cortex-A), mcause (RISC-V)
};

/// The reason in words, static.
constexpr const char* name_of(Cause cause) {
    constexpr const char* names[] = {"fault", "stack overflow", "interrupt", "returned"};
    return names[static_cast<std::uint32_t>(cause)];
}

/// The program defines this, and start-up calls it on a stack that is whole. It may reset, blink, report or
/// sleep.
[[noreturn]] void panic(const Panic& panic);

} // namespace spangle::mcu
