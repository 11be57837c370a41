// Draws triangles, quads and lines by code of their own, where no part of them is cut off.
#pragma once

#include "gl/vertex/vertex_kinds.hpp"

namespace spangle::gl {

/// Draws a triangle whose last corner is the provoking vertex.
template <class Sink, class Vertex> SPANGLE_INLINE void draw_face_of_3(Sink& to, Vertex* const* c) {
    to.draw_triangle(*c[0], *c[1], *c[2]);
}

/// Draws a quad whose third corner is the provoking vertex.
template <class Sink, class Vertex> SPANGLE_INLINE void draw_face_of_4(Sink& to, Vertex* const* c) {
    to.draw_quad(*c[0], *c[1], *c[2], *c[3], *c[2]);
}

/// Draws a line that nothing captures.
template <class Sink, class Vertex> SPANGLE_INLINE void draw_single_line(Sink& to, Vertex& a, Vertex& b) {
    Vertex* const ends[2] = {&a, &b};
    to.lines(ends, 2, 1, false);
}

} // namespace spangle::gl
