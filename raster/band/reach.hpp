// The rows of a picture that a primitive in window space reaches.
#pragma once

#include <cstdint>

#include "raster/primitive/edge.hpp"
#include "raster/primitive/keep.hpp"
#include "raster/primitive/point.hpp"
#include "raster/span/vertex.hpp"

namespace spangle::raster {

struct Reach {
    std::int32_t low, high; ///< rows [low, high)
};

/// The y of the lowest and of the highest corner, in subpixels, as a range of rows.
inline Reach corners_of(const Primitive& p) {
    Reach y = {p.corner[0]->y, p.corner[0]->y};
    for (int i = 1; i < p.corners; ++i) {
        y.low = p.corner[i]->y < y.low ? p.corner[i]->y : y.low;
        y.high = p.corner[i]->y > y.high ? p.corner[i]->y : y.high;
    }
    return y;
}

/// The rows in which fragments of a primitive may lie: its coordinates plus half of its size, rounded
/// outwards. The rows are right for every sample to which the primitive is moved.
inline Reach reach(const Primitive& p) {
    const Reach y = corners_of(p);
    const bool smooth = p.shape >= Primitive::Shape::smooth_point;
    // Two rows are added, because corners may be snapped to fragments, and because rectangles of lines reach
    // beyond their ends.
    const std::int32_t aside = (smooth ? (p.size + 7) / 8 : p.size) + 2;
    return {(y.low >> subpixel_bits) - aside, (y.high >> subpixel_bits) + 1 + aside};
}

/// The rows in which fragments of a primitive lie, if it is not moved to samples. A triangle has fragments in
/// rows whose centres it may hold (GL 1.3, 3.5.1). A point has fragments in the rows of its square.
inline Reach exact_reach(const Primitive& p) {
    if (p.shape == Primitive::Shape::point) {
        const std::int32_t low = point_begin(p.corner[0]->y, p.size);
        return {low, low + p.size};
    }
    if (p.shape != Primitive::Shape::triangle)
        return reach(p);
    const Reach y = corners_of(p);
    return {first_center(y.low), first_center(y.high)};
}

} // namespace spangle::raster
