// The rows of a picture that a primitive in window space reaches.
#pragma once

#include <cstdint>

#include "raster/primitive/edge.hpp"
#include "raster/primitive/keep.hpp"
#include "raster/span/vertex.hpp"

namespace spangle::raster {

struct Reach {
    std::int32_t low, high; ///< rows [low, high)
};

/// Rows that fragments of the primitive can lie in: coordinates, and half of its size, rounded outwards.
inline Reach reach(const Primitive& p) {
    std::int32_t low = p.corner[0]->y, high = low;
    for (int i = 1; i < p.corners; ++i) {
        low = p.corner[i]->y < low ? p.corner[i]->y : low;
        high = p.corner[i]->y > high ? p.corner[i]->y : high;
    }
    const bool smooth = p.shape >= Primitive::Shape::smooth_point;
    // Corners are snapped to fragments, rectangles reach beyond the ends of their lines.
    const std::int32_t aside = (smooth ? (p.size + 7) / 8 : p.size) + 2;
    return {(low >> subpixel_bits) - aside, (high >> subpixel_bits) + 1 + aside};
}

/// Rows whose centres a triangle may hold: it has fragments in no others (GL 1.3, 3.5.1).
inline Reach centers(const Primitive& triangle) {
    std::int32_t low = triangle.corner[0]->y, high = low;
    for (int i = 1; i < triangle.corners; ++i) {
        low = triangle.corner[i]->y < low ? triangle.corner[i]->y : low;
        high = triangle.corner[i]->y > high ? triangle.corner[i]->y : high;
    }
    return {first_center(low), first_center(high)};
}

} // namespace spangle::raster
