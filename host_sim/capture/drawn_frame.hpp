// A frame as one context drew it: what a tier's is held against double's by.
#pragma once

#include <vector>

#include <spangle/reference.hpp>

#include "host_sim/trade/coverage.hpp"

namespace spangle::trade {

struct DrawnFrame {
    DrawnPicture picture;
    FrameCoverage coverage; ///< of its triangles
    std::vector<bool> mask; ///< pixels that anything was drawn to, bottom row first
};

/// Depths of 24 bits become those of 16: finer codes than the tiers promise say nothing about them.
void coarsen(DrawnPicture& picture);

/// A mask of rows in the other order.
std::vector<bool> upside_down(const std::vector<bool>& mask, int width);

} // namespace spangle::trade
