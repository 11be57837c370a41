// Fog (GL 1.3, 3.10). The stages make the fog factor of the fog coordinate (FogConstants, draw_state.hpp) and
// blend with it.
#pragma once

#include "raster/numeric/power.hpp"
#include "raster/ops/lane_fog.hpp"
#include "raster/ops/stage.hpp"
#include "raster/span/draw_state.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// The fog factor f in units of 2^-24, 0 .. 2^24, from the fog coordinate in s7.24.
inline std::uint32_t fog_factor(FogMode mode, std::uint32_t coordinate) {
    if (mode == FogMode::linear) {
        constexpr std::int32_t one = 1 << 24;
        const auto f = static_cast<std::int32_t>(coordinate);
        return static_cast<std::uint32_t>(f < 0 ? 0 : f > one ? one : f);
    }
    const auto given = static_cast<std::int32_t>(coordinate);
    const std::uint32_t c = numeric::abs_u32(mode == FogMode::exp && given < 0 ? 0 : given);
    const std::uint64_t square = numeric::mul_u32(c, c) >> 24;
    const std::uint64_t exponent = mode == FogMode::exp ? c : square;
    return numeric::exp2_neg(exponent < 0xFFFFFFFFu ? static_cast<std::uint32_t>(exponent) : 0xFFFFFFFFu) >>
           6;
}

/// Fog whose mode is known only at run time.
template <class N> struct Fog : StageBase {
    static constexpr unsigned in = field_color | field_fog, out = field_color;
    static constexpr bool anywhere = true;
    FogMode mode;
    typename N::T r, g, b;
    template <class S>
    SPANGLE_INLINE Fog(const S& s, std::int32_t)
        : mode(s.state->fragment.fog_mode), r(N::from_units(s.state->fragment.fog_color[0])),
          g(N::from_units(s.state->fragment.fog_color[1])), b(N::from_units(s.state->fragment.fog_color[2])) {
    }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        if constexpr (N::lanes > 1) {
            return blend(p, N::clamped_fraction(lane_fog_factor(mode, p.fog)));
        } else {
            return blend(p, N::clamped_fraction(fog_factor(mode, p.fog)));
        }
    }

  protected:
    SPANGLE_INLINE bool blend(Px<N>& p, typename N::T f) const {
        p.color.r = N::mix(r, p.color.r, f);
        p.color.g = N::mix(g, p.color.g, f);
        p.color.b = N::mix(b, p.color.b, f);
        return true;
    }
};

/// Fog with FOG_MODE LINEAR.
template <class N> struct FogLinear : Fog<N> {
    using Fog<N>::Fog;
    SPANGLE_INLINE bool operator()(Px<N>& p) const { return this->blend(p, N::clamped_fraction(p.fog)); }
};

/// The first half of linear fog around MODULATE (fogs_light()): it multiplies light by the fog factor.
template <class N> struct FogLight : StageBase {
    static constexpr unsigned in = field_color | field_fog, out = field_color;
    static constexpr bool anywhere = true;
    template <class S> SPANGLE_INLINE FogLight(const S&, std::int32_t) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const { return apply_fog(p, N::clamped_fraction(p.fog)); }
    SPANGLE_INLINE static bool apply_fog(Px<N>& p, typename N::T f) {
        p.color.r = N::scaled(p.color.r, f);
        p.color.g = N::scaled(p.color.g, f);
        p.color.b = N::scaled(p.color.b, f);
        return true;
    }
};
/// The second half of linear fog around MODULATE: it adds the fog's colour times 1 - f. Steps: the texel is
/// counted in steps (counts_steps()).
template <class N, bool Steps = false> struct FogShare : Fog<N> {
    template <class S> SPANGLE_INLINE FogShare(const S& s, std::int32_t x) : Fog<N>(s, x) {
        if constexpr (Steps) {
            this->r = N::template steps15<5>(this->r);
            this->g = N::template steps15<6>(this->g);
            this->b = N::template steps15<5>(this->b);
        }
    }
    SPANGLE_INLINE bool operator()(Px<N>& p) const { return add(p, N::clamped_fraction(p.fog)); }
    SPANGLE_INLINE bool add(Px<N>& p, typename N::T f) const {
        const typename N::T rest = 65535 - f;
        p.color.r += N::scaled(this->r, rest);
        p.color.g += N::scaled(this->g, rest);
        p.color.b += N::scaled(this->b, rest);
        return true;
    }
};

/// The fog factor in lanes, from an affine coordinate. Where set-up has seen that all coordinates lie in [0,
/// 1) (Span::fog_inside), none is clamped. The coordinate is scaled then, so that its high half is the
/// factor.
template <class N> struct FogFactorLanes : StageBase {
    using L = typename N::L;
    static constexpr int up = 8;
    bool inside;
    Span<Fixed>::Affine plane; ///< the fog coordinate, with 32 fraction bits if `inside`, otherwise 24
    Ramp<L> v;
    template <class S>
    SPANGLE_INLINE FogFactorLanes(const S& s, std::int32_t x)
        : inside(s.fog_inside), plane(plane_of(s)), v(s, x, plane) {}
    template <class S> SPANGLE_INLINE static Span<Fixed>::Affine plane_of(const S& s) {
        const Span<Fixed>::Affine& fog = s.fog;
        return s.fog_inside ? Span<Fixed>::Affine{fog.value << up, fog.dx << up, fog.dy << up} : fog;
    }
    SPANGLE_INLINE typename N::T factor() const {
        return inside ? L::high_half(v.at) : N::clamped_fraction(v.at);
    }
    SPANGLE_INLINE void step() { v.step(); }
    template <class S> SPANGLE_INLINE void start(const S& s, std::int32_t x) { v.start(s, x, plane); }
};
template <class N> struct FogLightLanes : FogFactorLanes<N> {
    static constexpr unsigned in = field_color, out = field_color;
    using FogFactorLanes<N>::FogFactorLanes;
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.fog_factor = this->factor();
        return FogLight<N>::apply_fog(p, p.fog_factor);
    }
};
template <class N, bool Steps> struct FogShareLanes : FogShare<N, Steps> {
    using FogShare<N, Steps>::FogShare;
    SPANGLE_INLINE bool operator()(Px<N>& p) const { return this->add(p, p.fog_factor); }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
