// The two units of the fixed policy: what 1.0 is.
#pragma once

#include <cstdint>

namespace spangle::raster {

/// Colours are 255ths with 20 fraction bits, so 8-bit colours are exact integers.
inline constexpr int color_fraction_bits = 20;
/// Full intensity, 255 * 2^20.
inline constexpr std::uint32_t color_one = 255u << color_fraction_bits;

/// Depth is Q0.30.
inline constexpr std::uint32_t depth_one = 1u << 30;

} // namespace spangle::raster
