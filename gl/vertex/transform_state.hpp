// Matrix stacks, viewport and depth range (GL 1.3, 2.10).
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

struct TransformState {
    GLenum matrix_mode = GL_MODELVIEW;
    GLint viewport[4] = {0, 0, 0, 0};
    Real depth_range[2] = {numeric::real_zero, numeric::real_one};
    bool normalize = false;
    bool rescale_normal = false;
};

} // namespace spangle::gl
