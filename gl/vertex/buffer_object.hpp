// A buffer object: memory in the arena, or constant memory of the program (GL 1.5, 2.9).
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

struct ArraysState;
struct ClientArray;
struct Context;

struct BufferObject {
    GLuint name = 0;
    std::uint32_t references = 0; ///< number of bindings, in all contexts of the share group
    bool deleted = false;         ///< true if the name is free; the last binding frees the buffer
    std::uint8_t* bytes = nullptr;
    std::size_t size = 0;
    /// True if `bytes` is memory of the program, which GL never writes. A mesh in flash then needs no copy.
    bool constant = false;
    GLenum usage = GL_STATIC_DRAW;
    GLenum access = GL_READ_WRITE;
    bool mapped = false;
    GLbitfield map_flags = 0;
    std::size_t map_offset = 0, map_length = 0;
};

/// Binds a buffer object, or null. A deleted object is freed when its last binding ends (GL 1.5, 2.9; GL 3.0,
/// D.1.2).
void bind_buffer(Context& context, BufferObject*& binding, BufferObject* object);
/// Sets the buffer of an array to the one bound to GL_ARRAY_BUFFER, or to client memory if none is bound.
void set_buffer(Context& context, ClientArray& array);
/// Adds or releases one reference to each buffer that a vertex array object binds.
void hold_buffers(ArraysState& arrays);
void release_buffers(Context& context, ArraysState& arrays);

} // namespace spangle::gl
