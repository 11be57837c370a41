// spangle profile: what a program asks of GL, as the profile of a build that holds no more.
#pragma once

#include <string>
#include <vector>

#include "host_sim/cli/options.hpp"

namespace CLI {
class App;
}

namespace spangle::cli {

struct ProfileOptions {
    RunOptions run;                 ///< scene or model, frames (0: the usual), dither
    std::vector<std::string> words; ///< a scene, or a program and its arguments
    bool program = false;           ///< the words came after --
    std::string trace;              ///< a file of apitrace
    std::string size = "320x240", dither = "program", format = "rgb565", out;
    std::vector<std::string> tiers = {"exact", "balanced", "fast"};
    double max_error = -1.0; ///< percent of pixels; negative: not asked
    bool small = false, unclipped = false, json = false;
    std::string report; ///< HTML page; empty: none
};

/// The command with its options.
CLI::App* add_profile(CLI::App& app, ProfileOptions& options);

/// Writes the profile and prints what was recorded: the exit status.
int profile(ProfileOptions options);

} // namespace spangle::cli
