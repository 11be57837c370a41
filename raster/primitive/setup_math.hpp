// Small integer forms that set-up shares among its files.
#pragma once

#include "raster/numeric/bits.hpp"

namespace spangle::raster {

/// Largest minus least.
SPANGLE_INLINE std::uint32_t range_of(std::int32_t a, std::int32_t b, std::int32_t c) {
    const std::int32_t low = a < b ? (a < c ? a : c) : (b < c ? b : c);
    const std::int32_t high = a > b ? (a > c ? a : c) : (b > c ? b : c);
    return static_cast<std::uint32_t>(high) - static_cast<std::uint32_t>(low);
}

/// v * 2^-n for any n, rounded to nearest on the way down, mod 2^64 on the way up.
SPANGLE_INLINE std::int64_t shift(std::int64_t v, int n) {
    if (n > 0)
        return n > 62 ? 0 : ((v >> (n - 1)) + 1) >> 1;
    return n < -63 ? 0 : static_cast<std::int64_t>(static_cast<std::uint64_t>(v) << -n);
}

/// a * b / 2^30, rounded.
SPANGLE_INLINE std::int32_t mul30(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>((std::int64_t{a} * b + (1 << 29)) >> 30);
}

} // namespace spangle::raster
