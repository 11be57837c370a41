// How a pixel lies in memory: packing, read-back, one pixel at a time. Speed is the span stages' business.
#pragma once

#include <cstdint>

#include "raster/surface/surface.hpp"

namespace spangle::raster {

/// A component as stored: k / max, exactly. Formats without alpha read 1 / 1 (GL 1.3, 4.3.2: A = 1).
struct Component {
    std::uint8_t k = 0, max = 1;
    friend constexpr bool operator==(const Component&, const Component&) = default;

    /// k / max as the nearest 255th.
    constexpr std::uint8_t to_8() const { return static_cast<std::uint8_t>((k * 255u + max / 2u) / max); }
};

struct StoredColor {
    Component c[4]; ///< red, green, blue, alpha
};

constexpr std::uint32_t pack_565(std::uint32_t r, std::uint32_t g, std::uint32_t b) {
    return r << 11 | g << 5 | b;
}

constexpr std::uint32_t swap_bytes_16(std::uint32_t v) {
    return (v >> 8 & 0xFF) | (v & 0xFF) << 8;
}

/// Bytes of one pixel, first byte in memory in bits 7..0. `k` has as many bits per component as the format.
constexpr std::uint32_t pack_pixel(PixelFormat format, const std::uint32_t k[4]) {
    switch (format) {
    case PixelFormat::rgb565_be:
        return swap_bytes_16(pack_565(k[0], k[1], k[2]));
    case PixelFormat::rgb565_le:
        return pack_565(k[0], k[1], k[2]);
    case PixelFormat::rgb888:
        return k[0] | k[1] << 8 | k[2] << 16;
    case PixelFormat::rgba8888:
        return k[0] | k[1] << 8 | k[2] << 16 | k[3] << 24;
    default:
        return 0; // narrow formats: pixels share bytes
    }
}

constexpr StoredColor unpack_pixel(PixelFormat format, std::uint32_t bytes) {
    const auto part = [](std::uint32_t v, std::uint32_t max) {
        return Component{static_cast<std::uint8_t>(v & max), static_cast<std::uint8_t>(max)};
    };
    switch (format) {
    case PixelFormat::rgb565_be:
        bytes = swap_bytes_16(bytes);
        [[fallthrough]];
    case PixelFormat::rgb565_le:
        return {{part(bytes >> 11, 31), part(bytes >> 5, 63), part(bytes, 31), {1, 1}}};
    case PixelFormat::rgb888:
        return {{part(bytes, 255), part(bytes >> 8, 255), part(bytes >> 16, 255), {1, 1}}};
    case PixelFormat::rgba8888:
        return {{part(bytes, 255), part(bytes >> 8, 255), part(bytes >> 16, 255), part(bytes >> 24, 255)}};
    default:
        return {};
    }
}

/// Reads pixel (x, y) in GL window coordinates, which must lie in the surface.
StoredColor read_color(const Surface& s, std::int32_t x, std::int32_t y);

/// Reads `count` pixels of row y from column x on.
void read_color_row(const Surface& s, std::int32_t x, std::int32_t y, std::int32_t count, StoredColor* out);

/// Stored depth k / max: max is 65535, 2^24 - 1, or 1 (with k = 0) without a depth plane.
struct StoredDepth {
    std::uint32_t k = 0, max = 1;
};
StoredDepth read_depth(const Surface& s, std::int32_t x, std::int32_t y);

/// Reads the stored index; 0 on a surface of colours.
std::uint8_t read_index(const Surface& s, std::int32_t x, std::int32_t y);

/// Reads the stored stencil value; 0 without a stencil plane.
std::uint8_t read_stencil(const Surface& s, std::int32_t x, std::int32_t y);

/// Writes stored components (0 .. 2^bits - 1 of the format; greys have red's) and records the pixel as
/// touched.
void write_color(const Surface& s, std::int32_t x, std::int32_t y, const std::uint32_t k[4]);

/// Writes the stencil value; the depth code of the pixel stays. Without a stencil plane nothing is written.
void write_stencil(const Surface& s, std::int32_t x, std::int32_t y, std::uint8_t value);

} // namespace spangle::raster
