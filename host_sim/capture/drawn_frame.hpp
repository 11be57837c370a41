// A frame as one context drew it, by which a tier is compared with double.
#pragma once

#include <vector>

#include <spangle/reference.hpp>

#include "host_sim/trade/coverage.hpp"

namespace spangle::trade {

struct DrawnFrame {
    DrawnPicture picture;
    FrameCoverage coverage; ///< pixels that the frame's triangles cover
    std::vector<bool> mask; ///< pixels to which anything was drawn, bottom row first
};

/// Shortens depths of 24 bits to 16 bits. Finer codes than the tiers promise tell nothing about the tiers.
void coarsen(DrawnPicture& picture);

/// A mask whose rows are in the opposite order.
std::vector<bool> upside_down(const std::vector<bool>& mask, int width);

} // namespace spangle::trade
