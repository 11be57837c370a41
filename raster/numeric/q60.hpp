// Q4.60: numbers near 1 with all the bits that a table or an accumulated matrix can use.
#pragma once

#include <cstdint>

#include "raster/numeric/bits.hpp"

namespace spangle::numeric {

inline constexpr std::int64_t q60_one = std::int64_t{1} << 60;

/// a * b, rounded to nearest, for |a|, |b| <= 4 and |a * b| < 8.
constexpr std::int64_t mul_q60(std::int64_t a, std::int64_t b) {
    const Product128 p = mul_u64(abs_u64(a), abs_u64(b));
    const auto r = static_cast<std::int64_t>((p.high << 4 | p.low >> 60) + (p.low >> 59 & 1));
    return (a < 0) != (b < 0) ? -r : r;
}

} // namespace spangle::numeric
