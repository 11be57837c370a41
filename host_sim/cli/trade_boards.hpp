// What `spangle trade --targets` needs of firmware: the folder of images, and a count on each of them.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "host_sim/cli/trade.hpp"
#include "host_sim/trade/sweep.hpp"

namespace spangle::cli {

bool is_asked(const TradeOptions& options, const std::string& target);

/// Finds the targets that are asked for, and checks that each has its folder of images. Returns what to do
/// about a problem, or an empty string.
std::string read_targets(const TradeOptions& options, trade::Sweep& out);

/// Returns a function that counts on boards (Sweep::count_board). It reports a problem once for each target,
/// and a program without images once.
std::function<std::optional<trade::BoardCost>(const trade::Target&, const trade::Program&, const trade::Tier&,
                                              const trade::Format&, const trade::Work&)>
board_counter(const TradeOptions& options, const trade::Setting& setting);

} // namespace spangle::cli
