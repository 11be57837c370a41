// Plots of figures as SVG, which gnuplot draws.
#pragma once

#include <string>
#include <vector>

#include "host_sim/trade/table.hpp"

namespace spangle::trade {

/// An SVG element, or the problem why there is none. gnuplot (Debian: gnuplot-nox) runs as a program.
struct Plot {
    std::string svg, problem;
};

/// A figure by which frames of all tiers may be compared: a column of cost.csv.
struct Axis {
    std::string column;   ///< name of the column: "microseconds", "m4_instructions", ...
    std::string name;     ///< name on the page: "time", "instructions on m4", "flash on m4", ...
    bool of_frame = true; ///< false: a figure of the whole image
};
/// The axes that have figures: instructions on boards and on this machine, time, flash and RAM.
std::vector<Axis> axes_of(const Table& cost);

/// Plots a figure relative to that of the first tier against PSNR in 565, with a point for each program and
/// tier.
Plot plot_tiers(const Table& accuracy, const Table& cost, const Axis& axis);
/// Plots the bytes of a frame against how different it looks from a frame in eight bits, for the first tier.
Plot plot_formats(const Table& accuracy);

} // namespace spangle::trade
