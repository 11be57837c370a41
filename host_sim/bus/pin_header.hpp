// The numbered lines at which a display module is plugged in, whatever drives them.
#pragma once

#include <cstdint>
#include <functional>

#include <spangle/sim/violations.hpp>

namespace spangle::sim {

struct PinHeader {
    /// Is called after each change; bit n is the level of line n. Lines that are not driven are high, unless
    /// the module pulls them down.
    std::function<void(std::uint64_t levels, Time now)> on_change;
    /// Returns the level of an input line at a time. Callers ask with times that do not fall.
    std::function<bool(unsigned line, Time now)> input;
    /// Bit n says that the module has a resistor which pulls line n down while nobody drives it.
    std::uint64_t pulled_down = 0;
};

} // namespace spangle::sim
