// Assembles primitives from vertices (GL 1.3, 2.6.1). GL 1.3, 2.13.7, names the provoking vertex of each kind
// of primitive.
#pragma once

#include "gl/vertex/pipeline.hpp"

namespace spangle::gl {

/// Draws the primitive that the last vertex completed.
template <class M, class L> void Pipeline<M, L>::primitive() {
    assembler_.complete(*this);
}

template <class M, class L> SPANGLE_INLINE void Pipeline<M, L>::triangle(Vertex* const* c) {
    if constexpr (faces_are_polygons)
        polygon(c, 3, *c[2]);
    else
        draw_triangle(*c[0], *c[1], *c[2]);
}

/// Draws a quad. Its two triangles share the diagonal from c[0] to c[2].
template <class M, class L> SPANGLE_INLINE void Pipeline<M, L>::quad(Vertex* const* c) {
    if constexpr (faces_are_polygons)
        polygon(c, 4, *c[2]);
    else
        draw_quad(*c[0], *c[1], *c[2], *c[3], *c[2]);
}

template <class M, class L> inline void Pipeline<M, L>::fan(Vertex* const* c) {
    polygon(c, 3, *c[0]);
}

/// Draws a triangle of an outlined polygon. Boundary edges are those of the polygon: v0 v1 belongs to the
/// first triangle, and vn v0 to the last one.
template <class M, class L>
inline void Pipeline<M, L>::outlined_fan(Vertex* const* c, bool first, bool last) {
    const auto flag = [](Vertex& v, bool is_edge) {
        v.flags = is_edge && (v.flags & edge_flag) != 0 ? v.flags | boundary : v.flags & ~boundary;
    };
    flag(*c[0], first);
    flag(*c[1], true);
    flag(*c[2], last);
    polygon(c, 3, *c[0]);
}

template <class M, class L> inline void Pipeline<M, L>::gathered() {
    draw_gathered();
}

/// Index, of n corners, at which outlines and feedback begin: that of the vertex given first. A quad is
/// stored from its second vertex on, so that its first vertex comes last. GL leaves open where a clipped quad
/// begins.
template <class M, class L> inline int Pipeline<M, L>::first_corner(int n) const {
    return modes_.mode() == GL_QUADS ? n - 1 : 0;
}

/// Marks the edges that outlines of a triangle or quad draw. Edge flags apply to separate triangles and quads
/// only; strips and fans draw all edges (GL 1.3, 2.6.2).
template <class M, class L> inline void Pipeline<M, L>::flag_edges(Vertex* const* corners, int n) {
    if (modes_.mode() == GL_POLYGON)
        return;
    const bool by_flag = modes_.mode() == GL_TRIANGLES || modes_.mode() == GL_QUADS;
    for (int i = 0; i < n; ++i) {
        std::uint32_t& flags = corners[i]->flags;
        flags = !by_flag || (flags & edge_flag) != 0 ? flags | boundary : flags & ~boundary;
    }
}

} // namespace spangle::gl
