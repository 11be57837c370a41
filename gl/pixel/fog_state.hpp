// Fog parameters (GL 1.3, 3.10).
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

struct FogState {
    bool fog = false;
    GLenum mode = GL_EXP;
    Real index = numeric::zero; ///< the index that the program set, not masked to the bits of the surface
    Real density = numeric::one;
    Real start = numeric::zero, end = numeric::one;
    Real color[4] = {};
    GLenum source = GL_FRAGMENT_DEPTH; ///< GL 1.4, 3.10
};

} // namespace spangle::gl
