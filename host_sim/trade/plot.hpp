// Figures as pictures: gnuplot draws, as SVG.
#pragma once

#include <string>
#include <vector>

#include "host_sim/trade/table.hpp"

namespace spangle::trade {

/// An SVG element, or why there is none: gnuplot (Debian: gnuplot-nox) is asked for as a program.
struct Plot {
    std::string svg, problem;
};

/// What frames of all tiers may be compared by: a column of cost.csv.
struct Axis {
    std::string column;   ///< "microseconds", "m4_instructions", ...
    std::string name;     ///< "time", "instructions on m4", "flash on m4", ...
    bool of_frame = true; ///< else it is one of the whole image
};
/// The axes that have figures: instructions on boards and on this machine, time, flash and RAM.
std::vector<Axis> axes_of(const Table& cost);

/// A figure relative to that of the first tier against decibels in 565, a point for each program and tier.
Plot plot_tiers(const Table& accuracy, const Table& cost, const Axis& axis);
/// Bytes of a frame against how different it looks from one in eight bits, of the first tier.
Plot plot_formats(const Table& accuracy);

} // namespace spangle::trade
