// Eight words of 32 bits, one per lane. They are one vector of 256 bits where the instruction set has such
// vectors, and otherwise two vectors of 128 bits.
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>

#if defined(__AVX2__)
#include <immintrin.h>
#endif

#include "raster/numeric/bits.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

namespace lane_words {

using Half [[gnu::vector_size(16)]] = std::uint32_t; ///< four words
using Halfwords [[gnu::vector_size(16)]] = std::uint16_t;

/// The bits of v as signed words.
template <class Vector> SPANGLE_INLINE auto as_signed(const Vector& v) {
    using Signed [[gnu::vector_size(sizeof(Vector))]] = std::int32_t;
    return std::bit_cast<Signed>(v);
}
/// All ones where a < b, where both are signed.
template <class Vector> SPANGLE_INLINE Vector is_less(const Vector& a, const Vector& b) {
    return std::bit_cast<Vector>(as_signed(a) < as_signed(b));
}
// Compilers make one instruction of each of the loops below where the instruction set has it.

/// min(a, b) of signed numbers.
template <class Vector> SPANGLE_INLINE Vector smaller(const Vector& a, const Vector& b) {
    const auto s = as_signed(a), t = as_signed(b);
    auto r = s;
    for (unsigned i = 0; i < sizeof(Vector) / 4; ++i)
        r[i] = s[i] < t[i] ? s[i] : t[i];
    return std::bit_cast<Vector>(r);
}
/// max(a, b) of signed numbers.
template <class Vector> SPANGLE_INLINE Vector larger(const Vector& a, const Vector& b) {
    const auto s = as_signed(a), t = as_signed(b);
    auto r = s;
    for (unsigned i = 0; i < sizeof(Vector) / 4; ++i)
        r[i] = s[i] < t[i] ? t[i] : s[i];
    return std::bit_cast<Vector>(r);
}
/// True where at least one bit of the vector is set.
template <class Vector> SPANGLE_INLINE bool any_set(const Vector& v) {
#if defined(__AVX2__)
    if constexpr (sizeof(Vector) == 32)
        return _mm256_testz_si256(std::bit_cast<__m256i>(v), std::bit_cast<__m256i>(v)) == 0;
#endif
    std::uint32_t bits = 0;
    for (unsigned i = 0; i < sizeof(Vector) / 4; ++i)
        bits |= v[i];
    return bits != 0;
}
/// max(v, 0) of signed numbers.
template <class Vector> SPANGLE_INLINE Vector positive(const Vector& v) {
    auto r = as_signed(v);
    for (unsigned i = 0; i < sizeof(Vector) / 4; ++i)
        r[i] = r[i] < 0 ? 0 : r[i];
    return std::bit_cast<Vector>(r);
}

} // namespace lane_words

/// Two results of one operation in lanes: from the low parts and from the high parts.
template <class Words> struct LanePairs { Words low, high; };

#if defined(__AVX2__)

/// Eight words in one vector, in the order of the lanes.
struct LaneWords {
    using Vector [[gnu::vector_size(32)]] = std::uint32_t;
    using Halfwords = lane_words::Halfwords;
    Vector all;

    SPANGLE_INLINE static LaneWords splat(std::uint32_t v) { return {Vector{v, v, v, v, v, v, v, v}}; }
    /// One word per lane: start, start + step, and the next multiples.
    SPANGLE_INLINE static LaneWords ramp(std::uint32_t start, std::uint32_t step) {
        return {splat(start).all + splat(step).all * Vector{0, 1, 2, 3, 4, 5, 6, 7}};
    }
    /// Offsets of lanes that are four columns of two rows, with `dx` per column and `dy` per row.
    SPANGLE_INLINE static LaneWords two_rows(std::uint32_t dx, std::uint32_t dy) {
        return {splat(dx).all * Vector{0, 1, 2, 3, 0, 1, 2, 3} +
                splat(dy).all * Vector{0, 0, 0, 0, 1, 1, 1, 1}};
    }
    SPANGLE_INLINE static LaneWords widened(const Halfwords& v) {
        // GCC 12 makes four instructions of a conversion between vectors; this is one.
        return {std::bit_cast<Vector>(_mm256_cvtepu16_epi32(std::bit_cast<__m128i>(v)))};
    }
    SPANGLE_INLINE static LaneWords load(const std::uint8_t* p) {
        LaneWords v;
        __builtin_memcpy(&v.all, p, 32);
        return v;
    }
    template <class F> SPANGLE_INLINE static LaneWords generate(F f) {
        return {Vector{f(0u), f(1u), f(2u), f(3u), f(4u), f(5u), f(6u), f(7u)}};
    }
    /// The low and the high words of f(lane), which has 64 bits.
    template <class F> SPANGLE_INLINE static LanePairs<LaneWords> generate_pairs(F f) {
        using Pairs [[gnu::vector_size(32)]] = std::uint64_t;
        // The shuffle works inside of each half of a vector. Lanes are loaded in an order that the shuffle
        // makes ascending.
        const auto a = std::bit_cast<Vector>(Pairs{f(0u), f(1u), f(4u), f(5u)}),
                   b = std::bit_cast<Vector>(Pairs{f(2u), f(3u), f(6u), f(7u)});
        const auto words = [&](auto shuffled) __attribute__((always_inline)) {
            return LaneWords{std::bit_cast<Vector>(shuffled)};
        };
        const auto x = std::bit_cast<__m256>(a), y = std::bit_cast<__m256>(b);
        return {words(_mm256_shuffle_ps(x, y, 0x88)), words(_mm256_shuffle_ps(x, y, 0xDD))};
    }
    SPANGLE_INLINE static LaneWords select(const Halfwords& m, const LaneWords& a, const LaneWords& b) {
        const __m256i wide = _mm256_cvtepi16_epi32(std::bit_cast<__m128i>(m));
        return {std::bit_cast<Vector>(
            _mm256_blendv_epi8(std::bit_cast<__m256i>(b.all), std::bit_cast<__m256i>(a.all), wide))};
    }
    /// Applies f to each vector of words, whichever lanes the vector holds.
    template <class F, class... Words> SPANGLE_INLINE static LaneWords mapped(F f, const Words&... v) {
        return {f(v.all...)};
    }
    /// Calls f(lane, vectors...) once for each vector. The words of a vector are those of `lane`, `lane` +
    /// `apart`, and so on.
    static constexpr int apart = 1;
    template <class F, class... Words> SPANGLE_INLINE static void each(F f, const Words&... v) {
        f(0, v.all...);
    }
    SPANGLE_INLINE void store(std::uint8_t* p) const { __builtin_memcpy(p, &all, 32); }
    SPANGLE_INLINE Halfwords high_half() const { return LaneWords{all >> 16}.narrowed(); }
    SPANGLE_INLINE Halfwords low_half() const { return LaneWords{all & 0xFFFFu}.narrowed(); }
    SPANGLE_INLINE LanePairs<Halfwords> halves() const {
        const __m128i order = _mm_setr_epi8(0, 1, 4, 5, 8, 9, 12, 13, 2, 3, 6, 7, 10, 11, 14, 15);
        const __m256i parted =
            _mm256_shuffle_epi8(std::bit_cast<__m256i>(all), _mm256_broadcastsi128_si256(order));
        const __m256i v = _mm256_permute4x64_epi64(parted, 0xD8);
        return {std::bit_cast<Halfwords>(_mm256_castsi256_si128(v)),
                std::bit_cast<Halfwords>(_mm256_extracti128_si256(v, 1))};
    }
    /// Masks of 16 bits from words that are all ones or 0.
    SPANGLE_INLINE Halfwords mask() const {
        const auto v = std::bit_cast<__m256i>(all);
        return std::bit_cast<Halfwords>(
            _mm_packs_epi32(_mm256_castsi256_si128(v), _mm256_extracti128_si256(v, 1)));
    }
    /// At least one bit is set where any word is not 0.
    SPANGLE_INLINE Halfwords any_bits() const {
        const auto v = std::bit_cast<__m256i>(all);
        return std::bit_cast<Halfwords>(_mm256_castsi256_si128(v) | _mm256_extracti128_si256(v, 1));
    }
    SPANGLE_INLINE std::uint32_t lane(int i) const { return all[i]; }
    SPANGLE_INLINE void set_lane(int i, std::uint32_t v) { all[i] = v; }

  private:
    /// The low halves of words that are below 2^16.
    SPANGLE_INLINE Halfwords narrowed() const {
        const auto v = std::bit_cast<__m256i>(all);
        return std::bit_cast<Halfwords>(
            _mm_packus_epi32(_mm256_castsi256_si128(v), _mm256_extracti128_si256(v, 1)));
    }
};

#else

/// Eight words in two vectors, one of even lanes and one of odd lanes. A shift, a mask and an `or` then give
/// the high halves of all eight words.
struct LaneWords {
    using Vector = lane_words::Half;
    using Halfwords = lane_words::Halfwords;
    Vector even, odd;

    SPANGLE_INLINE static LaneWords splat(std::uint32_t v) {
        const Vector w = {v, v, v, v};
        return {w, w};
    }
    /// One word per lane: start, start + step, and the next multiples. Masks make the words, because
    /// inserting them one by one would take twice as long.
    SPANGLE_INLINE static LaneWords ramp(std::uint32_t start, std::uint32_t step) {
        constexpr std::uint32_t on = 0xFFFFFFFF;
        const Vector by = splat(step).even, one = by & Vector{0, on, 0, on}, two = by & Vector{0, 0, on, on};
        const Vector first = splat(start).even + (one + one) + (two << 2);
        return {first, first + by};
    }
    /// Offsets of lanes that are four columns of two rows, with `dx` per column and `dy` per row.
    SPANGLE_INLINE static LaneWords two_rows(std::uint32_t dx, std::uint32_t dy) {
        constexpr std::uint32_t on = 0xFFFFFFFF;
        const Vector by = splat(dx).even;
        const Vector one = by & Vector{0, on, 0, on};
        const Vector first = one + one + (splat(dy).even & Vector{0, 0, on, on});
        return {first, first + by};
    }
    SPANGLE_INLINE static LaneWords widened(const Halfwords& v) {
        const auto w = std::bit_cast<Vector>(v);
        return {w & 0xFFFFu, w >> 16};
    }
    SPANGLE_INLINE static LaneWords load(const std::uint8_t* p) {
        Vector low, high;
        __builtin_memcpy(&low, p, 16);
        __builtin_memcpy(&high, p + 16, 16);
        return {__builtin_shufflevector(low, high, 0, 2, 4, 6),
                __builtin_shufflevector(low, high, 1, 3, 5, 7)};
    }
    template <class F> SPANGLE_INLINE static LaneWords generate(F f) {
        return {Vector{f(0u), f(2u), f(4u), f(6u)}, Vector{f(1u), f(3u), f(5u), f(7u)}};
    }
    /// The low and the high words of f(lane), which has 64 bits.
    template <class F> SPANGLE_INLINE static LanePairs<LaneWords> generate_pairs(F f) {
        using Pairs [[gnu::vector_size(16)]] = std::uint64_t;
        const auto two = [&](std::uint32_t i) __attribute__((always_inline)) {
            return std::bit_cast<Vector>(Pairs{f(i), f(i + 2)});
        };
        const Vector a = two(0), b = two(4), c = two(1), d = two(5);
        return {{__builtin_shufflevector(a, b, 0, 2, 4, 6), __builtin_shufflevector(c, d, 0, 2, 4, 6)},
                {__builtin_shufflevector(a, b, 1, 3, 5, 7), __builtin_shufflevector(c, d, 1, 3, 5, 7)}};
    }
    SPANGLE_INLINE static LaneWords select(const Halfwords& m, const LaneWords& a, const LaneWords& b) {
        const auto halves = lane_words::as_signed(std::bit_cast<Vector>(m));
        const auto first = std::bit_cast<Vector>((halves << 16) >> 16),
                   second = std::bit_cast<Vector>(halves >> 16);
        return {(first & a.even) | (~first & b.even), (second & a.odd) | (~second & b.odd)};
    }
    /// Applies f to each vector of words, whichever lanes the vector holds.
    template <class F, class... Words> SPANGLE_INLINE static LaneWords mapped(F f, const Words&... v) {
        return {f(v.even...), f(v.odd...)};
    }
    /// Calls f(lane, vectors...) once for each vector. The words of a vector are those of `lane`, `lane` +
    /// `apart`, and so on.
    static constexpr int apart = 2;
    template <class F, class... Words> SPANGLE_INLINE static void each(F f, const Words&... v) {
        f(0, v.even...);
        f(1, v.odd...);
    }
    SPANGLE_INLINE void store(std::uint8_t* p) const {
        const Vector low = __builtin_shufflevector(even, odd, 0, 4, 1, 5),
                     high = __builtin_shufflevector(even, odd, 2, 6, 3, 7);
        __builtin_memcpy(p, &low, 16);
        __builtin_memcpy(p + 16, &high, 16);
    }
    SPANGLE_INLINE Halfwords high_half() const {
        return std::bit_cast<Halfwords>((even >> 16) | (odd & 0xFFFF0000u));
    }
    SPANGLE_INLINE Halfwords low_half() const {
        return std::bit_cast<Halfwords>((even & 0xFFFFu) | (odd << 16));
    }
    SPANGLE_INLINE LanePairs<Halfwords> halves() const { return {low_half(), high_half()}; }
    /// Masks of 16 bits from words that are all ones or 0.
    SPANGLE_INLINE Halfwords mask() const { return low_half(); }
    /// At least one bit is set where any word is not 0.
    SPANGLE_INLINE Halfwords any_bits() const { return std::bit_cast<Halfwords>(even | odd); }
    SPANGLE_INLINE std::uint32_t lane(int i) const { return (i & 1) != 0 ? odd[i >> 1] : even[i >> 1]; }
    SPANGLE_INLINE void set_lane(int i, std::uint32_t v) {
        // The word is not chosen by a conditional expression, because under UBSan gcc 12 would write into a
        // copy of the word.
        if ((i & 1) != 0)
            odd[i >> 1] = v;
        else
            even[i >> 1] = v;
    }
};

#endif

SPANGLE_INLINE LaneWords operator+(const LaneWords& a, const LaneWords& b) {
    return LaneWords::mapped(
        [](const auto& v, const auto& w) __attribute__((always_inline)) { return v + w; }, a, b);
}
SPANGLE_INLINE LaneWords operator-(const LaneWords& a, const LaneWords& b) {
    return LaneWords::mapped(
        [](const auto& v, const auto& w) __attribute__((always_inline)) { return v - w; }, a, b);
}
SPANGLE_INLINE LaneWords operator|(const LaneWords& a, const LaneWords& b) {
    return LaneWords::mapped(
        [](const auto& v, const auto& w) __attribute__((always_inline)) { return v | w; }, a, b);
}
SPANGLE_INLINE LaneWords operator^(const LaneWords& a, const LaneWords& b) {
    return LaneWords::mapped(
        [](const auto& v, const auto& w) __attribute__((always_inline)) { return v ^ w; }, a, b);
}
SPANGLE_INLINE LaneWords operator&(const LaneWords& a, const LaneWords& b) {
    return LaneWords::mapped(
        [](const auto& v, const auto& w) __attribute__((always_inline)) { return v & w; }, a, b);
}
SPANGLE_INLINE LaneWords operator*(const LaneWords& a, const LaneWords& b) {
    return LaneWords::mapped(
        [](const auto& v, const auto& w) __attribute__((always_inline)) { return v * w; }, a, b);
}
SPANGLE_INLINE LaneWords operator&(const LaneWords& a, std::uint32_t n) {
    return LaneWords::mapped(
        [n](const auto& v) __attribute__((always_inline)) { return v & n; }, a);
}
SPANGLE_INLINE LaneWords operator*(const LaneWords& a, std::uint32_t n) {
    return LaneWords::mapped(
        [n](const auto& v) __attribute__((always_inline)) { return v * n; }, a);
}
SPANGLE_INLINE LaneWords operator-(std::uint32_t n, const LaneWords& a) {
    return LaneWords::mapped(
        [n](const auto& v) __attribute__((always_inline)) { return n - v; }, a);
}
SPANGLE_INLINE LaneWords operator~(const LaneWords& a) {
    return LaneWords::mapped(
        [](const auto& v) __attribute__((always_inline)) { return ~v; }, a);
}
SPANGLE_INLINE LaneWords operator>>(const LaneWords& a, int n) {
    return LaneWords::mapped(
        [n](const auto& v) __attribute__((always_inline)) { return v >> static_cast<std::uint32_t>(n); }, a);
}
SPANGLE_INLINE LaneWords operator<<(const LaneWords& a, int n) {
    return LaneWords::mapped(
        [n](const auto& v) __attribute__((always_inline)) { return v << static_cast<std::uint32_t>(n); }, a);
}
/// floor(v / 2^n) word by word, where v is signed.
SPANGLE_INLINE LaneWords lane_shifted_signed(const LaneWords& v, int n) {
    return LaneWords::mapped(
        [n](const auto& w) __attribute__((always_inline)) {
            return std::bit_cast<std::remove_cvref_t<decltype(w)>>(lane_words::as_signed(w) >> n);
        },
        v);
}
SPANGLE_INLINE LaneWords& operator+=(LaneWords& a, const LaneWords& b) {
    return a = a + b;
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
