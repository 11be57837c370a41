// Words of scaled(), by one form for all shifts.
#pragma once

#include "raster/primitive/scaled.hpp"

namespace spangle::raster {

/// Both words of scaled(v, n).
SPANGLE_INLINE std::uint64_t scaled_words(std::int64_t v, int n) {
    return static_cast<std::uint64_t>(scaled(v, n));
}

/// The low word of scaled(v, n).
SPANGLE_INLINE std::uint32_t scaled_word(std::int64_t v, int n) {
    return static_cast<std::uint32_t>(scaled(v, n));
}

/// Whether add_lifted() makes a plane. In small builds add_steep() makes every plane.
SPANGLE_INLINE bool fits_lifted(std::uint32_t, std::uint32_t) {
    return false;
}

} // namespace spangle::raster
