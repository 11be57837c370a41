// Every program in every format and tier, or a part of them: the figures and pictures of a folder.
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
    int shard = 1, shards = 1; ///< jobs whose number mod shards is shard - 1
    bool times = true;
    /// Instructions of a frame, or 0 where nobody counts them.
    std::function<std::uint64_t(const Program&, const Tier&, const Format&)> count;
    /// The targets beside this machine, and what counts on them: nothing where it cannot.
    std::vector<Target> targets;
    std::function<std::optional<BoardCost>(const Target&, const Program&, const Tier&, const Format&,
                                           const Work&)>
        count_board;
    /// Told before each job.
    std::function<void(const Job&)> progress = [](const Job&) {};
};

struct Swept {
    Table accuracy, cost;
    std::string problem; ///< empty: everything was measured and written
};

/// Makes the folder, measures, and writes accuracy.csv, cost.csv and the pictures.
Swept sweep(const Sweep& what, const std::string& folder);

/// Puts the folders of shards together: CSV files and pictures, as one sweep would have written them.
Swept merge_folders(const std::vector<std::string>& parts, const std::string& folder);

} // namespace spangle::trade
