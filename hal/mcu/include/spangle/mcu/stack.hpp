// The stack as the linker script gives it: painted by start-up, so that what was used is known.
#pragma once

#include <cstdint>

/// The stack's lowest word, and the word above it: the linker script defines them.
extern "C" std::uint32_t stack_bottom, stack_top;

namespace spangle::mcu {

/// What start-up writes to each word.
inline constexpr std::uint32_t stack_paint = 0x5AA5C33C;

/// The most bytes of the stack that have been used so far.
inline std::uint32_t deepest_stack() {
    const volatile std::uint32_t* p = &stack_bottom;
    while (p != &stack_top && *p == stack_paint)
        ++p;
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(&stack_top) -
                                      reinterpret_cast<std::uintptr_t>(p));
}

} // namespace spangle::mcu
