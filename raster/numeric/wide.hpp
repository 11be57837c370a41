// Numbers of 61 bits with their own exponent, for clipping. There, coordinates that differ by any power of
// two meet (GL 1.3, 2.11), and the result of a sum may be far smaller than its terms.
#pragma once

#include <cstdint>

#include "raster/numeric/block.hpp"
#include "raster/numeric/block_matrix.hpp"
#include "raster/numeric/products.hpp"

namespace spangle::numeric {

/// m 2^e with 2^60 <= |m| < 2^61; 0 is {0, 0}. Rounding is towards 0, so that signs do not matter.
struct Wide {
    std::int64_t m = 0;
    std::int32_t e = 0;
};

/// v 2^e.
SPANGLE_RUN_CALL constexpr Wide make_wide(std::int64_t v, std::int32_t e) {
    if (v == 0)
        return {};
    const std::uint64_t magnitude = abs_u64(v);
    const int up = clz64(magnitude) - 3;
    const auto m =
        static_cast<std::int64_t>(up >= 0 ? magnitude << (up & 63) : magnitude >> (-up & 63)); // |up| < 64
    return {v < 0 ? -m : m, e - up};
}
constexpr Wide make_wide(Block v) {
    return make_wide(v.m, v.e);
}

constexpr Wide negate(Wide v) {
    return {-v.m, v.e};
}
/// v 2^n.
constexpr Wide scale(Wide v, int n) {
    return {v.m, v.m == 0 ? 0 : v.e + n};
}
constexpr Wide abs(Wide v) {
    return {v.m < 0 ? -v.m : v.m, v.e};
}

/// a b, within 2^-59 of the product. It is exact where the product has at most 60 bits.
SPANGLE_RUN_CALL constexpr Wide mul(Wide a, Wide b) {
    const auto high = static_cast<std::int64_t>(mul_u64(abs_u64(a.m) << 3, abs_u64(b.m)).high);
    return make_wide((a.m < 0) != (b.m < 0) ? -high : high, a.e + b.e + 61);
}

/// a + b, within 2^-60 of the larger term. It is exact where exponents differ by at most 1, and only then can
/// the sum be much smaller than both terms.
SPANGLE_RUN_CALL constexpr Wide add(Wide a, Wide b) {
    if (a.m == 0 || b.m == 0)
        return a.m == 0 ? b : a;
    const bool b_is_large = b.e > a.e;
    const Wide large = b_is_large ? b : a, small = b_is_large ? a : b;
    const std::int32_t apart = large.e - small.e;
    if (apart > 61)
        return large;
    const auto part = static_cast<std::int64_t>(abs_u64(small.m) << 1 >> apart);
    return make_wide(2 * large.m + (small.m < 0 ? -part : part), large.e - 1);
}
constexpr Wide sub(Wide a, Wide b) {
    return add(a, negate(b));
}

/// Whether a < b, without any rounding.
SPANGLE_RUN_CALL constexpr bool less(Wide a, Wide b) {
    const bool a_negative = a.m < 0, b_negative = b.m < 0;
    if (a_negative != b_negative || a.m == 0 || b.m == 0 || a.e == b.e)
        return a.m < b.m;
    return (a.e < b.e) != a_negative;
}

/// 1/v within 2^-57, for a v that is not 0.
SPANGLE_RUN_CALL constexpr Wide reciprocal(Wide v) {
    const std::uint32_t r = reciprocal(static_cast<std::uint32_t>(abs_u64(v.m) >> 29)); // 2^62 / its top word
    const Wide near = make_wide(v.m < 0 ? -std::int64_t{r} : std::int64_t{r}, -91 - v.e);
    return add(near, mul(near, sub(make_wide(1, 0), mul(near, v))));
}

/// Four Wide numbers whose exponents are limited to those of blocks. A smaller number becomes 0. A larger
/// number gets the largest exponent.
struct Wide4 {
    std::int64_t m[4] = {};
    std::int16_t e[4] = {};

    constexpr Wide operator[](int i) const { return {m[i], e[i]}; }
    constexpr void set(int i, Wide v) {
        m[i] = v.e < -16384 ? 0 : v.m;
        e[i] = static_cast<std::int16_t>(m[i] == 0 ? 0 : v.e > 16383 ? 16383 : v.e);
    }
};

/// The matrix a times v. Each row is exact to 60 bits of its largest term.
[[gnu::noinline]] constexpr Wide4 transform_wide(const BlockMatrix& a, const Real (&v)[4]) {
    Wide4 out;
    for (int i = 0; i < 4; ++i) {
        Wide sum;
        for (int j = 0; j < 4; ++j) {
            const detail::Scaled s = detail::scaled(v[j]);
            sum = add(sum, make_wide(mul_s32(a.m[4 * i + j], s.m), a.row[i] + a.column.e[j] - 31 + s.e));
        }
        out.set(i, sum);
    }
    return out;
}
/// The dot product of a plane and a point.
[[gnu::noinline]] constexpr Wide dot(const Block4& a, const Wide4& v) {
    Wide sum;
    for (int i = 0; i < 4; ++i)
        sum = add(sum, mul(make_wide(a.m[i], a.e), v[i]));
    return sum;
}

/// Converts to block form, whose mantissas are 32-bit words.
constexpr Block to_block(Wide v) {
    return make_block(v.m, v.e);
}
constexpr Block4 to_block(const Wide4& v) {
    return to_block(to_block(v[0]), to_block(v[1]), to_block(v[2]), to_block(v[3]));
}

} // namespace spangle::numeric
