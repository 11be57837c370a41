// `spangle trade`: measures speed against accuracy of scenes, models and programs, and writes CSV and a page.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace spangle::cli {

struct TradeOptions {
    std::vector<std::string> scenes; ///< ids of scenes; empty: all scenes, if nothing else is named
    std::vector<std::string> models, traces;
    std::vector<std::string> program; ///< the program and its arguments
    bool runs_program = false;        ///< the command line has --
    std::vector<std::string> tiers, formats;
    std::string size = "320x240", dither = "off", shard, out = "trade";
    int frames = 10;
    bool no_times = false, instructions = false, strict = false, bytes = false, knobs = false;
    std::vector<std::string> own_tiers; ///< tiers that the user composed, as NAME=BASE,KNOB=VALUE,...
    std::vector<std::string> targets;   ///< targets whose instructions are counted
    std::string firmware;               ///< folder with images for targets other than the host
    std::vector<std::string> parts;     ///< folders that merge joins
};

/// Adds the command with its options and its subcommand, merge.
CLI::App* add_trade(CLI::App& app, TradeOptions& options);

/// Returns the exit status; `merging` says that the subcommand was called.
int trade(const TradeOptions& options, bool merging);

} // namespace spangle::cli
