// What of a vertex a line of one colour depends on.
#pragma once

#include <cstdint>

#include "raster/primitive/setup_math.hpp"
#include "raster/span/vertex.hpp"

namespace spangle::raster {

struct LineEnd {
    std::int32_t x, y;   ///< subpixels
    std::uint32_t depth; ///< depth_code(z, 16)
};

SPANGLE_INLINE LineEnd line_end(const FixedVertex& v) {
    return {v.x, v.y, depth_code(v.z, 16)};
}

constexpr Position position(const LineEnd& v) {
    return {v.x, v.y};
}

/// Where the ends of strips may be for draw_strip() to take them: nowhere if it draws no lines of this state.
DrawState::Area strip_area(const DrawState& state, std::int32_t width);

/// Lines of width 1 from each of n > 1 ends, at most line_batch + 1, to the next, all in the strip_area(), in
/// the colour of `painted`.
void draw_strip(const DrawState& state, const Surface& target, const LineEnd* ends, int n,
                const FixedVertex& painted);

} // namespace spangle::raster
