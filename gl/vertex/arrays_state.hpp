// Vertex arrays: where they are and which are on (GL 1.3, 2.8). Client state.
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

struct ClientArray {
    bool enabled = false;
    GLint size = 4;
    GLenum type = GL_FLOAT;
    GLsizei stride = 0;            ///< as given; 0 = packed
    const void* pointer = nullptr; ///< in a buffer: the offset
    GLuint buffer = 0;             ///< its name, or 0: client memory

    bool on() const { return enabled && pointer != nullptr; }
};

struct ArraysState {
    ClientArray vertex, normal, color;
    ClientArray index{.size = 1}, edge_flag{.size = 1, .type = GL_UNSIGNED_BYTE}, fog_coord{.size = 1};
    ClientArray tex_coord[texture_units];
    GLuint array_buffer = 0, element_buffer = 0; ///< names bound
    bool buffered = false;                       ///< some array may lie in a buffer
    GLuint client_active = 0;                    ///< the unit whose array commands and queries name
};

} // namespace spangle::gl
