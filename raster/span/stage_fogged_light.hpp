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
        : g_(s.state->fragment.fog_color[1]), r_(s.state->fragment.fog_color[0]),
          b_(s.state->fragment.fog_color[2]) {}
    /// What a texel R5 G6 B5 multiplies green by.
    using Sixths = const std::uint16_t*;
    static constexpr Sixths sixths = texel_factors<Balanced<1>>.of6;
    /// As stored; what is above 16 bits is not.
    SPANGLE_INLINE std::uint32_t word(const N::Color& light, std::uint32_t f,
                                      [[maybe_unused]] std::uint32_t threshold,
                                      [[maybe_unused]] Sixths of6) const {
        std::uint32_t texel = light.texel;
        const std::uint32_t by = Is565 ? of6[texel >> 5 & 63] : Scales::green(texel);
        std::uint32_t g = g_.under(light.g * by, f);
        texel = numeric::later(texel, g);
        std::uint32_t r = r_.under(light.r * Scales::red(texel), f);
        texel = numeric::later(texel, r);
        std::uint32_t b = b_.under(light.b * Scales::blue(texel), f);
        if constexpr (Dither) {
            const std::uint32_t t = threshold << 21;
            r = (r >> 16) * N::step_scale(5) + (t << 1);
            g = (g >> 16) * N::step_scale(6) + t;
            b = (b >> 16) * N::step_scale(5) + (t << 1);
        }
        using Words = Words565<N::L, Format>;
        if constexpr (numeric::inserts_bits) { // in the high half, of which a byte swap leaves the low one
            const std::uint32_t high = numeric::with_bits<16, 5>((r & 0xF8000000) | g >> 5, b >> 27);
            return Words::swaps ? __builtin_bswap32(high) : high >> 16;
        }
        const std::uint32_t low = ((r >> 27) << 6 | g >> 26) << 5 | b >> 27;
        return Words::swaps ? N::L::swap_bytes(low) : low;
    }

  private:
    /// The fog's share is 65535 - f times its colour; what rounds the sum to 255ths comes with it.
    class Share {
      public:
        SPANGLE_INLINE explicit Share(std::uint32_t units) {
            const std::uint32_t color = N::from_units(units);
            color_whole_ = {color, numeric::factor32(color * 0xFFFF + (Dither ? 0 : 128u << 16))};
        }
        /// No low half, no carry: both are rounded down.
        SPANGLE_INLINE std::uint32_t under(std::uint32_t product, std::uint32_t f) const {
            const auto [color, whole] = numeric::load_two(color_whole_);
            return product + numeric::without_low_half(whole - color * f);
        }

      private:
        numeric::Two<std::uint32_t, std::uint32_t> color_whole_; ///< whole: the share where f is 0
    };
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
        N::L::store(p.color_plane + p.bytes(), texel_.word(p.color, f, dither_.threshold(), texel_.sixths));
        return true;
    }

  private:
    using Row = std::conditional_t<Dither, detail::DitherRow<N::L>, detail::NoThreshold>;
    FoggedTexel<Format, Is565, Dither> texel_;
    [[no_unique_address]] Row dither_;
};

} // namespace spangle::raster
