// Texture bindings, environments and enables (GL 1.3, 3.8).
#pragma once

#include "gl/context/types.hpp"
#include "gl/texture/texture_object.hpp"

namespace spangle::gl {

/// The generation of one coordinate by TexGen (GL 1.3, 2.10.4).
struct TexGenState {
    GLenum mode = GL_EYE_LINEAR;
    Real object_plane[4] = {}, eye_plane[4] = {}; ///< eye_plane is in eye space
};

/// The texture environment (GL 1.3, 3.8.12, 3.8.13). In arrays of combiners, element 0 is for RGB and element
/// 1 for alpha.
struct TexEnvState {
    GLenum mode = GL_MODULATE;
    Real color[4] = {};
    Real lod_bias = {};
#if SPANGLE_FEATURE_TEXTURE_COMBINE
    GLenum func[2] = {GL_MODULATE, GL_MODULATE};
    GLenum source[2][3] = {{GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT}, {GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT}};
    GLenum operand[2][3] = {{GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA},
                            {GL_SRC_ALPHA, GL_SRC_ALPHA, GL_SRC_ALPHA}};
    Real scale[2] = {numeric::one, numeric::one};
#endif
};

struct TextureUnitState {
#if SPANGLE_FEATURE_TEXGEN
    constexpr TextureUnitState() {
        for (int c = 0; c < 2; ++c)
            gen[c].object_plane[c] = gen[c].eye_plane[c] = numeric::one;
    }
    bool gen_on[4] = {}; ///< TexGen is enabled for S, T, R, Q
    TexGenState gen[4];
#endif
    bool enabled[texture_kinds] = {};
    TextureObject* bound[texture_kinds] = {}; ///< null: the default texture (name 0)
    bool on() const {
        return (enabled[0] | enabled[1] | enabled[2] | enabled[3]) != 0;
    }
    TexEnvState env;
};

/// In the result of units_in_use(), bit u is set if unit u is enabled. Bit u + third_coordinate is set if the
/// texture of unit u needs r.
inline constexpr int third_coordinate = 8;

/// Bindings, environments, and the texturing that a program has enabled.
struct TextureState {
    TextureUnitState unit[texture_units];
    unsigned active = 0;
    /// Returns the active unit, which is a constant in builds with one unit.
    unsigned active_unit() const { return texture_units > 1 ? active : 0; }

    // The default textures, name 0 of each target, are shared by all units.
    TextureObject default_2d{TextureKind::two};
#if SPANGLE_FEATURE_TEXTURE_1D
    TextureObject default_1d{TextureKind::one};
#endif
#if SPANGLE_FEATURE_TEXTURE_3D
    TextureObject default_3d{TextureKind::three};
#endif
#if SPANGLE_FEATURE_TEXTURE_CUBE_MAP
    CubeTexture default_cube;
#endif
    LevelShape proxies[kinds_before[texture_kinds]][texture_levels]{};

    /// The shape that a level of PROXY_TEXTURE_... was last given.
    LevelShape& proxy(TextureKind kind, GLint level) {
        return proxies[kinds_before[index_of(existing_kind(kind))]][level];
    }

    TextureObject& default_texture(TextureKind kind) {
        switch (kind) {
#if SPANGLE_FEATURE_TEXTURE_1D
        case TextureKind::one:
            return default_1d;
#endif
#if SPANGLE_FEATURE_TEXTURE_3D
        case TextureKind::three:
            return default_3d;
#endif
#if SPANGLE_FEATURE_TEXTURE_CUBE_MAP
        case TextureKind::cube:
            return default_cube.object;
#endif
        default:
            return default_2d;
        }
    }
    TextureObject& bound(unsigned u, TextureKind kind = TextureKind::two) {
        TextureObject* const object = unit[u].bound[index_of(existing_kind(kind))];
        return object != nullptr ? *object : default_texture(kind);
    }
    const TextureObject& bound(unsigned u, TextureKind kind = TextureKind::two) const {
        return const_cast<TextureState*>(this)->bound(u, kind);
    }
    unsigned units_in_use() const {
        unsigned bits = 0;
        for (unsigned u = 0; u < texture_units && raster::has_textures; ++u)
            if (unit[u].on())
                bits |= (wants_r(u) ? 1u << third_coordinate | 1u : 1u) << u;
        return bits;
    }

  private:
    bool wants_r(unsigned u) const {
        const bool* const on = unit[u].enabled;
        if (on[index_of(TextureKind::cube)] || on[index_of(TextureKind::three)])
            return true;
#if SPANGLE_FEATURE_DEPTH_TEXTURES
        const TextureKind kind = on[index_of(TextureKind::two)] ? TextureKind::two : TextureKind::one;
        return bound(u, kind).parameters.compare_mode != GL_NONE;
#else
        return false;
#endif
    }
};

} // namespace spangle::gl
