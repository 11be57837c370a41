// The LINEAR filter of the exact tier for words R5 G6 B5 that become words again. It computes only the bits
// of the colour that are stored.
#pragma once

#include <type_traits>

#include "raster/ops/number.hpp"
#include "raster/ops/texel.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

namespace inner {

/// Finds the step that is stored for n, the sum of weight k. The weights sum to 2^16, and k / (2^Bits - 1)
/// are the components of texels.
///
/// The chain sums weight c(k), where c(k) is k C / (2^Bits - 1) rounded up and C = 255 2^20. It rounds the
/// sum up (Exact::weighted()). So its sum is n C / (2^Bits - 1), or less than 2^17 more.
///
/// Step j is stored for sums from T = j 2^(44 - Bits) - 2^35 on. This is from n = T (2^Bits - 1) / C on,
/// which is a multiple of 1/255 (1/85 for 6 bits). The chain's excess is less than 1/63 (1/32) of n. With 5
/// bits no n is so near below a step, so n decides. With 6 bits the last n below a step may be so near, and
/// is left to the chain.
template <int Bits> struct StoredSteps {
    static constexpr std::uint32_t most = (1u << Bits) - 1;
    std::uint32_t from[most + 1]; ///< element j is the least n that gives step j + 1
    constexpr StoredSteps() : from{} {
        constexpr std::uint64_t one = color_one;
        for (std::uint64_t j = 1; j <= most; ++j) {
            const std::uint64_t sum = (j << (44 - Bits)) - (std::uint64_t{1} << 35);
            from[j - 1] = static_cast<std::uint32_t>((sum * most + one - 1) / one);
        }
        from[most] = ~0u;
    }
    /// The step of n. The product omits the sixteenth (eighth) of a step that rounding to 8 bits adds, and it
    /// is 2^-11 too small. So it is at most one step too small.
    SPANGLE_INLINE constexpr std::uint32_t at(std::uint32_t n) const {
        constexpr std::uint32_t factor = Bits == 5 ? 2105 : 1036, down = Bits == 5 ? 27 : 26;
        const std::uint32_t step = n * factor >> down;
        return step + (n >= from[step] ? 1u : 0u);
    }
    /// True where n is left to the chain; `step` is at(n).
    SPANGLE_INLINE constexpr bool open(std::uint32_t n, std::uint32_t step) const {
        return Bits == 6 && n + 1 == from[step];
    }
};
template <int Bits> inline constexpr StoredSteps<Bits> stored_steps;

/// Guesses steps from n / 2^(Bits + 2), rounded down. least() has 15 - Bits fraction bits. The true number of
/// steps is at least least(), and at most `range` of its units more. Nothing is rounded up, so numbers that
/// are left to the chain lie between both bounds.
template <int Bits> struct GuessedSteps {
    static constexpr std::uint32_t most = (1u << Bits) - 1, range = 4;
    /// `factor` is in 2^-16, for a quarter of the given n. `half_unit` is half a 255th.
    static constexpr std::uint32_t factor = (color_one >> (13 - Bits)) / most,
                                   half_unit = (most << (15 - Bits)) / 255;
    template <class U16> SPANGLE_INLINE static U16 least(const U16& n) {
        return Lanes<8>::mul_high(n * 4 + half_unit, Lanes<8>::splat(factor));
    }
};

} // namespace inner

/// The word that truncated565() or dithered565() makes of the exact tier's bilinear() colour.
template <int Count> struct FilterWords;

template <> struct FilterWords<1> {
    std::uint32_t b; ///< weight of row j + 1, in 256ths
    SPANGLE_INLINE explicit FilterWords(std::uint32_t weight) : b(weight) {}

    /// a is the weight of column i + 1, in 256ths.
    SPANGLE_INLINE std::uint32_t operator()(std::uint32_t c00, std::uint32_t c10, std::uint32_t c01,
                                            std::uint32_t c11, std::uint32_t a) const {
        const Sums n = weighted_sums(c00, c10, c01, c11, a);
        const std::uint32_t g = inner::stored_steps<6>.at(n.g);
        if (inner::stored_steps<6>.open(n.g, g)) [[unlikely]]
            return add_texels(c00, c10, c01, c11, a, b);
        return inner::stored_steps<5>.at(n.r) << 11 | g << 5 | inner::stored_steps<5>.at(n.b);
    }
    /// The dithered word. The sums n are steps with 16 fraction bits. The sum of the chain is at least n, and
    /// less than 2^-20 of a step more, so n decides. Where n and the threshold sum to a whole step, that step
    /// is stored.
    SPANGLE_INLINE std::uint32_t operator()(std::uint32_t c00, std::uint32_t c10, std::uint32_t c01,
                                            std::uint32_t c11, std::uint32_t a,
                                            std::uint32_t threshold32) const {
        const Sums n = weighted_sums(c00, c10, c01, c11, a);
        const std::uint32_t t = threshold32 << 11;
        return (n.r + t) >> 16 << 11 | (n.g + t) >> 16 << 5 | (n.b + t) >> 16;
    }

    /// The stored word, made by the arithmetic of the chain, for the rare n that do not decide.
    [[gnu::noinline]] static std::uint32_t add_texels(std::uint32_t c00, std::uint32_t c10, std::uint32_t c01,
                                                      std::uint32_t c11, std::uint32_t a, std::uint32_t b) {
        const auto color = [](std::uint32_t c) {
            return Exact::Color{Exact::texel5(c >> 11), Exact::texel6((c >> 5) & 63), Exact::texel5(c & 31),
                                color_one};
        };
        const Exact::Color mixed = bilinear<Exact>(color(c00), color(c10), color(c01), color(c11), a, b);
        return (Exact::to8(mixed.r) & 0xF8) << 8 | (Exact::to8(mixed.g) & 0xFC) << 3 |
               Exact::to8(mixed.b) >> 3;
    }

  private:
    /// Sums of weight * component, where the weights sum to 2^16.
    struct Sums {
        std::uint32_t r, g, b;
    };
    SPANGLE_INLINE Sums weighted_sums(std::uint32_t c00, std::uint32_t c10, std::uint32_t c01,
                                      std::uint32_t c11, std::uint32_t a) const {
        const auto both = [](std::uint32_t c) { return c >> 11 | (c & 31) << 16; };
        const auto green = [](std::uint32_t c) { return (c >> 5) & 63; };
        const auto mix = [](std::uint32_t near, std::uint32_t far, std::uint32_t weight) {
            return (near << 8) + (far - near) * weight;
        };
        const std::uint32_t rb0 = mix(both(c00), both(c01), b), rb1 = mix(both(c10), both(c11), b);
        return {mix(rb0 & 0xFFFF, rb1 & 0xFFFF, a),
                mix(mix(green(c00), green(c01), b), mix(green(c10), green(c11), b), a),
                mix(rb0 >> 16, rb1 >> 16, a)};
    }
};

/// The filter in eight lanes. Products of 16 bits keep the top bits of n. Where the dropped bits of n could
/// change the stored word, the words of these lanes are computed one by one.
template <> struct FilterWords<8> {
    using L = Lanes<8>;
    using U16 = L::U16;
    U16 b;
    SPANGLE_INLINE explicit FilterWords(U16 weight) : b(weight) {}

    SPANGLE_INLINE U16 operator()(U16 c00, U16 c10, U16 c01, U16 c11, U16 a) const {
        U16 open = L::splat(0);
        const auto steps = [&]<int Bits>(std::integral_constant<int, Bits>, U16 n)
            __attribute__((always_inline)) {
            using Guess = inner::GuessedSteps<Bits>;
            const U16 least = Guess::least(n);
            open |= ((least + Guess::range) ^ least) >> (15 - Bits);
            return least >> (15 - Bits);
        };
        const U16 word = joined(c00, c10, c01, c11, a, steps);
        return L::any(open) ? redo_exactly(word, open, {c00, c10, c01, c11}, a, b) : word;
    }
    /// Returns the words of dithered colours. A threshold has no bits below the 14 that n keeps, so that what
    /// n has dropped cannot change a step.
    SPANGLE_INLINE U16 operator()(U16 c00, U16 c10, U16 c01, U16 c11, U16 a, U16 threshold32) const {
        const auto steps = [&]<int Bits>(std::integral_constant<int, Bits>, U16 n)
            __attribute__((always_inline)) {
            return (n + (threshold32 << (9 - Bits))) >> (14 - Bits);
        };
        return joined(c00, c10, c01, c11, a, steps);
    }

  private:
    struct Texels {
        U16 c00, c10, c01, c11;
    };
    /// n / 2^(Bits + 2), rounded down, which has 14 bits. Differences along s have Bits + 8 bits and a sign.
    template <int Bits>
    SPANGLE_INLINE U16 sum(const U16& c00, const U16& c10, const U16& c01, const U16& c11,
                           const U16& a) const {
        const auto along = [&](const U16& c, const U16& next) { return (c << 8) + (next - c) * a; };
        const U16 near = along(c00, c10), far = along(c01, c11);
        return (near << (6 - Bits)) + L::mul_high_signed((far - near) << (7 - Bits), b << 7);
    }
    template <class Steps>
    SPANGLE_INLINE U16 joined(const U16& c00, const U16& c10, const U16& c01, const U16& c11, const U16& a,
                              Steps steps) const {
        const std::integral_constant<int, 5> five;
        const std::integral_constant<int, 6> six;
        const auto green = [](const U16& c) { return (c >> 5) & 63; };
        const U16 r = steps(five, sum<5>(c00 >> 11, c10 >> 11, c01 >> 11, c11 >> 11, a)),
                  g = steps(six, sum<6>(green(c00), green(c10), green(c01), green(c11), a)),
                  blue = steps(five, sum<5>(c00 & 31, c10 & 31, c01 & 31, c11 & 31, a));
        return r << 11 | g << 5 | blue;
    }
    [[gnu::noinline, gnu::cold]] static U16 redo_exactly(U16 word, const U16& open, const Texels& c,
                                                         const U16& a, const U16& b) {
        each_open(open, [&](int i) {
            word[i] = static_cast<std::uint16_t>(
                FilterWords<1>(b[i])(c.c00[i], c.c10[i], c.c01[i], c.c11[i], a[i]));
        });
        return word;
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
