// Who hangs on this bus? Asks for every identity that a known panel would give, and proposes those that fit.
#pragma once

#include <string>
#include <vector>

#include <spangle/hal/bus.hpp>
#include <spangle/hal/panel.hpp>

namespace spangle::bringup {

struct Answer {
    hal::Identity asked;
    std::uint32_t id = 0;
    bool floating = false; ///< all bits alike: nobody drives the line
};

struct Findings {
    std::string error; ///< empty: the bus could be read
    std::vector<Answer> answers;
    std::vector<const hal::PanelDesc*> panels; ///< that answer so, in the order of hal::panels::all
};

/// The panel must have its power and, where the bus has a reset line, is reset. `reset`: whether it has.
Findings probe(hal::Bus& bus, bool reset);
std::string text_of(const Findings& findings);
/// Panels that hang on I2C, a line each: nobody can ask which of them it is.
std::string i2c_candidates();

} // namespace spangle::bringup
