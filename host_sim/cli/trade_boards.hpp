// What `spangle trade --targets` asks of firmware: the folder of images, and a count on each of them.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "host_sim/cli/trade.hpp"
#include "host_sim/trade/sweep.hpp"

namespace spangle::cli {

bool is_asked(const TradeOptions& options, const std::string& target);

/// Every target that is asked for has its folder of images. Empty, or what to do.
std::string read_targets(const TradeOptions& options, trade::Sweep& out);

/// Counts on boards (Sweep::count_board). What goes wrong is told once for each target, and a program without
/// images is told once.
std::function<std::optional<trade::BoardCost>(const trade::Target&, const trade::Program&, const trade::Tier&,
                                              const trade::Format&, const trade::Work&)>
board_counter(const TradeOptions& options, const trade::Setting& setting);

} // namespace spangle::cli
