// The formats of pixels on the [wire](docs/glossary.md#wire), and the functions that convert a surface's
// pixels where its format differs.
#pragma once

#include <cstddef>
#include <cstdint>

#include <spangle/dither.hpp>
#include <spangle/format.hpp>
#include <spangle/hal/palette.hpp>

namespace spangle::hal {

/// Pixels as a controller takes them, first byte first. A new format goes before `none`, and to the same
/// place in the tables of wire_info() and format_code(). EGL_NATIVE_VISUAL_ID shows these numbers to
/// programs.
enum class WireFormat : std::uint8_t {
    rgb565, ///< RRRRRGGG GGGBBBBB: two bytes a pixel
    rgb666, ///< three bytes a pixel, each with a component in its upper six bits
    rgb444, ///< RRRRGGGG BBBBRRRR GGGGBBBB: two pixels in three bytes, which may lie in two rows
    rgb332, ///< RRRGGGBB
    grey4,  ///< two pixels of neighbouring memory columns, the first in the high nibble
    mono,   ///< eight pixels of neighbouring memory rows, the first in bit 0
    none,   ///< the surface's pixels travel as they are
};

/// How pixels of a wire format share bytes.
struct WireInfo {
    std::uint8_t bits;          ///< bits of a pixel
    std::uint8_t columns, rows; ///< pixels of memory that share a byte: windows end at multiples
};

/// The sizes of a wire format; all but the shared pixels are 0 for WireFormat::none.
constexpr WireInfo wire_info(WireFormat format) {
    constexpr WireInfo table[] = {{16, 1, 1}, {24, 1, 1}, {12, 1, 1}, {8, 1, 1},
                                  {4, 2, 1},  {1, 1, 8},  {0, 1, 1}};
    return table[static_cast<unsigned>(format)];
}

/// The wire format whose bytes a surface already holds.
constexpr WireFormat same_bytes(PixelFormat format) {
    switch (format) {
    case PixelFormat::rgb565_be:
        return WireFormat::rgb565;
    case PixelFormat::rgb888:
    case PixelFormat::rgb666:
        return WireFormat::rgb666;
    case PixelFormat::rgb444:
        return WireFormat::rgb444;
    case PixelFormat::rgb332:
        return WireFormat::rgb332;
    case PixelFormat::grey4:
        return WireFormat::grey4;
    case PixelFormat::mono:
        return WireFormat::mono;
    default:
        return WireFormat::none;
    }
}

/// A picture, top row first.
struct Picture {
    /// The first byte of the top row.
    const std::uint8_t* pixels = nullptr;
    /// Bytes from one row to the next one down.
    std::int32_t stride = 0;
    /// Rows of the picture. Dithering needs them, because GL's window coordinates count from the bottom.
    std::int32_t height = 0;
    /// The format of the pixels.
    PixelFormat format = PixelFormat::rgb565_be;
    bool sideways = false;            ///< the picture's rows run along the controller's memory columns
    const Palette* palette = nullptr; ///< the palette of a picture of PixelFormat::index8
};

/// Writes `area` of the picture, row by row, and returns the bytes it took. Colours between two steps of the
/// wire format are dithered in an ordered way, in GL window coordinates; steps stay. Where pixels share
/// bytes, the area must end where these do.
using Converter = std::size_t (*)(const Picture& picture, const Rect& area, std::uint8_t* to);

/// A wire format that differs from the surface's, and its conversion. Only those that a program names are
/// linked.
struct Wire {
    /// The format on the wire.
    WireFormat format = WireFormat::none;
    /// The function that writes the format; null where pixels travel as they are.
    Converter convert = nullptr;

    /// Whether pixels are converted.
    constexpr bool converts() const { return format != WireFormat::none; }
};

/// The Converter of wires::rgb565.
std::size_t to_rgb565(const Picture& picture, const Rect& area, std::uint8_t* to);
/// The Converter of wires::rgb666.
std::size_t to_rgb666(const Picture& picture, const Rect& area, std::uint8_t* to);
/// The Converter of wires::rgb444.
std::size_t to_rgb444(const Picture& picture, const Rect& area, std::uint8_t* to);
/// The Converter of wires::rgb332.
std::size_t to_rgb332(const Picture& picture, const Rect& area, std::uint8_t* to);
/// The Converter of wires::grey4: luma of 4 bits.
std::size_t to_grey4(const Picture& picture, const Rect& area, std::uint8_t* to);
/// The Converter of wires::mono: luma of one bit.
std::size_t to_mono(const Picture& picture, const Rect& area, std::uint8_t* to);

namespace wires {

/// 16 bits a pixel on the wire, for surfaces of another format.
inline constexpr Wire rgb565 = {WireFormat::rgb565, to_rgb565};
/// 24 bits a pixel on the wire, of which a controller uses 18.
inline constexpr Wire rgb666 = {WireFormat::rgb666, to_rgb666};
/// 12 bits a pixel on the wire.
inline constexpr Wire rgb444 = {WireFormat::rgb444, to_rgb444};
/// 8 bits a pixel on the wire.
inline constexpr Wire rgb332 = {WireFormat::rgb332, to_rgb332};
/// Greys of 4 bits, from colours.
inline constexpr Wire grey4 = {WireFormat::grey4, to_grey4};
/// Black and white, from colours.
inline constexpr Wire mono = {WireFormat::mono, to_mono};

} // namespace wires

} // namespace spangle::hal
