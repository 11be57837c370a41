// Shifts that move a sample to the place of its pixel's centre.
#pragma once

#include "raster/numeric/bits.hpp"
#include "raster/span/vertex.hpp"
#include "raster/surface/samples.hpp"

namespace spangle::raster {

/// The way from a sample to the centre of its pixel, in 1/256 pixel.
constexpr Position to_center(unsigned sample) {
    constexpr std::int32_t center = subpixel_one / 2;
    return {center - sample_position[sample].x, center - sample_position[sample].y};
}

/// Moves a vertex or a position; attributes do not change.
template <class V> constexpr void shift(V& v, const Position& by) {
    const Position at = position(v);
    place(v, {at.x + by.x, at.y + by.y});
}

} // namespace spangle::raster
