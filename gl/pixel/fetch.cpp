#include "gl/pixel/fetch.hpp"

#include <bit>

#include "raster/surface/pixel.hpp"

namespace spangle::gl {

namespace {

/// k / max, max = 2^bits - 1.
constexpr Component fraction(std::uint32_t k, std::uint32_t max) {
    return {k, static_cast<std::uint8_t>(std::bit_width(max))};
}

Pixel color_of(const raster::Surface& surface, const Transfer& transfer, std::int32_t x, std::int32_t y) {
    if (raster::drawn_indexed(surface.format))
        return transfer.color_of(whole_index(raster::read_index(surface, x, y)));
    const raster::StoredColor stored = raster::read_color(surface, x, y);
    Pixel pixel;
    for (int i = 0; i < 4; ++i)
        pixel.value[i] = fraction(stored.c[i].k, stored.c[i].max);
    transfer.apply(pixel);
    return pixel;
}

} // namespace

Group fetch(const raster::Surface& surface, const Transfer& transfer, Content content, std::int32_t x,
            std::int32_t y) {
    Group group;
    switch (content) {
    case Content::color:
        group.color = color_of(surface, transfer, x, y);
        break;
    case Content::depth: {
        const raster::StoredDepth stored = raster::read_depth(surface, x, y);
        group.color.value[0] = transfer.depth(fraction(stored.k, stored.max));
        break;
    }
    case Content::index:
        group.index = transfer.index(whole_index(raster::read_index(surface, x, y)));
        break;
    case Content::stencil:
        group.index = transfer.stencil(whole_index(raster::read_stencil(surface, x, y)));
        break;
    }
    return group;
}

} // namespace spangle::gl
