// How primitives become fragments: shading, facing, culling, sizes (GL 1.3, 2.13.7, 3.3 to 3.5).
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

struct PolygonState {
    GLenum shade_model = GL_SMOOTH;
    GLenum front_face = GL_CCW;
    GLenum cull_face_mode = GL_BACK;
    bool cull_face = false;
    GLenum mode[2] = {GL_FILL, GL_FILL}; ///< of front and back faces
    Real point_size = numeric::one;      ///< as set; clamped and rounded only in use
    Real line_width = numeric::one;
};

} // namespace spangle::gl
