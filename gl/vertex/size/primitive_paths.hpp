// Draws triangles and quads as polygons, and all lines as lines that may be cut.
#pragma once

#include "gl/vertex/vertex_kinds.hpp"

namespace spangle::gl {

/// Draws a triangle whose last corner is the provoking vertex.
template <class Sink, class Vertex> SPANGLE_INLINE void draw_face_of_3(Sink& to, Vertex* const* c) {
    if constexpr (has_polygons)
        to.polygon(c, 3, *c[2]);
    else
        to.draw_triangle(*c[0], *c[1], *c[2]);
}

/// Draws a quad whose third corner is the provoking vertex.
template <class Sink, class Vertex> SPANGLE_INLINE void draw_face_of_4(Sink& to, Vertex* const* c) {
    if constexpr (has_polygons)
        to.polygon(c, 4, *c[2]);
    else
        to.draw_quad(*c[0], *c[1], *c[2], *c[3], *c[2]);
}

/// Draws a line that nothing captures.
template <class Sink, class Vertex> SPANGLE_INLINE void draw_single_line(Sink& to, Vertex& a, Vertex& b) {
    to.draw_visible_line(a, b);
}

} // namespace spangle::gl
