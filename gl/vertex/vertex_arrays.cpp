// Vertex array objects hold the state that VertexPointer and similar commands set (GL 3.0, 2.10). Each
// context has its own objects.
#include "gl/context/hooks.hpp"

#if SPANGLE_FEATURE_VERTEX_ARRAY_OBJECTS

#include <new>

#include "gl/api/generated/commands.hpp"
#include "gl/context/arena.hpp"
#include "gl/context/context.hpp"
#include "gl/vertex/buffer_object.hpp"

namespace spangle::gl {

namespace {

/// Allocates the ArraysState of an array object that has none yet. False: the arena has no room.
bool make(Context& context, void*& object) {
    if (object != nullptr)
        return true;
    void* const memory = context.arena->allocate(sizeof(ArraysState));
    if (memory != nullptr)
        object = new (memory) ArraysState;
    return memory != nullptr;
}

/// Returns the place of the pointer to an unbound object's ArraysState. The pointer there is null until the
/// state is needed. Null: GenVertexArrays did not return this name.
void** place_of(ArrayBindings& bindings, GLuint name) {
    return name != 0 ? bindings.vertex_arrays.find(name) : &bindings.unnamed;
}

void destroy(Context& context, void* object) {
    if (object != nullptr)
        release_buffers(context, *static_cast<ArraysState*>(object));
    context.arena->free(object);
}

} // namespace

GLuint bound_vertex_array(const Context& context) {
    return context.array_bindings.vertex_array;
}

/// Binds an array object, or object 0 for an unknown name. The arrays of the bound object are in the context,
/// where draws read them, and those of other objects are in the arena. False: the arena has no room.
bool bind_vertex_array(Context& context, GLuint name) {
    ArrayBindings& bindings = context.array_bindings;
    void **const from = place_of(bindings, bindings.vertex_array), **to = place_of(bindings, name);
    if (to == nullptr) {
        name = 0;
        to = place_of(bindings, name);
    }
    if (from == to)
        return true;
    if (!make(context, *from) || !make(context, *to))
        return false;
    *static_cast<ArraysState*>(*from) = context.arrays;
    context.arrays = *static_cast<ArraysState*>(*to);
    bindings.vertex_array = name;
    return true;
}

void release_vertex_arrays(Context& context) {
    release_arrays(context);
    ArrayBindings& bindings = context.array_bindings;
    if (void** const bound = place_of(bindings, bindings.vertex_array); *bound != nullptr)
        *static_cast<ArraysState*>(*bound) = ArraysState(); // release_arrays() has released its buffers
    destroy(context, bindings.unnamed);
    for (std::uint32_t i = 0; i < bindings.vertex_arrays.capacity(); ++i)
        if (bindings.vertex_arrays.slot(i).name != 0)
            destroy(context, bindings.vertex_arrays.slot(i).object);
    bindings.vertex_arrays.clear(*context.arena);
}

namespace cmd {

void GenVertexArrays(Context& context, GLsizei n, GLuint* arrays) {
    gen_names(context, context.array_bindings.vertex_arrays, n, arrays);
}

void DeleteVertexArrays(Context& context, GLsizei n, const GLuint* arrays) {
    if (n < 0 || (n > 0 && arrays == nullptr))
        return error(context, GL_INVALID_VALUE);
    for (GLsizei i = 0; i < n; ++i) {
        if (arrays[i] == 0)
            continue;
        if (arrays[i] == context.array_bindings.vertex_array)
            BindVertexArray(context, 0);
        destroy(context, context.array_bindings.vertex_arrays.remove(arrays[i]));
    }
}

GLboolean IsVertexArray(Context& context, GLuint array) {
    void** const slot = context.array_bindings.vertex_arrays.find(array);
    return slot != nullptr && *slot != nullptr ? GL_TRUE : GL_FALSE;
}

void BindVertexArray(Context& context, GLuint array) {
    if (place_of(context.array_bindings, array) == nullptr)
        return error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("no name of glGenVertexArrays"));
    if (!bind_vertex_array(context, array))
        error(context, GL_OUT_OF_MEMORY, SPANGLE_TEXT("no room in the arena"));
}

} // namespace cmd

} // namespace spangle::gl

#else

namespace spangle::gl {

GLuint bound_vertex_array(const Context&) {
    return 0;
}
bool bind_vertex_array(Context&, GLuint) {
    return true;
}
void release_vertex_arrays(Context& context) {
    release_arrays(context);
}

} // namespace spangle::gl

#endif
