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

/// Behind FogLight. Sums are made in the high halves of words.
template <PixelFormat Format, bool Is565, bool Dither> class FoggedLightStore : public StageBase {
  public:
    using N = BalancedLit;
    static constexpr unsigned in = field_color | field_fog;
    static constexpr bool effect = true;

    template <class S>
    SPANGLE_INLINE FoggedLightStore(const S& s, std::int32_t x)
        : r_(s.state->fragment.fog_color[0]), g_(s.state->fragment.fog_color[1]),
          b_(s.state->fragment.fog_color[2]), dither_(s.x + x, s.y) {}
    template <class S> SPANGLE_INLINE void start(const S& s, std::int32_t x) { dither_ = Row(s.x + x, s.y); }
    SPANGLE_INLINE void step() { dither_.step(); }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        const std::uint32_t f = N::clamped_fraction(p.fog);
        std::uint32_t texel = p.color.texel;
        std::uint32_t g = g_.under(p.color.g * Scales::green(texel), f);
        texel = numeric::later(texel, g);
        std::uint32_t r = r_.under(p.color.r * Scales::red(texel), f);
        texel = numeric::later(texel, r);
        std::uint32_t b = b_.under(p.color.b * Scales::blue(texel), f);
        if constexpr (Dither) {
            const std::uint32_t t = dither_.threshold() << 21;
            r = (r >> 16) * N::step_scale(5) + (t << 1);
            g = (g >> 16) * N::step_scale(6) + t;
            b = (b >> 16) * N::step_scale(5) + (t << 1);
        }
        Words565<N::L, Format>::store(p.color_plane + 2 * p.i, ((r >> 27) << 6 | g >> 26) << 5 | b >> 27);
        return true;
    }

  private:
    using Row = std::conditional_t<Dither, detail::DitherRow<N::L>, detail::NoThreshold>;
    /// The fog's share is 65535 - f times its colour; what rounds the sum to 255ths comes with it.
    struct Share {
        std::uint32_t color, whole; ///< and where f is 0
        SPANGLE_INLINE explicit Share(std::uint32_t units)
            : color(N::from_units(units)),
              whole(numeric::factor32(color * 0xFFFF + (Dither ? 0 : 128u << 16))) {}
        /// No low half, no carry: both are rounded down.
        SPANGLE_INLINE std::uint32_t under(std::uint32_t product, std::uint32_t f) const {
            return product + numeric::without_low_half(whole - color * f);
        }
    };
    using Scales = TexelScales<ChainFactors<Balanced<1>>, Is565>;

    Share r_, g_, b_;
    [[no_unique_address]] Row dither_;
};

} // namespace spangle::raster
