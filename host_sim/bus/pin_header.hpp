// Where a module is plugged in: numbered lines, whatever drives them.
#pragma once

#include <cstdint>
#include <functional>

#include <spangle/sim/violations.hpp>

namespace spangle::sim {

struct PinHeader {
    /// Told after each change: bit n is the level of line n. Lines that are not driven are high.
    std::function<void(std::uint64_t levels, Time now)> on_change;
    /// The level of an input at a time, asked with times that do not fall.
    std::function<bool(unsigned line, Time now)> input;
};

} // namespace spangle::sim
