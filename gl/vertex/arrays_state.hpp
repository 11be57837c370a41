// Vertex arrays: where they are and which are on (GL 1.3, 2.8). Client state.
#pragma once

#include <initializer_list>

#include "gl/context/name_table.hpp"
#include "gl/context/types.hpp"

namespace spangle::gl {

struct BufferObject;

struct ClientArray {
    /// Not in line: there are many.
    [[gnu::noinline]] constexpr explicit ClientArray(GLint components = 4, GLenum component = GL_FLOAT)
        : size(components), type(component) {}

    bool enabled = false;
    GLint size;
    GLenum type;
    GLsizei stride = 0;             ///< as given; 0 = packed
    const void* pointer = nullptr;  ///< in a buffer: the offset
    BufferObject* buffer = nullptr; ///< null: client memory

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

/// Calls f(array) for each.
template <class Arrays, class F> void each_array(Arrays& arrays, F f) {
    for (auto* array : {&arrays.vertex, &arrays.normal, &arrays.color, &arrays.index, &arrays.edge_flag,
                        &arrays.fog_coord, &arrays.secondary_color})
        f(*array);
    for (auto& array : arrays.tex_coord)
        f(array);
}

/// What holds for all of them.
struct ArrayBindings {
    BufferObject* array_buffer = nullptr;
    GLuint client_active = 0; ///< the unit whose array commands and queries name
    /// The same; where there is one unit only the compiler knows it.
    GLuint client_unit() const { return texture_units > 1 ? client_active : 0; }
    GLuint restart_index = 0;
    bool restart = false; ///< PRIMITIVE_RESTART
#if SPANGLE_FEATURE_VERTEX_ARRAY_OBJECTS
    GLuint vertex_array = 0; ///< its name: Context::arrays is what it holds now
    NameTable vertex_arrays; ///< to ArraysState of those that are not bound
    void* unnamed = nullptr; ///< the same of name 0
#endif
};

} // namespace spangle::gl
