// Number systems of sprites: colours that are 8-bit RGBA texels until they are blended with SRC_ALPHA,
// ONE_MINUS_SRC_ALPHA into a 565 surface.
#pragma once

#include "raster/span/number.hpp"

namespace spangle::raster {

/// Two components in a word, the bits of Balanced<1>.
struct Packed {
    using Policy = Fixed;
    static constexpr int lanes = 1;
    using L = Lanes<1>;
    using T = std::uint32_t;
    struct Color {
        std::uint32_t rb; ///< R in the low half, B in the high one
        std::uint32_t g, a;
    };
    using Coord = TexCoords<std::uint32_t, 1>;
    using Fog = std::uint32_t;

    SPANGLE_INLINE static Color from_word(std::uint32_t texel) {
        return {texel & 0x00FF00FF, (texel >> 8) & 0xFF, texel >> 24};
    }
    SPANGLE_INLINE static std::uint32_t opaque(const Color& s) {
        return ((s.rb << 8) & 0xF800) | ((s.g << 3) & 0x07E0) | s.rb >> 19;
    }
    /// Balanced<1>::over, to8 and the top bits.
    SPANGLE_INLINE static std::uint32_t over(const Color& s, std::uint32_t under) {
        const Rounded x(s, under);
        return (x.rb & 0xF800) | ((x.g >> 5) & 0x07E0) | x.rb >> 27;
    }
    /// Balanced<1>::over and dithered, the top bits of products of words, from which the 128 are taken again.
    SPANGLE_INLINE static std::uint32_t over(const Color& s, std::uint32_t under, std::uint32_t threshold32) {
        constexpr std::uint32_t five = Balanced<1>::step_scale(5), six = Balanced<1>::step_scale(6);
        const Rounded x(s, under);
        const std::uint32_t t5 = (threshold32 << 22) - 128 * five, t6 = (threshold32 << 21) - 128 * six;
        return ((x.rb & 0xFFFF) * five + t5) >> 27 << 11 | (x.g * six + t6) >> 26 << 5 |
               ((x.rb >> 16) * five + t5) >> 27;
    }

  private:
    /// Balanced<1>::over and 128.
    struct Rounded {
        std::uint32_t rb, g;
        SPANGLE_INLINE Rounded(const Color& s, std::uint32_t under) {
            const std::uint32_t rest = 255 - s.a;
            rb = s.rb * s.a + (under >> 11 | (under & 31) << 16) * weight<5>(rest) + 0x00800080;
            g = s.g * s.a + ((under >> 5) & 63) * weight<6>(rest) + 0x80;
            rb += (rb >> 8) & 0x00FF00FF; // both halves stay below 2^16
            g += g >> 8;
        }
    };
    /// Balanced<1>::over_weight of a whole number of 255ths.
    template <unsigned Bits> SPANGLE_INLINE static std::uint32_t weight(std::uint32_t rest) {
        constexpr std::uint32_t scale = Balanced<1>::over_scale(Bits);
        return (rest * scale + (Balanced<1>::over_half(Bits) * scale >> 8)) >> 8;
    }
};

/// The same of the exact tier: the bits of Exact, which rounds to 8 bits what nothing but the quotient
/// decides. With k of m = 31 or 63 steps stored, v = (m s a + 255 (255 - a) k) / (255 m) is never halfway
/// between two of them, m being odd.
struct PackedExact : Packed {
    SPANGLE_INLINE static std::uint32_t over(const Color& s, std::uint32_t under) {
        return composed(s, under, Rounded{});
    }
    /// Dithered: v is a whole number of 65025ths of a step, so that floor(v + t) is one of the whole numbers
    /// of them. Thresholds are odd 32nds: nothing is nearer to a step than 2^-21, more than Exact is off by.
    SPANGLE_INLINE static std::uint32_t over(const Color& s, std::uint32_t under, std::uint32_t threshold32) {
        return composed(s, under, Dithered{(threshold32 * 65025 >> 5) + 511});
    }

  private:
    /// The top bits of round(x / (255 m)): floor((x / (255 m) + 1/2) / 2^(8 - Bits)), x < 2^22.
    struct Rounded {
        template <unsigned Bits> SPANGLE_INLINE std::uint32_t top(std::uint32_t x) const {
            constexpr std::uint32_t unit = 255 * ((1u << Bits) - 1), step = unit << (8 - Bits);
            constexpr auto inverse = static_cast<std::uint32_t>((std::uint64_t{1} << 43) / step + 1);
            return numeric::mul_high_u32(x + unit / 2, inverse) >> 11; // off by less than 2^-21
        }
    };
    /// floor((x + T) / 65025), x + T < 2^22; `more` is T + 511.
    struct Dithered {
        std::uint32_t more;
        template <unsigned> SPANGLE_INLINE std::uint32_t top(std::uint32_t x) const {
            return (x + more + 511 * ((x + more) >> 16)) >> 16;
        }
    };
    /// Of x = m s a + 255 (255 - a) k.
    template <class How>
    SPANGLE_INLINE static std::uint32_t composed(const Color& s, std::uint32_t under, const How& how) {
        const std::uint32_t rest = 255 * (255 - s.a), by5 = 31 * s.a, by6 = 63 * s.a;
        const std::uint32_t r = how.template top<5>((s.rb & 0xFF) * by5 + (under >> 11) * rest),
                            g = how.template top<6>(s.g * by6 + ((under >> 5) & 63) * rest),
                            b = how.template top<5>((s.rb >> 16) * by5 + (under & 31) * rest);
        return r << 11 | g << 5 | b;
    }
};
template <class N>
inline constexpr bool is_packed = std::is_same_v<N, Packed> || std::is_same_v<N, PackedExact>;

/// The bits of Exact again, in lanes of 16 bits: components are whole 255ths.
template <int Count> struct ExactBytes {
    using Policy = Fixed;
    static constexpr int lanes = Count;
    using L = Lanes<Count>;
    using T = typename L::U16;
    using Color = Rgba<T>;
    using Coord = TexCoords<std::uint32_t, Count>;
    using Fog = typename L::U32;

    SPANGLE_INLINE static T from8(T k) { return k; }
    SPANGLE_INLINE static T to8(T v) { return v; }
    SPANGLE_INLINE static T from_units(std::uint32_t c) { return L::splat(c >> color_fraction_bits); }
    /// v (PackedExact) in 65025ths is s a + (255 - a) k 255 / m. With 255 = whole m + rest the second product
    /// is `parts`, a whole number, and parts rest / (whole m), which is never halfway between two. Rounded to
    /// a whole number the sum is on the same side of every halfway point between two 255ths.
    template <unsigned Bits> SPANGLE_INLINE static T over(T s, T a, T k) {
        constexpr std::uint32_t m = (1u << Bits) - 1, whole = 255 / m, rest = 255 % m, unit = whole * m;
        constexpr std::uint32_t scale = ((rest << (16 + Bits)) + unit / 2) / unit;
        const T parts = k * (L::splat(255) - a) * whole;
        const T more = (L::mul_high(parts, L::splat(scale)) + (1u << (Bits - 1))) >> Bits;
        const T x = s * a + parts + more + 128;
        return (x + (x >> 8)) >> 8;
    }
    /// floor(65025 t), t in 32nds, in 255ths and what is left of them.
    struct Threshold {
        T whole, rest;
        Threshold() = default;
        SPANGLE_INLINE explicit Threshold(T threshold32)
            : whole((threshold32 * 255) >> 5),
              rest(L::mul_high(threshold32 << 11, L::splat(65025)) - whole * 255) {}
    };
    /// PackedExact's steps, floor((m s a + 255 (255 - a) k + T) / 65025): divided by 255 twice, of which 256
    /// is one and 1.
    template <unsigned Bits> SPANGLE_INLINE static T dithered(T s, T a, T k, const Threshold& t) {
        constexpr std::uint32_t m = (1u << Bits) - 1;
        const T product = s * a, high = product >> 8;
        const T low = (high + (product & 255)) * m + t.rest;
        return by_255(high * m + t.whole + by_255(low) + k * (L::splat(255) - a));
    }

  private:
    /// floor(v / 255), v < 2^16.
    SPANGLE_INLINE static T by_255(T v) { return L::mul_high(v, L::splat(0x8081)) >> 7; }
};

} // namespace spangle::raster
