// Operations that eight lanes of texels need besides Lanes<8>: pairs of half-words in words, and bytes.
#pragma once

#include "raster/ops/lane_products.hpp"
#include "raster/ops/lanes.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Joins a low and a high half-word to one word in each lane.
SPANGLE_INLINE LaneWords lane_joined(const Lanes<8>::U16& low, const Lanes<8>::U16& high) {
    return LaneWords::widened(low) | (LaneWords::widened(high) << 16);
}

namespace inner {

/// The sum of the products of the signed halves of each word: low a low b + high a high b.
template <class Vector> SPANGLE_INLINE Vector products_added(const Vector& a, const Vector& b) {
    // GCC and clang make six instructions or more of the products below. Each intrinsic is one instruction.
#if defined(__AVX2__)
    if constexpr (sizeof(Vector) == 32)
        return std::bit_cast<Vector>(_mm256_madd_epi16(std::bit_cast<__m256i>(a), std::bit_cast<__m256i>(b)));
    else
#endif
#if defined(__SSE2__)
        return std::bit_cast<Vector>(_mm_madd_epi16(std::bit_cast<__m128i>(a), std::bit_cast<__m128i>(b)));
#else
    const auto s = lane_words::as_signed(a), t = lane_words::as_signed(b);
    return std::bit_cast<Vector>(((s << 16) >> 16) * ((t << 16) >> 16) + (s >> 16) * (t >> 16));
#endif
}

} // namespace inner

SPANGLE_INLINE LaneWords lane_products_added(const LaneWords& a, const LaneWords& b) {
    return LaneWords::mapped(
        [](const auto& v, const auto& w)
            __attribute__((always_inline)) { return inner::products_added(v, w); },
        a, b);
}

/// Four bytes per lane: `low` holds bytes 0 and 1, and `high` holds bytes 2 and 3.
struct LaneBytes {
    Lanes<8>::U16 low, high;
    SPANGLE_INLINE static LaneBytes of(const LaneWords& words) {
        const auto [low, high] = words.halves();
        return {low, high};
    }
    SPANGLE_INLINE Lanes<8>::U16 at(int n) const {
        const Lanes<8>::U16& two = n < 2 ? low : high;
        return n % 2 == 0 ? two & 0xFF : two >> 8;
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
