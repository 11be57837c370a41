// Divides by w for eight fragments at once. The integers are those of Inverse, to_repeats() and to_coord().
// Only instruction sets that shift each word by its own number use it.
#pragma once

#include "raster/ops/coord_runs.hpp"
#include "raster/ops/lane_planes.hpp"
#include "raster/ops/packet_rows.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

namespace inner {

/// A word of 64 bits for each word of a vector. `even` holds those of the even words, and `odd` those of the
/// odd words.
template <class Vector> struct LongPair {
    using Long = Longs<Vector>;
    Long even, odd;

    /// The products v m, where v is signed and m is not.
    SPANGLE_INLINE static LongPair products(const Vector& v, const Vector& m) {
        // A negative word, taken as unsigned, is 2^32 too large.
        const auto more = std::bit_cast<Long>(m & std::bit_cast<Vector>(lane_words::as_signed(v) >> 31));
        return {even_products(v, m) - (more << 32),
                even_products(odd_words(v), odd_words(m)) - (more & 0xFFFFFFFF00000000u)};
    }
    /// floor(v / 2^n), where v is signed. AVX2 has no instruction that shifts signed words of 64 bits.
    SPANGLE_INLINE LongPair after(int n) const {
        const auto one = [n](const Long& v) __attribute__((always_inline)) {
            return ((v ^ sign) >> n) - (Long{} + (sign >> n));
        };
        return {one(even), one(odd)};
    }
    /// numeric::times_two_to(v, -down), where each word has its own `down`.
    SPANGLE_INLINE LongPair after(const Vector& down) const {
        if (lane_words::any_set(down & ~63u)) [[unlikely]]
            return after_any(*this, down);
        return {shifted_right(even, std::bit_cast<Long>(even_words(down))),
                shifted_right(odd, std::bit_cast<Long>(odd_words(down)))};
    }
    SPANGLE_INLINE LongPair operator+(std::int64_t n) const {
        const Long by = Long{} + static_cast<std::uint64_t>(n);
        return {even + by, odd + by};
    }
    /// Stores the words in the order of their lanes, at every n-th place.
    template <int n> SPANGLE_INLINE void store(std::int64_t* to) const {
        if constexpr (n == 1 && sizeof(Vector) == 32) {
            const Long low = __builtin_shufflevector(even, odd, 0, 4, 1, 5),
                       high = __builtin_shufflevector(even, odd, 2, 6, 3, 7);
            __builtin_memcpy(to, &low, 32);
            __builtin_memcpy(to + 4, &high, 32);
        } else {
            for (unsigned i = 0; i < sizeof even / sizeof even[0]; ++i) {
                to[2 * i * n] = static_cast<std::int64_t>(even[i]);
                to[(2 * i + 1) * n] = static_cast<std::int64_t>(odd[i]);
            }
        }
    }
    SPANGLE_INLINE Vector low_words() const {
        return std::bit_cast<Vector>((even & 0xFFFFFFFFu) | (odd << 32));
    }
    /// Limits each word to 32 bits, as numeric::saturate_i32() does.
    SPANGLE_INLINE LongPair saturated() const {
        const auto one = [](const Long& v) __attribute__((always_inline)) {
            using Signed [[gnu::vector_size(sizeof(Vector))]] = std::int64_t;
            constexpr auto most = static_cast<std::uint64_t>(INT32_MAX), least = 0 - most - 1;
            const auto s = std::bit_cast<Signed>(v);
            const auto over = std::bit_cast<Long>(s > INT32_MAX), under = std::bit_cast<Long>(s < INT32_MIN);
            return (v & ~(over | under)) | (most & over) | (least & under);
        };
        return {one(even), one(odd)};
    }

  private:
    static constexpr std::uint64_t sign = std::uint64_t{1} << 63;
    SPANGLE_INLINE static Vector even_words(const Vector& v) {
        return std::bit_cast<Vector>(std::bit_cast<Long>(v) & 0xFFFFFFFFu);
    }
    /// Does what after() does, for any `down`: also for a negative number and for one above 63.
    [[gnu::noinline]] static LongPair after_any(const LongPair& v, const Vector& down) {
        const Vector most = Vector{} + 63u;
        const auto n = lane_words::as_signed(down);
        const auto over = std::bit_cast<Vector>(n > 63), under = std::bit_cast<Vector>(n < -63);
        const Vector right = (most & over) | ((0 - most) & under) | (down & ~(over | under)),
                     left = 0 - right;
        return {shifted(v.even, even_words(right), even_words(left)),
                shifted(v.odd, odd_words(right), odd_words(left))};
    }
    /// floor(v / 2^n), where v is signed and each n is below 64.
    SPANGLE_INLINE static Long shifted_right(const Long& v, const Long& n) {
        return whole(v ^ sign, n, false) - whole(Long{} + sign, n, false);
    }
    /// Shifts v to the right or to the left. One of the two numbers is negative, and its shift gives 0; or
    /// both numbers are 0.
    SPANGLE_INLINE static Long shifted(const Long& v, const Vector& right, const Vector& left) {
        return shifted_right(v, std::bit_cast<Long>(right)) | whole(v, std::bit_cast<Long>(left), true);
    }
    /// Shifts by n. The result is 0 where n, taken as unsigned, is 64 or more.
    SPANGLE_INLINE static Long whole(const Long& v, const Long& n, bool up) {
#if defined(__AVX2__)
        if constexpr (sizeof(Vector) == 32) {
            const auto a = std::bit_cast<__m256i>(v), b = std::bit_cast<__m256i>(n);
            return std::bit_cast<Long>(up ? _mm256_sllv_epi64(a, b) : _mm256_srlv_epi64(a, b));
        }
#endif
        const Long by = n & 63, in = std::bit_cast<Long>(n < 64);
        return (up ? v << by : v >> by) & in;
    }
};

/// Converts words below 2^31 to floats.
template <class Vector> SPANGLE_INLINE auto to_floats(const Vector& v) {
    using Floats [[gnu::vector_size(sizeof(Vector))]] = float;
    return __builtin_convertvector(lane_words::as_signed(v), Floats);
}
/// Converts floats below 2^31 to words, rounding towards 0.
template <class Vector, class Floats> SPANGLE_INLINE Vector to_words(const Floats& v) {
    using Words [[gnu::vector_size(sizeof(Vector))]] = std::int32_t;
    return std::bit_cast<Vector>(__builtin_convertvector(v, Words));
}

/// numeric::reciprocal() for words whose highest bit is set.
template <class Vector> SPANGLE_INLINE Vector lane_reciprocals(const Vector& a) {
    using Long = Longs<Vector>;
    // The table of reciprocal() holds 2^25 / n to the nearest, for n = 513 + 2i. A quotient of floats is this
    // number, or one less, in every rounding mode. Twice the remainder of the division tells these two cases
    // apart.
    const Vector n = (a >> 22) | 1u;
    const auto near = to_words<Vector>(static_cast<float>(1u << 25) / to_floats(n));
    const Vector rest = ((1u << 26) + n) - near * n * 2u;
    const Vector seed =
        (near - std::bit_cast<Vector>(lane_words::as_signed(rest) >= lane_words::as_signed(n + n))) << 15;
    const Vector left = 0x80000000u - lane_product_high(a, seed);
    const Vector r = LongPair<Vector>{even_products(seed, left) >> 30,
                                      even_products(odd_words(seed), odd_words(left)) >> 30}
                         .low_words();
    // The residual is signed. even_products() takes its low word as unsigned, which is corrected.
    const auto step = [](const Long& product, const Vector& of) __attribute__((always_inline)) {
        const Long residual = ((std::uint64_t{1} << 62) - product) >> 14;
        const auto word = std::bit_cast<Vector>(residual);
        const auto borrowed =
            std::bit_cast<Long>(of & std::bit_cast<Vector>(lane_words::as_signed(word) >> 31)) << 32;
        return even_products(of, word) - borrowed + (std::uint64_t{1} << 47);
    };
    const Vector odd = odd_words(r);
    const Vector steps =
        high_words<Vector>(step(even_products(a, r), r), step(even_products(odd_words(a), odd), odd));
    return r + std::bit_cast<Vector>(lane_words::as_signed(steps) >> 16);
}

} // namespace inner

/// Inverse for eight fragments at once.
struct InverseLanes {
    LaneWords q, mantissa, zeros;

    /// `value` is signed and has no guard bits.
    SPANGLE_INLINE explicit InverseLanes(const LaneWords& value)
        : q(LaneWords::mapped(
              [](const auto& v) __attribute__((always_inline)) {
                  const auto positive =
                      std::bit_cast<std::remove_cvref_t<decltype(v)>>(lane_words::as_signed(v) > 0);
                  return (v & positive) | (1u & ~positive);
              },
              value)),
          zeros(leading_zeros(q)) {
        mantissa = LaneWords::mapped(
            [](const auto& v, const auto& n)
                __attribute__((always_inline)) { return inner::lane_reciprocals(v << n); },
            q, zeros);
    }
    /// Takes a q that was inverted before: `of` is q and `found` is its mantissa.
    SPANGLE_INLINE InverseLanes(const LaneWords& of, const LaneWords& found)
        : q(of), mantissa(found), zeros(leading_zeros(of)) {}
    /// 2^zeros for each lane.
    SPANGLE_INLINE LaneWords power() const {
        return LaneWords::mapped(
            [](const auto& n)
                __attribute__((always_inline)) { return (std::remove_cvref_t<decltype(n)>{} + 1u) << n; },
            zeros);
    }
    /// The coordinates that to_coord() makes of to_repeats().
    SPANGLE_INLINE LaneWords coord(const LaneWords& v, int exponent, bool wraps, std::int32_t base) const {
        return LaneWords::mapped(
            [&](const auto& of, const auto& m, const auto& n) __attribute__((always_inline)) {
                using Vector = std::remove_cvref_t<decltype(of)>;
                const auto repeats = inner::LongPair<Vector>::products(of, m).after(
                    static_cast<std::uint32_t>(30 - exponent) - n);
                return wraps ? repeats.low_words() : clamp_repeats(repeats, base).low_words();
            },
            v, mantissa, zeros);
    }
    /// Stores to_repeats(), or to_coord() of it where the coordinates do not wrap.
    SPANGLE_INLINE void repeats(const LaneWords& v, int exponent, bool wraps, std::int32_t base,
                                std::int64_t* to) const {
        LaneWords::each(
            [&](int lane, const auto& of, const auto& m, const auto& n) __attribute__((always_inline)) {
                using Vector = std::remove_cvref_t<decltype(of)>;
                const auto repeats = inner::LongPair<Vector>::products(of, m).after(
                    static_cast<std::uint32_t>(30 - exponent) - n);
                (wraps ? repeats : clamp_repeats(repeats, base)).template store<LaneWords::apart>(to + lane);
            },
            v, mantissa, zeros);
    }
    /// projective_fog() for fragments whose products are all shifted to the right.
    SPANGLE_INLINE LaneWords fog(const LaneWords& over_w, int exponent) const {
        return LaneWords::mapped(
            [&](const auto& of, const auto& m, const auto& n) __attribute__((always_inline)) {
                using Vector = std::remove_cvref_t<decltype(of)>;
                return inner::LongPair<Vector>::products(of, m)
                    .after(static_cast<std::uint32_t>(38 - exponent) - n)
                    .saturated()
                    .low_words();
            },
            over_w, mantissa, zeros);
    }

  private:
    template <class Vector>
    SPANGLE_INLINE static inner::LongPair<Vector> clamp_repeats(const inner::LongPair<Vector>& repeats,
                                                                std::int32_t base) {
        return (repeats.after(32 - clamped_coord_bits) + (std::int64_t{base} << clamped_coord_bits))
            .saturated();
    }
    /// Counts the leading zeros of words from 1 to 2^31 - 1.
    SPANGLE_INLINE static LaneWords leading_zeros(const LaneWords& words) {
        return LaneWords::mapped(
            [](const auto& v) __attribute__((always_inline)) {
                // The bit below the highest bit is cleared, so that rounding never takes a word to the next
                // power of two.
                return 158u -
                       (std::bit_cast<std::remove_cvref_t<decltype(v)>>(inner::to_floats(v & ~(v >> 1))) >>
                        23);
            },
            words);
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
