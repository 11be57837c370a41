// Draws every sorted triangle by one walk over its rows.
#pragma once

#include "raster/primitive/triangle_rows.hpp"

namespace spangle::raster {

namespace detail {

/// Draws a sorted triangle that may reach columns of the scissor rectangle.
template <class P>
SPANGLE_INLINE void draw_sorted(Pen<P>& pen, const Sorted<typename P::Vertex>& t,
                                const typename P::Vertex& provoking, const Breadth&) {
    draw_rows<Edge>(pen, t, provoking);
}

} // namespace detail

} // namespace spangle::raster
