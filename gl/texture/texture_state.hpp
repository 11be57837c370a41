// Texture bindings, environments and enables (GL 1.3, 3.8).
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

struct TextureObject;

struct TextureUnitState {
    bool texture_2d = false;
    TextureObject* bound_2d = nullptr; ///< null: the default texture (name 0)
    GLenum env_mode = GL_MODULATE;
    Real env_color[4] = {};
};

struct TextureState {
    TextureUnitState unit[texture_units];
    unsigned active = 0;
};

} // namespace spangle::gl
