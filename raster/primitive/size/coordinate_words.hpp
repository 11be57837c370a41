// Texture and fog coordinates in words, by the forms that fit all of them.
#pragma once

#include "raster/primitive/setup_planes.hpp"

namespace spangle::raster {

/// m 2^exponent with 32 fraction bits, as to_fixed() makes it.
SPANGLE_RUN_INLINE std::int64_t to_repeats(std::int32_t m, int exponent) {
    return to_fixed(m, exponent, 32);
}

/// m 2^-down, rounded to nearest.
SPANGLE_INLINE std::int64_t to_fixed_below(std::int64_t m, int down) {
    return to_fixed(m, -down, 0);
}

/// Loads fog coordinates in units of 2^span.fog_exponent, which is 2^-24 where all of them fit s7.24.
SPANGLE_INLINE void Setup<Fixed>::load_fog(std::int32_t fog[3]) const {
    span_.fog_exponent = -24;
    load_any_fog(fog);
}

/// Does what add_steep() does for one coordinate.
[[gnu::noinline]] inline void Setup<Fixed>::add_words(Interpolant<std::uint32_t>& at, std::uint32_t first,
                                                      const std::int32_t v[3], int up) {
    add_steep(at, first, v[1] - v[0], v[2] - v[0], up);
}

} // namespace spangle::raster
