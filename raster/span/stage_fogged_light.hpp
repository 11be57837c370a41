// MODULATE, fog's share and the store of the balanced tier as one stage: the bytes of the three, whose
// products are rounded down one by one. Fused spans of one lane only.
#pragma once

#include "raster/span/stage_fog.hpp"
#include "raster/span/stage_store.hpp"
#include "raster/span/texel_color.hpp"

namespace spangle::raster {

/// Components are Balanced's; MODULATE waits for the store, with its texel.
struct BalancedLit : Balanced<1> {
    struct Color {
        T r, g, b, a;
        std::uint32_t texel = 0;
    };
};

/// What becomes of light that fog has dimmed, of a texel and of fog's factor. Sums are made in the high
/// halves of words.
template <PixelFormat Format, bool Is565, bool Dither> class FoggedTexel {
  public:
    using N = BalancedLit;
    template <class S>
    SPANGLE_INLINE explicit FoggedTexel(const S& s)
        : g_(N::from_units(s.state->fragment.fog_color[1])),
          r_(N::from_units(s.state->fragment.fog_color[0])),
          b_(N::from_units(s.state->fragment.fog_color[2])) {}
    /// What a texel R5 G6 B5 multiplies green by, and red and blue.
    using Factors = const std::uint16_t*;
    static constexpr Factors sixths = texel_factors<Balanced<1>>.of6, fifths = texel_factors<Balanced<1>>.of5;
    /// What fog leaves of a light's component, as word() takes it.
    SPANGLE_INLINE static std::uint32_t dimmed(std::uint32_t light, std::uint32_t f) {
        return in_words ? numeric::without_low_half(light * f) : N::scaled(light, f);
    }
    SPANGLE_INLINE static std::uint32_t dimmed(std::uint32_t light) { return in_words ? light << 16 : light; }
    /// As stored; what is above 16 bits is not. Thresholds: in 2^-27 of a step.
    SPANGLE_INLINE std::uint32_t word(const N::Color& light, std::uint32_t f,
                                      [[maybe_unused]] std::uint32_t threshold, [[maybe_unused]] Factors of6,
                                      [[maybe_unused]] Factors of5) const {
        std::uint32_t texel = light.texel, rest = Share::of(f);
        const std::uint32_t by = Is565 ? of6[texel >> 5 & 63] : Scales::green(texel);
        std::uint32_t g = g_.template under<6>(light.g, by, rest, threshold);
        texel = numeric::later(texel, g);
        rest = numeric::later(rest, g);
        std::uint32_t r =
            r_.template under<5>(light.r, Is565 ? of5[texel >> 11] : Scales::red(texel), rest, threshold);
        texel = numeric::later(texel, r);
        rest = numeric::later(rest, r);
        std::uint32_t b =
            b_.template under<5>(light.b, Is565 ? of5[texel & 31] : Scales::blue(texel), rest, threshold);
        using Words = Words565<N::L, Format>;
        if constexpr (numeric::inserts_bits) { // in the high half, of which a byte swap leaves the low one
            const std::uint32_t high = numeric::with_bits<16, 5>((r & 0xF8000000) | g >> 5, b >> 27);
            return Words::swaps ? __builtin_bswap32(high) : high >> 16;
        }
        const std::uint32_t low = ((r >> 27) << 6 | g >> 26) << 5 | b >> 27;
        return Words::swaps ? N::L::swap_bytes(low) : low;
    }

  private:
    static constexpr bool in_words = Dither && numeric::long_products;
    /// The fog's share is 65535 - f times its colour; what rounds the sum to 255ths comes with it.
    class Halves {
      public:
        SPANGLE_INLINE explicit Halves(std::uint32_t color)
            : color_whole_{color, numeric::factor32(color * 0xFFFF + (Dither ? 0 : 128u << 16))} {}
        SPANGLE_INLINE static std::uint32_t of(std::uint32_t f) { return f; }
        /// No low half, no carry: both are rounded down.
        template <unsigned Bits>
        SPANGLE_INLINE std::uint32_t under(std::uint32_t light, std::uint32_t by, std::uint32_t f,
                                           [[maybe_unused]] std::uint32_t threshold) const {
            const auto [color, whole] = numeric::load_two(color_whole_);
            const std::uint32_t sum = light * by + numeric::without_low_half(whole - color * f);
            return Dither ? (sum >> 16) * N::step_scale(Bits) + (threshold >> (Bits - 5)) : sum;
        }

      private:
        numeric::Two<std::uint32_t, std::uint32_t> color_whole_; ///< whole: the share where f is 0
    };
    /// Of light in the high half, dithered.
    class Words {
      public:
        SPANGLE_INLINE explicit Words(std::uint32_t color) : color_(color << 16) {}
        SPANGLE_INLINE static std::uint32_t of(std::uint32_t f) {
            return numeric::kept_in_register(0xFFFF - f);
        }
        /// A product of halves lies in the middle of one of words; to its low one, that ends in 16 zeros,
        /// less than 2^16 are added.
        template <unsigned Bits>
        SPANGLE_INLINE std::uint32_t under(std::uint32_t light, std::uint32_t by, std::uint32_t rest,
                                           std::uint32_t threshold) const {
            // No register of their own for factors (factor32).
            const std::uint64_t share = std::uint64_t{color_} * rest >> 32,
                                sum = (share << 32 | by) + std::uint64_t{light} * by;
            return static_cast<std::uint32_t>(sum >> 32) * N::step_scale(Bits) + (threshold >> (Bits - 5));
        }

      private:
        std::uint32_t color_;
    };
    using Share = std::conditional_t<in_words, Words, Halves>;
    using Scales = TexelScales<ChainFactors<Balanced<1>>, Is565>;

    Share g_, r_, b_; ///< in the order in which they are read
};

/// Behind FogLight.
template <PixelFormat Format, bool Is565, bool Dither> class FoggedLightStore : public StageBase {
  public:
    using N = BalancedLit;
    static constexpr unsigned in = field_color | field_fog;
    static constexpr bool effect = true;

    template <class S>
    SPANGLE_INLINE FoggedLightStore(const S& s, std::int32_t x) : texel_(s), dither_(s.x + x, s.y) {}
    template <class S> SPANGLE_INLINE void start(const S& s, std::int32_t x) { dither_ = Row(s.x + x, s.y); }
    SPANGLE_INLINE void step() { dither_.step(); }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        const std::uint32_t f = N::clamped_fraction(p.fog);
        const N::Color c = {texel_.dimmed(p.color.r), texel_.dimmed(p.color.g), texel_.dimmed(p.color.b),
                            p.color.a, p.color.texel};
        N::L::store(p.color_plane + p.bytes(),
                    texel_.word(c, f, dither_.threshold() << 22, texel_.sixths, texel_.fifths));
        return true;
    }

  private:
    using Row = std::conditional_t<Dither, detail::DitherRow<N::L>, detail::NoThreshold>;
    FoggedTexel<Format, Is565, Dither> texel_;
    [[no_unique_address]] Row dither_;
};

} // namespace spangle::raster
