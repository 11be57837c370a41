// Sine and cosine of degrees, and unit vectors, in Q4.60. They serve matrices that programs accumulate: a
// million rotations by the same matrix multiply its error by a million.
#pragma once

#include <cstdint>

#include "raster/numeric/block.hpp"
#include "raster/numeric/q60.hpp"

namespace spangle::numeric {

/// Sine and cosine in Q4.60, each within 2^-57.
struct SinCos {
    std::int64_t sin, cos;
};

namespace detail {

/// 1 / (k (k + 1)) for k = 1 to 18. Builds with seed tables look these numbers up, too, because small
/// processors would call a library for each division.
struct SeriesFactors {
    std::int64_t at[18];
    static constexpr std::int64_t of(std::uint32_t k) {
        return static_cast<std::int64_t>(divide(q60_one, k * (k + 1)).quotient);
    }
    constexpr SeriesFactors() : at{} {
        for (std::uint32_t k = 1; k <= 18; ++k)
            at[k - 1] = of(k);
    }
};
inline constexpr SeriesFactors series_factors;

/// 1 - z/(n(n+1)) (1 - z/((n+2)(n+3)) (...)): sin(x)/x for n = 2, cos(x) for n = 1, with z = x^2. Nine terms
/// leave (pi/4)^20 / 20! < 2^-67.
constexpr std::int64_t alternating_series(std::int64_t z, std::uint32_t n) {
    std::int64_t sum = q60_one;
    for (std::uint32_t k = n + 18; k != n;) {
        k -= 2;
        const std::int64_t factor = has_seed_tables ? series_factors.at[k - 1] : SeriesFactors::of(k);
        sum = q60_one - mul_q60(mul_q60(z, factor), sum);
    }
    return sum;
}

/// An angle without its full turns, which are taken off exactly: the quadrant, and degrees in [0, 90) in Q56,
/// below 2^63.
struct ReducedAngle {
    std::uint32_t quadrant;
    std::uint64_t degrees;
};

constexpr ReducedAngle reduce_degrees(Unpacked u) {
    const std::int32_t bits = u.exponent < 0 ? -u.exponent : 0, down = bits < 31 ? bits : 31;
    const std::uint32_t whole = u.mantissa >> down, part = u.mantissa - (whole << down);
    std::uint32_t degrees = whole % 360;
    for (std::int32_t i = 0; i < u.exponent; ++i) // an integer m * 2^e, e <= 104
        degrees = degrees * 2 % 360;
    return {degrees / 90, (std::uint64_t{degrees % 90} << 56) + shift_right_even(part, bits - 56)};
}

} // namespace detail

/// Sine and cosine of any finite angle; exact at multiples of 90 degrees.
constexpr SinCos sincos_degrees(Real degrees) {
    const detail::Unpacked u = detail::unpack(degrees);
    const detail::ReducedAngle r = detail::reduce_degrees(u);
    const std::uint64_t turn = std::uint64_t{90} << 56, t = r.degrees;
    const bool swap = t > turn / 2;
    constexpr std::uint64_t radians_per_degree_q68 = 0x477D1A894A74E457; // pi / 180 * 2^68
    const auto x =
        static_cast<std::int64_t>(mul_u64(swap ? turn - t : t, radians_per_degree_q68).high); // Q60, <= pi/4
    const std::int64_t z = mul_q60(x, x);
    const std::int64_t s = mul_q60(x, detail::alternating_series(z, 2)), c = detail::alternating_series(z, 1);
    const bool crosswise = swap != ((r.quadrant & 1) != 0);
    const std::int64_t sine = crosswise ? c : s, cosine = crosswise ? s : c;
    return {((r.quadrant & 2) != 0) != u.negative ? -sine : sine,
            ((r.quadrant + 1) & 2) != 0 ? -cosine : cosine};
}

struct Unit3Q60 {
    std::int64_t m[3];
};

/// v / |v| in Q4.60, each component within 2^-57. (0, 0, 0) stays as it is.
constexpr Unit3Q60 normalize_q60(const Block3& v) {
    const auto square = static_cast<std::uint64_t>(mul_s32(v.m[0], v.m[0]) + mul_s32(v.m[1], v.m[1]) +
                                                   mul_s32(v.m[2], v.m[2])); // 0, or 2^58 .. 2^61.6
    if (square == 0)
        return {{0, 0, 0}};
    const int zeros = clz64(square) & ~1;    // `zeros` is 2 or 4
    const std::uint64_t a = square << zeros; // [2^62, 2^64): [1/4, 1)
    const auto estimate =
        static_cast<std::int64_t>(std::uint64_t{rsqrt(static_cast<std::uint32_t>(a >> 32))} << 30);
    const std::int64_t product = mul_q60(mul_q60(estimate, estimate), static_cast<std::int64_t>(a >> 4));
    const std::int64_t y =
        mul_q60(estimate, (3 * q60_one - product) >> 1); // one Newton step: 2^-29.9 becomes 2^-59
    const int shift = 2 - zeros / 2;
    Unit3Q60 out{};
    for (int i = 0; i < 3; ++i)
        out.m[i] = mul_q60(v.m[i] * (std::int64_t{1} << 30), y) >> shift;
    return out;
}

} // namespace spangle::numeric
