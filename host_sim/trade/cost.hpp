// What a frame costs in each tier, compared in one run on this machine.
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

/// The frames whose instructions are counted on every target, after frame 0 was drawn.
inline constexpr int first_counted = 1, counted_frames = 4;

/// Microseconds of processor time for a frame in each tier: the least of several rounds. Rounds take the
/// tiers by turns, so that all tiers see the same machine. A negative time stands for a tier that cannot be
/// drawn.
std::vector<double> frame_times(const Program& program, const std::vector<Tier>& chosen, const Format& format,
                                const Setting& setting);

/// The work in the frames whose instructions are counted.
struct Work {
    double triangles = 0;   ///< triangles, lines and points of a frame that reach a pixel
    double fragments = 0;   ///< fragments of a frame, whether hidden or not
    std::uint32_t hash = 0; ///< FNV-1a of the last frame's RGBA, as in tests/tools/bench/picture_hash.hpp
};
Work work_of_frames(const Program& program, const Tier& tier, const Format& format, const Setting& setting);

/// The figures of a row of cost.csv.
struct Cost {
    double microseconds = -1, first = -1; ///< us, of this tier and of the first; negative: not measured
    Work work;
    std::uint64_t instructions = 0;          ///< instructions of a frame on this machine; 0: not counted
    Work board_work;                         ///< work of the images of firmware
    std::map<std::string, BoardCost> boards; ///< costs on boards, by name of the target
};

/// The columns of cost.csv, and a row of it. Times are those of this machine, and relative to the first tier.
Table::Row cost_columns();
Table::Row cost_row(const Job& job, const Tier& tier, const Cost& cost);

/// The name of the column of a target's figure: "instructions", "per_pixel", "per_triangle", "flash", "ram".
std::string target_column(const std::string& target, const std::string& figure);

} // namespace spangle::trade
