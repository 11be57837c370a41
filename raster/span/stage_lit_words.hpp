// Lit textures of the exact tier, one fragment at a time: as stage_lit.hpp, in words of 32 bits, which leave
// one in some thousand open. Fused spans of one lane only.
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

/// A texel's number along one axis.
class LitAxisWords {
  public:
    SPANGLE_INLINE LitAxisWords(const PlaneRow& row, std::int32_t x, const NearQuotient& of, int log2_size)
        : size(numeric::factor32(1u << log2_size)), d_(row, x, of.d),
          base_(static_cast<std::uint32_t>(of.base) << NearWords::fraction_bits),
          undecided_(0 - (of.window << unused_bits << log2_size)) {}
    SPANGLE_INLINE void start(const PlaneRow& row, std::int32_t x, const NearQuotient& of) {
        d_.start(row, x, of.d);
    }
    struct Texel {
        std::uint32_t number;
        bool open;
    };
    SPANGLE_INLINE Texel texel(std::int32_t i, std::int32_t inverse) const {
        const std::uint32_t v = NearWords::of(base_, d_.value(i), inverse);
        const std::uint64_t texels = numeric::mul_u32(v << unused_bits, size);
        return {static_cast<std::uint32_t>(texels >> 32), static_cast<std::uint32_t>(texels) >= undecided_};
    }
    const std::uint32_t size;

  private:
    static constexpr int unused_bits = 16 - NearWords::fraction_bits; ///< of whole repeats
    NumberedRamp d_;
    std::uint32_t base_, undecided_; ///< fractions of a texel that may reach the next
};

/// A quotient.
class LitRatioWords {
  public:
    SPANGLE_INLINE LitRatioWords(const PlaneRow& row, std::int32_t x, const NearQuotient& of)
        : d_(row, x, of.d), base_(static_cast<std::uint32_t>(of.base) << NearWords::fraction_bits) {}
    SPANGLE_INLINE void start(const PlaneRow& row, std::int32_t x, const NearQuotient& of) {
        d_.start(row, x, of.d);
    }
    /// LitPatch has limited the base, so that sums fit.
    SPANGLE_INLINE std::int32_t at(std::int32_t i, std::int32_t inverse) const {
        return static_cast<std::int32_t>(NearWords::of(base_, d_.value(i), inverse));
    }

  private:
    NumberedRamp d_;
    std::uint32_t base_;
};

/// A colour, 255ths with 22 fraction bits.
template <bool Full> class LitColorWords {
  public:
    template <class Patch>
    SPANGLE_INLINE LitColorWords(const PlaneRow& row, std::int32_t x, const Patch& patch, int i)
        : v_(make(row, x, patch, i)) {}
    template <class Patch>
    SPANGLE_INLINE void start(const PlaneRow& row, std::int32_t x, const Patch& patch, int i) {
        if constexpr (Full)
            v_.start(row, x, patch.color[i]);
        else
            v_.start(row, x, row.color_value[i]);
    }
    SPANGLE_INLINE std::uint32_t at(std::int32_t i, std::int32_t inverse) const {
        if constexpr (Full)
            return static_cast<std::uint32_t>(numeric::clamp<std::int32_t>(v_.at(i, inverse), 0, 255 << 22));
        else
            return v_.value(i) >> 2; // not above one (Balanced::from_affine)
    }

  private:
    using V = std::conditional_t<Full, LitRatioWords, NumberedRamp>;
    template <class Patch>
    SPANGLE_INLINE static V make(const PlaneRow& row, std::int32_t x, const Patch& patch, int i) {
        if constexpr (Full)
            return V(row, x, patch.color[i]);
        else
            return V(row, x, row.color_value[i]);
    }
    V v_;
};

/// MODULATE, fog, truncation and the store, T a TextureFixed. Components are those of the exact tier, and
/// what is added to round them.
template <class T, bool Full, bool Gray, bool HasFog, PixelFormat Format> class LitWords : public T {
  public:
    using N = typename T::System;
    using Patch = LitPatch<Full, Gray, HasFog, NearWords>;
    static constexpr unsigned in = 0, out = 0;
    static constexpr bool effect = true;

    SPANGLE_INLINE LitWords(const LitRow<Patch>& row, std::int32_t x)
        : T(row, x), u_(row, x, row.patch.u), s_(row, x, row.patch.s, this->log2_width),
          t_(row, x, row.patch.t, this->log2_height), fog_(fog(row, x)), r_(row, x, row.patch, 0),
          g_(other(row, x, 1)), b_(other(row, x, 2)) {
        const std::uint32_t under = units(row.patch.under) + under_products;
        from_ = (1u << (color_fraction_bits - 1)) - under;
        range_ = under + units(row.patch.over) + over_products;
        for (int i = 0; i < 3; ++i)
            fog_color_[i] = row.state->fragment.fog_color[i] << 2;
    }
    SPANGLE_INLINE void start(const LitRow<Patch>& row, std::int32_t x) {
        const Patch& patch = row.patch;
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
        const std::int32_t inverse = NearWords::inverse(u_.value(i));
        const LitAxisWords::Texel s = s_.texel(i, inverse), t = t_.texel(i, inverse);
        if (s.open || t.open) [[unlikely]]
            return false;
        const std::uint32_t texel = T::word_at(T::texel(this->texels, t.number * s_.size + s.number));
        std::uint32_t f = 0;
        if constexpr (HasFog)
            f = numeric::saturated_after<0, 30>(fog_.at(i, inverse));
        const auto share = [&](const Color& c) __attribute__((always_inline)) {
            const std::uint32_t v = c.at(i, inverse);
            return HasFog ? numeric::mul_high_u32(v, f) : v >> 2;
        };
        const std::uint32_t red = share(r_);
        std::uint32_t green = red, blue = red;
        if constexpr (!Gray) {
            green = share(g_);
            blue = share(b_);
        }
        const std::uint32_t rest = (1u << 30) - f, r = lit(red, factor5(texel, 0), rest, 0),
                            g = lit(green, factor6(texel), rest, 1),
                            b = lit(blue, factor5(texel, 2), rest, 2);
        if (((((r + range_) ^ r) | ((b + range_) ^ b)) & 0xF8u << color_fraction_bits) != 0 ||
            (((g + range_) ^ g) & 0xFCu << color_fraction_bits) != 0) [[unlikely]]
            return false;
        Words565<Lanes<1>, Format>::store(color_plane + 2 * i, (r >> (color_fraction_bits - 8) & 0xF800) |
                                                                   (g >> (color_fraction_bits - 3) & 0x07E0) |
                                                                   b >> (color_fraction_bits + 3));
        return true;
    }

  private:
    static constexpr bool is_565 = T::texel_format == TexelFormat::rgb565;
    using Color = LitColorWords<Full>;
    /// In units of the exact tier: products round down twice; what the chain rounds takes less than 3 off, or
    /// adds less than 1; affine colours have half a 256th of a 255th added.
    static constexpr std::uint32_t under_products = 4 + (Full ? 0 : 1u << 11), over_products = 4;

    SPANGLE_INLINE static std::uint32_t units(std::uint32_t off) { return (off >> 2) + 1; }
    SPANGLE_INLINE static auto other(const LitRow<Patch>& row, std::int32_t x, int i) {
        if constexpr (Gray)
            return StageBase{};
        else
            return Color(row, x, row.patch, i);
    }
    SPANGLE_INLINE static auto fog(const LitRow<Patch>& row, std::int32_t x) {
        if constexpr (HasFog)
            return LitRatioWords(row, x, row.patch.fog);
        else
            return StageBase{};
    }
    /// Of red (0) or blue (2).
    SPANGLE_INLINE static std::uint32_t factor5(std::uint32_t texel, int byte) {
        if constexpr (is_565)
            return texel_factors<Exact>.of5[byte == 0 ? texel >> 11 : texel & 31];
        else
            return Exact::fraction(Exact::from8(texel >> (8 * byte) & 255));
    }
    SPANGLE_INLINE static std::uint32_t factor6(std::uint32_t texel) {
        if constexpr (is_565)
            return texel_factors<Exact>.of6[texel >> 5 & 63];
        else
            return Exact::fraction(Exact::from8(texel >> 8 & 255));
    }
    /// The least that the component may be.
    SPANGLE_INLINE std::uint32_t lit(std::uint32_t c, std::uint32_t factor, std::uint32_t rest, int i) const {
        std::uint64_t sum = numeric::mul_u32(c, factor);
        if constexpr (HasFog)
            sum += numeric::mul_u32(fog_color_[i], rest);
        return static_cast<std::uint32_t>(sum >> 32) + from_;
    }

    NumberedRamp u_;
    LitAxisWords s_, t_;
    [[no_unique_address]] std::conditional_t<HasFog, LitRatioWords, StageBase> fog_;
    Color r_;
    [[no_unique_address]] std::conditional_t<Gray, StageBase, Color> g_, b_;
    std::uint32_t from_, range_, fog_color_[3];
};

} // namespace spangle::raster
