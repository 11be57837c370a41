// Lit textures of the exact tier, one fragment at a time: as stage_lit.hpp, in words of 32 bits where there
// are long products, which leave one fragment in some thousand open. Fused spans of one lane only.
#pragma once

#include "raster/span/stage_lit.hpp"
#include "raster/span/stage_lit_store.hpp"

namespace spangle::raster {

/// A plane by the number of the fragment in its row: nothing steps.
class NumberedRamp {
  public:
    template <class S>
    SPANGLE_INLINE NumberedRamp(const S& row, std::int32_t x, const Interpolant<std::uint32_t>& plane)
        : by_(plane.dx) {
        start(row, x, plane);
    }
    template <class S>
    SPANGLE_INLINE void start(const S& row, std::int32_t x, const Interpolant<std::uint32_t>& plane) {
        at_ = row.at(x, plane);
    }
    SPANGLE_INLINE std::uint32_t value(std::int32_t i) const {
        return at_ + static_cast<std::uint32_t>(i) * by_;
    }

  private:
    std::uint32_t at_, by_;
};

/// What is made of quotients: colours and fog with the fraction bits of the products, components whose 255ths
/// end at bit `top`.
template <class Products> struct LitNumbers;

/// Components are those of the exact tier.
template <> struct LitNumbers<NearWords> {
    static constexpr int top = color_fraction_bits + 8;
    SPANGLE_INLINE static std::uint32_t affine(std::uint32_t v) { return v >> 2; }
    SPANGLE_INLINE static std::uint32_t fog(std::int32_t v) { return numeric::saturated_after<0, 30>(v); }
    SPANGLE_INLINE static std::uint32_t rest(std::uint32_t f) { return (1u << 30) - f; }
    SPANGLE_INLINE static std::uint32_t share(std::uint32_t c, std::uint32_t f) {
        return numeric::mul_high_u32(c, f);
    }
    SPANGLE_INLINE static std::uint32_t whole(std::uint32_t c) { return c >> 2; }
    using Factors = ChainFactors<Exact>;
    SPANGLE_INLINE static std::uint32_t modulated(std::uint32_t c, std::uint32_t factor) {
        return numeric::mul_high_u32(c, factor);
    }
    SPANGLE_INLINE static std::uint32_t fog_color(std::uint32_t units) { return units << 2; }
    SPANGLE_INLINE static std::uint32_t fogged(std::uint32_t c, std::uint32_t factor, std::uint32_t fog_color,
                                               std::uint32_t rest) {
        return static_cast<std::uint32_t>((numeric::mul_u32(c, factor) + numeric::mul_u32(fog_color, rest)) >>
                                          32);
    }
    /// In units of the exact tier: products round down twice; what the chain rounds takes less than 3 off, or
    /// adds less than 1; affine colours have half a 256th of a 255th added.
    template <bool Full, bool> SPANGLE_INLINE static std::uint32_t under(std::uint32_t patch) {
        return (patch >> 2) + 1 + 4 + (Full ? 0 : 1u << 11);
    }
    template <bool> SPANGLE_INLINE static std::uint32_t over(std::uint32_t patch) {
        return (patch >> 2) + 1 + 4;
    }
    /// A component in steps of 2^(32 - Bits), by one product that is rounded down (Exact::steps takes two).
    template <unsigned Bits> SPANGLE_INLINE static std::uint32_t steps(std::uint32_t v) {
        constexpr std::uint64_t scale =
            (((std::uint64_t{1} << Bits) - 1) << (60 - Bits - color_fraction_bits)) / 255 + 1;
        return numeric::mul_high_u32(v << 4, static_cast<std::uint32_t>(scale));
    }
    /// And what a component may be off by.
    SPANGLE_INLINE static std::uint32_t off_in_steps(std::uint32_t off) { return (off << 4) + 1; }
};

/// Components have 8 bits, and 24 below them.
template <> struct LitNumbers<NearHalves> {
    static constexpr int top = 32;
    SPANGLE_INLINE static std::uint32_t affine(std::uint32_t v) { return v >> 16; }
    SPANGLE_INLINE static std::uint32_t fog(std::int32_t v) {
        return static_cast<std::uint32_t>(numeric::clamp<std::int32_t>(v, 0, 0xFFFF));
    }
    SPANGLE_INLINE static std::uint32_t rest(std::uint32_t f) { return 0xFFFF - f; }
    SPANGLE_INLINE static std::uint32_t share(std::uint32_t c, std::uint32_t f) { return c * f >> 16; }
    SPANGLE_INLINE static std::uint32_t whole(std::uint32_t c) { return c; }
    using Factors = HalfFactors;
    SPANGLE_INLINE static std::uint32_t modulated(std::uint32_t c, std::uint32_t factor) {
        return c * factor;
    }
    SPANGLE_INLINE static std::uint32_t fog_color(std::uint32_t units) { return (units + (1u << 11)) >> 12; }
    /// Below 65281 2^16.
    SPANGLE_INLINE static std::uint32_t fogged(std::uint32_t c, std::uint32_t factor, std::uint32_t fog_color,
                                               std::uint32_t rest) {
        return c * factor + fog_color * rest;
    }
    template <bool, bool Fog> SPANGLE_INLINE static std::uint32_t under(std::uint32_t patch) {
        return (LitGuess<Fog>::under + patch) << 16;
    }
    template <bool Fog> SPANGLE_INLINE static std::uint32_t over(std::uint32_t patch) {
        return (LitGuess<Fog>::over + patch) << 16;
    }
    template <unsigned Bits> SPANGLE_INLINE static std::uint32_t steps(std::uint32_t v) {
        return (v >> 16) * Balanced<1>::step_scale(Bits);
    }
    SPANGLE_INLINE static std::uint32_t off_in_steps(std::uint32_t off) { return off + (1u << 16); }
};

/// A texel's number along one axis.
template <class Products> class LitAxisOne {
  public:
    SPANGLE_INLINE LitAxisOne(const PlaneRow& row, std::int32_t x, const NearQuotient& of, int log2_size)
        : size(Size::of(log2_size)), d_(row, x, of.d),
          base_(static_cast<std::uint32_t>(of.base) << Products::fraction_bits),
          undecided_(0 - (of.window << unused_bits << log2_size)) {}
    SPANGLE_INLINE void start(const PlaneRow& row, std::int32_t x, const NearQuotient& of) {
        d_.start(row, x, of.d);
    }
    struct Texel {
        std::uint32_t number;
        bool open;
    };
    SPANGLE_INLINE Texel texel(std::int32_t i, std::int32_t inverse) const {
        const std::uint64_t texels = size.times(Products::of(base_, d_.value(i), inverse) << unused_bits);
        return {static_cast<std::uint32_t>(texels >> 32), static_cast<std::uint32_t>(texels) >= undecided_};
    }

  private:
    static constexpr int unused_bits = 16 - Products::fraction_bits; ///< of whole repeats
    /// Of an axis: a factor, or how far there are shifts.
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
    std::uint32_t base_, undecided_; ///< fractions of a texel that may reach the next
};

/// A quotient.
template <class Products> class LitRatioOne {
  public:
    SPANGLE_INLINE LitRatioOne(const PlaneRow& row, std::int32_t x, const NearQuotient& of)
        : d_(row, x, of.d), base_(static_cast<std::uint32_t>(of.base) << Products::fraction_bits) {}
    SPANGLE_INLINE void start(const PlaneRow& row, std::int32_t x, const NearQuotient& of) {
        d_.start(row, x, of.d);
    }
    /// LitPatch has limited the base, so that sums fit.
    SPANGLE_INLINE std::int32_t at(std::int32_t i, std::int32_t inverse) const {
        return static_cast<std::int32_t>(Products::of(base_, d_.value(i), inverse));
    }

  private:
    NumberedRamp d_;
    std::uint32_t base_;
};

/// A colour.
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
            return LitNumbers<Products>::affine(v_.value(i)); // not above one (Balanced::from_affine)
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

/// MODULATE, fog, truncation or dithering, and the store, T a TextureFixed.
template <class Products, class T, bool Full, bool Gray, bool HasFog, PixelFormat Format, bool Dither>
class LitOne : public T {
  public:
    using N = typename T::System;
    using Patch = LitPatch<Full, Gray, HasFog, Products>;
    static constexpr unsigned in = 0, out = 0;
    static constexpr bool effect = true;

    SPANGLE_INLINE LitOne(const LitRow<Patch>& row, std::int32_t x)
        : T(row, x), u_(row, x, row.patch.u), s_(row, x, row.patch.s, this->log2_width),
          t_(row, x, row.patch.t, this->log2_height), fog_(fog(row, x)), r_(row, x, row.patch, 0),
          g_(other(row, x, 1)), b_(other(row, x, 2)), thresholds_(row.x + x, row.y) {
        const std::uint32_t under = off(Numbers::template under<Full, HasFog>(row.patch.under));
        from_ = (Dither ? 0 : 1u << (top - 9)) - under; // which rounds to 255ths
        range_ = under + off(Numbers::template over<HasFog>(row.patch.over));
        for (int i = 0; i < 3; ++i)
            fog_color_[i] = Numbers::fog_color(row.state->fragment.fog_color[i]);
    }
    SPANGLE_INLINE void start(const LitRow<Patch>& row, std::int32_t x) {
        const Patch& patch = row.patch;
        thresholds_ = Thresholds(row.x + x, row.y);
        u_.start(row, x, patch.u);
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
    /// False: it is open.
    SPANGLE_INLINE bool draw(std::int32_t i, std::uint8_t* color_plane) const {
        const std::int32_t inverse = Products::inverse(u_.value(i));
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
        const std::uint32_t rest = Numbers::rest(f);
        const auto lit = [&](std::uint32_t c, std::uint32_t factor, int k) __attribute__((always_inline)) {
            return HasFog ? Numbers::fogged(c, factor, fog_color_[k], rest) : Numbers::modulated(c, factor);
        };
        const std::uint32_t threshold = thresholds_.threshold(i);
        // The least that they may be.
        const std::uint32_t r = least<5>(lit(red, Scales::red(texel), 0), threshold),
                            g = least<6>(lit(green, Scales::green(texel), 1), threshold),
                            b = least<5>(lit(blue, Scales::blue(texel), 2), threshold);
        constexpr std::uint32_t five = 0xF8u << (top - 8), six = 0xFCu << (top - 8);
        if (((((r + range_) ^ r) | ((b + range_) ^ b)) & five) != 0 || (((g + range_) ^ g) & six) != 0)
            [[unlikely]]
            return false;
        Words565<Lanes<1>, Format>::store(
            color_plane + 2 * i, (r >> (top - 16) & 0xF800) | (g >> (top - 11) & 0x07E0) | b >> (top - 5));
        return true;
    }

  private:
    using Numbers = LitNumbers<Products>;
    using Scales = TexelScales<typename Numbers::Factors, T::texel_format == TexelFormat::rgb565>;
    using Color = LitColorOne<Products, Full>;
    using Thresholds = std::conditional_t<Dither, detail::DitherRow<Lanes<1>>, detail::NoThreshold>;
    static constexpr int top = Dither ? 32 : Numbers::top; ///< where components that are stored end

    SPANGLE_INLINE static std::uint32_t off(std::uint32_t component) {
        return Dither ? Numbers::off_in_steps(component) : component;
    }
    template <unsigned Bits>
    SPANGLE_INLINE std::uint32_t least(std::uint32_t v, std::uint32_t threshold) const {
        if constexpr (Dither)
            return Numbers::template steps<Bits>(v) + (threshold << (27 - Bits)) + from_;
        else
            return v + from_;
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

    NumberedRamp u_;
    LitAxisOne<Products> s_, t_;
    [[no_unique_address]] std::conditional_t<HasFog, LitRatioOne<Products>, StageBase> fog_;
    Color r_;
    [[no_unique_address]] std::conditional_t<Gray, StageBase, Color> g_, b_;
    [[no_unique_address]] Thresholds thresholds_;
    std::uint32_t from_, range_, fog_color_[3];
};

} // namespace spangle::raster
