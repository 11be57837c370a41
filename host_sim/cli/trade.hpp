// `spangle trade`: speed against accuracy, of scenes, models and programs, as CSV and as a page.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace spangle::cli {

struct TradeOptions {
    std::vector<std::string> scenes; ///< none, and nothing else: all
    std::vector<std::string> models, traces;
    std::vector<std::string> program; ///< and its arguments
    bool runs_program = false;        ///< -- was there
    std::vector<std::string> tiers, formats;
    std::string size = "320x240", dither = "off", shard, out = "trade";
    int frames = 10;
    bool no_times = false, instructions = false, strict = false, bytes = false, knobs = false;
    std::vector<std::string> own_tiers; ///< NAME=BASE,KNOB=VALUE,...
    std::vector<std::string> targets;   ///< whose instructions are counted
    std::string firmware;               ///< the folder of images for targets but the host
    std::vector<std::string> parts;     ///< of merge
};

/// The command with its options and its own subcommand, merge.
CLI::App* add_trade(CLI::App& app, TradeOptions& options);

/// The exit status; `merging`: the subcommand was called.
int trade(const TradeOptions& options, bool merging);

} // namespace spangle::cli
