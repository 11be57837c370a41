// Fog parameters (GL 1.3, 3.10).
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

struct FogState {
    bool fog = false;
    GLenum mode = GL_EXP;
    Real density = numeric::one;
    Real start = numeric::zero, end = numeric::one;
    Real color[4] = {};
};

} // namespace spangle::gl
