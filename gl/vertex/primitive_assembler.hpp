// Assembles primitives from vertices (GL 1.3, 2.6.1).
//
// PrimitiveAssembler owns which vertices are corners of the current primitive, not the vertices themselves.
// Vertices come in the order of the program, and a Sink is told of each primitive when its last corner has
// come. The assembler promises the primitives of GL 1.3, 2.6.1, in order, each with its winding and its
// provoking vertex (GL 1.3, 2.13.7). A Sink has these functions:
//   point(v), line(a, b)           b is the provoking vertex of the line.
//   triangle(c), quad(c)           c is an array of 3 or 4 corners, whose corner 2 is the provoking vertex.
//   fan(c)                         c is a triangle of a POLYGON, whose corner 0 is the provoking vertex.
//   outlined_fan(c, first, last)   is the same with PolygonForm::outlined. The flags say whether the triangle
//                                  is the first or the last one of the polygon.
//   gather(v), gathered()          take each vertex of a POLYGON with PolygonForm::gathered, and its end.
#pragma once

#include <cstdint>

#include "gl/context/limits.hpp"
#include "gl/context/types.hpp"
#include "gl/vertex/render_state.hpp"

namespace spangle::gl {

/// How a POLYGON reaches the sink.
enum class PolygonForm : std::uint8_t {
    filled,   ///< the POLYGON arrives as a fan of triangles
    outlined, ///< the POLYGON arrives as a fan, with flags for the edges of its boundary
    gathered, ///< the POLYGON arrives vertex by vertex
};

template <class Vertex> class PrimitiveAssembler {
  public:
    /// Number of vertices that a caller needs to have a place for each next vertex.
    static constexpr int slot_count = 4;

    /// Begins primitives of `mode`, a token of Begin. Corners go to `slots`, unless set_next() places them.
    void begin(GLenum mode, Vertex (&slots)[slot_count]) {
        mode_ = mode;
        needed_ = corners_of(mode);
        form_ = PolygonForm::filled;
        restart();
        for (int i = 0; i < slot_count; ++i)
            corner_[i] = &slots[i];
    }
    /// Sets the form of a POLYGON, after begin().
    void set_form(PolygonForm form) {
        form_ = form;
        // An outlined triangle waits for one vertex more, since the polygon's last triangle has one boundary
        // more.
        needed_ = form == PolygonForm::gathered ? 1 : form == PolygonForm::outlined ? 4 : 3;
    }
    /// Forgets the corners of an incomplete primitive. The next vertex starts a strip anew.
    void restart() { count_ = 0, is_odd_triangle_ = false; }

    GLenum mode() const { return mode_; }
    /// Number of vertices that wait for the primitive to be complete.
    int count() const { return count_; }
    /// Returns waiting vertex i, from 0 to count() - 1. The next primitive may need it.
    Vertex& corner(int i) const { return *corner_[i]; }

    /// The place of the next vertex: no corner of the current primitive is there.
    Vertex& next() const { return *corner_[count_]; }
    /// Makes a vertex that lies elsewhere the next one.
    void set_next(Vertex& v) { corner_[count_] = &v; }
    /// Takes the next vertex. True: it completes a primitive, so that complete() must be called.
    bool take_next() { return ++count_ == needed_; }
    /// Hands the completed primitive to the sink. Corners that the next primitive shares stay.
    template <class Sink> SPANGLE_INLINE void complete(Sink& sink);
    /// Hands over what only the end completes: the line that closes a loop, and the rest of a POLYGON.
    template <class Sink> SPANGLE_INLINE void end(Sink& sink);
    /// Leaves the last line of a LINE_LOOP to end(), after somebody else has drawn the others.
    void close_loop(Vertex& first, Vertex& last) {
        corner_[0] = &first;
        corner_[1] = &last;
        count_ = 2;
    }

    /// Returns the place of a new vertex: `wanted`, unless a corner of the current primitive is there, or
    /// else a slot that holds no corner.
    SPANGLE_INLINE Vertex& place_beside_corners(Vertex& wanted, Vertex (&slots)[slot_count]) const {
        Vertex* v = &wanted;
        for (int i = 0; i < count_; ++i)
            if (corner_[i] == v)
                v = free_slot(slots);
        return *v;
    }

  private:
    GLenum mode_ = GL_POINTS;
    /// Number of vertices that `corner_` holds, and the number that completes a primitive.
    int count_ = 0, needed_ = 0;
    /// True after an odd number of triangles of a strip, and after the first triangle of an outlined polygon.
    bool is_odd_triangle_ = false;
    PolygonForm form_ = PolygonForm::filled;
    Vertex* corner_[slot_count] = {}; ///< vertices of the current primitive

    static int corners_of(GLenum mode);
    bool is_outlined() const { return SPANGLE_FEATURE_POLYGON_MODE && form_ == PolygonForm::outlined; }
    bool is_gathered() const { return SPANGLE_GATHERS_POLYGONS && form_ == PolygonForm::gathered; }
    void swap(int i, int j) {
        Vertex* const v = corner_[i];
        corner_[i] = corner_[j];
        corner_[j] = v;
    }
    template <class Sink> [[gnu::noinline]] void outlined_fan(Sink& sink, bool last);
    [[gnu::noinline]] Vertex* free_slot(Vertex (&slots)[slot_count]) const;
};

template <class Vertex> inline int PrimitiveAssembler<Vertex>::corners_of(GLenum mode) {
    constexpr std::int8_t corners[] = {1, 2, 2, 2, 3, 3, 3, 4, 4, 3};
    static_assert(corners[GL_POINTS] == 1 && corners[GL_LINES] == 2 && corners[GL_LINE_LOOP] == 2 &&
                  corners[GL_LINE_STRIP] == 2 && corners[GL_TRIANGLES] == 3 &&
                  corners[GL_TRIANGLE_STRIP] == 3 && corners[GL_TRIANGLE_FAN] == 3 &&
                  corners[GL_QUADS] == 4 && corners[GL_QUAD_STRIP] == 4 && corners[GL_POLYGON] == 3 &&
                  sizeof corners == GL_POLYGON + 1);
    return corners[mode];
}

template <class Vertex>
template <class Sink>
SPANGLE_INLINE void PrimitiveAssembler<Vertex>::complete(Sink& sink) {
    Vertex* const* const c = corner_;
    switch (mode_) {
    case GL_POINTS:
        count_ = 0;
        return sink.point(*c[0]);
    case GL_LINES:
        count_ = 0;
        return sink.line(*c[0], *c[1]);
    case GL_LINE_STRIP:
        count_ = 1;
        swap(0, 1);
        return sink.line(*c[1], *c[0]);
    case GL_LINE_LOOP: // the first vertex of the loop stays in corner_[0]
        count_ = 2;
        if (needed_ == 2) {
            needed_ = 3;
            return sink.line(*c[0], *c[1]);
        }
        swap(1, 2);
        return sink.line(*c[2], *c[1]);
    case GL_TRIANGLES:
        count_ = 0;
        return sink.triangle(c);
    case GL_TRIANGLE_STRIP: // the newest vertex replaces the oldest, so that all triangles keep their winding
        sink.triangle(c);
        swap(is_odd_triangle_ ? 1 : 0, 2);
        is_odd_triangle_ = !is_odd_triangle_;
        count_ = 2;
        return;
    case GL_TRIANGLE_FAN:
        sink.triangle(c);
        break;
    case GL_POLYGON:
        if constexpr (!has_polygons)
            return;
        if (is_gathered()) {
            count_ = 0;
            return sink.gather(*c[0]);
        }
        if (is_outlined())
            return outlined_fan(sink, false);
        sink.fan(c);
        break;
    case GL_QUADS: {
        // GL leaves open which diagonal divides a quad (GL 1.3, 2.6.1). Here the diagonal ends at the
        // provoking vertex, as in QUAD_STRIP and in Mesa. A quad with four colours looks as it does
        // elsewhere.
        Vertex* const from_second[4] = {c[1], c[2], c[3], c[0]};
        count_ = 0;
        return sink.quad(from_second);
    }
    case GL_QUAD_STRIP:
        swap(2, 3); // the corners are in the order v0 v1 v3 v2 now
        sink.quad(c);
        swap(0, 3);
        break;
    }
    swap(1, 2);
    count_ = 2;
}

template <class Vertex>
template <class Sink>
SPANGLE_INLINE void PrimitiveAssembler<Vertex>::end(Sink& sink) {
    if (has_lines && mode_ == GL_LINE_LOOP && count_ == 2)
        sink.line(*corner_[1], *corner_[0]);
    if (is_gathered())
        sink.gathered();
    else if (is_outlined() && count_ == 3)
        outlined_fan(sink, true);
}

/// Hands over the oldest triangle (v0, vi, vi+1) of an outlined polygon. `last` says that this triangle is
/// the last one.
template <class Vertex>
template <class Sink>
void PrimitiveAssembler<Vertex>::outlined_fan(Sink& sink, bool last) {
    const bool first = !is_odd_triangle_;
    is_odd_triangle_ = true;
    sink.outlined_fan(corner_, first, last);
    swap(1, 2);
    swap(2, 3);
    count_ = 3;
}

/// Returns a slot that holds no corner of the current primitive. At most three of the four slots hold one.
template <class Vertex> Vertex* PrimitiveAssembler<Vertex>::free_slot(Vertex (&slots)[slot_count]) const {
    for (Vertex& v : slots) {
        bool held = false;
        for (int i = 0; i < count_; ++i)
            held = held || corner_[i] == &v;
        if (!held)
            return &v;
    }
    return slots;
}

} // namespace spangle::gl
