// Reports the values that a program reaches, such as the largest point size. They go to the recorder of
// profiles, and to builds that check the ranges of a recorded profile.
#pragma once

#include <algorithm>

#include "gl/vertex/pipeline.hpp"

namespace spangle::gl {

/// Reports the values that are known when a primitive begins.
template <class M, class L> void Pipeline<M, L>::record_draw_reach() const {
    Context& context = *context_;
    const auto tell = [&](Range range, std::int32_t value) {
        reach(context, range, static_cast<std::uint32_t>(value));
    };
    const raster::Surface& surface = context.drawable.surface;
    tell(Range::SURFACE_WIDTH, surface.width);
    tell(Range::SURFACE_HEIGHT, surface.height);
    tell(Range::BAND_ROWS, surface.area().h);
    if (modes_.mode() == GL_POINTS || modes_.has_outlines())
        tell(Range::POINT_SIZE, rounded_size(context.polygon.point_size));
    if ((modes_.mode() != GL_POINTS && modes_.mode() <= GL_LINE_STRIP) || modes_.has_outlines())
        tell(Range::LINE_WIDTH, rounded_size(context.polygon.line_width));
}

/// Reports the range of a vertex's position and texture coordinates, and whether they need a division.
template <class M, class L>
void Pipeline<M, L>::record_vertex_reach(const CurrentState& current, const Vertex& v) const {
    Context& context = *context_;
    std::uint32_t bits = 0;
    for (const Real x : v.position)
        bits = std::max(bits, bits_before_point(x));
    reach(context, Range::POSITION_BITS, bits);
    Real clip[4];
    M::to_reals(M::to_clip(transforms_, v.position), clip);
    bool divides = !(clip[3] == numeric::one);
    for (int u = 0; u < texture_units; ++u) {
        if ((modes_.units() >> u & 1) == 0)
            continue;
        Real strq[4];
        M::to_reals(texture_of(current, v, u), strq);
        for (int c = 0; c < 3; ++c)
            reach(context, Range::TEXTURE_BITS, bits_before_point(strq[c]));
        divides = divides || !(strq[3] == numeric::one);
    }
    if constexpr (raster::has_perspective) // other builds report a division as an error
        reach(context, Range::PERSPECTIVE, divides ? 1 : 0);
}

/// Reports a primitive that needs clipping, which a build without SPANGLE_CLIPPING refuses. `flags` is the
/// union of the flags of all corners.
template <class M, class L> inline void Pipeline<M, L>::record_clip_reach(unsigned flags) const {
    if ((flags & (beyond_mask | unprojected)) != 0 || clip_planes(flags) != 0)
        reach(*context_, Range::CUTS, 1);
}

} // namespace spangle::gl
