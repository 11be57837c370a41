// Buffer objects: names, data and mapping (GL 1.5, 2.9; GL 3.0, 2.9.3).
#include "gl/context/hooks.hpp"

#if SPANGLE_FEATURE_BUFFERS

#include <cstring>
#include <new>

#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/share_group.hpp"
#include "gl/vertex/buffer_object.hpp"

namespace spangle::gl {

void destroy_buffer(Arena& arena, void* object) {
    if (object == nullptr)
        return;
    auto* const buffer = static_cast<BufferObject*>(object);
    if (!buffer->constant)
        arena.free(buffer->bytes);
    arena.free(buffer);
}

void bind_buffer(Context& context, BufferObject*& binding, BufferObject* object) {
    BufferObject* const before = binding;
    if (object != nullptr)
        ++object->references;
    binding = object;
    if (before != nullptr && --before->references == 0 && before->deleted)
        destroy_buffer(*context.arena, before);
}

void hold_buffers(ArraysState& arrays) {
    const auto hold = [](BufferObject* buffer) {
        if (buffer != nullptr)
            ++buffer->references;
    };
    hold(arrays.element_buffer);
    each_array(arrays, [&](ClientArray& array) { hold(array.buffer); });
}

void release_buffers(Context& context, ArraysState& arrays) {
    bind_buffer(context, arrays.element_buffer, nullptr);
    each_array(arrays, [&](ClientArray& array) { bind_buffer(context, array.buffer, nullptr); });
}

void hold_arrays(Context& context) {
    hold_buffers(context.arrays);
    if (context.array_bindings.array_buffer != nullptr)
        ++context.array_bindings.array_buffer->references;
}

void release_arrays(Context& context) {
    release_buffers(context, context.arrays);
    bind_buffer(context, context.array_bindings.array_buffer, nullptr);
}

GLuint bound_buffer(const Context& context, GLenum pname) {
    const ArraysState& arrays = context.arrays;
    const auto name = [](const BufferObject* buffer) { return buffer != nullptr ? buffer->name : 0; };
    switch (pname) {
    case GL_ARRAY_BUFFER_BINDING:
        return name(context.array_bindings.array_buffer);
    case GL_ELEMENT_ARRAY_BUFFER_BINDING:
        return name(arrays.element_buffer);
    case GL_VERTEX_ARRAY_BUFFER_BINDING:
        return name(arrays.vertex.buffer);
    case GL_NORMAL_ARRAY_BUFFER_BINDING:
        return name(arrays.normal.buffer);
    case GL_COLOR_ARRAY_BUFFER_BINDING:
        return name(arrays.color.buffer);
    case GL_INDEX_ARRAY_BUFFER_BINDING:
        return name(arrays.index.buffer);
    case GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING:
        return name(arrays.secondary_color.buffer);
    case GL_FOG_COORDINATE_ARRAY_BUFFER_BINDING:
        return name(arrays.fog_coord.buffer);
    case GL_EDGE_FLAG_ARRAY_BUFFER_BINDING:
        return name(arrays.edge_flag.buffer);
    default:
        return name(arrays.tex_coord[context.array_bindings.client_unit()].buffer);
    }
}

namespace {

/// Returns the object with a name, or null.
BufferObject* find_buffer(const Context& context, GLuint name) {
    void** const slot = context.share->buffers.find(name);
    return slot != nullptr ? static_cast<BufferObject*>(*slot) : nullptr;
}

BufferObject** binding_of(Context& context, GLenum target) {
    if (target == GL_ARRAY_BUFFER)
        return &context.array_bindings.array_buffer;
    return target == GL_ELEMENT_ARRAY_BUFFER ? &context.arrays.element_buffer : nullptr;
}

/// Returns the buffer that is bound to a target. Without one, sets the error and returns null.
BufferObject* bound(Context& context, GLenum target) {
    BufferObject* const* const binding = binding_of(context, target);
    BufferObject* const buffer = binding != nullptr ? *binding : nullptr;
    if (buffer == nullptr)
        error(context, binding == nullptr ? GL_INVALID_ENUM : GL_INVALID_OPERATION,
              SPANGLE_TEXT("no buffer is bound to target"));
    return buffer;
}

bool in_range(const BufferObject& buffer, GLintptr offset, GLsizeiptr size) {
    return offset >= 0 && size >= 0 && static_cast<std::size_t>(offset) <= buffer.size &&
           static_cast<std::size_t>(size) <= buffer.size - static_cast<std::size_t>(offset);
}

/// Returns the message for a range that exceeds the buffer. Null: the range is valid, and a null pointer is
/// the error.
[[maybe_unused]] const char* why_out_of_range(const BufferObject& buffer, GLintptr offset, GLsizeiptr size) {
    return in_range(buffer, offset, size) ? nullptr : SPANGLE_TEXT("offset and size leave the buffer");
}

/// True if a byte of the range is mapped. The range must be in_range().
bool is_mapped(const BufferObject& buffer, GLintptr offset, GLsizeiptr size) {
    const auto begin = static_cast<std::size_t>(offset), end = begin + static_cast<std::size_t>(size);
    const std::size_t map_end = buffer.map_offset + buffer.map_length;
    return buffer.mapped &&
           (begin > buffer.map_offset ? begin : buffer.map_offset) < (end < map_end ? end : map_end);
}

/// Returns the message that says why a buffer cannot be mapped.
[[maybe_unused]] const char* why_not_mapped(const BufferObject& buffer) {
    return buffer.mapped             ? SPANGLE_TEXT("the buffer is mapped already")
           : buffer.bytes == nullptr ? SPANGLE_TEXT("the buffer has no data")
                                     : SPANGLE_TEXT("constant memory is mapped for reading only");
}

// Each of STREAM, STATIC and DYNAMIC has three consecutive tokens, for DRAW, READ and COPY. The first tokens
// are 4 apart.
bool is_usage(GLenum usage) {
    return usage >= GL_STREAM_DRAW && usage <= GL_DYNAMIC_COPY && (usage & 3) != 3;
}

/// Frees the data store of a buffer and sets a new one, which is not mapped.
void replace(Context& context, BufferObject& buffer, std::uint8_t* bytes, GLsizeiptr size, bool constant) {
    if (!buffer.constant)
        context.arena->free(buffer.bytes);
    buffer.bytes = bytes;
    buffer.size = static_cast<std::size_t>(size);
    buffer.constant = constant;
    buffer.mapped = false;
    buffer.access = GL_READ_WRITE;
    buffer.map_flags = 0;
    buffer.map_offset = buffer.map_length = 0;
}

/// Unbinds a deleted buffer from the targets and arrays of this context (GL 1.5, 2.9).
void forget(Context& context, const BufferObject* buffer) {
    const auto drop = [&](BufferObject*& binding) {
        if (binding == buffer)
            bind_buffer(context, binding, nullptr);
    };
    drop(context.array_bindings.array_buffer);
    drop(context.arrays.element_buffer);
    each_array(context.arrays, [&](ClientArray& array) {
        if (array.buffer == buffer)
            array.pointer = nullptr;
        drop(array.buffer);
    });
}

void delete_buffer(Context& context, GLuint name) {
    BufferObject* buffer = nullptr;
    bind_buffer(context, buffer, static_cast<BufferObject*>(context.share->buffers.remove(name)));
    if (buffer == nullptr)
        return;
    buffer->deleted = true;
    forget(context, buffer);
    bind_buffer(context, buffer, nullptr);
}

/// Returns the object with a name, and creates it if there is none. Null: there is no memory.
BufferObject* object_of(Context& context, GLuint name) {
    NameTable& names = context.share->buffers;
    void** const slot = names.find(name);
    if (slot != nullptr && *slot != nullptr)
        return static_cast<BufferObject*>(*slot);
    void* const memory = context.arena->allocate(sizeof(BufferObject));
    if (memory == nullptr || (slot == nullptr && !names.insert(*context.arena, name, memory))) {
        context.arena->free(memory);
        return nullptr;
    }
    if (slot != nullptr)
        *slot = memory;
    auto* const object = new (memory) BufferObject;
    object->name = name;
    return object;
}

void* map(BufferObject& buffer, std::size_t offset, std::size_t length, GLbitfield flags, GLenum access) {
    buffer.mapped = true;
    buffer.map_flags = flags;
    buffer.map_offset = offset;
    buffer.map_length = length;
    buffer.access = access;
    return buffer.bytes + offset;
}

} // namespace

namespace cmd {

void GenBuffers(Context& context, GLsizei n, GLuint* buffers) {
    gen_names(context, context.share->buffers, n, buffers);
}

void DeleteBuffers(Context& context, GLsizei n, const GLuint* buffers) {
    if (n < 0 || (n > 0 && buffers == nullptr))
        return error(context, GL_INVALID_VALUE);
    for (GLsizei i = 0; i < n; ++i)
        if (buffers[i] != 0)
            delete_buffer(context, buffers[i]);
}

GLboolean IsBuffer(Context& context, GLuint buffer) {
    return find_buffer(context, buffer) != nullptr ? GL_TRUE : GL_FALSE;
}

void BindBuffer(Context& context, GLenum target, GLuint buffer) {
    BufferObject** const binding = binding_of(context, target);
    if (binding == nullptr)
        return error(context, GL_INVALID_ENUM);
    BufferObject* const object = buffer != 0 ? object_of(context, buffer) : nullptr;
    if (buffer != 0 && object == nullptr)
        return error(context, GL_OUT_OF_MEMORY, SPANGLE_TEXT("no room in the arena for a new object"));
    bind_buffer(context, *binding, object);
}

void BufferData(Context& context, GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
    if (binding_of(context, target) == nullptr || !is_usage(usage))
        return error(context, GL_INVALID_ENUM);
    if (size < 0)
        return error(context, GL_INVALID_VALUE);
    BufferObject* const buffer = bound(context, target);
    if (buffer == nullptr)
        return;
    // The new store is allocated before the old one is freed, so that nothing changes without memory.
    auto* const bytes =
        static_cast<std::uint8_t*>(context.arena->allocate(size != 0 ? static_cast<std::size_t>(size) : 1));
    if (bytes == nullptr)
        return error(context, GL_OUT_OF_MEMORY, SPANGLE_TEXT("no room in the arena"));
    if (data != nullptr)
        std::memcpy(bytes, data, static_cast<std::size_t>(size));
    else
        std::memset(bytes, 0, static_cast<std::size_t>(size));
    replace(context, *buffer, bytes, size, false);
    buffer->usage = usage;
}

void BufferConstantDataSPANGLE(Context& context, GLenum target, GLsizeiptr size, const void* data) {
    if (binding_of(context, target) == nullptr)
        return error(context, GL_INVALID_ENUM);
    if (size < 0 || data == nullptr)
        return error(context, GL_INVALID_VALUE);
    if (BufferObject* const buffer = bound(context, target); buffer != nullptr) {
        // The cast is safe, since every command that would write to a constant buffer is refused.
        replace(context, *buffer, static_cast<std::uint8_t*>(const_cast<void*>(data)), size, true);
        buffer->usage = GL_STATIC_DRAW;
    }
}

void BufferSubData(Context& context, GLenum target, GLintptr offset, GLsizeiptr size, const void* data) {
    BufferObject* const buffer = bound(context, target);
    if (buffer == nullptr)
        return;
    if (!in_range(*buffer, offset, size) || (data == nullptr && size != 0))
        return error(context, GL_INVALID_VALUE, why_out_of_range(*buffer, offset, size));
    if (is_mapped(*buffer, offset, size) || buffer->constant)
        return error(context, GL_INVALID_OPERATION,
                     buffer->constant ? SPANGLE_TEXT("the buffer is constant memory")
                                      : SPANGLE_TEXT("a part of the range is mapped"));
    if (size != 0)
        std::memcpy(buffer->bytes + offset, data, static_cast<std::size_t>(size));
}

void GetBufferSubData(Context& context, GLenum target, GLintptr offset, GLsizeiptr size, void* data) {
    const BufferObject* const buffer = bound(context, target);
    if (buffer == nullptr)
        return;
    if (!in_range(*buffer, offset, size) || (data == nullptr && size != 0))
        return error(context, GL_INVALID_VALUE, why_out_of_range(*buffer, offset, size));
    if (is_mapped(*buffer, offset, size))
        return error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("a part of the range is mapped"));
    if (size != 0)
        std::memcpy(data, buffer->bytes + offset, static_cast<std::size_t>(size));
}

void* MapBuffer(Context& context, GLenum target, GLenum access) {
    if (binding_of(context, target) == nullptr || access < GL_READ_ONLY || access > GL_READ_WRITE) {
        error(context, GL_INVALID_ENUM);
        return nullptr;
    }
    BufferObject* const buffer = bound(context, target);
    if (buffer == nullptr)
        return nullptr;
    if (buffer->mapped || buffer->bytes == nullptr || (buffer->constant && access != GL_READ_ONLY)) {
        error(context, GL_INVALID_OPERATION, why_not_mapped(*buffer));
        return nullptr;
    }
    const GLbitfield flags =
        (access != GL_WRITE_ONLY ? GL_MAP_READ_BIT : 0u) | (access != GL_READ_ONLY ? GL_MAP_WRITE_BIT : 0u);
    return map(*buffer, 0, buffer->size, flags, access);
}

void* MapBufferRange(Context& context, GLenum target, GLintptr offset, GLsizeiptr length, GLbitfield access) {
    BufferObject* const buffer = bound(context, target);
    if (buffer == nullptr)
        return nullptr;
    const bool reads = (access & GL_MAP_READ_BIT) != 0, writes = (access & GL_MAP_WRITE_BIT) != 0;
    constexpr GLbitfield discards =
        GL_MAP_INVALIDATE_RANGE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT | GL_MAP_UNSYNCHRONIZED_BIT;
    if (!in_range(*buffer, offset, length) ||
        (access & ~(GL_MAP_READ_BIT | GL_MAP_WRITE_BIT | discards | GL_MAP_FLUSH_EXPLICIT_BIT)) != 0) {
        error(context, GL_INVALID_VALUE,
              in_range(*buffer, offset, length) ? SPANGLE_TEXT("access has a bit that is not defined")
                                                : SPANGLE_TEXT("offset and length leave the buffer"));
        return nullptr;
    }
    if (buffer->mapped || buffer->bytes == nullptr || (!reads && !writes) ||
        (reads && (access & discards) != 0) || ((access & GL_MAP_FLUSH_EXPLICIT_BIT) != 0 && !writes) ||
        (buffer->constant && writes)) {
        error(context, GL_INVALID_OPERATION,
              buffer->mapped || buffer->bytes == nullptr || (buffer->constant && writes)
                  ? why_not_mapped(*buffer)
                  : SPANGLE_TEXT("access asks for nothing, or for what excludes each other"));
        return nullptr;
    }
    return map(*buffer, static_cast<std::size_t>(offset), static_cast<std::size_t>(length), access,
               reads && writes ? GL_READ_WRITE
               : reads         ? GL_READ_ONLY
                               : GL_WRITE_ONLY);
}

/// The command checks its arguments, and does nothing else. A program and GL use the same memory, so that
/// writes need no flush.
void FlushMappedBufferRange(Context& context, GLenum target, GLintptr offset, GLsizeiptr length) {
    const BufferObject* const buffer = bound(context, target);
    if (buffer == nullptr)
        return;
    // explain() tells that a length is negative before it looks at the rule, so the rule is about the offset.
    if (offset < 0 || length < 0)
        return error(context, GL_INVALID_VALUE, SPANGLE_TEXT("offset is negative"));
    if (!buffer->mapped || (buffer->map_flags & GL_MAP_FLUSH_EXPLICIT_BIT) == 0)
        return error(context, GL_INVALID_OPERATION,
                     SPANGLE_TEXT("the buffer is not mapped with GL_MAP_FLUSH_EXPLICIT_BIT"));
    if (static_cast<std::size_t>(offset) > buffer->map_length ||
        static_cast<std::size_t>(length) > buffer->map_length - static_cast<std::size_t>(offset))
        error(context, GL_INVALID_VALUE, SPANGLE_TEXT("offset and length leave the mapped range"));
}

GLboolean UnmapBuffer(Context& context, GLenum target) {
    BufferObject* const buffer = bound(context, target);
    if (buffer == nullptr)
        return GL_FALSE;
    if (!buffer->mapped) {
        error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("the buffer is not mapped"));
        return GL_FALSE;
    }
    buffer->mapped = false;
    buffer->map_flags = 0;
    buffer->map_offset = buffer->map_length = 0;
    buffer->access = GL_READ_WRITE;
    return GL_TRUE;
}

void GetBufferParameteriv(Context& context, GLenum target, GLenum pname, GLint* params) {
    if (params == nullptr)
        return error(context, GL_INVALID_VALUE);
    if (binding_of(context, target) == nullptr || pname < GL_BUFFER_SIZE)
        return error(context, GL_INVALID_ENUM);
    const BufferObject* const buffer = bound(context, target);
    if (buffer == nullptr)
        return;
    switch (pname) {
    case GL_BUFFER_SIZE:
        *params = static_cast<GLint>(buffer->size);
        break;
    case GL_BUFFER_USAGE:
        *params = static_cast<GLint>(buffer->usage);
        break;
    case GL_BUFFER_ACCESS:
        *params = static_cast<GLint>(buffer->access);
        break;
    case GL_BUFFER_MAPPED:
        *params = buffer->mapped ? 1 : 0;
        break;
    case GL_BUFFER_ACCESS_FLAGS:
        *params = static_cast<GLint>(buffer->map_flags);
        break;
    case GL_BUFFER_MAP_OFFSET:
        *params = static_cast<GLint>(buffer->map_offset);
        break;
    case GL_BUFFER_MAP_LENGTH:
        *params = static_cast<GLint>(buffer->map_length);
        break;
    default:
        error(context, GL_INVALID_ENUM);
    }
}

void GetBufferPointerv(Context& context, GLenum target, GLenum pname, void** params) {
    if (params == nullptr)
        return error(context, GL_INVALID_VALUE);
    if (binding_of(context, target) == nullptr || pname != GL_BUFFER_MAP_POINTER)
        return error(context, GL_INVALID_ENUM);
    if (const BufferObject* const buffer = bound(context, target); buffer != nullptr)
        *params = buffer->mapped ? buffer->bytes + buffer->map_offset : nullptr;
}

} // namespace cmd

} // namespace spangle::gl

#else

#include "gl/vertex/buffer_object.hpp"

namespace spangle::gl {

void release_buffers(Context&, ArraysState&) {}
void hold_arrays(Context&) {}
void release_arrays(Context&) {}

} // namespace spangle::gl

#endif
