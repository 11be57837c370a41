// Powers of numbers in [0, 1], for specular and spot exponents and for fog: x^n = 2^(-n L) with L = -log2(x).
// A power is within 2^-21: the exponent 128 multiplies the error of log2 by 88. All tiers use these
// functions.
#pragma once

#include <cstdint>

#include "raster/numeric/bits.hpp"
#include "raster/numeric/q60.hpp"
#include "raster/numeric/real.hpp"

namespace spangle::numeric {

namespace detail {

inline constexpr std::uint32_t log2_e_q31 = 0xB8AA3B29; // 1 / ln 2

/// Q16 of 1 / x, where x is the middle of the i-th 64th of [1, 2).
constexpr std::uint32_t inverse_near(std::uint32_t i) {
    return ((1u << 24) / (129 + 2 * i) + 1) / 2; // 2^23 / (129 + 2i), rounded
}
/// For each 64th of [1, 2): inverse_near(), and log2 of its inverse in Q0.32.
struct Log2Table {
    std::uint32_t inverse[has_seed_tables ? 64 : 1];
    std::uint32_t log2[64];
    constexpr Log2Table() : inverse{}, log2{} {
        for (std::uint32_t i = 0; i < 64; ++i) {
            const std::uint32_t c = inverse_near(i);
            if constexpr (has_seed_tables)
                inverse[i] = c;
            log2[i] = 0u - fraction_of_log2(std::uint64_t{c} << (clz32(c) + 32));
        }
    }
    /// The fraction of log2(v / 2^63) in Q0.32, v >= 2^63. Squaring doubles a logarithm. Where the square
    /// reaches 2, the next bit of the fraction is 1.
    static constexpr std::uint32_t fraction_of_log2(std::uint64_t v) {
        std::uint64_t bits = 0;
        for (int i = 0; i < 33; ++i) {
            const std::uint64_t square = mul_u64(v, v).high; // square in Q2.62
            const bool carry = square >> 63 != 0;
            bits = bits << 1 | (carry ? 1u : 0u);
            v = carry ? square : square << 1;
        }
        return static_cast<std::uint32_t>((bits + 1) >> 1);
    }
};
inline constexpr Log2Table log2_table;

/// 2^(-i/64) in Q1.31.
struct Exp2Table {
    std::uint32_t at[64];
    constexpr Exp2Table() : at{} {
        constexpr std::int64_t ln2_q60 = 0x0B17217F7D1CF79A;
        for (std::int64_t i = 0; i < 64; ++i) {
            const std::int64_t y = i * (ln2_q60 / 64);
            // e^-y is 1 - y (1 - y/2 (1 - y/3 ...)). After 24 terms the error is below 0.7^24 / 24! < 2^-90.
            std::int64_t sum = q60_one;
            for (std::int64_t k = 24; k > 0; --k)
                sum = q60_one - mul_q60(y / k, sum);
            at[i] = static_cast<std::uint32_t>((sum + (1 << 28)) >> 29);
        }
    }
};
inline constexpr Exp2Table exp2_table;

/// -log2(x) for x = v / 2^30, 0 < v < 2^30, in Q5.32. The error is at most 2^-31.
SPANGLE_INLINE constexpr std::uint64_t minus_log2(std::uint32_t v) {
    const int zeros = clz32(v);         // >= 2
    const std::uint32_t a = v << zeros; // [1, 2) in Q1.31
    const std::uint32_t i = (a >> 25) & 63;
    const std::uint32_t c = has_seed_tables ? log2_table.inverse[i] : inverse_near(i);
    // r = a c - 1, |r| < 2^-6.9, Q0.38
    const auto r =
        static_cast<std::int32_t>(static_cast<std::int64_t>(mul_u32(a, c) - (std::uint64_t{1} << 47)) >> 9);
    // log2(1 + r) = r/ln2 (1 - r/2 + r^2/3 - r^3/4): the bracket in Q2.30.
    constexpr std::int32_t third = 0x15555555, quarter = 0x10000000; // 1/3 and 1/4 in Q0.30
    const std::int32_t tail = third - static_cast<std::int32_t>(mul_s32(r, quarter) >> 38);
    const std::int32_t half = (1 << 29) - static_cast<std::int32_t>(mul_s32(r, tail) >> 38);
    const std::int32_t bracket = (1 << 30) - static_cast<std::int32_t>(mul_s32(r, half) >> 38);
    const auto scaled =
        static_cast<std::int32_t>((mul_s32(bracket, static_cast<std::int32_t>(log2_e_q31 >> 1))) >> 30);
    const std::int64_t fraction =
        std::int64_t{log2_table.log2[i]} + (mul_s32(r, scaled) >> 36); // Q30 * Q38 -> Q32
    // x = a 2^(1 - zeros) in Q1.31 over 2^30: log2(x) = fraction + 1 - zeros
    const std::int64_t l = (static_cast<std::int64_t>(zeros - 1) << 32) - fraction;
    return static_cast<std::uint64_t>(l < 0 ? 0 : l);
}

} // namespace detail

/// 2^-q, q in Q8.24, the result in Q0.30 (1 is 2^30). The relative error is at most 2^-26.
SPANGLE_INLINE constexpr std::uint32_t exp2_neg(std::uint32_t q) {
    const std::uint32_t down = q >> 24;
    if (down > 30)
        return 0;
    constexpr std::uint32_t ln2_q32 = 0xB17217F8;                                   // ln 2, to the nearest
    const auto y = static_cast<std::uint32_t>(mul_u32(q & 0x3FFFF, ln2_q32) >> 24); // Q0.32, < 2^-6.5
    std::uint32_t fall = y;                                                         // 1 - e^-y
    fall -= mul_high_u32(y, y) >> 1;
    fall += mul_high_u32(mul_high_u32(y, y), y) / 6;
    const std::uint64_t product =
        mul_u32(detail::exp2_table.at[(q >> 18) & 63], 0x80000000u - (fall >> 1)); // product in Q2.62
    const std::uint32_t shift = 32 + down;
    return static_cast<std::uint32_t>(((product >> (shift - 1)) + 1) >> 1);
}

/// GL's exponents, 0 .. 128, in the form that pow_unit() takes: Q8.24, clamped.
constexpr std::uint32_t power_exponent(Real n) {
    const std::int32_t q = to_fixed(n, 23);
    return static_cast<std::uint32_t>(clamp<std::int32_t>(q, 0, 128 << 23)) << 1;
}

/// x^n. x and the result are in Q2.30, x is clamped to [0, 1], and n comes from power_exponent(). 0^0 is 1.
/// The result never falls where x rises. The error is at most 2^-21.
constexpr std::int32_t pow_unit(std::int32_t x, std::uint32_t exponent) {
    constexpr std::int32_t unit = 1 << 30;
    if (exponent == 0 || x >= unit)
        return unit; // 0^0 = 1 (GL 1.3, 2.1.1)
    if (x <= 0)
        return 0;
    const std::uint64_t l = detail::minus_log2(static_cast<std::uint32_t>(x));
    const std::uint64_t q = mul_u32(exponent, static_cast<std::uint32_t>(l >> 32)) +
                            ((mul_u32(exponent, static_cast<std::uint32_t>(l)) + (1u << 31)) >> 32);
    return q >> 32 != 0 ? 0 : static_cast<std::int32_t>(exp2_neg(static_cast<std::uint32_t>(q)));
}

} // namespace spangle::numeric
