// What does a frame cost in each tier, compared in one run on this machine?
#pragma once

#include <string>
#include <vector>

#include "host_sim/trade/choice.hpp"
#include "host_sim/trade/measure.hpp"
#include "host_sim/trade/program.hpp"
#include "host_sim/trade/table.hpp"

namespace spangle::trade {

/// Microseconds of the processor for a frame of each tier: the least of rounds that take the tiers by turns,
/// so that all of them see the same machine; negative where the tier cannot be drawn.
std::vector<double> frame_times(const Program& program, const std::vector<Tier>& chosen, const Format& format,
                                const Setting& setting);

/// The columns of cost.csv, and a row of it: times are those of this machine, and relative to the first tier.
Table::Row cost_columns();
Table::Row cost_row(const Job& job, const Tier& tier, double microseconds, double first,
                    std::uint64_t instructions);

} // namespace spangle::trade
