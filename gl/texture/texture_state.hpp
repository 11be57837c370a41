// Texture bindings, environments and enables (GL 1.3, 3.8).
#pragma once

#include "gl/context/types.hpp"
#include "gl/texture/texture_object.hpp"

namespace spangle::gl {

/// TexGen of one coordinate (GL 1.3, 2.10.4).
struct TexGenState {
    GLenum mode = GL_EYE_LINEAR;
    Real object_plane[4] = {}, eye_plane[4] = {}; ///< the latter in eye space
};

/// What TexEnv sets (GL 1.3, 3.8.12, 3.8.13). Of combiners [0] is RGB, [1] alpha.
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
    TextureUnitState() {
        for (int c = 0; c < 2; ++c)
            gen[c].object_plane[c] = gen[c].eye_plane[c] = numeric::one;
    }

    bool texture_2d = false;
    TextureObject* bound_2d = nullptr; ///< null: the default texture (name 0)
    TexEnvState env;
    bool gen_on[4] = {}; ///< of S, T, R, Q
    TexGenState gen[4];
};

struct TextureState {
    TextureUnitState unit[texture_units];
    unsigned active = 0;
    TextureObject default_2d;              ///< name 0, shared by all units
    LevelShape proxy_2d[texture_levels]{}; ///< what PROXY_TEXTURE_2D was last asked

    TextureObject& bound(unsigned u) { return unit[u].bound_2d != nullptr ? *unit[u].bound_2d : default_2d; }
    const TextureObject& bound(unsigned u) const {
        return unit[u].bound_2d != nullptr ? *unit[u].bound_2d : default_2d;
    }
};

} // namespace spangle::gl
