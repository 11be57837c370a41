// Sine and cosine of degrees and unit vectors in Q4.60, for matrices that programs accumulate: rotating a
// million times by the same matrix multiplies its error by a million.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "raster/numeric/block.hpp"
#include "raster/numeric/q60.hpp"

namespace spangle::numeric {

/// Q4.60, within 2^-57.
struct SinCos {
    std::int64_t sin, cos;
};

namespace detail {

/// 1 / (k (k + 1)), k = 1 to 18. No division is left, which small processors would call a library for.
inline constexpr auto series_factors = [] {
    std::array<std::int64_t, 18> factor{};
    for (std::int64_t k = 1; k <= 18; ++k)
        factor[static_cast<std::size_t>(k - 1)] = q60_one / (k * (k + 1));
    return factor;
}();

/// 1 - z/(n(n+1)) (1 - z/((n+2)(n+3)) (...)): sin(x)/x for n = 2, cos(x) for n = 1, with z = x^2. Nine terms
/// leave (pi/4)^20 / 20! < 2^-67.
constexpr std::int64_t alternating_series(std::int64_t z, std::size_t n) {
    std::int64_t sum = q60_one;
    for (std::size_t k = n + 18; k != n;) {
        k -= 2;
        sum = q60_one - mul_q60(mul_q60(z, series_factors[k - 1]), sum);
    }
    return sum;
}

/// A full turn removed exactly: quadrant, and fraction * 2^-fraction_bits degrees in [0, 90).
struct ReducedAngle {
    std::uint32_t quadrant;
    std::uint32_t fraction;
    std::int32_t fraction_bits;
};

constexpr ReducedAngle reduce_degrees(Unpacked u) {
    if (u.exponent >= 0) { // an integer m * 2^e, e <= 104
        std::uint32_t degrees = u.mantissa % 360;
        for (std::int32_t i = 0; i < u.exponent; ++i)
            degrees = degrees * 2 % 360;
        return {degrees / 90, degrees % 90, 0};
    }
    const std::int32_t bits = -u.exponent;
    const std::uint32_t whole = bits > 31 ? 0 : u.mantissa >> bits;
    const std::uint32_t part = bits > 31 ? u.mantissa : u.mantissa - (whole << bits);
    const std::uint32_t degrees = whole % 360;
    return {degrees / 90, bits > 31 ? part : ((degrees % 90) << bits) + part, bits};
}

} // namespace detail

/// Exact at multiples of 90 degrees; any finite argument.
constexpr SinCos sincos_degrees(Real degrees) {
    const detail::Unpacked u = detail::unpack(degrees);
    const detail::ReducedAngle r = detail::reduce_degrees(u);
    // Q56 degrees: below 90 * 2^56 < 2^63.
    const std::uint64_t turn = std::uint64_t{90} << 56;
    const std::uint64_t t = r.fraction_bits <= 56 ? std::uint64_t{r.fraction} << (56 - r.fraction_bits)
                                                  : shift_right_even(r.fraction, r.fraction_bits - 56);
    const bool swap = t > turn / 2;
    constexpr std::uint64_t radians_per_degree_q68 = 0x477D1A894A74E457; // pi / 180 * 2^68
    const auto x =
        static_cast<std::int64_t>(mul_u64(swap ? turn - t : t, radians_per_degree_q68).high); // Q60, <= pi/4
    const std::int64_t z = mul_q60(x, x);
    const std::int64_t s = mul_q60(x, detail::alternating_series(z, 2)), c = detail::alternating_series(z, 1);
    SinCos a = swap ? SinCos{c, s} : SinCos{s, c};
    if (r.quadrant == 1)
        a = {a.cos, -a.sin};
    if (r.quadrant == 2)
        a = {-a.sin, -a.cos};
    if (r.quadrant == 3)
        a = {-a.cos, a.sin};
    return {u.negative ? -a.sin : a.sin, a.cos};
}

struct Unit3Q60 {
    std::int64_t m[3];
};

/// v / |v| in Q4.60, each component within 2^-57; (0, 0, 0) stays.
constexpr Unit3Q60 normalize_q60(const Block3& v) {
    const auto square = static_cast<std::uint64_t>(mul_s32(v.m[0], v.m[0]) + mul_s32(v.m[1], v.m[1]) +
                                                   mul_s32(v.m[2], v.m[2])); // 0, or 2^58 .. 2^61.6
    if (square == 0)
        return {{0, 0, 0}};
    const int zeros = clz64(square) & ~1;    // 2 or 4
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
