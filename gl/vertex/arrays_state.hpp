// The client state of vertex arrays: where they lie and which are enabled (GL 1.3, 2.8).
#pragma once

#include <initializer_list>

#include "gl/context/name_table.hpp"
#include "gl/context/types.hpp"

namespace spangle::gl {

struct BufferObject;

struct ClientArray {
    /// Out of line: a context constructs many arrays, and each copy of the code would cost bytes.
    [[gnu::noinline]] constexpr explicit ClientArray(GLint components = 4, GLenum component = GL_FLOAT)
        : size(components), type(component) {}

    bool enabled = false;
    GLint size;
    GLenum type;
    GLsizei stride = 0;             ///< bytes from one element to the next, as given; 0: packed
    const void* pointer = nullptr;  ///< an address, or the offset in `buffer`
    BufferObject* buffer = nullptr; ///< null: the array lies in client memory

    bool on() const { return enabled && pointer != nullptr; }
};

/// What a vertex array object holds (GL 3.0, 2.10).
struct ArraysState {
    ClientArray vertex, normal, color;
    ClientArray index{1}, edge_flag{1, GL_UNSIGNED_BYTE}, fog_coord{1}, secondary_color{3};
    ClientArray tex_coord[texture_units];
    BufferObject* element_buffer = nullptr;
    bool buffered = false; ///< some array may lie in a buffer
};

/// Calls f(array) for each array.
template <class Arrays, class F> void each_array(Arrays& arrays, F f) {
    for (auto* array : {&arrays.vertex, &arrays.normal, &arrays.color, &arrays.index, &arrays.edge_flag,
                        &arrays.fog_coord, &arrays.secondary_color})
        f(*array);
    for (auto& array : arrays.tex_coord)
        f(array);
}

/// The bindings and modes that no vertex array object holds.
struct ArrayBindings {
    BufferObject* array_buffer = nullptr;
    GLuint client_active = 0; ///< the unit whose array commands and queries refer to
    /// The unit of client_active; a constant 0 where the build has one unit.
    GLuint client_unit() const { return texture_units > 1 ? client_active : 0; }
    GLuint restart_index = 0;
    bool restart = false; ///< PRIMITIVE_RESTART is enabled
#if SPANGLE_FEATURE_VERTEX_ARRAY_OBJECTS
    GLuint vertex_array = 0; ///< name of the bound object, whose arrays are in Context::arrays
    NameTable vertex_arrays; ///< names to ArraysState, which is current only while the object is not bound
    void* unnamed = nullptr; ///< ArraysState of name 0, likewise
#endif
};

} // namespace spangle::gl
