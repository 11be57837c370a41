// Describes the pixels of a surface to GL: its whole planes, or those of the open band.
#include "gl/egl/objects.hpp"

namespace spangle::egl {

namespace {

/// Returns the address that GL row 0 has in a plane. The plane begins with row `first` of `rows`, counted
/// from the top. The address is computed as an integer, because row 0 may lie outside of the plane of a band.
std::uint8_t* bottom_row(std::uint8_t* plane, std::int32_t first, std::int32_t rows, std::int32_t stride) {
    const auto way = static_cast<std::intptr_t>(rows - 1 - first) * stride;
    return reinterpret_cast<std::uint8_t*>(reinterpret_cast<std::intptr_t>(plane) + way);
}

#if SPANGLE_FEATURE_MULTISAMPLE

/// Returns the samples of the rows in memory. The top row comes first, as in the surface's own planes, so
/// that strides agree.
const raster::Samples& show_samples(Surface& surface, const Rect& rows) {
    const PixelFormat format = surface.config.drawn();
    const std::int32_t stride = row_bytes(format, surface.width),
                       top = (rows.y + rows.h - 1) / raster::drawn_info(format).rows;
    surface.samples.color = bottom_row(surface.sample_colors, 0, top + 1, stride);
    surface.samples.color_stride = -stride;
    surface.samples.unresolved = surface.unresolved - rows.y;
    return surface.samples;
}

#endif

} // namespace

void set_pixels(Surface& surface, raster::Surface& out) {
    out = {};
    const PixelFormat format = surface.config.drawn();
    out.format = format;
    out.depth_format = surface.config.depth;
    if (!surface.has_pixels())
        return; // the surface is empty: nothing is drawn to it or read from it
    const bool bands = surface.in_bands();
    const std::int32_t color_first = bands && surface.band.colors ? surface.band.first : 0,
                       first = bands ? surface.band.first : 0, rows = stored_rows(format, surface.height);
    out.width = surface.width;
    out.height = surface.height;
    out.color_stride = -surface.frame.stride; // memory holds the top row first
    out.color = bottom_row(surface.frame.pixels, color_first / raster::drawn_info(format).rows, rows,
                           surface.frame.stride);
#if SPANGLE_EXTENTS
    out.extents = surface.frame.extents;
    out.touched = out.extents != nullptr && out.extents->rows != nullptr
                      ? out.extents->rows + (surface.height - 1)
                      : nullptr;
    out.touched_step = -1;
#endif
    if (surface.depth != nullptr) {
        out.depth_stride = -surface.width * bytes_per_depth(surface.config.depth);
        out.depth = bottom_row(surface.depth, first, surface.height, -out.depth_stride);
    }
    out.accum = surface.accum;
    if (bands)
        show_band(surface, out);
#if SPANGLE_FEATURE_MULTISAMPLE
    if (surface.config.has_samples())
        out.samples = &show_samples(surface, out.area());
#endif
}

} // namespace spangle::egl
