// The number system of the exact tier in eight lanes. It makes the bits of Exact for eight fragments at once.
#pragma once

#include "raster/ops/lane_products.hpp"
#include "raster/ops/number.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Number system of the exact tier in lanes. A component is a word of 32 bits per lane: 255ths with 20
/// fraction bits, as in Exact. Each function returns what the function of the same name in Exact returns.
struct ExactLanes {
    using Policy = Fixed;
    static constexpr int lanes = 8;
    using L = Lanes<8>;
    using T = L::U32;
    using Color = Rgba<T>;
    using Coord = TexCoords<std::uint32_t, 8>;
    using Fog = L::U32;
    static constexpr std::uint32_t one = color_one;

    SPANGLE_INLINE static T from8(const L::U16& k) { return L::widened(k) << color_fraction_bits; }
    SPANGLE_INLINE static L::U16 to8(const T& v) {
        return L::low_half((v + L::splat32(1u << (color_fraction_bits - 1))) >> color_fraction_bits);
    }
    SPANGLE_INLINE static T from5(const L::U16& k) { return step<31>(L::widened(k), 15); }
    SPANGLE_INLINE static T from6(const L::U16& k) { return step<63>(L::widened(k), 31); }
    SPANGLE_INLINE static T texel5(const L::U16& k) { return step<31>(L::widened(k), 30); }
    SPANGLE_INLINE static T texel6(const L::U16& k) { return step<63>(L::widened(k), 62); }
    /// k / 7, rounded up as texels are.
    SPANGLE_INLINE static T texel3(const L::U16& k) { return step<7>(L::widened(k), 6); }
    SPANGLE_INLINE static T from_units(std::uint32_t c) { return L::splat32(c); }
    SPANGLE_INLINE static T from_affine(const L::U32& v) {
        // Words below the bias of half a unit become 0, because rounding took them below it.
        const auto unbiased = [](const auto& w) __attribute__((always_inline)) {
            return (w - (1u << 15)) & std::bit_cast<std::remove_cvref_t<decltype(w)>>((w >> 15) != 0);
        };
        const T c = T::mapped(unbiased, v) >> (24 - color_fraction_bits);
        return L::minimum(c, L::splat32(one));
    }
    SPANGLE_INLINE static T mul(const T& a, const T& b) { return scaled(a, fraction(b)); }
    SPANGLE_INLINE static T fraction(const T& v) { return (v << 4) + (v >> 4) + (v >> 12) + (v >> 20); }
    SPANGLE_INLINE static T scaled(const T& a, const T& factor) { return lane_product_rounded(a, factor); }
    SPANGLE_INLINE static T lerp(const T& a, const T& b, const T& k) {
        return L::minimum(mul(a, one - k) + mul(b, k), L::splat32(one));
    }
    SPANGLE_INLINE static T add(const T& a, const T& b) { return L::minimum(a + b, L::splat32(one)); }
    SPANGLE_INLINE static T subtract(const T& a, const T& b) { return a - L::minimum(a, b); }
    template <unsigned Bits> SPANGLE_INLINE static T over(const T& s, const T& a, const L::U16& k) {
        const T d = Bits == 5 ? from5(k) : Bits == 6 ? from6(k) : from8(k);
        return add(mul(s, a), mul(d, one - a));
    }
    /// Does what Exact::weighted() does, for two components and weights below 2^16. The products of
    /// half-words fit 32 bits.
    SPANGLE_INLINE static T weighted(const T& a, const L::U16& wa, const T& b, const L::U16& wb) {
        const T x = L::widened(wa), y = L::widened(wb);
        const T high = (a >> 16) * x + (b >> 16) * y, low = (a & 0xFFFFu) * x + (b & 0xFFFFu) * y;
        return high + ((low + L::splat32(65535)) >> 16);
    }
    /// The weights of four texels for LINEAR. The weights of column i + 1 and of row j + 1 are given in
    /// 256ths.
    class Weights {
      public:
        SPANGLE_INLINE explicit Weights(const L::U16& b)
            : near_weight_(256u - L::widened(b)), far_weight_(L::widened(b)) {}
        /// The weighted component of four texels with 8 bits, k / 255. No rounding is needed.
        SPANGLE_INLINE T bytes(const L::U16& c00, const L::U16& c10, const L::U16& c01, const L::U16& c11,
                               const T& right) const {
            return sum(L::widened(c00), L::widened(c10), L::widened(c01), L::widened(c11), right)
                   << (color_fraction_bits - 16);
        }
        /// The weighted component of four texels with 28 bits, which are taken as two halves of 14 bits. A
        /// row of two halves then has 22 bits, and both rows together have 30.
        SPANGLE_INLINE T components(const T& c00, const T& c10, const T& c01, const T& c11,
                                    const T& right) const {
            constexpr std::uint32_t low_bits = (1u << 14) - 1;
            const T high = sum(c00 >> 14, c10 >> 14, c01 >> 14, c11 >> 14, right),
                    low = sum(c00 & low_bits, c10 & low_bits, c01 & low_bits, c11 & low_bits, right);
            return (high >> 2) + ((((high & 3u) << 14) + low + L::splat32(65535)) >> 16);
        }

      private:
        T near_weight_, far_weight_; ///< weights of rows j and j + 1, 256ths
        SPANGLE_INLINE T sum(const T& c00, const T& c10, const T& c01, const T& c11, const T& right) const {
            const T left = 256u - right;
            return (c00 * left + c10 * right) * near_weight_ + (c01 * left + c11 * right) * far_weight_;
        }
    };
    SPANGLE_INLINE static T clamped_fraction(const L::U32& v) {
        return L::minimum(L::positive(v), L::splat32(1u << 24)) << 6;
    }
    SPANGLE_INLINE static T mix(const T& a, const T& b, const T& f) {
        return a + lane_product_high_signed((b - a) << 2, f);
    }
    /// A threshold of dithering, in 2^-11 of a step of five bits.
    struct Threshold {
        static constexpr int words = 1;
        static constexpr std::uint32_t word(int, std::uint32_t threshold32) { return threshold32 << 6; }
    };
    /// The dithered colour as a word of 16 bits, with whole steps in the top bits.
    template <unsigned Bits> SPANGLE_INLINE static L::U16 tops(const T& v, const L::U16& threshold) {
        // A step is 2^(28 - Bits) in the 28 bits of steps(). A 32nd of a step of five bits is 2^6 in a
        // threshold.
        return L::low_half((steps<Bits>(v) + (L::widened(threshold) << (17 - Bits))) >> 12);
    }
    template <unsigned Bits> SPANGLE_INLINE static L::U16 dithered(const T& v, const L::U16& threshold32) {
        return L::low_half((steps<Bits>(v) + (L::widened(threshold32) << (23 - Bits))) >> (28 - Bits));
    }

  private:
    /// (k one + more) / Most, rounded down. one / Most is taken as a whole number and a rest.
    template <std::uint32_t Most> SPANGLE_INLINE static T step(const T& k, std::uint32_t more) {
        constexpr std::uint32_t whole = one / Most, rest = one % Most;
        // The second term is (k rest + more) / Most. For numerators below Most (Most + 1) an inverse with 20
        // fraction bits is exact.
        constexpr std::uint32_t inverse = ((1u << 20) + Most - 1) / Most;
        return k * whole + (((k * rest + L::splat32(more)) * inverse) >> 20);
    }
    template <unsigned Bits> SPANGLE_INLINE static T steps(const T& v) {
        static_assert(Bits == 5 || Bits == 6);
        return lane_product_high(v, L::splat32(exact_steps.of(Bits == 6 ? 1 : 0)));
    }
};

template <> struct WithOneLane<ExactLanes> { using Type = Exact; };

/// True for number systems of the exact tier with any number of lanes.
template <class N> inline constexpr bool is_exact = std::is_same_v<OneLane<N>, Exact>;

/// The number system of the exact tier in which the chain of this build draws.
using ExactChain = std::conditional_t<host_lanes == 8, ExactLanes, Exact>;

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
