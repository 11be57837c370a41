// Converts depth from the unit of the fixed policy (Q0.30) to stored codes.
#pragma once

#include <cstdint>

#include <spangle/raster/units.hpp>

namespace spangle::raster {

/// The nearest code k of k / 65535. Depth 1.0 is stored as all ones (GL 1.3, 2.10.1).
constexpr std::uint32_t depth_to_16(std::uint32_t z) {
    return (z - (z >> 16) + (1u << 13)) >> 14;
}

/// The nearest code k of k / (2^24 - 1).
constexpr std::uint32_t depth_to_24(std::uint32_t z) {
    return (z - (z >> 24) + (1u << 5)) >> 6;
}

} // namespace spangle::raster
