// Numbers of 64 bits times a power of two, for any exponent.
#pragma once

#include <cstdint>

#include "raster/numeric/bits.hpp"

namespace spangle::raster {

/// v * 2^-n for any n. A right shift rounds to nearest, and a left shift is modulo 2^64.
SPANGLE_INLINE std::int64_t shift(std::int64_t v, int n) {
    if (n > 0)
        return n > 62 ? 0 : (numeric::times_two_to(v, 1 - n) + 1) >> 1;
    return n < -63 ? 0 : numeric::times_two_to(v, -n);
}

/// v 2^-n for any n. A right shift rounds down, which loses less than the last bit of an interpolant. A left
/// shift is modulo 2^64.
inline std::int64_t scaled(std::int64_t v, int n) {
    if (n >= 0)
        return numeric::times_two_to(v, -n);
    return shift(v, n);
}

/// m * 2^exponent with `fraction` fraction bits, saturated below 2^61.
[[gnu::noinline]] inline std::int64_t to_fixed(std::int64_t m, int exponent, int fraction) {
    const int up = exponent + fraction;
    if (up <= 0)
        return shift(m, -up < 62 ? -up : 62);
    constexpr std::int64_t limit = std::int64_t{1} << 61;
    if (m == 0)
        return 0;
    if (up >= numeric::clz64(numeric::abs_u64(m)) - 2)
        return m < 0 ? -limit : limit;
    return numeric::times_two_to(m, up);
}

} // namespace spangle::raster
