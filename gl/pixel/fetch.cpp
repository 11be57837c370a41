#include "gl/pixel/fetch.hpp"

#include "raster/surface/pixel.hpp"

namespace spangle::gl {

namespace {

/// The component k / max, where max is 2^bits - 1.
constexpr Component fraction(std::uint32_t k, std::uint32_t max) {
    return {k, static_cast<std::uint8_t>(32 - numeric::clz32(max))};
}

void get_color(const raster::Surface& surface, const Transfer& transfer, std::int32_t x, std::int32_t y,
               Pixel& out) {
    if (raster::drawn_indexed(surface.format)) {
        out = transfer.color_of(whole_index(raster::read_index(surface, x, y)));
        return;
    }
    const raster::StoredColor stored = raster::read_color(surface, x, y);
    for (int i = 0; i < 4; ++i)
        out.value[i] = fraction(stored.c[i].k, stored.c[i].max);
    transfer.transfer_if_needed(out);
}

} // namespace

PixelGroup fetch(const raster::Surface& surface, const Transfer& transfer, Content content, std::int32_t x,
                 std::int32_t y) {
    PixelGroup group;
    if (content == Content::color) {
        get_color(surface, transfer, x, y, group.color);
    } else if (content == Content::depth) {
        const raster::StoredDepth stored = raster::read_depth(surface, x, y);
        group.color.value[0] = transfer.depth(fraction(stored.k, stored.max));
    } else if (raster::has_indices && content == Content::index) {
        group.index = transfer.index(whole_index(raster::read_index(surface, x, y)));
    } else {
        group.index = transfer.stencil(whole_index(raster::read_stencil(surface, x, y)));
    }
    return group;
}

} // namespace spangle::gl
