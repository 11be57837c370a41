// Logarithms of eight fragments at once. The integers are those of log2_fraction8(). The leading bits of a
// number become a float, which no rounding mode changes. The exponent and the mantissa of the float then take
// the place of leading zeros and a shift.
#pragma once

#include "raster/ops/lane_division.hpp"
#include "raster/ops/log2.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

namespace inner {

/// log2_fraction8() of 2^(exponent - bias) (1 + x). Each word has 16 bits of x below the exponent.
template <class Vector> SPANGLE_INLINE Vector log2_of_parts(const Vector& parts, std::uint32_t bias) {
    const Vector x = parts & 0xFFFFu;
    const Vector bulge = (x * (65536u - x)) >> 16, slope = 27700u - ((x * 10400u) >> 16);
    const Vector fraction = x + ((bulge * slope) >> 16);
    return (((parts >> 16) - bias) << 8) + ((fraction + 128u) >> 8);
}
/// The parts of 64-bit numbers in the form of log2_of_parts(). The parts of 0 are less than those of 1.
template <class Long> SPANGLE_INLINE Long parts_of(const Long& v) {
    using Doubles [[gnu::vector_size(sizeof(Long))]] = double;
    const Long beyond = ((v >> 53) + 0x7FFu) >> 11; // 1 where v has more than the 53 bits of a double
    const Long kept = v & ~((beyond << 11) - beyond);
    constexpr std::uint64_t two_52 = std::uint64_t{0x433} << 52, two_84 = std::uint64_t{0x453} << 52;
    // The exponents in `two_84` and `two_52` add this number to the value.
    constexpr double of_exponents = 0x1p84 + 0x1p52;
    const auto high = std::bit_cast<Doubles>((kept >> 32) | two_84) - of_exponents,
               low = std::bit_cast<Doubles>((kept & 0xFFFFFFFFu) | two_52);
    return (std::bit_cast<Long>(high + low) >> 36) & 0x7FFFFFFu; // a sum of 0 may be -0
}

/// log2_fraction8() of 64-bit numbers, where 0 counts as 1.
template <class Vector> SPANGLE_INLINE Vector lane_log2(const LongPair<Vector>& v) {
    constexpr std::uint32_t bias = 1023;
    const Vector parts = LongPair<Vector>{parts_of(v.even), parts_of(v.odd)}.low_words();
    const Vector less = lane_words::is_less(parts, Vector{} + (bias << 16));
    return log2_of_parts<Vector>((parts & ~less) | ((bias << 16) & less), bias);
}
/// log2_fraction8() of words from 1 to 2^31 - 1.
template <class Vector> SPANGLE_INLINE Vector lane_log2(const Vector& v) {
    const Vector beyond = ((v >> 24) + 0x7Fu) >> 7; // 1 where v has more bits than a float
    const Vector kept = v & ~((beyond << 7) - beyond);
    return log2_of_parts<Vector>(std::bit_cast<Vector>(to_floats(kept)) >> 7, 127);
}

/// level_of_detail() in lanes.
template <class Vector> SPANGLE_INLINE Vector lane_level_of_detail(const Vector& sum) {
    constexpr std::uint32_t lost = 3;
    static_assert(level_of_detail(lost) == 0 && level_of_detail(lost + 1) != 0);
    return sum & std::bit_cast<Vector>(sum + lost > 2 * lost);
}

template <class Vector> SPANGLE_INLINE Vector at_least_one(const Vector& v) {
    const auto positive = std::bit_cast<Vector>(lane_words::as_signed(v) > 0);
    return (v & positive) | (1u & ~positive);
}

/// The size of the derivative of v / q, times q^2, for the even words of all four vectors: |dv q - v dq|,
/// where dv and dq are the differences from pixel to pixel.
template <class Vector>
SPANGLE_INLINE Longs<Vector> even_derivative(const Vector& dv, const Vector& v, const Vector& dq,
                                             const Vector& q) {
    using Signed [[gnu::vector_size(sizeof(Vector))]] = std::int64_t;
    using Long = Longs<Vector>;
    const Long d = even_products_signed(q, dv) - even_products_signed(v, dq);
    const auto negative = std::bit_cast<Long>(std::bit_cast<Signed>(d) < 0);
    return (d ^ negative) - negative;
}
/// |dv q - v dq| (even_derivative()) for all words. Each word has differences of its own.
template <class Vector>
SPANGLE_INLINE LongPair<Vector> derivative(const Vector& dv, const Vector& v, const Vector& dq,
                                           const Vector& q) {
    return {even_derivative(dv, v, dq, q),
            even_derivative(odd_words(dv), odd_words(v), odd_words(dq), odd_words(q))};
}
/// |dv q - v dq| (even_derivative()) for all words. The differences dv and dq are the same for all words.
template <class Vector>
SPANGLE_INLINE LongPair<Vector> derivative(std::int32_t dv, const Vector& v, std::int32_t dq,
                                           const Vector& q) {
    const Vector by_q = Vector{} + static_cast<std::uint32_t>(dv),
                 by_v = Vector{} + static_cast<std::uint32_t>(dq);
    return {even_derivative(by_q, v, by_v, q), even_derivative(by_q, odd_words(v), by_v, odd_words(q))};
}
template <class Vector>
SPANGLE_INLINE LongPair<Vector> larger(const LongPair<Vector>& a, const LongPair<Vector>& b) {
    const auto one = [](const auto& v, const auto& w) __attribute__((always_inline)) {
        const auto more = std::bit_cast<std::remove_cvref_t<decltype(v)>>(v > w);
        return (v & more) | (w & ~more);
    };
    return {one(a.even, b.even), one(a.odd, b.odd)};
}

} // namespace inner

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
