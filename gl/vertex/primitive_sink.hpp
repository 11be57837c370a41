// Draws the primitives that an assembler completes.
//
// PrimitiveSink owns nothing. It is a sink of PrimitiveAssembler, and takes vertices that VertexStage has
// processed. It draws common triangles and quads itself, and leaves those that need clipping or a special
// mode to PolygonSink. It promises that a vertex is coloured only for a primitive that survives culling, and
// that both triangles of a quad face the same way.
#pragma once

#include "gl/vertex/polygon_sink.hpp"
#include "gl/vertex/primitive_paths.hpp"

namespace spangle::gl {

template <class M, class L> class PrimitiveSink : public PolygonSink<M, L> {
    using Base = PolygonSink<M, L>;
    template <class Sink, class Vertex> friend void draw_face_of_3(Sink& to, Vertex* const* c);
    template <class Sink, class Vertex> friend void draw_face_of_4(Sink& to, Vertex* const* c);

  public:
    using Window = typename M::Window;
    using Vertex = gl::Vertex<M>;
    using ClippedVertex = gl::ClippedVertex<M, L>;

    SPANGLE_INLINE void triangle(Vertex* const* c);
    SPANGLE_INLINE void quad(Vertex* const* c);
    void fan(Vertex* const* c);
    void outlined_fan(Vertex* const* c, bool first, bool last);
    SPANGLE_INLINE void draw_common_triangle(Vertex& a, Vertex& b, Vertex& c, bool whole);

  protected:
    using Base::area_of;
    using Base::batches_;
    using Base::color;
    using Base::context_;
    using Base::modes_;
    using Base::needs_clipping;
    using Base::polygon;
    using Base::refuse_clipping;
    using Base::skips_batches;
    using Base::state_;

    [[gnu::noinline]] void draw_triangle(Vertex& a, Vertex& b, Vertex& c);
    void draw_quad(Vertex& a, Vertex& b, Vertex& c, Vertex& d, Vertex& provoking);
    template <class... V> bool is_outside_rows(const V&... corner) const;
};

template <class M, class L> SPANGLE_INLINE void PrimitiveSink<M, L>::triangle(Vertex* const* c) {
    draw_face_of_3(*this, c);
}

/// Draws a quad. Its two triangles share the diagonal from c[0] to c[2].
template <class M, class L> SPANGLE_INLINE void PrimitiveSink<M, L>::quad(Vertex* const* c) {
    draw_face_of_4(*this, c);
}

template <class M, class L> inline void PrimitiveSink<M, L>::fan(Vertex* const* c) {
    polygon(c, 3, *c[0]);
}

/// Draws a triangle of an outlined polygon. Boundary edges are those of the polygon: v0 v1 belongs to the
/// first triangle, and vn v0 to the last one.
template <class M, class L>
inline void PrimitiveSink<M, L>::outlined_fan(Vertex* const* c, bool first, bool last) {
    const auto flag = [](Vertex& v, bool is_edge) {
        v.flags = is_edge && (v.flags & edge_flag) != 0 ? v.flags | boundary : v.flags & ~boundary;
    };
    flag(*c[0], first);
    flag(*c[1], true);
    flag(*c[2], last);
    fan(c);
}

template <class M, class L>
SPANGLE_INLINE void PrimitiveSink<M, L>::draw_common_triangle(Vertex& a, Vertex& b, Vertex& c, bool whole) {
    const unsigned any = a.flags | b.flags | c.flags;
    if ((any & (outside_mask | beyond_mask | unprojected)) != 0 || whole) [[unlikely]] {
        if ((a.flags & b.flags & c.flags & outside_mask) != 0)
            return;
        if (refuse_clipping(any))
            return;
        if (needs_clipping(any) || whole) {
            Vertex* const corners[3] = {&a, &b, &c};
            return polygon(corners, 3, c);
        }
    }
    const std::int64_t area = area_of(a.window, b.window, c.window);
    if (modes_.culls(area < 0) || area == 0 || is_outside_rows(a, b, c))
        return;
    if ((any & uncolored) != 0) {
        if (!modes_.is_flat_shaded())
            color(a), color(b);
        color(c);
    }
    raster::draw_triangle(*state_, context_->drawable.surface, a.window, b.window, c.window, c.window, area);
}

/// Draws a triangle whose last corner is the provoking vertex. polygon() draws triangles that need clipping
/// or two-sided lighting.
template <class M, class L> void PrimitiveSink<M, L>::draw_triangle(Vertex& a, Vertex& b, Vertex& c) {
    draw_common_triangle(a, b, c, modes_.needs_polygon_path());
}

/// Draws a quad as two triangles. The area of the whole quad decides which way both triangles face.
template <class M, class L>
void PrimitiveSink<M, L>::draw_quad(Vertex& a, Vertex& b, Vertex& c, Vertex& d, Vertex& provoking) {
    if constexpr (!has_polygons)
        return;
    const unsigned any = a.flags | b.flags | c.flags | d.flags;
    if ((a.flags & b.flags & c.flags & d.flags & outside_mask) != 0)
        return;
    if (refuse_clipping(any))
        return;
    if (needs_clipping(any) || modes_.needs_polygon_path()) {
        Vertex* const corners[4] = {&a, &b, &c, &d};
        return polygon(corners, 4, provoking);
    }
    const std::int64_t first = area_of(a.window, b.window, c.window),
                       second = area_of(a.window, c.window, d.window);
    if (modes_.culls(first + second <= 0) || is_outside_rows(a, b, c, d))
        return;
    if ((any & uncolored) != 0) {
        if (!modes_.is_flat_shaded())
            color(a), color(b), color(c), color(d);
        color(provoking);
    }
    const raster::Surface& surface = context_->drawable.surface;
    if (first != 0)
        raster::draw_triangle(*state_, surface, a.window, b.window, c.window, provoking.window, first);
    if (second != 0)
        raster::draw_triangle(*state_, surface, a.window, c.window, d.window, provoking.window, second);
}

/// True if a callback draws bands, and all corners of a filled triangle or quad are below or above the
/// current band. The colours of such corners need not be computed.
template <class M, class L>
template <class... V>
inline bool PrimitiveSink<M, L>::is_outside_rows([[maybe_unused]] const V&... corner) const {
    if constexpr (skips_batches) {
        if (batches_ == nullptr || batches_->is_recording())
            return false;
        const raster::Surface& surface = context_->drawable.surface;
        const std::int32_t low = surface.first_row * raster::subpixel_one,
                           high = surface.end_row * raster::subpixel_one;
        return ((raster::position(corner.window).y < low) && ...) ||
               ((raster::position(corner.window).y > high) && ...);
    } else {
        return false;
    }
}

} // namespace spangle::gl
