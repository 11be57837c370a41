// Number systems of sprites. Their colours are RGBA texels of 8 bits until they are blended with SRC_ALPHA,
// ONE_MINUS_SRC_ALPHA into a surface R5 G6 B5.
#pragma once

#include "raster/ops/number.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// The number system of sprites in the balanced tier. Two components share a word, and the bits are those of
/// Balanced<1>.
struct Packed {
    using Policy = Fixed;
    static constexpr int lanes = 1;
    using L = Lanes<1>;
    using T = std::uint32_t;
    struct Color {
        std::uint32_t word; ///< 8 bits for each component, R in the lowest byte
        SPANGLE_INLINE std::uint32_t r() const { return word & 0xFF; }
        SPANGLE_INLINE std::uint32_t g() const { return word >> 8 & 0xFF; }
        SPANGLE_INLINE std::uint32_t b() const { return word >> 16 & 0xFF; }
        SPANGLE_INLINE std::uint32_t a() const { return word >> 24; }
    };
    using Coord = TexCoords<std::uint32_t, 1>;
    using Fog = std::uint32_t;

    SPANGLE_INLINE static Color from_word(std::uint32_t texel) { return {texel}; }
    SPANGLE_INLINE static std::uint32_t opaque(const Color& s) {
        return ((s.word << 8) & 0xF800) | ((s.word >> 5) & 0x07E0) | (s.word >> 19 & 0x1F);
    }
    /// clear(): blending leaves the stored pixel as it is. is_opaque(): blending stores the colour itself.
    SPANGLE_INLINE static bool clear(const Color& s) { return s.a() == 0; }
    SPANGLE_INLINE static bool is_opaque(const Color& s) { return s.a() == 255; }
    /// The stored word that Balanced<1>::over() and to8() make.
    SPANGLE_INLINE static std::uint32_t over(const Color& s, std::uint32_t under) {
        const Rounded x(s, under);
        return (x.rb & 0xF800) | ((x.g >> 5) & 0x07E0) | x.rb >> 27;
    }
    /// A threshold of dithering, in 2^-27 of a step of five bits.
    struct Threshold {
        std::uint32_t five;
        constexpr Threshold(std::uint32_t threshold32 = 0) : five(threshold32 << 22) {}
    };
    /// The stored word that Balanced<1>::over() and dithered() make. Its bits are the top bits of products.
    SPANGLE_INLINE static std::uint32_t over(const Color& s, std::uint32_t under, const Threshold& t) {
        // The factors by_five and by_six are kept in registers. Compilers would make sums of shifts of
        // constant factors.
        std::uint32_t by5 = numeric::kept_in_register(by_five), by6 = numeric::kept_in_register(by_six);
        Sums x(s, under);
        x.rb += ((x.rb + 0x00800080) >> 8) & 0x00FF00FF;
        x.g += (x.g + 0x80) >> 8;
        const std::uint32_t five = numeric::factor32(t.five); // compilers then read the threshold once
        return ((x.rb & 0xFFFF) * by5 + five) >> 27 << 11 | (x.g * by6 + (five >> 1)) >> 26 << 5 |
               ((x.rb >> 16) * by5 + five) >> 27;
    }

  private:
    static constexpr std::uint32_t by_five = Balanced<1>::step_scale(5), by_six = Balanced<1>::step_scale(6);
    /// The blended components in 65025ths (255ths of 255ths), as Balanced<1>::over() has them before its
    /// division.
    struct Sums {
        std::uint32_t rb, g;
        SPANGLE_INLINE Sums(const Color& s, std::uint32_t under) {
            const std::uint32_t a = s.a(), rest = 255 - a;
            rb = (s.word & 0x00FF00FF) * a + (under >> 11 | (under & 31) << 16) * weight<5>(rest);
            g = numeric::bit_field<8, 8>(s.word) * a + ((under >> 5) & 63) * weight<6>(rest);
        }
    };
    /// Does what Balanced<1>::over() does, with 128 added, so that the top bits are rounded.
    struct Rounded : Sums {
        SPANGLE_INLINE Rounded(const Color& s, std::uint32_t under) : Sums(s, under) {
            rb += 0x00800080;
            g += 0x80;
            rb += (rb >> 8) & 0x00FF00FF; // red and blue both stay below 2^16
            g += g >> 8;
        }
    };
    /// Does what Balanced<1>::over_weight() does, for a `rest` that is a whole number of 255ths.
    template <unsigned Bits> SPANGLE_INLINE static std::uint32_t weight(std::uint32_t rest) {
        constexpr std::uint32_t scale = Balanced<1>::over_scale(Bits);
        return (rest * scale + (Balanced<1>::over_half(Bits) * scale >> 8)) >> 8;
    }
};

/// The number system of sprites in the exact tier. It makes the bits of Exact, whose rounding to 8 bits
/// depends on the exact quotient alone.
///
/// Let k of m steps be stored, m = 31 or 63. Then v = s a + (255 - a) 255 k / m in 65025ths is a multiple of
/// 1 / m. m is odd, so v is never halfway between two whole numbers, but at least 1 / (2 m) away from there.
/// v is rounded to a whole number, which lies on the same side of every halfway point between two 255ths.
struct PackedExact : Packed {
    SPANGLE_INLINE static std::uint32_t over(const Color& s, std::uint32_t under) {
        const std::uint32_t rest = 255 - s.a(), a = s.a() << fraction, w5 = weight<5>(rest),
                            w6 = weight<6>(rest);
        const std::uint32_t r = rounded<5>(s.r() * a + (under >> 11) * w5),
                            g = rounded<6>(s.g() * a + ((under >> 5) & 63) * w6),
                            b = rounded<5>(s.b() * a + (under & 31) * w5);
        return (r & 0xF800) | ((g >> 5) & 0x07E0) | b >> 11;
    }
    struct Threshold {
        std::uint32_t more;
        constexpr Threshold(std::uint32_t threshold32 = 0) : more((threshold32 * 65025 >> 5) + 511) {}
    };
    /// Dithered blending. v is a whole number of 65025ths of a step, so whole numbers decide floor(v + t).
    /// Thresholds are odd numbers of 32nds. So no sum is nearer to a step than 2^-21, and Exact is off by
    /// less than that.
    SPANGLE_INLINE static std::uint32_t over(const Color& s, std::uint32_t under, const Threshold& t) {
        // The steps of v = m s a + 255 (255 - a) k. With the threshold, v is below 2^22.
        const auto steps = [more = t.more](std::uint32_t v) {
            return (v + more + 511 * ((v + more) >> 16)) >> 16;
        };
        const std::uint32_t rest = 255 * (255 - s.a()), by5 = 31 * s.a(), by6 = 63 * s.a();
        const std::uint32_t r = steps(s.r() * by5 + (under >> 11) * rest),
                            g = steps(numeric::bit_field<8, 8>(s.word) * by6 + ((under >> 5) & 63) * rest),
                            b = steps(s.b() * by5 + (under & 31) * rest);
        return r << 11 | g << 5 | b;
    }

  private:
    static constexpr unsigned fraction = 13;
    /// The weight rest 255 / m in 2^-13; it is less than 2 too small.
    template <unsigned Bits> SPANGLE_INLINE static std::uint32_t weight(std::uint32_t rest) {
        constexpr unsigned more = Bits + 2; // keeps rest * scale below 2^32
        constexpr std::uint32_t m = (1u << Bits) - 1, scale = (255u << (fraction + more)) / m;
        return (rest * scale) >> more;
    }
    /// Rounds v to 8 bits, where v is in 2^-13 and less than 2 m too small. m is added, which leaves an error
    /// of less than 1 / (2 m). The result is 256 v / 255, of which the top 8 bits count.
    template <unsigned Bits> SPANGLE_INLINE static std::uint32_t rounded(std::uint32_t v) {
        constexpr std::uint32_t m = (1u << Bits) - 1, half = (128u << fraction) + (1u << (fraction - 1)) + m;
        const std::uint32_t x = (v + half) >> fraction;
        return x + (x >> 8);
    }
};

/// The number system of sprites in the fast tier (Coarse). All three components are blended by one product.
struct PackedCoarse : Packed {
    // Alpha is 0 of 32 (Coarse counts it in 32nds).
    SPANGLE_INLINE static bool clear(const Color& s) { return s.word < 4u << 24; }
    // Alpha is 32 of 32.
    SPANGLE_INLINE static bool is_opaque(const Color& s) { return s.word >= 252u << 24; }
    /// Alpha in 32nds, where 32 becomes 0, too.
    SPANGLE_INLINE static std::uint32_t weight(const Color& s) { return (s.word + (4u << 24)) >> 27; }
    SPANGLE_INLINE static bool whole(const Color& s) { return weight(s) == 0; }
    SPANGLE_INLINE static std::uint32_t over(const Color& s, std::uint32_t under) {
        return over_both(s, weight(s), under | under << 16);
    }
    struct Threshold {
        std::uint32_t bytes;
        constexpr Threshold(std::uint32_t threshold32 = 0)
            : bytes((threshold32 >> 2) * 0x00010001 + (threshold32 >> 3 << 8)) {}
    };
    /// Does what Coarse::dithered() does, for all components at once. Only the bits above the fractions of
    /// steps are blended or stored. No byte carries into the next byte.
    SPANGLE_INLINE static Color dithered(const Color& s, const Threshold& t) {
        return {s.word - (s.word >> 5 & 0x00070007) - (s.word >> 6 & 0x00000300) + t.bytes};
    }
    /// The blended word for a colour that is not solid; `both` holds the stored word twice. Every sum is
    /// below 2^10, or below 2^11 for six bits, so no sum carries into the next component.
    SPANGLE_INLINE static std::uint32_t over_both(const Color& s, std::uint32_t a, std::uint32_t both) {
        // Fields are extracted before they are inserted, which takes five instructions on ARM.
        const std::uint32_t r = numeric::factor32(numeric::bit_field<3, 5>(s.word)),
                            g = numeric::factor32(numeric::bit_field<10, 6>(s.word));
        const std::uint32_t source = numeric::bit_field<19, 5>(s.word) | r << 11 | g << 21;
        const std::uint32_t stored = both & components;
        constexpr std::uint32_t halves = 16u << 21 | 16u << 11 | 16u;
        const std::uint32_t sum =
            (stored + (((source - stored) * a + halves) >> 5)) & components; // the sum is modulo 2^27
        return (sum | sum >> 16) & 0xFFFF;
    }

  private:
    /// G in the high half-word, R and B in the low half-word.
    static constexpr std::uint32_t components = 0x07E0F81F;
};
template <class N> inline constexpr bool is_packed = std::is_base_of_v<Packed, N>;

/// A number system of sprites in lanes of 16 bits. Its components are whole 255ths.
template <int Count> struct Bytes {
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
};

/// The number system of sprites in lanes in the fast tier, with the bits of PackedCoarse.
template <int Count> struct CoarseBytes : Bytes<Count> {
    using T = typename Bytes<Count>::T;
    struct Threshold {
        static constexpr int words = 1;
        static constexpr std::uint32_t word(int, std::uint32_t threshold32) { return threshold32; }
    };
    template <unsigned Bits> SPANGLE_INLINE static T over(T s, T a, T k) {
        return Coarse::over<T>(s >> (8 - Bits), Coarse::alpha<T>(a), k) << (8 - Bits);
    }
    template <unsigned Bits, class Thresholds>
    SPANGLE_INLINE static T dithered(T s, T a, T k, const Thresholds& t) {
        return Coarse::over<T>(Coarse::dithered<Bits, T>(s, t.word(0)), Coarse::alpha<T>(a), k);
    }
};

/// The number system of sprites in lanes in the exact tier, with the bits of Exact.
template <int Count> struct ExactBytes : Bytes<Count> {
    using typename Bytes<Count>::L, typename Bytes<Count>::T;
    /// The blended component. In 65025ths v (see PackedExact) is s a + (255 - a) k 255 / m. With 255 = whole
    /// m + rest the second product is `parts` + parts rest / (whole m). `parts` is a whole number, and the
    /// second term is never halfway between two whole numbers. The sum is rounded to a whole number, which
    /// lies on the same side of every halfway point between two 255ths.
    template <unsigned Bits> SPANGLE_INLINE static T over(T s, T a, T k) {
        constexpr std::uint32_t m = (1u << Bits) - 1, whole = 255 / m, rest = 255 % m, unit = whole * m;
        constexpr std::uint32_t scale = ((rest << (16 + Bits)) + unit / 2) / unit;
        const T parts = k * (L::splat(255) - a) * whole;
        const T more = (L::mul_high(parts, L::splat(scale)) + (1u << (Bits - 1))) >> Bits;
        return by_256ths(s * a + parts + more + 128);
    }
    /// A threshold T = floor(65025 t), split into whole 255ths and the rest. Each word is one larger, as
    /// by_256ths() needs it.
    struct Threshold {
        static constexpr int words = 2;
        static constexpr std::uint32_t word(int i, std::uint32_t threshold32) {
            const std::uint32_t t = threshold32 * 65025 >> 5;
            return (i == 0 ? t / 255 : t % 255) + 1;
        }
    };
    /// The steps of PackedExact, floor((m s a + 255 (255 - a) k + T) / 65025), made by two divisions by 255.
    /// 256 is 255 + 1, so the product is split into high 256 + low.
    template <unsigned Bits, class Thresholds>
    SPANGLE_INLINE static T dithered(T s, T a, T k, const Thresholds& t) {
        constexpr std::uint32_t m = (1u << Bits) - 1;
        const T product = s * a, high = product >> 8;
        const T low = (high + (product & 255)) * m + t.word(1);
        return by_256ths(high * m + t.word(0) + by_256ths(low) + k * (L::splat(255) - a));
    }

  private:
    /// floor((v + floor(v / 256)) / 256). Called with v + 1 it gives floor(v / 255), where v + 1 < 2^16.
    SPANGLE_INLINE static T by_256ths(T v) { return L::mul_high(v, L::splat(257)); }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
