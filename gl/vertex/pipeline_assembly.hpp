// Assembles primitives from vertices (GL 1.3, 2.6.1). GL 1.3, 2.13.7, names the provoking vertex of each kind
// of primitive.
#pragma once

#include "gl/vertex/pipeline.hpp"

namespace spangle::gl {

template <class M, class L> inline int Pipeline<M, L>::corners_of(GLenum mode) {
    constexpr std::int8_t corners[] = {1, 2, 2, 2, 3, 3, 3, 4, 4, 3};
    static_assert(corners[GL_POINTS] == 1 && corners[GL_LINES] == 2 && corners[GL_LINE_LOOP] == 2 &&
                  corners[GL_LINE_STRIP] == 2 && corners[GL_TRIANGLES] == 3 &&
                  corners[GL_TRIANGLE_STRIP] == 3 && corners[GL_TRIANGLE_FAN] == 3 &&
                  corners[GL_QUADS] == 4 && corners[GL_QUAD_STRIP] == 4 && corners[GL_POLYGON] == 3 &&
                  sizeof corners == GL_POLYGON + 1);
    return corners[mode];
}

template <class M, class L> inline void Pipeline<M, L>::swap(int i, int j) {
    Vertex* const v = corner_[i];
    corner_[i] = corner_[j];
    corner_[j] = v;
}

/// Draws a triangle (N = 3) or quad (N = 4) with corners c. The two triangles of a quad share the diagonal
/// from c[0] to c[2].
template <class M, class L>
template <int N>
SPANGLE_INLINE void Pipeline<M, L>::draw_face(Vertex* const* c, int provoking) {
    if constexpr (faces_are_polygons)
        polygon(c, N, *c[provoking]);
    else if constexpr (N == 3)
        triangle(*c[0], *c[1], *c[2]);
    else
        draw_quad(*c[0], *c[1], *c[2], *c[3], *c[provoking]);
}

/// Draws a primitive, all corners of which have been given. Corners that the next primitive shares move to
/// the front of corner_.
template <class M, class L> void Pipeline<M, L>::primitive() {
    Vertex* const* const c = corner_;
    switch (modes_.mode()) {
    case GL_POINTS:
        corner_count_ = 0;
        return point(*c[0]);
    case GL_LINES:
        corner_count_ = 0;
        return line(*c[0], *c[1]);
    case GL_LINE_STRIP:
        corner_count_ = 1;
        swap(0, 1);
        return line(*c[1], *c[0]);
    case GL_LINE_LOOP: // the first vertex of the loop stays in corner_[0]
        corner_count_ = 2;
        if (corners_needed_ == 2) {
            corners_needed_ = 3;
            return line(*c[0], *c[1]);
        }
        swap(1, 2);
        return line(*c[2], *c[1]);
    case GL_TRIANGLES:
        corner_count_ = 0;
        return draw_face<3>(c, 2);
    case GL_TRIANGLE_STRIP: // the newest vertex replaces the oldest, so that all triangles keep their winding
        draw_face<3>(c, 2);
        swap(is_odd_triangle_ ? 1 : 0, 2);
        is_odd_triangle_ = !is_odd_triangle_;
        corner_count_ = 2;
        return;
    case GL_TRIANGLE_FAN:
        draw_face<3>(c, 2);
        break;
    case GL_POLYGON:
        if constexpr (!has_polygons)
            return;
        if (modes_.gathers_polygons())
            return gather(*c[0]);
        if (modes_.has_outlines())
            return outlined_fan(false);
        polygon(c, 3, *c[0]);
        break;
    case GL_QUADS: {
        // GL leaves open which diagonal divides a quad (GL 1.3, 2.6.1). Here the diagonal ends at the
        // provoking vertex, as in QUAD_STRIP and in Mesa. A quad with four colours looks as it does
        // elsewhere.
        Vertex* const from_second[4] = {c[1], c[2], c[3], c[0]};
        corner_count_ = 0;
        return draw_face<4>(from_second, 2);
    }
    case GL_QUAD_STRIP:
        swap(2, 3); // the corners are in the order v0 v1 v3 v2 now
        draw_face<4>(c, 2);
        swap(0, 3);
        break;
    }
    swap(1, 2);
    corner_count_ = 2;
}

/// Begins a POLYGON that is outlined or gathered, not drawn as a fan of filled triangles.
template <class M, class L> void Pipeline<M, L>::begin_polygon() {
    if (modes_.gathers_polygons())
        corners_needed_ = 1;
    else if (modes_.has_outlines())
        corners_needed_ = 4; // an outlined triangle waits for one vertex more, since the polygon's last
                             // triangle has one boundary more
}

template <class M, class L> void Pipeline<M, L>::end_polygon() {
    if (modes_.gathers_polygons())
        draw_gathered();
    else if (modes_.has_outlines() && corner_count_ == 3)
        outlined_fan(true);
}

/// Draws the oldest triangle (v0, vi, vi+1) of an outlined polygon. Boundary edges are those of the polygon:
/// v0 v1 belongs to the first triangle, and vn v0 to the last one. `last` says that this triangle is the last
/// one.
template <class M, class L> void Pipeline<M, L>::outlined_fan(bool last) {
    const auto flag = [](Vertex& v, bool is_edge) {
        v.flags = is_edge && (v.flags & edge_flag) != 0 ? v.flags | boundary : v.flags & ~boundary;
    };
    flag(*corner_[0], !is_odd_triangle_);
    flag(*corner_[1], true);
    flag(*corner_[2], last);
    is_odd_triangle_ = true;
    polygon(corner_, 3, *corner_[0]);
    swap(1, 2);
    swap(2, 3);
    corner_count_ = 3;
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
