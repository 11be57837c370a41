// 1/w of eight fragments at once: the bits of Inverse, of projective_color and its like, in lanes.
#pragma once

#include "raster/numeric/reciprocal.hpp"
#include "raster/span/lanes.hpp"
#include "raster/span/span.hpp"
#include "raster/span/stage_color.hpp"

namespace spangle::raster {

namespace detail {

using WideLanes = Lanes<8>::U32;
using WideWords = Lanes<8>::Words;

/// f(k) of four lanes; compilers make vectors of it, products of 64 bits included.
template <class F> SPANGLE_INLINE WideWords each_word(F f) {
    WideWords r;
    for (int i = 0; i < 4; ++i)
        r[i] = f(i);
    return r;
}
/// f(a, b) of eight lanes.
template <class F> SPANGLE_INLINE WideLanes each_lane(const WideLanes& a, const WideLanes& b, F f) {
    return {each_word([&](int i) __attribute__((always_inline)) { return f(a.even[i], b.even[i]); }),
            each_word([&](int i) __attribute__((always_inline)) { return f(a.odd[i], b.odd[i]); })};
}

/// floor(a b / 2^32).
SPANGLE_INLINE WideLanes mul_high(const WideLanes& a, const WideLanes& b) {
    return each_lane(
        a, b, [](std::uint32_t v, std::uint32_t w) __attribute__((always_inline)) {
            return static_cast<std::uint32_t>(std::uint64_t{v} * w >> 32);
        });
}

/// Those lanes of `of` where v, signed, is negative; else 0.
SPANGLE_INLINE WideLanes where_negative(const WideLanes& v, const WideLanes& of) {
    using Signed [[gnu::vector_size(16)]] = std::int32_t;
    const auto one = [](WideWords value, WideWords word) {
        return std::bit_cast<WideWords>(std::bit_cast<Signed>(value) >> 31) & word;
    };
    return {one(v.even, of.even), one(v.odd, of.odd)};
}

/// min(max(v, 0), most), all signed, most >= 0.
SPANGLE_INLINE WideLanes clamped(const WideLanes& v, const WideLanes& most) {
    using Signed [[gnu::vector_size(16)]] = std::int32_t;
    const auto one = [](WideWords value, WideWords limit) {
        const auto s = std::bit_cast<Signed>(value), m = std::bit_cast<Signed>(limit);
        const Signed positive = s & ~(s >> 31), below = positive < m;
        return std::bit_cast<WideWords>((positive & below) | (m & ~below));
    };
    return {one(v.even, most.even), one(v.odd, most.odd)};
}

} // namespace detail

/// Inverse of eight fragments whose 1/w has as many leading zeros.
struct InverseLanes {
    using L = Lanes<8>;
    L::U32 q, mantissa;
    int zeros;
    InverseLanes() = default;
    SPANGLE_INLINE InverseLanes(const L::U32& value, int leading) : q(value), zeros(leading) {
        const L::U32 a = q << zeros, r = first_step(a);
        // numeric::reciprocal: the second step. A signed factor is one without a sign, 2^31 less.
        const L::U32 residual = detail::each_lane(
            a, r, [](std::uint32_t v, std::uint32_t w) __attribute__((always_inline)) {
                return static_cast<std::uint32_t>(((std::uint64_t{1} << 62) - std::uint64_t{v} * w) >> 14);
            });
        const L::U32 step = detail::each_lane(
            r, residual ^ L::splat32(0x80000000u),
            [](std::uint32_t v, std::uint32_t w) __attribute__((always_inline)) {
                const std::uint64_t sum =
                    std::uint64_t{v} * w + (std::uint64_t{1} << 47) - (std::uint64_t{v} << 31);
                return static_cast<std::uint32_t>(sum >> 32);
            });
        mantissa = r + sixteenth_bits(step);
    }

  private:
    /// numeric::reciprocal_1.
    SPANGLE_INLINE static L::U32 first_step(const L::U32& a) {
        const L::U16 index = L::low_half(a >> 23) & 255;
        const L::U16 seeds = L::generate([&](std::uint32_t k) __attribute__((always_inline)) {
            return numeric::detail::reciprocal_table.at[index[k]];
        });
        const L::U32 seed = L::widened(seeds) << 15;
        return detail::each_lane(
            seed, L::splat32(0x80000000u) - detail::mul_high(a, seed),
            [](std::uint32_t v, std::uint32_t w) __attribute__((always_inline)) {
                return static_cast<std::uint32_t>(std::uint64_t{v} * w >> 30);
            });
    }
    /// v / 2^16, signed.
    SPANGLE_INLINE static L::U32 sixteenth_bits(const L::U32& v) {
        using Signed [[gnu::vector_size(16)]] = std::int32_t;
        const auto one = [](L::Words w) { return std::bit_cast<L::Words>(std::bit_cast<Signed>(w) >> 16); };
        return {one(v.even), one(v.odd)};
    }
};

/// Eight values in a row of memory, of a plane: what the first of them is, and what the others are more.
class LanesInRow {
  public:
    using Words = Lanes<8>::Words;
    SPANGLE_INLINE explicit LanesInRow(std::uint32_t step)
        : low_((splat(step) & Words{0, on, 0, on}) + (splat(2 * step) & Words{0, 0, on, on})),
          high_(low_ + splat(4 * step)) {}
    SPANGLE_INLINE Words low(std::uint32_t first) const { return splat(first) + low_; }
    SPANGLE_INLINE Words high(std::uint32_t first) const { return splat(first) + high_; }

  private:
    static constexpr std::uint32_t on = 0xFFFFFFFF;
    SPANGLE_INLINE static Words splat(std::uint32_t v) { return Words{v, v, v, v}; }
    Words low_, high_;
};

/// A plane along a row, eight values at a time. Projective ones without their guard bits.
template <class T> class PlaneLanes;
template <> class PlaneLanes<std::uint32_t> {
  public:
    template <class S>
    SPANGLE_INLINE PlaneLanes(const S& span, std::int32_t x, const Span<Fixed>::Affine& plane)
        : lanes_(plane.dx), by_(8 * plane.dx) {
        start(span, x, plane);
    }
    template <class S>
    SPANGLE_INLINE void start(const S& span, std::int32_t x, const Span<Fixed>::Affine& plane) {
        at_ = span.at(x, plane);
    }
    SPANGLE_INLINE void store(std::uint32_t* to) const {
        const LanesInRow::Words low = lanes_.low(at_), high = lanes_.high(at_);
        __builtin_memcpy(to, &low, 16);
        __builtin_memcpy(to + 4, &high, 16);
    }
    SPANGLE_INLINE void step() { at_ += by_; }

  private:
    LanesInRow lanes_;
    std::uint32_t at_, by_;
};
template <> class PlaneLanes<std::uint64_t> {
  public:
    template <class S>
    SPANGLE_INLINE PlaneLanes(const S& span, std::int32_t x, const Span<Fixed>::Projective& plane)
        : whole_(above(plane.dx)), guard_(below(plane.dx)), by_(8 * plane.dx) {
        start(span, x, plane);
    }
    template <class S>
    SPANGLE_INLINE void start(const S& span, std::int32_t x, const Span<Fixed>::Projective& plane) {
        at_ = span.at(x, plane);
    }
    /// floor((at + k dx) / 2^16): guard bits of eight steps are less than 2^20.
    SPANGLE_INLINE void store(std::uint32_t* to) const {
        const std::uint32_t whole = above(at_), guard = below(at_);
        const LanesInRow::Words low = whole_.low(whole) + (guard_.low(guard) >> guard_bits),
                                high = whole_.high(whole) + (guard_.high(guard) >> guard_bits);
        __builtin_memcpy(to, &low, 16);
        __builtin_memcpy(to + 4, &high, 16);
    }
    SPANGLE_INLINE void step() { at_ += by_; }

  private:
    static_assert(guard_bits == 16);
    SPANGLE_INLINE static std::uint32_t above(std::uint64_t v) {
        return static_cast<std::uint32_t>(v >> guard_bits);
    }
    SPANGLE_INLINE static std::uint32_t below(std::uint64_t v) {
        return static_cast<std::uint32_t>(v) & ((1u << guard_bits) - 1);
    }
    LanesInRow whole_, guard_; ///< of the steps
    std::uint64_t at_, by_;
};

} // namespace spangle::raster
