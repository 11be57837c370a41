// Draws a line without a stipple as a path, where the build has paths.
#pragma once

#include "raster/primitive/line_batch.hpp"

namespace spangle::raster {

/// Draws a line without a stipple.
SPANGLE_INLINE void draw_solid_line(const DrawState& state, const Surface& target, const FixedVertex& a,
                                    const FixedVertex& b, const FixedVertex& provoking, std::int32_t width) {
    if constexpr (has_paths)
        draw_line_by<HostLines>(state, target, a, b, provoking, width);
    else
        draw_line_of<Fixed>(state, target, a, b, provoking, width);
}

} // namespace spangle::raster
