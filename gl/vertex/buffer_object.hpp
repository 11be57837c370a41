// A buffer object: memory of the arena, or the program's own constant memory (GL 1.5, 2.9).
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

struct ArraysState;
struct ClientArray;
struct Context;

struct BufferObject {
    GLuint name = 0;
    std::uint32_t references = 0; ///< bindings that hold the buffer, in all contexts of the share group
    bool deleted = false;         ///< the name is free again; the buffer goes with its last binding
    std::uint8_t* bytes = nullptr;
    std::size_t size = 0;
    /// `bytes` is the program's memory and is never written: a mesh in flash needs no copy.
    bool constant = false;
    GLenum usage = GL_STATIC_DRAW;
    GLenum access = GL_READ_WRITE;
    bool mapped = false;
    GLbitfield map_flags = 0;
    std::size_t map_offset = 0, map_length = 0;
};

/// Binds a buffer object, or null. A deleted object is freed with its last binding (GL 1.5, 2.9; D.1.2).
void bind_buffer(Context& context, BufferObject*& binding, BufferObject* object);
/// Makes the array lie in the buffer that is bound to GL_ARRAY_BUFFER now, or in client memory.
void set_buffer(Context& context, ClientArray& array);
/// Adds or releases one reference to each buffer that a vertex array object binds.
void hold_buffers(ArraysState& arrays);
void release_buffers(Context& context, ArraysState& arrays);

} // namespace spangle::gl
