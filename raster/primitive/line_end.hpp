// The part of a vertex that a line of one colour depends on.
#pragma once

#include <cstdint>

#include "raster/primitive/setup_math.hpp"
#include "raster/span/vertex.hpp"

namespace spangle::raster {

struct LineEnd {
    std::int32_t x, y;   ///< window position in subpixels
    std::uint32_t depth; ///< the depth as depth_code(z, 16) gives it
};

SPANGLE_INLINE LineEnd line_end(const FixedVertex& v) {
    return {v.x, v.y, depth_code(v.z, 16)};
}

constexpr Position position(const LineEnd& v) {
    return {v.x, v.y};
}

/// The area in which the ends of strips must lie for draw_strip(). It is empty where draw_strip() draws no
/// lines of this state.
DrawState::Area strip_area(const DrawState& state, std::int32_t width);

/// Draws lines of width 1 from each end to the next, in the colour of `painted`. There are n ends, 1 < n <=
/// line_batch + 1, all of which lie in strip_area().
void draw_strip(const DrawState& state, const Surface& target, const LineEnd* ends, int n,
                const FixedVertex& painted);

} // namespace spangle::raster
