// The memory a context draws into: colour, depth and stencil planes, and the record of what was touched.
#pragma once

#include <cstdint>

#include <spangle/format.hpp>
#include <spangle/raster/features.hpp>

namespace spangle::raster {

/// The multisample buffer of a surface, which is private to the rasterizer.
struct Samples; // defined in raster/surface/samples.hpp

/// Row y of GL window space (y up, row 0 at the bottom) starts at `plane + y * stride`; a surface stored top
/// row first has a negative stride. Planes may be null when their format says none. Rows of mono are stored
/// by pages of eight, of which `color` is the lowest: row y lies in page y / 8, bit 7 - y % 8.
struct Surface {
    /// The colour plane at GL row 0. The planes must stay while anything draws on the surface.
    std::uint8_t* color = nullptr;
    /// The plane of depth and stencil at GL row 0; null: there is none.
    std::uint8_t* depth = nullptr;
    std::int32_t color_stride = 0; ///< bytes from GL row y to y + 1
    std::int32_t depth_stride = 0; ///< bytes from GL row y to y + 1
    std::int16_t* accum = nullptr; ///< RGBA, k / 32767, from GL row 0 on without gaps; null: there is none
#if SPANGLE_EXTENTS
    RowExtents* extents = nullptr; ///< touched rows and full clears; null: not kept
    RowSpan* touched = nullptr;    ///< the element for GL row 0; null: touched rows are not kept
    std::int32_t touched_step = 0; ///< +1 or -1 elements from GL row y to y + 1
#else
    /// Null: builds without SPANGLE_EXTENTS do not record what was touched.
    static constexpr RowExtents* extents = nullptr;
    /// Null: builds without SPANGLE_EXTENTS have no such elements.
    static constexpr RowSpan* touched = nullptr;
    /// 0: `touched` has no elements in builds without SPANGLE_EXTENTS.
    static constexpr std::int32_t touched_step = 0;
#endif
    /// The size in pixels.
    std::int32_t width = 0, height = 0;
#if SPANGLE_FEATURE_BANDS
    /// The GL rows [first_row, end_row) that a [band](docs/glossary.md#band) holds. Pointers are those that
    /// row 0 would have.
    std::int32_t first_row = 0, end_row = INT32_MAX;
#else
    /// All rows: there are no bands in this build.
    static constexpr std::int32_t first_row = 0, end_row = INT32_MAX;
#endif
    /// The format of the colour plane.
    PixelFormat format = PixelFormat::rgb565_be;
    /// The format of the depth plane.
    DepthFormat depth_format = DepthFormat::none;
#if SPANGLE_FEATURE_MULTISAMPLE
    const Samples* samples = nullptr; ///< the multisample buffer of GL's surfaces that have one
#else
    /// Null: builds without multisampling have no multisample buffer.
    static constexpr const Samples* samples = nullptr;
#endif

    /// The pixels that the surface holds.
    constexpr Rect area() const {
        const std::int32_t end = end_row < height ? end_row : height;
        return {0, first_row, width, end - first_row};
    }
    /// The stored row of GL row y. The eight rows of a page of PixelFormat::mono are one stored row.
    std::uint8_t* color_row(std::int32_t y) const {
        return color +
               static_cast<std::intptr_t>(drawn(format) == PixelFormat::mono ? y >> 3 : y) * color_stride;
    }
    /// The depths of GL row y.
    std::uint8_t* depth_row(std::int32_t y) const {
        return depth + static_cast<std::intptr_t>(y) * depth_stride;
    }
};

} // namespace spangle::raster
