// Figures as pictures: gnuplot draws, as SVG.
#pragma once

#include <string>

#include "host_sim/trade/table.hpp"

namespace spangle::trade {

/// An SVG element, or why there is none: gnuplot (Debian: gnuplot-nox) is asked for as a program.
struct Plot {
    std::string svg, problem;
};

/// Time relative to the first tier against decibels in 565, a point for each program and tier.
Plot plot_tiers(const Table& accuracy, const Table& cost);
/// Bytes of a frame against how different it looks from one in eight bits, of the first tier.
Plot plot_formats(const Table& accuracy);

} // namespace spangle::trade
