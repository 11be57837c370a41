// Rows of RGB565, little-endian, as the pixel formats that GUD devices take. Components that keep fewer bits
// are dithered as GL dithers, in window coordinates, so that equal pictures are sent as equal bytes.
#pragma once

#include <cstddef>
#include <cstdint>

namespace spangle::hal::gud {

enum Format : std::uint8_t {
    R1 = 0x01, ///< eight pixels in a byte, the left one in the highest bit
    R8 = 0x08,
    XRGB1111 = 0x20, ///< two pixels in a byte, the left one in the high nibble
    RGB332 = 0x30,
    RGB565 = 0x40,
    RGB888 = 0x50,   ///< bytes in the order B, G, R
    XRGB8888 = 0x80, ///< bytes in the order B, G, R, X
    ARGB8888 = 0x81,
};

/// The format of `offered` that loses least of RGB565 and then takes the fewest bytes, or 0.
std::uint8_t best_format(const std::uint8_t* offered, std::size_t count);
std::uint32_t bits_per_pixel(std::uint8_t format);
/// Pixels that share a byte: rectangles begin at their multiples.
std::uint32_t pixels_per_byte(std::uint8_t format);
std::size_t row_bytes(std::uint8_t format, std::uint32_t width);
/// Converts `width` pixels of a row. `x`: the first pixel's column in the window; `y`: the row, from the
/// bottom.
void convert_row(std::uint8_t format, const std::uint8_t* rgb565, std::int32_t x, std::int32_t y,
                 std::uint32_t width, std::uint8_t* to);

} // namespace spangle::hal::gud
