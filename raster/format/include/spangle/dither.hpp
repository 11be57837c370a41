// Ordered dithering: the rasterizer's and the display's, where a [wire](docs/glossary.md#wire) format has
// fewer bits than the surface (docs/architecture/numbers.md, "Colours").
#pragma once

#include <cstdint>

namespace spangle {

namespace detail {
inline constexpr std::uint32_t dither_rows[4] = {0x15'05'11'01, 0x0D'1D'09'19, 0x13'03'17'07, 0x0B'1B'0F'1F};
}

/// Thresholds t = (k + 1/2) / 16 of a 4x4 ordered matrix, one row of four as bytes 2k + 1 (32nds of a step).
/// Byte x & 3 belongs to window column x.
constexpr std::uint32_t dither_row(std::int32_t y) {
    return detail::dither_rows[static_cast<std::uint32_t>(y) & 3];
}

/// The threshold of window column `x` in a row of dither_row(), in 32nds of a step: odd, 1 to 31.
constexpr std::uint32_t dither_threshold(std::uint32_t row, std::int32_t x) {
    return (row >> (8 * (static_cast<std::uint32_t>(x) & 3))) & 0xFF;
}

/// floor(v / Max) for v < 2^14: m = ceil(2^22 / Max) and v (m Max - 2^22) < 2^22. Small cores cannot divide.
template <std::uint32_t Max> constexpr std::uint32_t divide_by(std::uint32_t v) {
    return v * (((1u << 22) + Max - 1) / Max) >> 22;
}

/// floor(k / Max (2^Bits - 1) + threshold / 32).
template <unsigned Bits, std::uint32_t Max>
constexpr std::uint32_t dithered_step(std::uint32_t k, std::uint32_t threshold) {
    return divide_by<Max>(k * ((1u << Bits) - 1) + (threshold * Max >> 5));
}

/// Luma of 8-bit components, in tenths as the kernel's drivers have it (drm_fb_xrgb8888_to_gray8).
constexpr std::uint32_t luma(std::uint32_t r, std::uint32_t g, std::uint32_t b) {
    return (3 * r + 6 * g + b) * 6554 >> 16; // divides by 10, exactly for sums below 16384
}

} // namespace spangle
