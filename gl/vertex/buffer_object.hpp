// A buffer object: memory of the arena, or the program's own constant memory (GL 1.5, 2.9).
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

struct ArraysState;
struct ClientArray;
struct Context;

struct BufferObject {
    GLuint name = 0;
    std::uint32_t references = 0; ///< bindings, of all contexts of the share group, that hold it
    bool deleted = false;         ///< its name is free again; the last binding keeps it
    std::uint8_t* bytes = nullptr;
    std::size_t size = 0;
    bool constant = false; ///< the program's memory, which is not written: a mesh in flash costs no copy
    GLenum usage = GL_STATIC_DRAW;
    GLenum access = GL_READ_WRITE;
    bool mapped = false;
    GLbitfield map_flags = 0;
    std::size_t map_offset = 0, map_length = 0;
};

/// Binds an object, or null. One that was deleted goes with its last binding (GL 1.5, 2.9; D.1.2).
void bind_buffer(Context& context, BufferObject*& binding, BufferObject* object);
/// The array lies where GL_ARRAY_BUFFER is bound now.
void set_buffer(Context& context, ClientArray& array);
/// What an array object binds.
void hold_buffers(ArraysState& arrays);
void release_buffers(Context& context, ArraysState& arrays);

} // namespace spangle::gl
