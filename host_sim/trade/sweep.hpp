// Measures every program in every format and tier, or a part of them, and writes figures and pictures into a
// folder.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/trade/choice.hpp"
#include "host_sim/trade/cost.hpp"
#include "host_sim/trade/measure.hpp"
#include "host_sim/trade/program.hpp"
#include "host_sim/trade/table.hpp"

namespace spangle::trade {

struct Sweep {
    std::vector<Program> programs;
    std::vector<Tier> tiers;
    std::vector<Format> formats;
    Setting setting;
    int shard = 1, shards = 1; ///< this sweep takes jobs whose number mod shards is shard - 1
    bool times = true;
    /// Counts the instructions of a frame; returns 0 where nobody counts them.
    std::function<std::uint64_t(const Program&, const Tier&, const Format&)> count;
    /// The targets beside this machine, and the function that counts on them. It returns nothing where it
    /// cannot.
    std::vector<Target> targets;
    std::function<std::optional<BoardCost>(const Target&, const Program&, const Tier&, const Format&,
                                           const Work&)>
        count_board;
    /// Is called before each job.
    std::function<void(const Job&)> progress = [](const Job&) {};
};

struct SweepResult {
    Table accuracy, cost;
    std::string problem; ///< empty if everything was measured and written
};

/// Makes the folder, measures, and writes accuracy.csv, cost.csv and the pictures.
SweepResult sweep(const Sweep& what, const std::string& folder);

/// Merges the folders of shards: CSV files and pictures become those that one sweep would have written.
SweepResult merge_folders(const std::vector<std::string>& parts, const std::string& folder);

} // namespace spangle::trade
