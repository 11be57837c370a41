// The texture function of one unit, one fragment at a time.
#pragma once

#include "raster/ops/stage_texture_volume.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Samples by three coordinates of its own, or by the two coordinates that earlier stages have found. HasLod:
/// an earlier stage has found a level of detail. Steps: MODULATE takes texels in steps of the surface,
/// N::in_steps().
template <class N, int Unit, bool HasLod, bool Steps = false> struct Texture2D : StageBase {
    static_assert(N::lanes == 1);
    static constexpr unsigned in = field_color | field_coord << Unit | (HasLod ? field_lod << Unit : 0u);
    static constexpr unsigned out = field_color;
    const Span<typename N::Policy>& span;
    std::int32_t x;
    const TextureUnit& unit;
    TextureFunction<N> function;
    SPANGLE_INLINE Texture2D(const Span<typename N::Policy>& s, std::int32_t first)
        : span(s), x(first), unit(s.state->fragment.unit[Unit]), function(unit) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        const auto s = texel(p);
        if constexpr (Steps)
            apply_env<N>(TexEnv::modulate, function.texture.base, p.color, N::in_steps(s), s);
        else
            apply_env<N>(unit.env, function.texture.base, p.color, s, env_color<N>(unit));
        return true;
    }
    SPANGLE_INLINE void step() { ++x; }
    typename N::Color texel(const Px<N>& p) const {
        if (has_third_coordinates && wants_r(function.texture))
            return VolumeFunction<N>(unit).sample(VolumeCoords(span, Unit).at(x));
        return function.sample(p.coord[Unit].s[0], p.coord[Unit].t[0], HasLod ? p.lod[Unit][0] : 0);
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
