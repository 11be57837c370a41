// What a pixel, a rectangle and a set of [touched rows](docs/glossary.md#touched-rows) are. Shapes only, no
// behaviour: the rasterizer, the HAL and the simulator agree on these and on nothing else.
#pragma once

#include <cstdint>

// Optional kinds of surfaces. CMake defines them; a build by hand has both.
#ifndef SPANGLE_FEATURE_NARROW_SURFACES
/// 1: this build draws on surfaces of PixelFormat::rgb666 to PixelFormat::mono.
#define SPANGLE_FEATURE_NARROW_SURFACES 1
#endif
#ifndef SPANGLE_FEATURE_COLOR_INDEX
/// 1: this build draws on surfaces of PixelFormat::index8.
#define SPANGLE_FEATURE_COLOR_INDEX 1
#endif

namespace spangle {

/// Layout of one pixel in memory and on the [wire](docs/glossary.md#wire), first byte first.
enum class PixelFormat : std::uint8_t {
    rgb565_be, ///< RRRRRGGG GGGBBBBB: what ILI9341, ST7789 and ST7735 take after COLMOD 55h.
    rgb565_le, ///< GGGBBBBB RRRRRGGG: a little-endian uint16_t.
    rgb888,    ///< R, G, B bytes.
    rgba8888,  ///< R, G, B, A bytes.
    // The next formats are narrow. Their pixels lie as controllers take them, and a separate stage draws them
    // (raster/surface/narrow.hpp).
    rgb666, ///< R, G, B bytes, the upper six bits of each.
    rgb444, ///< RRRRGGGG BBBBRRRR GGGGBBBB: two pixels in three bytes; a row begins with a byte.
    rgb332, ///< RRRGGGBB.
    grey4,  ///< Two pixels a byte, the left one in the high nibble.
    mono,   ///< Pages: a byte is eight pixels one above the other, the top one in bit 0.
    index8, ///< A byte a pixel: an index of a palette, which belongs to the display.
};

/// The layout of a pixel in numbers; see format_info().
struct FormatInfo {
    std::uint8_t bytes_per_pixel; ///< 0: pixels share bytes
    /// Bits of each component; grey has its bits in red, green and blue.
    std::uint8_t red_bits, green_bits, blue_bits, alpha_bits;
    std::uint8_t bits;           ///< bits that a stored row has for each column
    std::uint8_t rows = 1;       ///< rows of pixels that are stored as one row
    bool grey = false;           ///< red, green and blue are one component
    std::uint8_t index_bits = 0; ///< bits of a colour index; a format with an index has no components
};

namespace detail {
/// The table of format_info(). It is not a local constant of that function, because a table that is indexed
/// at run time would then be built on the stack.
inline constexpr FormatInfo formats[] = {{2, 5, 6, 5, 0, 16},         {2, 5, 6, 5, 0, 16},
                                         {3, 8, 8, 8, 0, 24},         {4, 8, 8, 8, 8, 32},
                                         {3, 6, 6, 6, 0, 24},         {0, 4, 4, 4, 0, 12},
                                         {1, 3, 3, 2, 0, 8},          {0, 4, 4, 4, 0, 4, 1, true},
                                         {0, 1, 1, 1, 0, 8, 8, true}, {1, 0, 0, 0, 0, 8, 1, false, 8}};
} // namespace detail

/// Bits and bytes of each format, indexed by PixelFormat.
constexpr const FormatInfo& format_info(PixelFormat format) {
    return detail::formats[static_cast<unsigned>(format)];
}
/// The number of pixel formats.
inline constexpr int pixel_formats = 10;

/// Whether the format is narrow. A build without narrow surfaces always answers false, so the code that only
/// they need is not compiled.
constexpr bool is_narrow(PixelFormat format) {
    return SPANGLE_FEATURE_NARROW_SURFACES && format > PixelFormat::rgba8888 && format < PixelFormat::index8;
}
/// Whether pixels are colour indices. It is false in builds without such surfaces.
constexpr bool is_indexed(PixelFormat format) {
    return SPANGLE_FEATURE_COLOR_INDEX && format == PixelFormat::index8;
}
/// Whether this build can draw on surfaces of this format.
constexpr bool is_drawable(PixelFormat format) {
    return format <= PixelFormat::rgba8888 || is_narrow(format) || is_indexed(format);
}

/// Bytes of a stored row of `width` pixels.
constexpr std::int32_t row_bytes(PixelFormat format, std::int32_t width) {
    return (width * format_info(format).bits + 7) / 8;
}
/// The stored rows of a picture of `height` rows. In mono format, eight rows are one stored row; in all
/// others each row is one.
constexpr std::int32_t stored_rows(PixelFormat format, std::int32_t height) {
    const std::int32_t rows = format_info(format).rows;
    return (height + rows - 1) / rows;
}

/// How depth, and with it stencil, lies in memory.
enum class DepthFormat : std::uint8_t {
    none,  ///< no depth buffer
    z16,   ///< uint16_t, host order, k / 65535.
    z24s8, ///< uint32_t, host order: depth k / (2^24 - 1) in bits 31..8, stencil in bits 7..0.
};

/// Half-open rectangle: x .. x+w-1, y .. y+h-1. Empty when w or h is <= 0.
struct Rect {
    /// The first column and the first row, and the numbers of columns and rows.
    std::int32_t x = 0, y = 0, w = 0, h = 0;
    friend constexpr bool operator==(const Rect&, const Rect&) = default;
};

/// Half-open interval of columns of one row; empty when begin >= end.
struct RowSpan {
    /// The first column.
    std::int16_t begin = INT16_MAX;
    /// The column behind the last one.
    std::int16_t end = 0;
    friend constexpr bool operator==(const RowSpan&, const RowSpan&) = default;
};

/// Columns touched in each row of a surface since its last present, in memory order (row 0 is the first row
/// in memory). The rasterizer widens them, the display reads and resets them. `rows` has `height` elements.
/// A full clear (no scissor, all channels) empties the rows and sets `cleared`: the rows then tell what was
/// drawn since.
struct RowExtents {
    /// The columns of each row; null: not kept. The memory is the display's.
    RowSpan* rows = nullptr;
    /// The number of elements of `rows`.
    std::int32_t height = 0;
    /// The surface was cleared as a whole since the last present.
    bool cleared = false;
    std::uint32_t clear_value = 0; ///< equal for two clears that give the same pixels
};

} // namespace spangle
