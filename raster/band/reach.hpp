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

/// The same of what is drawn where it lies, not moved to samples later: a triangle has fragments in rows
/// whose centres it may hold (GL 1.3, 3.5.1), a point in those of its square.
inline Reach exact_reach(const Primitive& p) {
    if (p.shape == Primitive::Shape::point) {
        const std::int32_t low = point_begin(p.corner[0]->y, p.size);
        return {low, low + p.size};
    }
    if (p.shape != Primitive::Shape::triangle)
        return reach(p);
    std::int32_t low = p.corner[0]->y, high = low;
    for (int i = 1; i < p.corners; ++i) {
        low = p.corner[i]->y < low ? p.corner[i]->y : low;
        high = p.corner[i]->y > high ? p.corner[i]->y : high;
    }
    return {first_center(low), first_center(high)};
}

} // namespace spangle::raster
