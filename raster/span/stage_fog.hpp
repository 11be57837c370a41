// Fog (GL 1.3, 3.10): the factor from the fog coordinate (draw_state.hpp, FogConstants), and the blend.
#pragma once

#include "raster/numeric/power.hpp"
#include "raster/span/draw_state.hpp"
#include "raster/span/stage.hpp"

namespace spangle::raster {

/// f with 24 fraction bits, 0 .. 2^24, of a coordinate in s7.24.
SPANGLE_INLINE std::uint32_t fog_factor_linear(std::uint32_t coordinate) {
    constexpr std::int32_t one = 1 << 24;
    const auto c = static_cast<std::int32_t>(coordinate);
    return static_cast<std::uint32_t>(c < 0 ? 0 : c > one ? one : c);
}
inline std::uint32_t fog_factor(FogMode mode, std::uint32_t coordinate) {
    if (mode == FogMode::linear)
        return fog_factor_linear(coordinate);
    const std::uint32_t c = numeric::abs_u32(static_cast<std::int32_t>(coordinate));
    const std::uint64_t square = numeric::mul_u32(c, c) >> 24;
    const std::uint64_t exponent = mode == FogMode::exp ? c : square;
    return numeric::exp2_neg(exponent < 0xFFFFFFFFu ? static_cast<std::uint32_t>(exponent) : 0xFFFFFFFFu) >>
           6;
}

/// Mode at run time.
template <class N> struct Fog : StageBase {
    static constexpr unsigned in = field_color | field_fog, out = field_color;
    FogMode mode;
    typename N::T r, g, b;
    SPANGLE_INLINE Fog(const Span<typename N::Policy>& s, std::int32_t)
        : mode(s.state->fragment.fog_mode), r(N::from_units(s.state->fragment.fog_color[0])),
          g(N::from_units(s.state->fragment.fog_color[1])), b(N::from_units(s.state->fragment.fog_color[2])) {
    }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        const typename N::T f = N::from_fraction24(fog_factor(mode, p.fog));
        p.color.r = N::lerp(r, p.color.r, f);
        p.color.g = N::lerp(g, p.color.g, f);
        p.color.b = N::lerp(b, p.color.b, f);
        return true;
    }
};

/// FOG_MODE LINEAR.
template <class N> struct FogLinear : Fog<N> {
    using Fog<N>::Fog;
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        const typename N::T f = N::from_fraction24(clamped(p.fog));
        p.color.r = N::lerp(this->r, p.color.r, f);
        p.color.g = N::lerp(this->g, p.color.g, f);
        p.color.b = N::lerp(this->b, p.color.b, f);
        return true;
    }

  private:
    SPANGLE_INLINE static typename N::Fog clamped(const typename N::Fog& c) {
        if constexpr (N::lanes == 1)
            return fog_factor_linear(c);
        else
            return N::L::clamp_signed(c, 1 << 24);
    }
};

} // namespace spangle::raster
