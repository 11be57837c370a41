// Aliased points: squares of whole size (GL 1.3, 3.3).
#pragma once

#include "raster/primitive/draw.hpp"
#include "raster/primitive/edge.hpp"
#include "raster/primitive/keep.hpp"
#include "raster/primitive/pen.hpp"

namespace spangle::raster {

/// The first column or row of a point. A point of odd size is centred on a fragment, and one of even size on
/// the corner that is nearest to v.
constexpr std::int32_t point_begin(std::int32_t v, std::int32_t size) {
    return (size & 1) != 0 ? (v >> subpixel_bits) - (size - 1) / 2
                           : ((v + subpixel_one / 2) >> subpixel_bits) - size / 2;
}

template <class P>
void draw_point_of(const DrawState& state, const Surface& target, const typename P::Vertex& v,
                   std::int32_t size) {
    observe_other(state);
    Pen<P> pen(state, target);
    const Position at = position(v);
    const std::int32_t left = point_begin(at.x, size), low = point_begin(at.y, size);
    std::int32_t y = low < pen.row_begin() ? pen.row_begin() : low;
    const std::int32_t top = low + size < pen.row_end() ? low + size : pen.row_end();
    if (state.nothing && !keep(state, Primitive::Shape::point, size, nullptr, v, v))
        return;
    if (y >= top || !pen.reaches_scissor(left, left + size))
        return;
    Setup<P>(pen.span, v);
    pen.begin();
    for (; y < top; ++y)
        pen.add(y, left, left + size);
    pen.flush();
}

} // namespace spangle::raster
