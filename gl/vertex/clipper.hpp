// Clips lines and polygons to the view volume, the guard band and the user's planes (GL 1.3, 2.11).
//
// Clipper owns the vertices that clipping makes. It takes corners as the program gave them, and returns
// corners whose window coordinates are known after project(). It promises that two primitives that share an
// edge get the same integers where a plane cuts it, and that clipping a primitive needs bounded time and no
// memory of the arena. A build without clipping refuses primitives that would need it, as an error of GL.
#pragma once

#include "gl/context/error.hpp"
#include "gl/context/reach.hpp"
#include "gl/vertex/clipped_vertex_pool.hpp"
#include "gl/vertex/shading.hpp"

namespace spangle::gl {

template <class M, class L> class Clipper : public Shading<M, L> {
    using Base = Shading<M, L>;

  public:
    using Window = typename M::Window;
    using Vertex = gl::Vertex<M>;
    using ClippedVertex = gl::ClippedVertex<M, L>;

    /// Planes that a primitive must be clipped by; bit p stands for plane p. `flags` is the union of the
    /// flags of all corners.
    unsigned clip_planes(unsigned flags) const {
        return modes_.clips_to_view_volume() ? flags & outside_mask : (flags & beyond_mask) >> beyond_shift;
    }
    static bool needs_clipping(unsigned flags);
    bool refuse_clipping(unsigned flags);
    [[gnu::noinline]] ClippedVertex& to_clip_vertex(Vertex& v, ClippedVertex& out);
#if SPANGLE_CLIPPING
    bool clip_line(Vertex* (&ends)[2]);
    int clip_polygon(Vertex** corners, Vertex** work, int room, int n, unsigned planes);
#endif
    [[gnu::noinline]] bool project(Vertex& v);

  protected:
    using Base::color;
    using Base::context_;
    using Base::flags_of;
    using Base::lighting_;
    using Base::modes_;
    using Base::outside;
    using Base::planes_;
    using Base::slot_count;
    using Base::transforms_;
    using Base::vertex_slot_;
#if SPANGLE_FEATURE_FEEDBACK
    using Base::texture_coords_;
#endif
#if SPANGLE_TWO_SIDES
    using Base::back_colors_;
#endif

    /// Number of corners that a quad may have while it is clipped. Each plane of the view volume and of the
    /// user adds at most one corner, and clip_polygon() wants room for two more at every edge. A
    /// ClippedVertex that one plane cut off is used again for the next plane.
    static constexpr int clip_vertices = slot_count + 6 +
                                         (SPANGLE_FEATURE_CLIP_PLANES ? max_clip_planes : 0) + 2 + clip_spare,
                         clipped_vertex_count = clip_vertices + clip_spare;
    static_assert(has_clipping || !(SPANGLE_FEATURE_CLIP_PLANES || SPANGLE_FEATURE_POLYGON_MODE ||
                                    SPANGLE_FEATURE_SELECTION || SPANGLE_GATHERS_POLYGONS),
                  "user's planes, outlines, selection, feedback and antialiasing need SPANGLE_CLIPPING");
    static_assert(raster::has_perspective || !has_clipping, "what SPANGLE_CLIPPING cuts has a w of its own");

    bool needs_eye() const;
    [[gnu::noinline]] void mix(const ClippedVertex& a, const ClippedVertex& b, const typename M::Parameter& t,
                               ClippedVertex& out);
    int clip_volume_scale() const;
    bool is_inside_plane(int plane, const ClippedVertex& v) const;
    void clip_edge(int plane, const ClippedVertex& inside, const ClippedVertex& outside, ClippedVertex& out);
#if SPANGLE_FEATURE_CLIP_PLANES
    void clip_by_user_plane(const typename M::Plane& plane, const ClippedVertex& inside,
                            const ClippedVertex& outside, ClippedVertex& out);
#endif
    void record_clip_reach(unsigned flags) const;

#if SPANGLE_CLIPPING
    ClippedVertexPool<ClippedVertex, clipped_vertex_count> pool_;
#endif
};

/// True if a corner may be beyond a plane, or has no window coordinates yet. `flags` is the union of the
/// flags of all corners.
template <class M, class L> inline bool Clipper<M, L>::needs_clipping(unsigned flags) {
    return has_clipping && (flags & (beyond_mask | unprojected)) != 0;
}

/// Sets GL_INVALID_OPERATION and returns true if a primitive needs clipping that this build does not do.
/// `flags` is the union of the flags of all corners.
template <class M, class L> inline bool Clipper<M, L>::refuse_clipping(unsigned flags) {
    if (tells_reach && has_clipping)
        record_clip_reach(flags);
    if (has_clipping || (flags & (beyond_mask | unprojected)) == 0)
        return false;
    drawing_error(*context_, GL_INVALID_OPERATION,
                  raster::has_perspective
                      ? SPANGLE_TEXT("this build cuts nothing (SPANGLE_CLIPPING)")
                      : SPANGLE_TEXT("this build cuts nothing (SPANGLE_CLIPPING) and divides "
                                     "neither by w nor by q (SPANGLE_PERSPECTIVE)"));
    return true;
}

/// Makes a ClippedVertex of a vertex: lights the vertex and computes all values that clipping mixes.
template <class M, class L>
typename Clipper<M, L>::ClippedVertex& Clipper<M, L>::to_clip_vertex(Vertex& v, ClippedVertex& out) {
    color(v);
    static_cast<Vertex&>(out) = v;
    out.clip = M::clip_point(transforms_, v.position);
    out.flags |= is_clipped_vertex;
#if SPANGLE_FEATURE_FOG
    if (modes_.has_fog())
        out.eye_z =
            modes_.has_fog_coordinates() ? M::fog_coordinate(v.window) : M::depth(transforms_, v.position);
#endif
#if SPANGLE_TWO_SIDES || SPANGLE_FEATURE_CLIP_PLANES || SPANGLE_FEATURE_POINT_PARAMETERS
    if (needs_eye())
        out.eye = M::eye_point(transforms_, v.position);
#endif
#if SPANGLE_FEATURE_FEEDBACK
    if (modes_.is_capturing())
        out.texture = texture_coords_[&v - vertex_slot_];
#endif
#if SPANGLE_TWO_SIDES
    out.light = L::input(v.normal);
    if ((v.flags & back_known) != 0)
        out.back = back_colors_[&v - vertex_slot_];
#endif
    return out;
}

#if SPANGLE_CLIPPING

/// Clips a line to all planes, and replaces its ends by ClippedVertex objects. False: nothing of the line is
/// left.
template <class M, class L> inline bool Clipper<M, L>::clip_line(Vertex* (&ends)[2]) {
    int made = 2;
    ClippedVertex* end[2] = {&to_clip_vertex(*ends[0], pool_[0]), &to_clip_vertex(*ends[1], pool_[1])};
    for (int plane = 0; plane < user_shift + planes_.count(); ++plane) {
        const bool first_in = is_inside_plane(plane, *end[0]), second_in = is_inside_plane(plane, *end[1]);
        if (!first_in && !second_in)
            return false;
        if (first_in && second_in)
            continue;
        ClippedVertex& fresh = pool_[made++];
        const int outer = first_in ? 1 : 0;
        clip_edge(plane, *end[1 - outer], *end[outer], fresh);
        end[outer] = &fresh;
    }
    ends[0] = end[0];
    ends[1] = end[1];
    return true;
}

/// Clips a polygon plane by plane (Sutherland and Hodgman). The clipped corners replace the n corners; both
/// arrays have room for `room` corners. Returns the number of corners left, or 0 if nothing is left.
template <class M, class L>
inline int Clipper<M, L>::clip_polygon(Vertex** corners, Vertex** work, int room, int n, unsigned planes) {
    for (int plane = 0; plane < user_shift + planes_.count(); ++plane) {
        if ((planes >> plane & 1) == 0)
            continue;
        int m = 0;
        pool_.keep(corners, n);
        for (int i = 0; i < n; ++i) {
            // A convex polygon meets a plane twice. A quad that crosses itself may meet it more often, and so
            // may a quad that rounding bent at the limits of the mantissas. Such a quad may be left out (GL
            // 1.3, 2.6.1).
            if (m + 2 > room)
                return 0;
            ClippedVertex& here = static_cast<ClippedVertex&>(*corners[i]);
            ClippedVertex& next = static_cast<ClippedVertex&>(*corners[i + 1 == n ? 0 : i + 1]);
            const bool here_in = is_inside_plane(plane, here), next_in = is_inside_plane(plane, next);
            if (here_in)
                work[m++] = &here;
            if (here_in == next_in)
                continue;
            ClippedVertex* const fresh = pool_.take();
            if (fresh == nullptr)
                return 0;
            clip_edge(plane, here_in ? here : next, here_in ? next : here, *fresh);
            // Where an edge leaves the volume, the new vertex starts an edge along the plane, which is a
            // boundary. Where an edge enters, the rest of that edge is a boundary if the edge was one (GL
            // 1.3, 2.11).
            fresh->flags |= here_in ? unsigned{boundary} : here.flags & boundary;
            work[m++] = fresh;
        }
        n = m;
        for (int i = 0; i < n; ++i)
            corners[i] = work[i];
        if (n < 3)
            return 0;
    }
    return n;
}

#endif

/// Sets the window coordinates of a vertex that has none yet. False: the vertex is not in front of the eye
/// and is not drawn.
template <class M, class L> bool Clipper<M, L>::project(Vertex& v) {
    // Builds without clipping refuse vertices without window coordinates.
    if (!has_clipping || (v.flags & unprojected) == 0)
        return true;
    // The window position must be the same whether a polygon of the vertex is clipped or not.
    const typename M::Clip clip =
        M::narrow((v.flags & is_clipped_vertex) != 0 ? static_cast<const ClippedVertex&>(v).clip
                                                     : M::clip_point(transforms_, v.position));
    if (!M::in_front(clip))
        return false;
    M::project(transforms_, clip, v.window);
    v.flags &= ~unprojected;
    return true;
}

template <class M, class L> inline bool Clipper<M, L>::needs_eye() const {
    return planes_.any() || (SPANGLE_TWO_SIDES && modes_.is_lit() && lighting_.needs_eye()) ||
           modes_.has_special_points();
}

/// Sets everything but the clip coordinates of a new vertex, at parameter t on the edge from a to b.
template <class M, class L>
void Clipper<M, L>::mix(const ClippedVertex& a, const ClippedVertex& b, const typename M::Parameter& t,
                        ClippedVertex& out) {
    [[maybe_unused]] const auto mix_part = [&](auto ClippedVertex::*part) SPANGLE_RUN_LAMBDA {
        out.*part = M::mix(a.*part, b.*part, t);
    };
    M::mix(a.window, b.window, t, modes_.units(), out.window);
#if SPANGLE_FEATURE_FOG
    if (modes_.has_fog()) {
        out.eye_z = M::mix(a.eye_z, b.eye_z, t);
        if (modes_.has_fog_coordinates())
            M::set_fog_coordinate(out.eye_z, out.window);
        else
            M::set_fog(out.eye_z, out.window);
    }
#endif
#if SPANGLE_TWO_SIDES || SPANGLE_FEATURE_CLIP_PLANES || SPANGLE_FEATURE_POINT_PARAMETERS
    if (needs_eye())
        mix_part(&ClippedVertex::eye);
#endif
#if SPANGLE_FEATURE_FEEDBACK
    if (modes_.is_capturing())
        mix_part(&ClippedVertex::texture);
#endif
    out.flags = flags_of(out.clip) | is_clipped_vertex;
#if SPANGLE_TWO_SIDES
    L::mix(a.light, b.light, t, out.light);
    if ((a.flags & b.flags & back_known) != 0) {
        M::mix_color(a.back, b.back, t, out.back);
        out.flags |= back_known;
    }
#endif
}

template <class M, class L> inline int Clipper<M, L>::clip_volume_scale() const {
    return modes_.clips_to_view_volume() ? 1 : M::guard_band;
}

/// True if the vertex is inside of a plane. Planes 0 to 5 are those of the view volume, or of the guard band;
/// the user's planes begin at user_shift. The user's planes cut last, so that a plane and its complement cut
/// the same polygon.
template <class M, class L>
inline bool Clipper<M, L>::is_inside_plane(int plane, const ClippedVertex& v) const {
#if SPANGLE_FEATURE_CLIP_PLANES
    if (plane >= user_shift) {
        const typename M::Plane& user = planes_[plane - user_shift];
        return !M::outside(user, M::distance(user, v.eye));
    }
#endif
    return !M::beyond(v.clip, plane, clip_volume_scale());
}

/// Makes the new vertex where an edge meets a plane. Two polygons that share the edge get the same integers.
template <class M, class L>
inline void Clipper<M, L>::clip_edge(int plane, const ClippedVertex& inside, const ClippedVertex& outside,
                                     ClippedVertex& out) {
#if SPANGLE_FEATURE_CLIP_PLANES
    if (plane >= user_shift)
        return clip_by_user_plane(planes_[plane - user_shift], inside, outside, out);
#endif
    const auto t = M::intersect(M::distance(inside.clip, plane, clip_volume_scale()),
                                M::distance(outside.clip, plane, clip_volume_scale()));
    out.clip = M::clip_edge(inside.clip, outside.clip, plane, clip_volume_scale(), t);
    mix(inside, outside, t, out);
    // Rounding must not leave the new vertex outside of the plane that it lies on.
    out.flags &= ~(1u << plane | 1u << (static_cast<unsigned>(plane) + beyond_shift));
}

#if SPANGLE_FEATURE_CLIP_PLANES

/// Makes the new vertex where an edge meets a plane of the user. The parameter runs from the end with the
/// positive distance, whichever end is kept. A plane and its complement therefore get the same integers.
template <class M, class L>
inline void Clipper<M, L>::clip_by_user_plane(const typename M::Plane& plane, const ClippedVertex& inside,
                                              const ClippedVertex& outside, ClippedVertex& out) {
    const ClippedVertex &a = M::turned(plane) ? outside : inside, &b = M::turned(plane) ? inside : outside;
    const auto t = M::intersect(M::distance(plane, a.eye), M::distance(plane, b.eye));
    out.clip = M::mix(a.clip, b.clip, t);
    mix(a, b, t, out);
}

#endif

/// Reports a primitive that needs clipping, which a build without SPANGLE_CLIPPING refuses. `flags` is the
/// union of the flags of all corners.
template <class M, class L> inline void Clipper<M, L>::record_clip_reach(unsigned flags) const {
    if ((flags & (beyond_mask | unprojected)) != 0 || clip_planes(flags) != 0)
        reach(*context_, Range::CUTS, 1);
}

} // namespace spangle::gl
