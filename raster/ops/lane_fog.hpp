// fog_factor() for eight fragments at once, with the same integers.
#pragma once

#include "raster/numeric/power.hpp"
#include "raster/ops/lane_division.hpp"
#include "raster/ops/lane_products.hpp"
#include "raster/span/instructions.hpp"
#include <spangle/raster/fragment_state.hpp>

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// numeric::exp2_neg() in lanes: 2^(-q / 2^24) with 30 fraction bits.
SPANGLE_INLINE LaneWords lane_exp2_neg(const LaneWords& q) {
    // This is ln 2 in Q0.32. Its product with Q24 is in Q0.32 after a shift by 24.
    constexpr std::uint32_t ln2_q24 = 0xB17217F8;
    // The fraction of a 64th has 18 bits. Shifted up by 8, its product has the bits of y in the high word.
    const LaneWords y = lane_product_high((q & 0x3FFFF) << 8, LaneWords::splat(ln2_q24)),
                    square = lane_product_high(y, y), cube = lane_product_high(square, y);
    // y is below 2^26, so its cube is below 2^14. In this range the product is a sixth, rounded down.
    const LaneWords sixth = (cube * 10923) >> 16;
    const LaneWords rest = 0x80000000u - ((y - (square >> 1) + sixth) >> 1);
    const LaneWords step = LaneWords::generate([&](std::uint32_t lane) __attribute__((always_inline)) {
        return numeric::detail::exp2_table.at[(q.lane(static_cast<int>(lane)) >> 18) & 63];
    });
    return LaneWords::mapped(
        [](const auto& of, const auto& by, const auto& exponent) __attribute__((always_inline)) {
            using Vector = std::remove_cvref_t<decltype(of)>;
            const Vector down = exponent >> 24,
                         product =
                             inner::LongPair<Vector>{
                                 inner::even_products(of, by) >> 31,
                                 inner::even_products(inner::odd_words(of), inner::odd_words(by)) >> 31}
                                 .low_words();
            const auto some = std::bit_cast<Vector>(down <= 30);
            return (((product >> (down & 31)) + 1) >> 1) & some;
        },
        step, rest, q);
}

/// fog_factor() in lanes.
SPANGLE_INLINE LaneWords lane_fog_factor(FogMode mode, const LaneWords& coordinate) {
    using L = Lanes<8>;
    if (mode == FogMode::linear)
        return L::minimum(L::positive(coordinate), L::splat32(1u << 24));
    if (mode == FogMode::exp)
        return lane_exp2_neg(L::positive(coordinate)) >> 6;
    const LaneWords square = LaneWords::mapped(
        [](const auto& v) __attribute__((always_inline)) {
            using Vector = std::remove_cvref_t<decltype(v)>;
            const auto sign = std::bit_cast<Vector>(lane_words::as_signed(v) >> 31);
            const Vector c = (v ^ sign) - sign, odd = inner::odd_words(c);
            const Vector low = inner::LongPair<Vector>{inner::even_products(c, c) >> 24,
                                                       inner::even_products(odd, odd) >> 24}
                                   .low_words();
            // A |c| of 16 or more (bit 28 of s7.24) has a square of 2^8 or more, which a word with 24
            // fraction bits cannot hold. Its word becomes all ones.
            return low | std::bit_cast<Vector>(c >> 28 != 0);
        },
        coordinate);
    return lane_exp2_neg(square) >> 6;
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
