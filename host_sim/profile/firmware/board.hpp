// The clock and the output of an emulated board, for code that counts.
#pragma once

#include <cstdint>

#include <spangle/mcu/semihosting.hpp>
#include <spangle/mcu/systick.hpp>

namespace spangle::measure {

inline std::uint32_t now() {
    return mcu::reg(mcu::SysTick::current);
}

/// The ticks from `begin` to `end` of the timer, which counts down.
inline std::uint32_t ticks_between(std::uint32_t begin, std::uint32_t end) {
    return (begin - end) & mcu::SysTick::most_ticks;
}

inline void print(const char* text) {
    mcu::semihosting::print(text);
}

inline void print(std::uint32_t number) {
    mcu::semihosting::print_number(number);
}

} // namespace spangle::measure
