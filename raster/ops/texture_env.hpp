// Texture environments (GL 1.3, tables 3.21 and 3.22).
#pragma once

#include "raster/ops/number.hpp"
#include "raster/span/instructions.hpp"
#include <spangle/raster/fragment_state.hpp>

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// TEXTURE_ENV_COLOR as a colour of number system N.
template <class N> SPANGLE_INLINE typename N::Color env_color(const TextureUnit& unit) {
    const std::uint32_t* const c = unit.env_color;
    return {N::from_units(c[0]), N::from_units(c[1]), N::from_units(c[2]), N::from_units(c[3])};
}

/// Applies an environment. f is the fragment's colour and becomes the result, s is the colour of the texture,
/// and c is TEXTURE_ENV_COLOR.
template <class N>
SPANGLE_INLINE void apply_env(TexEnv env, BaseFormat base, typename N::Color& f, const typename N::Color& s,
                              const typename N::Color& c) {
    const bool color = base != BaseFormat::alpha;
    const bool alpha = base != BaseFormat::rgb && base != BaseFormat::luminance;
    switch (env) {
    case TexEnv::replace:
        if (color)
            f.r = s.r, f.g = s.g, f.b = s.b;
        if (alpha)
            f.a = s.a;
        return;
    case TexEnv::modulate:
        if (color)
            f.r = N::mul(f.r, s.r), f.g = N::mul(f.g, s.g), f.b = N::mul(f.b, s.b);
        if (alpha)
            f.a = N::mul(f.a, s.a);
        return;
    // DECAL is defined for RGB and RGBA only. It keeps alpha.
    case TexEnv::decal:
        if (base == BaseFormat::rgba)
            f.r = N::lerp(f.r, s.r, s.a), f.g = N::lerp(f.g, s.g, s.a), f.b = N::lerp(f.b, s.b, s.a);
        else if (color)
            f.r = s.r, f.g = s.g, f.b = s.b;
        return;
    case TexEnv::blend:
        if (color)
            f.r = N::lerp(f.r, c.r, s.r), f.g = N::lerp(f.g, c.g, s.g), f.b = N::lerp(f.b, c.b, s.b);
        if (base == BaseFormat::intensity)
            f.a = N::lerp(f.a, c.a, s.a);
        else if (alpha)
            f.a = N::mul(f.a, s.a);
        return;
    case TexEnv::add:
        if (color)
            f.r = N::add(f.r, s.r), f.g = N::add(f.g, s.g), f.b = N::add(f.b, s.b);
        if (base == BaseFormat::intensity)
            f.a = N::add(f.a, s.a);
        else if (alpha)
            f.a = N::mul(f.a, s.a);
        return;
    case TexEnv::combine: // texture_combine.hpp combines all units at once
        return;
    }
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
