// Finds out which panel is connected to a bus. It asks for every identity that a known panel would give, and
// proposes the panels that fit.
#pragma once

#include <string>
#include <vector>

#include <spangle/hal/bus.hpp>
#include <spangle/hal/panel.hpp>

namespace spangle::bringup {

struct Answer {
    hal::Identity asked;
    std::uint32_t id = 0;
    bool floating = false; ///< all bits are equal, because nobody drives the line
};

struct Findings {
    std::string error; ///< why the bus could not be read; empty: it was read
    std::vector<Answer> answers;
    std::vector<const hal::PanelDesc*> panels; ///< panels that answer so, in the order of hal::panels::all
};

/// Asks the panel, which must have its power. `reset` says whether the bus has a reset line; then the panel
/// is reset first.
Findings probe(hal::Bus& bus, bool reset);
std::string text_of(const Findings& findings);
/// Panels that hang on I2C, a line each. Nobody can ask which of them is there.
std::string i2c_candidates();

} // namespace spangle::bringup
