// The two units of the fixed policy: what 1.0 is.
#pragma once

#include <cstdint>

namespace spangle::raster {

/// Colours are 255ths with 20 fraction bits, so 8-bit colours are exact integers.
inline constexpr int color_fraction_bits = 20;
inline constexpr std::uint32_t color_one = 255u << color_fraction_bits;

/// Depth is Q0.30.
inline constexpr std::uint32_t depth_one = 1u << 30;

/// Nearest code k of k / 65535: 1.0 stores as all ones (GL 1.3, 2.10.1).
constexpr std::uint32_t depth_to_16(std::uint32_t z) {
    return (z - (z >> 16) + (1u << 13)) >> 14;
}

/// Nearest code k of k / (2^24 - 1).
constexpr std::uint32_t depth_to_24(std::uint32_t z) {
    return (z - (z >> 24) + (1u << 5)) >> 6;
}

} // namespace spangle::raster
