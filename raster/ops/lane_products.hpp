// High halves of products of words, four or eight at once. Hosts have instructions that multiply every second
// word of a vector.
#pragma once

#include <bit>
#include <cstdint>

#if defined(__AVX2__)
#include <immintrin.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#elif defined(__ARM_NEON)
#include <arm_neon.h>
#endif

#include "raster/ops/lane_words.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

namespace inner {

/// A vector of 64-bit words that has the size of `Vector`.
template <class Vector> struct LongsOf { using Type [[gnu::vector_size(sizeof(Vector))]] = std::uint64_t; };
template <class Vector> using Longs = typename LongsOf<Vector>::Type;

/// The products of words 0 and 2, 64 bits each; of eight words, also the products of words 4 and 6.
template <class Vector> SPANGLE_INLINE Longs<Vector> even_products(const Vector& a, const Vector& b) {
    // GCC 12 multiplies vectors of 64-bit words by three instructions. These intrinsics are one.
#if defined(__AVX2__)
    if constexpr (sizeof(Vector) == 32)
        return std::bit_cast<Longs<Vector>>(
            _mm256_mul_epu32(std::bit_cast<__m256i>(a), std::bit_cast<__m256i>(b)));
    else
#endif
#if defined(__SSE2__)
        return std::bit_cast<Longs<Vector>>(
            _mm_mul_epu32(std::bit_cast<__m128i>(a), std::bit_cast<__m128i>(b)));
#elif defined(__ARM_NEON)
    const auto low = [](const Vector& v) { return vmovn_u64(std::bit_cast<uint64x2_t>(v)); };
    return std::bit_cast<Longs<Vector>>(vmull_u32(low(a), low(b)));
#else
    return Longs<Vector>{std::uint64_t{a[0]} * b[0], std::uint64_t{a[2]} * b[2]};
#endif
}
/// The products of even words, as even_products() orders them, where both factors are signed.
template <class Vector> SPANGLE_INLINE Longs<Vector> even_products_signed(const Vector& a, const Vector& b) {
#if defined(__AVX2__)
    if constexpr (sizeof(Vector) == 32)
        return std::bit_cast<Longs<Vector>>(
            _mm256_mul_epi32(std::bit_cast<__m256i>(a), std::bit_cast<__m256i>(b)));
    else
#endif
    {
        // A negative word, taken as unsigned, is 2^32 too large.
        const auto more = (b & std::bit_cast<Vector>(lane_words::as_signed(a) >> 31)) +
                          (a & std::bit_cast<Vector>(lane_words::as_signed(b) >> 31));
        return even_products(a, b) - (std::bit_cast<Longs<Vector>>(more) << 32);
    }
}
/// Moves the odd words to the places of the even words. Big-endian hosts have no lanes.
template <class Vector> SPANGLE_INLINE Vector odd_words(const Vector& v) {
    return std::bit_cast<Vector>(std::bit_cast<Longs<Vector>>(v) >> 32);
}
/// Joins the high words of the products of even words and of odd words.
template <class Vector>
SPANGLE_INLINE Vector high_words(const Longs<Vector>& even, const Longs<Vector>& odd) {
    return std::bit_cast<Vector>((even >> 32) | (odd & 0xFFFFFFFF00000000u));
}

} // namespace inner

/// floor(a b / 2^32), word by word.
template <class Vector> SPANGLE_INLINE Vector lane_product_high(const Vector& a, const Vector& b) {
    return inner::high_words<Vector>(inner::even_products(a, b),
                                     inner::even_products(inner::odd_words(a), inner::odd_words(b)));
}
/// a b / 2^32 to the nearest, halves up, where a is below 2^31.
template <class Vector> SPANGLE_INLINE Vector lane_product_rounded(const Vector& a, const Vector& b) {
    constexpr std::uint64_t half = std::uint64_t{1} << 31;
    return inner::high_words<Vector>(inner::even_products(a, b) + half,
                                     inner::even_products(inner::odd_words(a), inner::odd_words(b)) + half);
}
/// floor(a b / 2^32), where a is signed and b is below 2^31.
template <class Vector> SPANGLE_INLINE Vector lane_product_high_signed(const Vector& a, const Vector& b) {
    // A negative word, taken as unsigned, is 2^32 too large.
    return lane_product_high(a, b) - (b & std::bit_cast<Vector>(lane_words::as_signed(a) >> 31));
}
/// This function and the next ones multiply the words of all eight lanes.
SPANGLE_INLINE LaneWords lane_product_high(const LaneWords& a, const LaneWords& b) {
    return LaneWords::mapped(
        [](const auto& v, const auto& w) __attribute__((always_inline)) { return lane_product_high(v, w); },
        a, b);
}
SPANGLE_INLINE LaneWords lane_product_rounded(const LaneWords& a, const LaneWords& b) {
    return LaneWords::mapped(
        [](const auto& v, const auto& w)
            __attribute__((always_inline)) { return lane_product_rounded(v, w); },
        a, b);
}
SPANGLE_INLINE LaneWords lane_product_high_signed(const LaneWords& a, const LaneWords& b) {
    return LaneWords::mapped(
        [](const auto& v, const auto& w)
            __attribute__((always_inline)) { return lane_product_high_signed(v, w); },
        a, b);
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
