// spangle profile: what a scene or a model asks of GL, as the profile of a build that holds no more.
#pragma once

#include <string>
#include <vector>

#include "host_sim/cli/options.hpp"

namespace CLI {
class App;
}

namespace spangle::cli {

struct ProfileOptions {
    RunOptions run; ///< scene or model, frames, dither
    std::string size = "320x240", dither = "program", out;
    std::vector<std::string> tiers = {"exact", "balanced", "fast"};
    double max_error = -1.0; ///< percent of pixels; negative: not asked
    bool small = false, json = false;
};

/// The command with its options.
CLI::App* add_profile(CLI::App& app, ProfileOptions& options);

/// Writes the profile and prints what was recorded: the exit status.
int profile(ProfileOptions options);

} // namespace spangle::cli
