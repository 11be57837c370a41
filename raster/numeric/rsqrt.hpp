// 1/sqrt(a) by a table and Newton steps.
#pragma once

#include <cstdint>

#include "raster/numeric/bits.hpp"

namespace spangle::numeric {

namespace detail {

/// The largest x with x * x <= v. It is below twice `highest`, a power of two.
constexpr std::uint32_t integer_sqrt(std::uint64_t v, std::uint32_t highest = 1u << 31) {
    std::uint32_t root = 0;
    for (std::uint32_t bit = highest; bit != 0; bit >>= 1)
        if (std::uint64_t{root | bit} * (root | bit) <= v)
            root |= bit;
    return root;
}

/// 1/sqrt(a) in Q1.15 at the middle of the i-th 2^-9 of [1/4, 1), where a = (257 + 2i) / 1024.
constexpr std::uint16_t rsqrt_near(std::uint32_t i) {
    const std::uint32_t d = 257 + 2 * i, high = (1u << 31) / d;
    const std::uint64_t square =
        (std::uint64_t{high} << 11) + (((1u << 31) - high * d) << 11) / d; // 2^42 / d, which is 1/a in Q.32
    return static_cast<std::uint16_t>((integer_sqrt(square, 1u << 16) + 1) / 2); // 1/sqrt(a) in Q.16, halved
}
struct RsqrtTable {
    std::uint16_t at[384];
    constexpr RsqrtTable() : at{} {
        for (std::uint32_t i = 0; i < 384; ++i)
            at[i] = rsqrt_near(i);
    }
};
inline constexpr RsqrtTable rsqrt_table;

SPANGLE_INLINE constexpr std::uint32_t rsqrt_seed(std::uint32_t i) {
    return has_seed_tables ? rsqrt_table.at[i] : rsqrt_near(i);
}

} // namespace detail

/// Bounds of the relative error, in tenths of a bit. Tests and proofs read these constants.
inline constexpr int rsqrt_1_accuracy = 173, rsqrt_accuracy = 299;

/// 1/sqrt(a) in Q2.30 by one Newton step. a in [2^30, 2^32) stands for [1/4, 1). The relative error is in
/// [-2^-17.3, 2^-29].
SPANGLE_INLINE constexpr std::uint32_t rsqrt_1(std::uint32_t a) {
    const std::uint32_t seed = detail::rsqrt_seed((a >> 23) - 128); // seed in Q1.15
    const std::uint32_t square = seed * seed;                       // square in Q2.30, exact
    const std::uint32_t product = mul_high_u32(a, square);          // product in Q2.30, near 1
    return mul_by_half(0xC0000000u - product, seed);                // seed * (3 - a seed^2) / 2
}

/// 1/sqrt(a) in Q2.30 by two Newton steps; the result in (2^30, 2^31] stands for (1, 2]. The relative error
/// is at most 2^-29.9.
SPANGLE_INLINE constexpr std::uint32_t rsqrt(std::uint32_t a) {
    const std::uint32_t r = rsqrt_1(a);
    const auto square = static_cast<std::uint32_t>((mul_u32(r, r) + (1u << 29)) >> 30); // Q2.30, <= 2^32 - 1
    const std::uint64_t product = mul_u32(a, square);                                   // Q.62, near 1
    // The residual in Q.48: Q.47 is halved.
    const auto residual =
        static_cast<std::int32_t>(static_cast<std::uint32_t>(((std::uint64_t{1} << 62) - product) >> 15));
    const std::int64_t step = // r < 2^31
        (mul_s32(static_cast<std::int32_t>(r), residual) + (std::int64_t{1} << 47)) >> 48;
    return r + static_cast<std::uint32_t>(step);
}

} // namespace spangle::numeric
