// Makes trapezoids of a triangle. They stand for the rows of edge.hpp, without a list of rows.
#pragma once

#include "raster/primitive/edge.hpp"
#include "raster/span/trapezoids.hpp"

namespace spangle::raster {

/// Makes the trapezoids of rows [begin, end), begin < end. Corners are sorted upwards and lie within
/// SmallEdge::extent.
SPANGLE_INLINE Trapezoids make_trapezoids(const std::int32_t (&xs)[3], const std::int32_t (&ys)[3],
                                          bool middle_left, std::int32_t begin, std::int32_t end) {
    const auto edge = [&](int from, int to, std::int32_t row) {
        return SmallEdge::at(xs[from], ys[from], xs[to], ys[to], row).side();
    };
    const auto part = [&](std::int32_t stop, const Trapezoids::Side& whole, const Trapezoids::Side& half) {
        return middle_left ? Trapezoids::Part{stop, half, whole} : Trapezoids::Part{stop, whole, half};
    };
    const std::int32_t corner = first_center(ys[1]), high = corner < end ? corner : end,
                       middle = high < begin ? begin : high;
    const Trapezoids::Side whole = edge(0, 2, begin);
    Trapezoids shape{begin, {}};
    shape.part[0] = shape.part[1] = {middle, whole, whole};
    if (begin < middle)
        shape.part[0] = part(middle, whole, edge(0, 1, begin));
    if (middle < end)
        shape.part[1] = part(end, whole.after(middle - begin), edge(1, 2, middle));
    return shape;
}

} // namespace spangle::raster
