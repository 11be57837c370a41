// Pixels of the framebuffer as groups, before pixel transfer (GL 1.3, 4.3.2).
#pragma once

#include <bit>

#include "gl/pixel/group.hpp"
#include "raster/surface/pixel.hpp"

namespace spangle::gl {

/// k / max, max = 2^bits - 1.
constexpr Component fraction(std::uint32_t k, std::uint32_t max) {
    return {k, static_cast<std::uint8_t>(std::bit_width(max))};
}

inline Pixel fetch_color(const raster::Surface& surface, std::int32_t x, std::int32_t y) {
    const raster::StoredColor stored = raster::read_color(surface, x, y);
    Pixel pixel;
    for (int i = 0; i < 4; ++i)
        pixel.value[i] = fraction(stored.c[i].k, stored.c[i].max);
    return pixel;
}

/// Behind pixel transfer; an index becomes a colour by the maps (GL 1.3, 4.3.2).
inline Pixel transferred_color(const raster::Surface& surface, const Transfer& transfer, std::int32_t x,
                               std::int32_t y) {
    if (raster::drawn_indexed(surface.format))
        return transfer.color_of(whole_index(raster::read_index(surface, x, y)));
    Pixel pixel = fetch_color(surface, x, y);
    transfer.apply(pixel);
    return pixel;
}

inline Component fetch_depth(const raster::Surface& surface, std::int32_t x, std::int32_t y) {
    const raster::StoredDepth stored = raster::read_depth(surface, x, y);
    return fraction(stored.k, stored.max);
}

} // namespace spangle::gl
