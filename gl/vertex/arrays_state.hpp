// Vertex arrays: where they are and which are on (GL 1.3, 2.8). Client state.
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

struct ClientArray {
    bool enabled = false;
    GLint size = 4;
    GLenum type = GL_FLOAT;
    GLsizei stride = 0; ///< as given; 0 = packed
    const void* pointer = nullptr;
};

struct ArraysState {
    ClientArray vertex, normal, color;
    ClientArray tex_coord[texture_units];
};

} // namespace spangle::gl
