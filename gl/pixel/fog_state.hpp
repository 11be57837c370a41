// Fog parameters (GL 1.3, 3.10).
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

struct FogState {
    bool fog = false;
    GLenum mode = GL_EXP;
    Real density = numeric::real_one;
    Real start = numeric::real_zero, end = numeric::real_one;
    Real color[4] = {};
};

} // namespace spangle::gl
