// spangle profile: records what a program asks of GL, and writes the profile of a build that holds no more.
#pragma once

#include <string>
#include <vector>

#include "host_sim/cli/options.hpp"

namespace CLI {
class App;
}

namespace spangle::cli {

struct ProfileOptions {
    RunOptions run;                 ///< scene or model, frames (0: the usual number), dither
    std::vector<std::string> words; ///< a scene, or a program and its arguments
    bool program = false;           ///< the words came after --, so that they name a program
    std::string trace;              ///< file of apitrace; empty: no trace is given
    std::string size = "320x240", dither = "program", format = "rgb565", out;
    std::vector<std::string> tiers = {"exact", "balanced", "fast"};
    double max_error = -1.0; ///< percent of pixels; negative: no bound is asked
    bool small = false, unclipped = false, json = false;
    std::string report; ///< file for an HTML page; empty: no page is written
};

/// Adds the command with its options.
CLI::App* add_profile(CLI::App& app, ProfileOptions& options);

/// Writes the profile and prints what was recorded. Returns the exit status.
int profile(ProfileOptions options);

} // namespace spangle::cli
