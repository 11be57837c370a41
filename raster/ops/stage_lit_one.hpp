// Lit textures of the exact tier, one fragment at a time. On processors with long products the guess of
// stage_lit.hpp is made in words of 32 bits, which leaves only one fragment in some thousand open. Other
// processors use half-words. Only fused spans of one lane use this file.
#pragma once

#include "raster/ops/stage_lit.hpp"
#include "raster/ops/stage_lit_store.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// A plane that is evaluated by the number of the fragment in its row. No step is needed.
class NumberedRamp {
  public:
    template <class S>
    SPANGLE_INLINE NumberedRamp(const S& row, std::int32_t x, const Interpolant<std::uint32_t>& plane)
        : step_(plane.dx) {
        start(row, x, plane);
    }
    template <class S>
    SPANGLE_INLINE void start(const S& row, std::int32_t x, const Interpolant<std::uint32_t>& plane) {
        at_ = row.at(x, plane);
    }
    SPANGLE_INLINE std::uint32_t value(std::int32_t i) const {
        return at_ + static_cast<std::uint32_t>(i) * step_;
    }

  private:
    std::uint32_t at_, step_;
};

/// The arithmetic on quotients. Colours and fog have the fraction bits of the products. A component is the
/// product of light, of the fog factor and of a texel's component. `Whole` is 1 in a component of the result,
/// and `Most` is 1 in a component of a texel.
template <class Products> struct LitNumbers;

/// Arithmetic in which light has the bits of the exact tier.
template <> struct LitNumbers<NearWords> {
    static constexpr int top = 30; ///< components end below this bit
    SPANGLE_INLINE static std::uint32_t affine(std::uint32_t v) { return v >> 2; }
    SPANGLE_INLINE static std::uint32_t fog(std::int32_t v) { return numeric::saturated_after<0, 30>(v); }
    SPANGLE_INLINE static std::uint32_t rest(std::uint32_t f) { return (1u << 30) - f; }
    SPANGLE_INLINE static std::uint32_t share(std::uint32_t c, std::uint32_t f) {
        return numeric::mul_high_u32(c, f);
    }
    SPANGLE_INLINE static std::uint32_t whole(std::uint32_t c) { return c >> 2; }
    template <std::uint32_t Whole, std::uint32_t Most>
    SPANGLE_INLINE static std::uint32_t light(std::uint32_t share) {
        constexpr std::uint64_t scale = (std::uint64_t{Whole} << 32) / (std::uint64_t{color_one} * Most);
        return numeric::mul_high_u32(share, static_cast<std::uint32_t>(scale));
    }
    template <std::uint32_t Whole> SPANGLE_INLINE static std::uint32_t fog_color(std::uint32_t units) {
        constexpr std::uint64_t scale = (std::uint64_t{Whole} << 31) / color_one; // the scale is below 8
        return static_cast<std::uint32_t>(numeric::mul_u32(units, static_cast<std::uint32_t>(scale >> 2)) >>
                                          27);
    }
    /// The sum of a component and the fog's share. Its low word may be anything (NearWords).
    SPANGLE_INLINE static std::uint32_t fogged(std::uint32_t c, std::uint32_t fog_color, std::uint32_t rest) {
        return static_cast<std::uint32_t>(
            ((std::uint64_t{c} << 32 | fog_color) + numeric::mul_u32(fog_color, rest)) >> 32);
    }
    /// The error bound of a component, from the bound `off` that its quotients have over the whole patch. One
    /// 255th is at most 2^22 in these units, and light is not rounded further.
    SPANGLE_INLINE static std::uint32_t of_patch(std::uint32_t off) { return off; }
    /// Bounds how far a component may be below the guess. The last bit of the exact tier counts 4 here. The
    /// chain's rounding takes off less than 3 such bits, and its conversion to steps less than 1 unit of this
    /// arithmetic. Affine colours include half a 256th of a 255th. A low word that may hold anything
    /// (NearWords) adds 1.
    template <bool Full> static constexpr std::uint32_t under = 3 * 4 + (Full ? 0 : 1u << 13) + 2;
    /// Bounds how far a component may be above the guess. The chain adds less than 1. Light is rounded down
    /// before it is multiplied by `Whole`, and again before it meets the texel. The fog's colour and the sum
    /// are rounded down, too.
    template <std::uint32_t, std::uint32_t Most, bool>
    static constexpr std::uint32_t over = 2 * 4 + 2 * Most + 2;
};

/// Arithmetic in which light has 8 bits and 8 fraction bits.
template <> struct LitNumbers<NearHalves> {
    static constexpr int top = 32;
    static constexpr std::uint32_t one = 255 << 8;
    /// Whole / (one Most) as a factor of 16 bits and a shift, rounded down.
    template <std::uint32_t Whole, std::uint32_t Most> struct Factor {
        static constexpr std::uint64_t of = std::uint64_t{one} * Most;
        static constexpr int bits = [] {
            int bits = 0;
            while ((std::uint64_t{Whole} << (bits + 1)) / of < 1u << 16)
                ++bits;
            return bits;
        }();
        static constexpr auto scale = static_cast<std::uint32_t>((std::uint64_t{Whole} << bits) / of);
        /// Bounds what a component loses because the factor is rounded down: 0 where the factor is 1.
        static constexpr auto lost =
            scale == 1u << bits ? 0 : static_cast<std::uint32_t>(Whole - (of * scale >> bits) + Most);
    };
    SPANGLE_INLINE static std::uint32_t affine(std::uint32_t v) { return v >> 16; }
    SPANGLE_INLINE static std::uint32_t fog(std::int32_t v) {
        return static_cast<std::uint32_t>(numeric::clamp<std::int32_t>(v, 0, 0xFFFF));
    }
    SPANGLE_INLINE static std::uint32_t rest(std::uint32_t f) { return 0xFFFF - f; }
    SPANGLE_INLINE static std::uint32_t share(std::uint32_t c, std::uint32_t f) { return c * f >> 16; }
    SPANGLE_INLINE static std::uint32_t whole(std::uint32_t c) { return c; }
    template <std::uint32_t Whole, std::uint32_t Most>
    SPANGLE_INLINE static std::uint32_t light(std::uint32_t share) {
        return share * Factor<Whole, Most>::scale >> Factor<Whole, Most>::bits;
    }
    template <std::uint32_t Whole> SPANGLE_INLINE static std::uint32_t fog_color(std::uint32_t units) {
        return light<(Whole >> 16), 1>((units + (1u << 11)) >> 12);
    }
    SPANGLE_INLINE static std::uint32_t fogged(std::uint32_t c, std::uint32_t fog_color, std::uint32_t rest) {
        return c + fog_color * rest;
    }
    /// The error bound of a component, from the bound `off` that its quotients have over the whole patch. A
    /// 256th of a 255th is at most 2^16 in these units. Light and the fog's colour, rounded to such units,
    /// are off by 1/2. The rounding of the exact tier is less than 2^-10.
    SPANGLE_INLINE static std::uint32_t of_patch(std::uint32_t off) { return off << 16; }
    template <bool> static constexpr std::uint32_t under = (1u << 15) + (1u << 6);
    /// Bounds how far a component may be above the guess, including what light() loses. With fog, the factors
    /// of light and of the fog's colour sum to 2^16 - 1, and two more products are rounded down.
    template <std::uint32_t Whole, std::uint32_t Most, bool Fog>
    static constexpr std::uint32_t over = (1u << 15) + (1u << 6) + Factor<Whole, Most>::lost +
                                          (Fog ? (2 + Factor<(Whole >> 16), 1>::lost) << 16 : 0);
};

/// Finds the number of a texel along one axis, and whether it is in doubt.
template <class Products> class LitAxisOne {
  public:
    SPANGLE_INLINE LitAxisOne(const PlaneRow& row, std::int32_t x, const NearQuotient& of, int log2_size)
        : size(Size::of(log2_size)), d_(row, x, of.d),
          base_(static_cast<std::uint32_t>(of.base) << Products::fraction_bits),
          undecided_from_(0 - (of.window << unused_bits << log2_size)) {}
    SPANGLE_INLINE void start(const PlaneRow& row, std::int32_t x, const NearQuotient& of) {
        d_.start(row, x, of.d);
    }
    struct Texel {
        std::uint32_t number;
        bool open;
    };
    SPANGLE_INLINE Texel texel(std::int32_t i, std::int32_t inverse) const {
        const std::uint64_t texels = size.times(Products::of(base_, d_.value(i), inverse) << unused_bits);
        return {static_cast<std::uint32_t>(texels >> 32),
                static_cast<std::uint32_t>(texels) >= undecided_from_};
    }

  private:
    /// The top bits of a word, which hold whole repeats and are shifted out.
    static constexpr int unused_bits = 16 - Products::fraction_bits;
    /// The size of an axis, as a factor or as two shifts.
    struct Factor {
        std::uint32_t texels;
        SPANGLE_INLINE static Factor of(int log2_size) { return {numeric::factor32(1u << log2_size)}; }
        SPANGLE_INLINE std::uint64_t times(std::uint32_t v) const { return numeric::mul_u32(v, texels); }
        SPANGLE_INLINE std::uint32_t rows(std::uint32_t n) const { return n * texels; }
    };
    struct Shift {
        int up, down;
        SPANGLE_INLINE static Shift of(int log2_size) { return {log2_size, 31 - log2_size}; }
        SPANGLE_INLINE std::uint64_t times(std::uint32_t v) const {
            return std::uint64_t{v >> 1 >> down} << 32 | v << up;
        }
        SPANGLE_INLINE std::uint32_t rows(std::uint32_t n) const { return n << up; }
    };
    using Size = std::conditional_t<std::is_same_v<Products, NearWords>, Factor, Shift>;

  public:
    const Size size;

  private:
    NumberedRamp d_;
    /// Fractions of a texel from `undecided_from_` on may reach the next texel.
    std::uint32_t base_, undecided_from_;
};

/// A quotient, evaluated at one fragment.
template <class Products> class LitRatioOne {
  public:
    SPANGLE_INLINE LitRatioOne(const PlaneRow& row, std::int32_t x, const NearQuotient& of)
        : d_(row, x, of.d), base_(static_cast<std::uint32_t>(of.base) << Products::fraction_bits) {}
    SPANGLE_INLINE void start(const PlaneRow& row, std::int32_t x, const NearQuotient& of) {
        d_.start(row, x, of.d);
    }
    /// The quotient at fragment i. The sum fits a word, because LitPatch has limited the base.
    SPANGLE_INLINE std::int32_t at(std::int32_t i, std::int32_t inverse) const {
        return static_cast<std::int32_t>(Products::of(base_, d_.value(i), inverse));
    }

  private:
    NumberedRamp d_;
    std::uint32_t base_;
};

/// A component of the primary colour, evaluated at one fragment.
template <class Products, bool Full> class LitColorOne {
  public:
    template <class Patch>
    SPANGLE_INLINE LitColorOne(const PlaneRow& row, std::int32_t x, const Patch& patch, int i)
        : v_(row, x, plane(row, patch, i)) {}
    template <class Patch>
    SPANGLE_INLINE void start(const PlaneRow& row, std::int32_t x, const Patch& patch, int i) {
        v_.start(row, x, plane(row, patch, i));
    }
    SPANGLE_INLINE std::uint32_t at(std::int32_t i, std::int32_t inverse) const {
        constexpr std::int32_t one = (255 << 8) << Products::fraction_bits;
        if constexpr (Full)
            return static_cast<std::uint32_t>(numeric::clamp<std::int32_t>(v_.at(i, inverse), 0, one));
        else
            // No limit from above is needed (Balanced::from_affine).
            return LitNumbers<Products>::affine(v_.value(i));
    }

  private:
    using V = std::conditional_t<Full, LitRatioOne<Products>, NumberedRamp>;
    template <class Patch>
    SPANGLE_INLINE static const auto& plane([[maybe_unused]] const PlaneRow& row,
                                            [[maybe_unused]] const Patch& patch, int i) {
        if constexpr (Full)
            return patch.color[i];
        else
            return row.color_value[i];
    }
    V v_;
};

/// MODULATE, fog, truncation or dithering, and the store. T is a TextureFixed.
template <class Products, class T, bool Full, bool Gray, bool HasFog, PixelFormat Format, bool Dither>
class LitOne : public T {
  public:
    using N = typename T::System;
    using Patch = LitPatch<Full, Gray, HasFog, Products>;
    static constexpr unsigned in = 0, out = 0;
    static constexpr bool effect = true;

    SPANGLE_INLINE LitOne(const LitRow<Patch>& row, std::int32_t x)
        : T(row, x), ramp_(row, x, row.patch.u), s_(row, x, row.patch.s, this->log2_width),
          t_(row, x, row.patch.t, this->log2_height), fog_(fog(row, x)), r_(row, x, row.patch, 0),
          g_(other(row, x, 1)), b_(other(row, x, 2)), thresholds_(row.x + x, row.y) {
        const std::uint32_t under = Numbers::of_patch(row.patch.under) + Numbers::template under<Full>;
        constexpr std::uint32_t over5 = Numbers::template over<whole<5>, most<5>, HasFog>,
                                over6 = Numbers::template over<whole<6>, most<6>, HasFog>;
        from_ = (Dither ? 0 : 1u << (top - 9)) - under; // 1u << (top - 9) rounds to 255ths
        range_ = under + Numbers::of_patch(row.patch.over) + (over5 > over6 ? over5 : over6);
        const std::uint32_t* const fog_color = row.state->fragment.fog_color;
        fog_color_[0] = Numbers::template fog_color<whole<5>>(fog_color[0]);
        fog_color_[1] = Numbers::template fog_color<whole<6>>(fog_color[1]);
        fog_color_[2] = Numbers::template fog_color<whole<5>>(fog_color[2]);
    }
    SPANGLE_INLINE void start(const LitRow<Patch>& row, std::int32_t x) {
        const Patch& patch = row.patch;
        thresholds_ = Thresholds(row.x + x, row.y);
        ramp_.start(row, x, patch.u);
        s_.start(row, x, patch.s);
        t_.start(row, x, patch.t);
        if constexpr (HasFog)
            fog_.start(row, x, patch.fog);
        r_.start(row, x, patch, 0);
        if constexpr (!Gray) {
            g_.start(row, x, patch, 1);
            b_.start(row, x, patch, 2);
        }
    }
    /// Draws fragment i. Returns false where the guess leaves the fragment open.
    SPANGLE_INLINE bool draw(std::int32_t i, std::uint8_t* color_plane) const {
        const std::int32_t inverse = Products::inverse(ramp_.value(i));
        const auto s = s_.texel(i, inverse), t = t_.texel(i, inverse);
        if (s.open || t.open) [[unlikely]]
            return false;
        const std::uint32_t texel = T::word_at(T::texel(this->texels, s_.size.rows(t.number) + s.number));
        std::uint32_t f = 0;
        if constexpr (HasFog)
            f = Numbers::fog(fog_.at(i, inverse));
        const auto share = [&](const Color& c) __attribute__((always_inline)) {
            const std::uint32_t v = c.at(i, inverse);
            return HasFog ? Numbers::share(v, f) : Numbers::whole(v);
        };
        const std::uint32_t red = share(r_);
        std::uint32_t green = red, blue = red;
        if constexpr (!Gray) {
            green = share(g_);
            blue = share(b_);
        }
        const std::uint32_t rest = Numbers::rest(f), from = thresholds_.threshold(i) + from_;
        // Returns the least value that a component may have.
        const auto lit = [&](std::uint32_t light, std::uint32_t k, int component)
            __attribute__((always_inline)) {
            const std::uint32_t v = light * k + from;
            return HasFog ? Numbers::fogged(v, fog_color_[component], rest) : v;
        };
        const std::uint32_t r = lit(Numbers::template light<whole<5>, most<5>>(red), Components::red(texel),
                                    0),
                            g = lit(Numbers::template light<whole<6>, most<6>>(green),
                                    Components::green(texel), 1),
                            b = lit(Numbers::template light<whole<5>, most<5>>(blue), Components::blue(texel),
                                    2);
        if ((changed<5>(r) | changed<5>(b)) != 0 || changed<6>(g) != 0) [[unlikely]]
            return false;
        Words565<Lanes<1>, Format>::store(color_plane + 2 * i, (r >> (step<5> - 11) & 0xF800) |
                                                                   (g >> (step<6> - 5) & 0x07E0) |
                                                                   b >> step<5>);
        return true;
    }

  private:
    using Numbers = LitNumbers<Products>;
    static constexpr bool is_565 = T::texel_format == TexelFormat::rgb565;
    using Components = TexelScales<TexelComponents, is_565>;
    using Color = LitColorOne<Products, Full>;
    static constexpr int top = Numbers::top;
    using Thresholds = std::conditional_t<Dither, inner::NumberedThresholds<top - 6>, inner::NoThreshold>;
    /// `most` is 1 in a component of a texel, and `whole` is 1 in a component of the result. Dithered
    /// components are counted in steps, which are as high as steps of 6 bits in all components. Other
    /// components are counted in 255ths.
    template <unsigned Bits> static constexpr std::uint32_t most = is_565 ? (1u << Bits) - 1 : 255;
    template <unsigned Bits>
    static constexpr std::uint32_t whole = Dither ? ((1u << Bits) - 1) << (top - 6) : 255u << (top - 8);
    template <unsigned Bits> static constexpr int step = top - (Dither ? 6 : static_cast<int>(Bits));

    /// Returns which stored bits depend on the error: those in which the least value `v` differs from the
    /// largest value, v + range_.
    template <unsigned Bits> SPANGLE_INLINE std::uint32_t changed(std::uint32_t v) const {
        return ((v + range_) ^ v) >> step<Bits>;
    }
    SPANGLE_INLINE static auto other(const LitRow<Patch>& row, std::int32_t x, int i) {
        if constexpr (Gray)
            return StageBase{};
        else
            return Color(row, x, row.patch, i);
    }
    SPANGLE_INLINE static auto fog(const LitRow<Patch>& row, std::int32_t x) {
        if constexpr (HasFog)
            return LitRatioOne<Products>(row, x, row.patch.fog);
        else
            return StageBase{};
    }

    NumberedRamp ramp_;
    LitAxisOne<Products> s_, t_;
    [[no_unique_address]] std::conditional_t<HasFog, LitRatioOne<Products>, StageBase> fog_;
    Color r_;
    [[no_unique_address]] std::conditional_t<Gray, StageBase, Color> g_, b_;
    [[no_unique_address]] Thresholds thresholds_;
    std::uint32_t from_, range_, fog_color_[3];
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
