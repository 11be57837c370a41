// A buffer object: memory of the arena, or the program's own constant memory (GL 1.5, 2.9).
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

struct Context;

struct BufferObject {
    std::uint8_t* bytes = nullptr;
    std::size_t size = 0;
    bool constant = false; ///< the program's memory, which is not written: a mesh in flash costs no copy
    GLenum usage = GL_STATIC_DRAW;
    GLenum access = GL_READ_WRITE;
    bool mapped = false;
    GLbitfield map_flags = 0;
    std::size_t map_offset = 0, map_length = 0;
};

/// The object of a name, or null.
BufferObject* find_buffer(const Context& context, GLuint name);

} // namespace spangle::gl
