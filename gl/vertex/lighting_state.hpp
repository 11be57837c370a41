// Lights, materials, light model, ColorMaterial (GL 1.3, 2.13).
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

inline constexpr unsigned max_lights = 8;

struct LightingState {
    bool lighting = false;
    bool light_enabled[max_lights] = {};
    bool color_material = false;
    GLenum color_material_face = GL_FRONT_AND_BACK;
    GLenum color_material_parameter = GL_AMBIENT_AND_DIFFUSE;
    Real model_ambient[4] = {{0x3E4CCCCD}, {0x3E4CCCCD}, {0x3E4CCCCD}, numeric::real_one};
    bool local_viewer = false;
    bool two_side = false;
    GLenum color_control = GL_SINGLE_COLOR;
};

} // namespace spangle::gl
