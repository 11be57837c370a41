// Paths: what a line of width 1 hands to a loop of its own, one fragment per step along its major axis.
// Several at a time, so that what finds them and what draws them each run without waiting for the other.
#pragma once

#include <cstdint>

#include "raster/span/draw_state.hpp"
#include "raster/span/span.hpp"

namespace spangle::raster {

/// Each fragment is `along` from the one before it, and `aside` further whenever `rest`, grown by `rise`, is
/// no longer negative; then `denominator` is taken off. Pixels, in planes whose rows have the same stride.
struct Path {
    std::int32_t first; ///< from that of window (0, 0)
    std::int32_t along, aside;
    std::int32_t count;
    std::int32_t rest, rise, denominator; ///< -denominator <= rest < 0 <= rise <= denominator
    /// An attribute: at the first fragment, and from one to the next.
    struct Ramp {
        Fixed::Affine value, step;
    } z, color[3];
    std::uint32_t word; ///< Kind::flat
};

/// Draws paths.
using PathFunction = void (*)(const DrawState&, const Surface&, const Path* path, const Path* end);

} // namespace spangle::raster
