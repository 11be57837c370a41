// Where a module is plugged in: numbered lines, whatever drives them.
#pragma once

#include <cstdint>
#include <functional>

#include <spangle/sim/violations.hpp>

namespace spangle::sim {

struct PinHeader {
    /// Told after each change: bit n is the level of line n. Lines that are not driven are high, unless the
    /// module pulls them down.
    std::function<void(std::uint64_t levels, Time now)> on_change;
    /// The level of an input at a time, asked with times that do not fall.
    std::function<bool(unsigned line, Time now)> input;
    /// Bit n: the module has a resistor that pulls line n down while it is not driven.
    std::uint64_t pulled_down = 0;
};

} // namespace spangle::sim
