// What does a frame cost in each tier, compared in one run on this machine?
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host_sim/trade/choice.hpp"
#include "host_sim/trade/measure.hpp"
#include "host_sim/trade/program.hpp"
#include "host_sim/trade/table.hpp"
#include "host_sim/trade/targets.hpp"

namespace spangle::trade {

/// Instructions are counted of these frames, once frame 0 was drawn, on every target.
inline constexpr int first_counted = 1, counted_frames = 4;

/// Microseconds of the processor for a frame of each tier: the least of rounds that take the tiers by turns,
/// so that all of them see the same machine; negative where the tier cannot be drawn.
std::vector<double> frame_times(const Program& program, const std::vector<Tier>& chosen, const Format& format,
                                const Setting& setting);

/// What is drawn in the frames whose instructions are counted.
struct Work {
    double triangles = 0;   ///< of a frame that reach a pixel, lines and points among them
    double fragments = 0;   ///< of a frame: covered, hidden or not
    std::uint32_t hash = 0; ///< FNV-1a of the last one's RGBA, as tests/bench/picture_hash.hpp has it
};
Work work_of_frames(const Program& program, const Tier& tier, const Format& format, const Setting& setting);

/// All that a row of cost.csv says.
struct Cost {
    double microseconds = -1, first = -1; ///< of this tier and of the first; negative: not measured
    Work work;
    std::uint64_t instructions = 0;          ///< on this machine; 0: not counted
    Work board_work;                         ///< what images draw
    std::map<std::string, BoardCost> boards; ///< by the target's name
};

/// The columns of cost.csv, and a row of it: times are those of this machine, and relative to the first tier.
Table::Row cost_columns();
Table::Row cost_row(const Job& job, const Tier& tier, const Cost& cost);

/// The column of a target's figure: "instructions", "per_pixel", "per_triangle", "flash", "ram".
std::string target_column(const std::string& target, const std::string& figure);

} // namespace spangle::trade
