// Draws triangles (GL 1.3, 3.5.1). Corners are sorted by y, edges are walked exactly, and planes are set up
// when the first row reaches a pixel.
#pragma once

#include "raster/primitive/draw_sorted.hpp"

namespace spangle::raster {

template <class P>
SPANGLE_INLINE void draw_triangle_of(const DrawState& state, const Surface& target,
                                     const typename P::Vertex& a, const typename P::Vertex& b,
                                     const typename P::Vertex& c, const typename P::Vertex& provoking,
                                     std::int64_t area2) {
    detail::Corner low(a), middle(b), high(c);
    detail::sort(low, middle, high, area2);
    std::int32_t least = low.x < middle.x ? low.x : middle.x, most = low.x < middle.x ? middle.x : low.x;
    least = high.x < least ? high.x : least;
    most = high.x > most ? high.x : most;
    const auto sorted = [&] { return detail::Sorted<typename P::Vertex>{low, middle, high, area2}; };

    detail::observe(state, {low.vertex, middle.vertex, high.vertex});
    Pen<P> pen(state, target);
    const std::int32_t left = first_center(least), right = first_center(most);
    if (state.nothing && !keep(state, Primitive::Shape::triangle, 0, nullptr, provoking, a, b, c))
        return;
    if (!pen.reaches_scissor(left, right))
        return;
    detail::draw_sorted(pen, sorted(), provoking, {left, right, most - least});
}

} // namespace spangle::raster
