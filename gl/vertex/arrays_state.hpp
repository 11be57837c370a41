// Client state of vertex arrays: where they are and which are enabled (GL 1.3, 2.8).
#pragma once

#include <initializer_list>

#include "gl/context/name_table.hpp"
#include "gl/context/types.hpp"

namespace spangle::gl {

struct BufferObject;

struct ClientArray {
    /// The constructor is not inlined, since a context constructs many arrays and each copy would take code.
    [[gnu::noinline]] constexpr explicit ClientArray(GLint components = 4, GLenum component = GL_FLOAT)
        : size(components), type(component) {}

    bool enabled = false;
    GLint size;
    GLenum type;
    /// Bytes from one element to the next, as given. 0: the elements are packed.
    GLsizei stride = 0;
    const void* pointer = nullptr;  ///< address of the first element, or its offset in `buffer`
    BufferObject* buffer = nullptr; ///< null: the array is in client memory

    bool on() const { return enabled && pointer != nullptr; }
};

/// The state of a vertex array object (GL 3.0, 2.10).
struct ArraysState {
    ClientArray vertex, normal, color;
    ClientArray index{1}, edge_flag{1, GL_UNSIGNED_BYTE}, fog_coord{1}, secondary_color{3};
    ClientArray tex_coord[texture_units];
    BufferObject* element_buffer = nullptr;
    bool buffered = false; ///< true if an array may be in a buffer
};

/// Calls f(array) for each array.
template <class Arrays, class F> void each_array(Arrays& arrays, F f) {
    for (auto* array : {&arrays.vertex, &arrays.normal, &arrays.color, &arrays.index, &arrays.edge_flag,
                        &arrays.fog_coord, &arrays.secondary_color})
        f(*array);
    for (auto& array : arrays.tex_coord)
        f(array);
}

/// Bindings and modes that are not part of a vertex array object.
struct ArrayBindings {
    BufferObject* array_buffer = nullptr;
    GLuint client_active = 0; ///< texture unit that array commands and queries refer to
    /// Returns client_active, or a constant 0 in builds with one unit.
    GLuint client_unit() const { return texture_units > 1 ? client_active : 0; }
    GLuint restart_index = 0;
    bool restart = false; ///< true if PRIMITIVE_RESTART is enabled
#if SPANGLE_FEATURE_VERTEX_ARRAY_OBJECTS
    GLuint vertex_array = 0; ///< name of the bound object, whose arrays are in Context::arrays
    /// Names of objects with their ArraysState, which is out of date while the object is bound.
    NameTable vertex_arrays;
    void* unnamed = nullptr; ///< ArraysState of object 0, out of date while it is bound
#endif
};

} // namespace spangle::gl
