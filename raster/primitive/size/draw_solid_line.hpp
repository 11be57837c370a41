// Draws a line without a stipple by the loop of stippled lines, where the build has that loop.
#pragma once

#include "raster/primitive/line_batch.hpp"

namespace spangle::raster {

/// Draws a line without a stipple. With stipples, it is drawn with a stipple that leaves all fragments.
/// Builds with records draw it without one, because records would keep this stipple.
SPANGLE_INLINE void draw_solid_line(const DrawState& state, const Surface& target, const FixedVertex& a,
                                    const FixedVertex& b, const FixedVertex& provoking, std::int32_t width) {
    if constexpr (LineStipple all; SPANGLE_FEATURE_STIPPLE && !SPANGLE_HAS_RECORDS)
        draw_stippled_line(state, target, a, b, provoking, width, all);
    else
        draw_line_of<Fixed>(state, target, a, b, provoking, width);
}

} // namespace spangle::raster
