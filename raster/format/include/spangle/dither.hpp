// The thresholds of ordered dithering: the rasterizer's and the display's, where a wire format has fewer bits
// than the surface (docs/architecture.md, "Numbers").
#pragma once

#include <cstdint>

namespace spangle {

/// Thresholds t = (k + 1/2) / 16 of a 4x4 ordered matrix, one row of four as bytes 2k + 1 (32nds of a step).
/// Byte x & 3 belongs to window column x.
constexpr std::uint32_t dither_row(std::int32_t y) {
    constexpr std::uint32_t rows[4] = {0x15'05'11'01, 0x0D'1D'09'19, 0x13'03'17'07, 0x0B'1B'0F'1F};
    return rows[static_cast<std::uint32_t>(y) & 3];
}

constexpr std::uint32_t dither_threshold(std::uint32_t row, std::int32_t x) {
    return (row >> (8 * (static_cast<std::uint32_t>(x) & 3))) & 0xFF;
}

} // namespace spangle
