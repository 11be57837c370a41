// Products of lanes for which hosts have an instruction that compilers do not find.
#pragma once

#include <bit>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#elif defined(__ARM_NEON)
#include <arm_neon.h>
#endif

#include "raster/span/lanes.hpp"

namespace spangle::raster {

namespace detail {

using LaneWords = Lanes<8>::Words;
using LaneLongs [[gnu::vector_size(16)]] = std::uint64_t;

/// The products of words 0 and 2, 64 bits each.
SPANGLE_INLINE LaneLongs even_products(const LaneWords& a, const LaneWords& b) {
#if defined(__SSE2__)
    // GCC 12 multiplies a vector of 64-bit words by three instructions; this is one.
    return std::bit_cast<LaneLongs>(_mm_mul_epu32(std::bit_cast<__m128i>(a), std::bit_cast<__m128i>(b)));
#elif defined(__ARM_NEON)
    const auto low = [](const LaneWords& v) { return vmovn_u64(std::bit_cast<uint64x2_t>(v)); };
    return std::bit_cast<LaneLongs>(vmull_u32(low(a), low(b)));
#else
    return LaneLongs{std::uint64_t{a[0]} * b[0], std::uint64_t{a[2]} * b[2]};
#endif
}
/// Words 1 and 3 in the places of 0 and 2. Big-endian hosts have no lanes.
SPANGLE_INLINE LaneWords odd_words(const LaneWords& v) {
    return std::bit_cast<LaneWords>(std::bit_cast<LaneLongs>(v) >> 32);
}
/// The high words of the products of words 0 and 2, and of 1 and 3.
SPANGLE_INLINE LaneWords high_words(const LaneLongs& even, const LaneLongs& odd) {
    return std::bit_cast<LaneWords>((even >> 32) | (odd & 0xFFFFFFFF00000000u));
}

} // namespace detail

/// Of two halves in each word, signed: the sum of their products.
SPANGLE_INLINE detail::LaneWords lane_products_added(const Lanes<8>::U16& a, const Lanes<8>::U16& b) {
#if defined(__SSE2__)
    return std::bit_cast<detail::LaneWords>(
        _mm_madd_epi16(std::bit_cast<__m128i>(a), std::bit_cast<__m128i>(b)));
#else
    using Signed [[gnu::vector_size(16)]] = std::int32_t;
    const auto s = std::bit_cast<Signed>(a), t = std::bit_cast<Signed>(b);
    return std::bit_cast<detail::LaneWords>((s << 16 >> 16) * (t << 16 >> 16) + (s >> 16) * (t >> 16));
#endif
}

/// floor(a b / 2^32).
SPANGLE_INLINE detail::LaneWords lane_product_high(const detail::LaneWords& a, const detail::LaneWords& b) {
    return detail::high_words(detail::even_products(a, b),
                              detail::even_products(detail::odd_words(a), detail::odd_words(b)));
}
/// a b / 2^32 to nearest, halves up, of a below 2^31.
SPANGLE_INLINE detail::LaneWords lane_product_rounded(const detail::LaneWords& a,
                                                      const detail::LaneWords& b) {
    constexpr std::uint64_t half = std::uint64_t{1} << 31;
    return detail::high_words(detail::even_products(a, b) + half,
                              detail::even_products(detail::odd_words(a), detail::odd_words(b)) + half);
}
/// floor(a b / 2^32), a signed, b below 2^31.
SPANGLE_INLINE detail::LaneWords lane_product_high_signed(const detail::LaneWords& a,
                                                          const detail::LaneWords& b) {
    using Signed [[gnu::vector_size(16)]] = std::int32_t;
    // As an unsigned word a negative one is 2^32 larger.
    return lane_product_high(a, b) - (b & std::bit_cast<detail::LaneWords>(std::bit_cast<Signed>(a) >> 31));
}

} // namespace spangle::raster
