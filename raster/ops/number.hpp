// Number systems of the stages say what a colour is and how colours are combined. The tier of accuracy
// selects the number system (docs/architecture/fragments.md, "Tiers"). Every number system has the members
// that Exact documents. Lists of stages are templates over it.
#pragma once

#include <cstdint>
#include <type_traits>

#include "raster/ops/lanes.hpp"
#include "raster/span/color_steps.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/span.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

template <class T> struct Rgba { T r, g, b, a; };
template <class V, class T> SPANGLE_INLINE void lane_of(const Rgba<V>& v, int i, Rgba<T>& to) {
    lane_of(v.r, i, to.r), lane_of(v.g, i, to.g), lane_of(v.b, i, to.b), lane_of(v.a, i, to.a);
}
template <class V, class T> SPANGLE_INLINE void set_lane(Rgba<V>& v, int i, const Rgba<T>& from) {
    set_lane(v.r, i, from.r), set_lane(v.g, i, from.g), set_lane(v.b, i, from.b), set_lane(v.a, i, from.a);
}

/// Texture coordinates of one unit, one pair per lane. With Wrap::repeat one repeat is 2^32. The word wraps
/// as the texture does, and texel = s >> (32 - log2 size). With the other wrap modes a coordinate is a
/// signed, saturated word with `clamped_coord_bits` fraction bits.
template <class T, int Count> struct TexCoords { T s[Count], t[Count]; };

/// The table of k / (Count - 1) in colour units, rounded to nearest, or up where Up is true.
template <std::uint32_t Count, bool Up = false> struct ColorSteps {
    std::uint32_t at[Count];
    constexpr ColorSteps() : at{} {
        constexpr std::uint32_t most = Count - 1, more = Up ? most - 1 : most / 2;
        for (std::uint32_t k = 0; k < Count; ++k)
            at[k] = static_cast<std::uint32_t>((std::uint64_t{k} * color_one + more) / most);
    }
};

/// A colour in steps, by the factors exact_steps. The result is at most one unit of its last fraction bit too
/// small.
template <bool Long = numeric::long_products>
SPANGLE_INLINE std::uint32_t color_in_steps(std::uint32_t c, int component) {
    if constexpr (Long) {
        return numeric::mul_high_u32(c, exact_steps.of(component));
    } else {
        // 2^32 less a factor is the same half-word twice, so two products take the place of four.
        const auto rest =
            static_cast<std::int32_t>(numeric::kept_in_register((0 - exact_steps.of(component)) >> 16));
        const auto less = -static_cast<std::int32_t>(c);
        const std::int32_t high = (less >> 16) * rest,
                           low = static_cast<std::int32_t>(numeric::detail::low_half(0 - c)) * rest;
        return c + static_cast<std::uint32_t>(high + ((high + low + (low >> 16)) >> 16));
    }
}
/// A colour in steps, by the factors near_steps, which are 249/256 and 253/256. Without long products, 7/256
/// and 3/256 of the colour are subtracted by shifts.
template <bool Long = numeric::long_products>
SPANGLE_INLINE std::uint32_t color_in_near_steps(std::uint32_t c, int component) {
    if constexpr (Long)
        return numeric::mul_high_u32(c, near_steps.of(component));
    else
        return c - (((component == 1 ? c + (c << 1) : (c << 3) - c) + 255) >> 8);
}
/// A colour in steps, by exact_steps, but up to 2^-12 of a 255th too large. `rest` is 1 minus the factor.
SPANGLE_INLINE std::uint32_t color_in_guessed_steps(std::uint32_t c, int component) {
    // One minus the factor of exact_steps, in units of 2^-16.
    const auto rest = numeric::kept_in_register(component == 1 ? 771u : 1799u);
    return c - ((c >> 8) * rest >> 8);
}

/// The number system of the exact tier, and the model for the other systems. Components are 255ths with 20
/// fraction bits.
struct Exact {
    using Policy = Fixed;
    static constexpr int lanes = 1;
    using L = Lanes<1>;
    using T = std::uint32_t; ///< a component, 0 .. one
    using Color = Rgba<T>;
    using Coord = TexCoords<std::uint32_t, 1>;
    using Fog = std::uint32_t; ///< a fog coordinate in s7.24, two's complement
    static constexpr T one = color_one;

    /// from8() makes the component k / 255; to8() makes the nearest k of a component.
    SPANGLE_INLINE static T from8(L::U16 k) { return k << color_fraction_bits; }
    SPANGLE_INLINE static L::U16 to8(T v) {
        return (v + (1u << (color_fraction_bits - 1))) >> color_fraction_bits;
    }
    /// k / 31 and k / 63 to the nearest unit. 31 / 31 and 63 / 63 are exactly one.
    SPANGLE_INLINE static constexpr T from5(L::U16 k) { return steps5.at[k]; }
    SPANGLE_INLINE static constexpr T from6(L::U16 k) { return steps6.at[k]; }
    /// k / 31 and k / 63 of texels, rounded up. So a filtered colour is never below the value that GL 1.3,
    /// 3.8.8 asks for (weighted()).
    SPANGLE_INLINE static constexpr T texel5(L::U16 k) { return texels5.at[k]; }
    SPANGLE_INLINE static constexpr T texel6(L::U16 k) { return texels6.at[k]; }
    /// k / 7 of texels, rounded up.
    SPANGLE_INLINE static constexpr T texel3(L::U16 k) { return (k * color_one + 6) / 7; }
    /// A component from a constant in colour units (vertex.hpp).
    SPANGLE_INLINE static T from_units(std::uint32_t c) { return c; }
    /// A component from the word of an interpolated colour of a span (8.24).
    SPANGLE_INLINE static T from_affine(L::U32 v) {
        // The bias that set-up has added to the colour. A value that rounding has taken below the bias counts
        // as 0.
        constexpr std::uint32_t bias = 1u << 15;
        const std::uint32_t c = v < bias ? 0 : (v - bias) >> (24 - color_fraction_bits);
        return c < one ? c : one;
    }
    /// The product a b, where `one` is the neutral element; off by less than 2^-28 of one.
    SPANGLE_INLINE static T mul(T a, T b) { return scaled(a, fraction(b)); }
    /// v as a factor of scaled(), which several products may share: v 4096 / 255, 0 .. 2^32 - 1, at most 3
    /// too small.
    SPANGLE_INLINE static constexpr std::uint32_t fraction(T v) {
        return (v << 4) + (v >> 4) + (v >> 12) + (v >> 20);
    }
    SPANGLE_INLINE static T scaled(T a, std::uint32_t factor) {
        return static_cast<T>(numeric::high_rounded(static_cast<std::int64_t>(numeric::mul_u32(a, factor))));
    }
    /// The mean a (1 - k) + b k, at most one.
    SPANGLE_INLINE static T lerp(T a, T b, T k) {
        const T sum = mul(a, one - k) + mul(b, k);
        return sum < one ? sum : one;
    }
    SPANGLE_INLINE static T add(T a, T b) { return L::minimum(a + b, one); }
    /// Blends: a s + (1 - a) k / (2^Bits - 1), where k is the component as stored.
    template <unsigned Bits> SPANGLE_INLINE static T over(T s, T a, L::U16 k) {
        const T d = Bits == 5 ? from5(k) : Bits == 6 ? from6(k) : from8(k);
        return add(mul(s, a), mul(d, one - a));
    }
    /// The sum of value * weight / 2^16, rounded up. The weights sum to 2^16. Texels are rounded up, too, so
    /// the sum is the value of GL's formula or up to two units more. A sum that lies on a threshold, or
    /// halfway between two 255ths, is therefore never taken for the step below. (With GL_DITHER on, one in
    /// 300 texels of 5 and 6 bits lies on a threshold.)
    SPANGLE_INLINE static T weighted(T a, std::uint32_t wa, T b, std::uint32_t wb, T c, std::uint32_t wc, T d,
                                     std::uint32_t wd) {
        return static_cast<T>((numeric::mul_u32(a, wa) + numeric::mul_u32(b, wb) + numeric::mul_u32(c, wc) +
                               numeric::mul_u32(d, wd) + 65535) >>
                              16);
    }
    SPANGLE_INLINE static T subtract(T a, T b) { return a > b ? a - b : 0; }
    /// A factor for mix(): min(max(v, 0), 1) in 2^-30, where v is signed with 24 fraction bits, as fog
    /// factors are.
    SPANGLE_INLINE static T clamped_fraction(L::U32 v) {
        const auto s = static_cast<std::int32_t>(v);
        const std::uint32_t f = s < 0 ? 0 : s > 1 << 24 ? 1u << 24 : v;
        return f << 6;
    }
    /// The mean a (1 - f) + b f, rounded down, with f in 2^-30. Differences of components take 29 bits.
    SPANGLE_INLINE static T mix(T a, T b, T f) {
        return a + static_cast<T>(numeric::mul_high_s32(static_cast<std::int32_t>((b - a) << 2),
                                                        static_cast<std::int32_t>(f)));
    }
    /// floor(v (2^Bits - 1) + t), where t is an odd number of 32nds. Colours of whole steps do not change (GL
    /// 1.3, 4.1.8).
    template <unsigned Bits> SPANGLE_INLINE static L::U16 dithered(T v, L::U16 threshold32) {
        // The threshold is at most 31/32 of a step, so the sum does not wrap.
        return (steps<Bits>(v) + (threshold32 << (steps_word<Bits> - 5 - Bits))) >> (steps_word<Bits> - Bits);
    }
    /// v (2^Bits - 1) in whole 32nds of a step.
    template <unsigned Bits> SPANGLE_INLINE static std::uint32_t steps32(T v) {
        return steps<Bits>(v) >> (steps_word<Bits> - 5 - Bits);
    }

  private:
    /// The size of what steps() returns, in bits. The upper `Bits` of them are whole steps, the others a
    /// fraction.
    template <unsigned Bits> static constexpr unsigned steps_word = Bits == 5 || Bits == 6 ? 28 : 32;
    /// v (2^Bits - 1). The result is up to 2^Bits - 1 steps, each of which is 2^(steps_word - Bits).
    template <unsigned Bits> SPANGLE_INLINE static std::uint32_t steps(T v) {
        if constexpr (Bits == 5 || Bits == 6)
            return color_in_steps(v, Bits == 5 ? 0 : 1);
        constexpr std::uint64_t factor =
            ((((std::uint64_t{1} << Bits) - 1) << (64 - Bits - color_fraction_bits)) + 254) / 255;
        // This is v factor / 2^32. Two products are faster than the shifts that a compiler finds for 64 bits.
        return v * static_cast<std::uint32_t>(factor >> 32) +
               numeric::mul_high_u32(v, static_cast<std::uint32_t>(factor));
    }
    static constexpr ColorSteps<32> steps5{};
    static constexpr ColorSteps<64> steps6{};
    static constexpr ColorSteps<32, true> texels5{};
    static constexpr ColorSteps<64, true> texels6{};
};

/// The number system of the balanced tier. Components are 255ths with 8 fraction bits in 16 bits (0 ..
/// 65280). One lane and eight lanes make the same bits.
template <int Count> struct Balanced {
    using Policy = Fixed;
    static constexpr int lanes = Count;
    using L = Lanes<Count>;
    using T = typename L::U16;
    using Color = Rgba<T>;
    using Coord = TexCoords<std::uint32_t, Count>;
    using Fog = typename L::U32;
    static constexpr std::uint32_t one = 255u << 8;

    SPANGLE_INLINE static T from8(T k) { return k << 8; }
    SPANGLE_INLINE static T to8(T v) { return (v + 128) >> 8; }
    /// k / 31 and k / 63, within a 50th of a 255th.
    SPANGLE_INLINE static constexpr T from5(T k) { return k * 2106 - (k >> 2); }
    SPANGLE_INLINE static constexpr T from6(T k) {
        if constexpr (Count == 1)
            return k * 1036 + (k >> 3);
        // 12 / 2^10 of `top` are added. Compilers would make seven instructions of the product above.
        const T top = k << 10;
        return top + L::mul_high(top, L::splat(12u << 6)) + (top >> 13);
    }
    SPANGLE_INLINE static constexpr T texel5(T k) { return from5(k); }
    SPANGLE_INLINE static constexpr T texel6(T k) { return from6(k); }
    /// k / 7, to the nearest. It is k 65280 / 7, and 65280 / 7 is 9326 less 2 / 7.
    SPANGLE_INLINE static constexpr T texel3(T k) { return k * 9326 - ((k * 73 + 128) >> 8); }
    SPANGLE_INLINE static T from_units(std::uint32_t c) { return L::splat((c + (1u << 11)) >> 12); }
    /// Set-up has added the half that rounds to 8.8. Set-up is off by less than this half, and fragments lie
    /// inside of their primitive. So no component is above one.
    SPANGLE_INLINE static T from_affine(const typename L::U32& v) { return L::high_half(v); }
    /// The product a b, at most 3 256ths of a 255th too small; at most 2 where a and b have 8 bits.
    SPANGLE_INLINE static T mul(T a, T b) { return scaled(a, fraction(b)); }
    /// v as a factor of scaled() and mix(): 0 .. one becomes 0 .. 65535.
    SPANGLE_INLINE static constexpr T fraction(T v) { return v + (v >> 8); }
    SPANGLE_INLINE static T scaled(T a, T factor) { return L::mul_high(a, factor); }
    SPANGLE_INLINE static T lerp(T a, T b, T k) { return mix(a, b, fraction(k)); }
    /// The mean a (1 - f) + b f. f has 16 bits, and 65535 stands for 1.
    SPANGLE_INLINE static T mix(T a, T b, T f) { return L::mul_high(a, 65535 - f) + L::mul_high(b, f); }
    SPANGLE_INLINE static T add(T a, T b) { return a + L::minimum(b, L::splat(one) - a); }
    /// Blends in 65025ths, which 16 bits hold. The stored k is not expanded to 8 bits: the weight that it is
    /// multiplied by turns 31sts and 63rds into 65025ths. The sum is at most 1/5 of a 255th off. It is exact
    /// to 8 bits where s, a and k have 8 bits.
    template <unsigned Bits> SPANGLE_INLINE static T over(T s, T a, T k) {
        const T rest = L::splat(one) - a;
        const T stored = Bits == 8 ? L::mul_high(k << 8, rest) : k * over_weight<Bits>(rest);
        const T x = L::mul_high(s, a) + stored + 128;
        return x + (x >> 8) - 128; // multiplies by 256 / 255, which rounds the 8 bits exactly
    }
    /// What over_weight() multiplies with, and what it adds first in order to round to nearest.
    static constexpr std::uint32_t over_scale(unsigned bits) { return bits == 5 ? 2105 : 1036; }
    static constexpr std::uint32_t over_half(unsigned bits) { return bits == 5 ? 16 : 32; }
    /// The weight of a stored component: rest 255 / (2^Bits - 1) / 256, to nearest (Bits 5 or 6).
    template <unsigned Bits> SPANGLE_INLINE static T over_weight(T rest) {
        return L::mul_high(rest + L::splat(over_half(Bits)), L::splat(over_scale(Bits)));
    }
    /// The sum of value * weight / 2^16, where each product is rounded down. The weights sum to at most 2^16
    /// - 1.
    SPANGLE_INLINE static T weighted(T a, T wa, T b, T wb, T c, T wc, T d, T wd) {
        return L::mul_high(a, wa) + L::mul_high(b, wb) + L::mul_high(c, wc) + L::mul_high(d, wd);
    }
    SPANGLE_INLINE static T subtract(T a, T b) { return a - L::minimum(a, b); }
    /// A factor for mix(): min(max(v, 0), 1), where v is signed with 24 fraction bits.
    SPANGLE_INLINE static T clamped_fraction(const typename L::U32& v) { return L::clamped_24_to_16(v); }
    /// A threshold of dithering, in 2^-11 of a step of five bits.
    struct Threshold {
        static constexpr int words = 1;
        static constexpr std::uint32_t word(int, std::uint32_t threshold32) { return threshold32 << 6; }
    };
    /// The dithered colour as a word of 16 bits, with whole steps in the top bits.
    template <unsigned Bits> SPANGLE_INLINE static T tops(T v, T threshold) {
        return steps<Bits>(v) + (threshold >> (Bits - 5));
    }
    template <unsigned Bits> SPANGLE_INLINE static T dithered(T v, T threshold32) {
        // The whole 32-bit product is used. 1 plus the largest threshold stays below 2^32.
        if constexpr (Count == 1) {
            std::uint32_t factor = step_scale(Bits);
            // Compilers for Thumb would make a sum of shifts of a constant factor, so it is kept in a
            // register.
            if constexpr (!numeric::long_products)
                factor = numeric::kept_in_register(factor);
            // All components use one mask of thresholds.
            return (v * factor + (numeric::factor32(threshold32 << 22) >> (Bits - 5))) >> (32 - Bits);
        }
        return (steps<Bits>(v) + (threshold32 << (11 - Bits))) >> (16 - Bits);
    }
    template <unsigned Bits> SPANGLE_INLINE static T steps32(T v) { return steps<Bits>(v) >> (11 - Bits); }
    /// The factor that makes steps of 2^(16 - bits) by a high product. Colours of whole steps come out at
    /// most 3 too small, and the least threshold is 32 or more.
    static constexpr std::uint32_t step_scale(unsigned bits) {
        return (((1u << bits) - 1) << 16 << (16 - bits)) / one + 1;
    }
    template <unsigned Bits> SPANGLE_INLINE static T steps(T v) {
        return L::mul_high(v, L::splat(step_scale(Bits)));
    }
    /// The colour in steps of 2^(15 - bits), which fit signed half-words.
    template <unsigned Bits> SPANGLE_INLINE static constexpr T steps15(T v) {
        constexpr std::uint32_t scale = (((1u << Bits) - 1) << 15 << (16 - Bits)) / one + 1;
        if constexpr (Count == 1)
            return (v * scale) >> 16;
        else
            return L::mul_high(v, L::splat(scale));
    }
    /// A colour whose components are counted in the steps of 5, 6 and 5 bits in which they are stored.
    SPANGLE_INLINE static Color in_steps(const Color& c) {
        return {steps15<5>(c.r), steps15<6>(c.g), steps15<5>(c.b), c.a};
    }
};

/// Blending of the fast tier with SRC_ALPHA, ONE_MINUS_SRC_ALPHA. Colours are counted in steps of the target,
/// and alpha in 32nds.
struct Coarse {
    /// Alpha of 8 bits in 32nds, to the nearest.
    template <class T> SPANGLE_INLINE static T alpha(T a) { return (a + 4) >> 3; }
    static constexpr std::uint32_t most = 32;
    /// (s a + k (32 - a)) / 32 to the nearest, halves up. The sum before the shift is at most 63 * 32 + 16.
    template <class T> SPANGLE_INLINE static T over(T s, T a, T k) {
        return ((k << 5) + (s - k) * a + 16) >> 5;
    }
    /// The source colour of blending where dithering is on, from a colour s of 8 bits. s - floor(s / 2^Bits)
    /// is the colour in 2^(Bits - 8) of a step. Thresholds are rounded down to this unit. The mean of a
    /// dithered pattern is within 3/16 of a step.
    template <unsigned Bits, class T> SPANGLE_INLINE static T dithered(T s, T threshold32) {
        return (s - (s >> Bits) + (threshold32 >> (Bits - 3))) >> (8 - Bits);
    }
};

/// The full weight of a texel, in 2^-16. Lanes of 16 bits hold at most 65535.
template <class N> inline constexpr std::uint32_t weight_one = 65536;
template <int Count> inline constexpr std::uint32_t weight_one<Balanced<Count>> = 65535;

/// The number system of colours that no stage combines. A colour is the 16 bits R5 G6 B5 from its source to
/// the surface.
template <int Count> struct Raw565 {
    using Policy = Fixed;
    using L = Lanes<Count>;
    static constexpr int lanes = L::count;
    using T = typename L::U16;
    struct Color {
        T word;
    };
    using Coord = TexCoords<std::uint32_t, Count>;
    using Fog = typename L::U32;
    /// Components of which only the top bits count. With one lane a component is a word of 32 bits. With
    /// eight lanes it is the high half of that word.
    struct Tops {
        T r, g, b;
    };
    SPANGLE_INLINE static Tops tops(const typename L::U32& r, const typename L::U32& g,
                                    const typename L::U32& b) {
        if constexpr (Count == 1)
            return {r, g, b};
        else
            return {L::high_half(r), L::high_half(g), L::high_half(b)};
    }
    /// Adds a threshold to components in steps (Variant::steps): floor(step + t), where t is a fraction of a
    /// step of five bits. 31 or 63 steps plus 31/32 do not wrap, but a component that set-up has made a
    /// little less than 0 does.
    SPANGLE_INLINE static Tops dithered(const Tops& v, T t) {
        if constexpr (Count == 1)
            t = numeric::factor32(t);
        const T t6 = t >> 1;
        return {v.r + t, v.g + t6, v.b + t};
    }
    /// The t of dithered() for a threshold in 32nds of a step.
    SPANGLE_INLINE static T fraction5(T threshold32) { return threshold32 << (6 + below); }
    SPANGLE_INLINE static Color word(const Tops& v) {
        return {(v.r >> below & 0xF800) | ((v.g >> (below + 5)) & 0x07E0) | (v.b >> (below + 11))};
    }
    /// The stored word. With one lane it is made without masks, by two shifts per component.
    SPANGLE_INLINE static Color joined(const Tops& v) {
        if constexpr (Count > 1) {
            return word(v);
        } else {
            const std::uint32_t red = numeric::factor32(v.r >> 27),
                                both = numeric::factor32(red << 6 | v.g >> 26);
            return {both << 5 | v.b >> 27};
        }
    }
    /// The stored word of an interpolated colour. It is rounded to 8 bits, for which set-up has added half a
    /// 255th, and cut to its top bits.
    SPANGLE_INLINE static Color from_affine(const typename L::U32& r, const typename L::U32& g,
                                            const typename L::U32& b) {
        return numeric::three_operands ? word(tops(r, g, b)) : joined(tops(r, g, b));
    }

  private:
    static constexpr int below = Count == 1 ? 16 : 0;
};

template <class V> SPANGLE_INLINE void lane_of(const V& v, int i, Raw565<1>::Color& to) {
    lane_of(v.word, i, to.word);
}
template <class V> SPANGLE_INLINE void set_lane(V& v, int i, const Raw565<1>::Color& from) {
    set_lane(v.word, i, from.word);
}

template <class N> inline constexpr bool is_balanced = false;
template <int Count> inline constexpr bool is_balanced<Balanced<Count>> = true;

/// The number system with one lane that makes the same bits as N.
template <class N> struct WithOneLane { using Type = N; };
template <int Count> struct WithOneLane<Balanced<Count>> { using Type = Balanced<1>; };
template <int Count> struct WithOneLane<Raw565<Count>> { using Type = Raw565<1>; };
template <class N> using OneLane = typename WithOneLane<N>::Type;

/// True for number systems whose colour is a stored word, without components that can be combined.
template <class N> inline constexpr bool is_raw = false;
template <int Count> inline constexpr bool is_raw<Raw565<Count>> = true;

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
