// Draws polygons in any mode (GL 1.3, 3.5).
//
// PolygonSink owns the corners of POLYGONs that are drawn as a whole. It takes corners that VertexStage has
// processed, in the order of the polygon. It promises to clip, cull, colour and draw them, to divide a
// clipped quad by the same diagonal as a whole one, and to draw outlines, both sides, depth offsets and
// antialiased polygons.
#pragma once

#include "gl/vertex/gathered_polygon.hpp"
#include "gl/vertex/line_sink.hpp"
#include "raster/primitive/polygon_offset.hpp"

namespace spangle::gl {

template <class M, class L> class PolygonSink : public LineSink<M, L> {
    using Base = LineSink<M, L>;

  public:
    using Window = typename M::Window;
    using Vertex = gl::Vertex<M>;
    using ClippedVertex = gl::ClippedVertex<M, L>;

    [[gnu::noinline]] void polygon(Vertex* const* corners, int n, Vertex& provoking);
    [[gnu::noinline]] void gather(Vertex& v);
    [[gnu::noinline]] void gathered();

  protected:
    using Base::begin_capture;
    using Base::capture_vertex;
    using Base::clip_planes;
    using Base::clip_vertices;
    using Base::color;
    using Base::color_back;
    using Base::context_;
    using Base::draw_line;
    using Base::draw_point;
    using Base::light_back;
    using Base::modes_;
    using Base::outside;
    using Base::planes_;
    using Base::project;
    using Base::refuse_clipping;
    using Base::restarts_stipple_;
    using Base::state_;
    using Base::to_clip_vertex;
#if SPANGLE_CLIPPING
    using Base::clip_polygon;
    using Base::pool_;
#endif

    /// Corners of a polygon with the window vertices of the side that is seen. `back` holds those of a back
    /// face; it is null for a front face.
    struct VisibleFace {
        Vertex* const* corners;
        const Window* back = nullptr;
        const Window& operator()(int i) const { return back != nullptr ? back[i] : corners[i]->window; }
    };

    /// Draws a polygon that clipping and culling left. `part` has room for n areas. `whole` has the sign of
    /// the polygon's area before clipping, or is 0.
    void draw_visible(Vertex* const* corners, int n, Vertex& provoking, std::int64_t* part,
                      std::int64_t whole);
    SPANGLE_INLINE void draw(const VisibleFace& at, int n, const Window& provoking, int side,
                             const std::int64_t* part);
    [[gnu::noinline]] void fill_whole_polygon(const VisibleFace& at, int n, const Window& provoking,
                                              const std::int64_t* part);
    [[gnu::noinline]] void fill_polygon(const Window* const* corner, int n, const Window& provoking,
                                        const std::int64_t* part);
    [[gnu::noinline]] void set_offset(const VisibleFace& at, int n, GLenum mode, const std::int64_t* part);
    [[gnu::noinline]] void outline(const VisibleFace& at, int n, const Window& provoking, GLenum mode);
    [[gnu::noinline]] void draw_back(Vertex* const* corners, int n, const Vertex& provoking,
                                     const std::int64_t* part);
    void clip_gathered(Vertex** work, int room, std::int64_t* part);
    bool has_gathered() const;
    void flag_edges(Vertex* const* corners, int n);
    int first_corner(int n) const;
    static std::int64_t area_of(const Window& a, const Window& b, const Window& c);
    static std::int64_t area_of(Vertex* const* corners, int n);

  private:
#if SPANGLE_GATHERS_POLYGONS
    GatheredPolygon<ClippedVertex> gathered_;
    /// Room for the corners that clipping leaves of the gathered polygon.
    const Window** gathered_windows_ = nullptr;
#endif
};

/// Clips and draws a polygon of n corners, in any mode.
template <class M, class L>
void PolygonSink<M, L>::polygon(Vertex* const* corners, int n, Vertex& provoking) {
    unsigned all = outside_mask, any = 0;
    for (int i = 0; i < n; ++i) {
        all &= corners[i]->flags;
        any |= corners[i]->flags;
    }
    if (all != 0 || refuse_clipping(any))
        return;
    if (modes_.has_outlines())
        flag_edges(corners, n);
    [[maybe_unused]] unsigned planes = clip_planes(any);
    if (planes_.any()) {
        unsigned all_user = ~0u, any_user = 0;
        for (int i = 0; i < n; ++i) {
            const unsigned user = outside(*corners[i]);
            all_user &= user;
            any_user |= user;
        }
        if (all_user != 0)
            return;
        planes |= any_user << user_shift;
    }
    // The two arrays are used one after the other. They share memory, since stacks are small.
    union {
        std::int64_t part[clip_vertices];
        Vertex* scratch[clip_vertices];
    };
    std::int64_t whole = 0;
#if SPANGLE_CLIPPING
    Vertex* clipped[clip_vertices];
    // A clipped quad is divided by the same diagonal as a whole one. Its colours therefore do not move while
    // it leaves the view volume.
    if (planes != 0 && n == 4 && !modes_.is_drawn_whole()) {
        Vertex* const first[3] = {corners[0], corners[1], corners[2]};
        Vertex* const second[3] = {corners[0], corners[2], corners[3]};
        polygon(first, 3, provoking);
        return polygon(second, 3, provoking);
    }
    if (planes != 0) {
        if ((any & back_known) != 0)
            for (int i = 0; i < n; ++i)
                color_back(*corners[i]);
        for (int i = 0; i < n; ++i)
            clipped[i] = &to_clip_vertex(*corners[i], pool_[i]);
        // Snapping may turn over a sliver. Its pixels are drawn by the rest of the polygon, or by the
        // polygon's part beyond the plane. draw_visible() drops the sliver, because the sign of its area
        // differs from that of the whole polygon.
        if (planes >> user_shift != 0 && (any & (beyond_mask | unprojected)) == 0)
            whole = area_of(corners, n);
        n = clip_polygon(clipped, scratch, clip_vertices, n, planes);
        if (n < 3)
            return;
        corners = clipped;
    }
#endif
    draw_visible(corners, n, provoking, part, whole);
}

/// Adds a vertex to the gathered polygon.
template <class M, class L> void PolygonSink<M, L>::gather([[maybe_unused]] Vertex& v) {
#if SPANGLE_GATHERS_POLYGONS
    ClippedVertex* const place = gathered_.add(*context_);
    if (place == nullptr)
        return;
    color_back(v);
    ClippedVertex& corner = to_clip_vertex(v, *place);
    if ((v.flags & edge_flag) != 0)
        corner.flags |= boundary;
#endif
}

template <class M, class L> void PolygonSink<M, L>::gathered() {
#if SPANGLE_GATHERS_POLYGONS
    const int n = gathered_.count(), room = n + clip_vertices;
    const auto places = static_cast<std::size_t>(room);
    void* const memory =
        n < 3 ? nullptr : context_->arena->allocate(places * (sizeof(std::int64_t) + 3 * sizeof(Vertex*)));
    if (gathered_.has_failed() || (n >= 3 && memory == nullptr)) {
        drawing_error(*context_, GL_OUT_OF_MEMORY,
                      SPANGLE_TEXT("no room in the arena for a polygon that is fed back or antialiased"));
    } else if (n >= 3) {
        auto* const part = static_cast<std::int64_t*>(memory);
        auto** const work = reinterpret_cast<Vertex**>(part + room);
        gathered_windows_ = static_cast<const Window**>(static_cast<void*>(work + 2 * room));
        clip_gathered(work, room, part);
    }
    context_->arena->free(memory);
    gathered_.free(*context_);
#endif
}

/// Culls, colours and draws a clipped polygon.
template <class M, class L>
inline void PolygonSink<M, L>::draw_visible(Vertex* const* corners, int n, Vertex& provoking,
                                            std::int64_t* part, std::int64_t whole) {
    std::int64_t area = 0; // `part[i]` is the area of triangle (0, i, i + 1)
    for (int i = 0; i < n; ++i)
        if ((corners[i]->flags & unprojected) != 0 && !project(*corners[i]))
            return;
    for (int i = 1; i + 1 < n; ++i) {
        part[i] = area_of(corners[0]->window, corners[i]->window, corners[i + 1]->window);
        if (whole != 0 && (part[i] ^ whole) < 0)
            part[i] = 0;
        area += part[i];
    }
    if (area == 0 && (n == 3 || whole != 0) && !modes_.is_capturing())
        return;
    const bool ccw = area > 0;
    if (modes_.culls(!ccw))
        return;
    if (SPANGLE_FEATURE_STENCIL_SIDES && modes_.has_two_sided_stencil())
        state_ = &draw_state_of(*context_, ccw == modes_.front_is_ccw() ? 0 : 1);
    if (SPANGLE_TWO_SIDES && ccw != modes_.front_is_ccw() && modes_.has_two_sides())
        return draw_back(corners, n, provoking, part);
    for (int i = 0; i < n && !modes_.is_flat_shaded(); ++i)
        color(*corners[i]);
    color(provoking);
    draw({corners}, n, provoking.window, ccw == modes_.front_is_ccw() ? 0 : 1, part);
}

/// Draws a polygon in the polygon mode of its side. at(i) is the coloured window vertex of corner i.
template <class M, class L>
SPANGLE_INLINE void PolygonSink<M, L>::draw(const VisibleFace& at, int n, const Window& provoking, int side,
                                            const std::int64_t* part) {
    if (modes_.has_polygon_offset() && !modes_.is_capturing())
        set_offset(at, n, modes_.face_mode(side), part);
    if (modes_.has_outlines() && modes_.face_mode(side) != GL_FILL)
        return outline(at, n, provoking, modes_.face_mode(side));
    if (modes_.is_capturing()) {
        begin_capture(GL_POLYGON_TOKEN, n);
        for (int i = first_corner(n), left = n; left > 0; i = i + 1 < n ? i + 1 : 0, --left)
            capture_vertex({*at.corners[i], modes_.is_flat_shaded() ? provoking : at(i)});
        return;
    }
    if (modes_.fills_whole_polygons())
        return fill_whole_polygon(at, n, provoking, part);
    for (int i = 1; i + 1 < n; ++i)
        if (part[i] != 0)
            raster::draw_triangle(*state_, context_->drawable.surface, at(0), at(i), at(i + 1), provoking,
                                  part[i]);
}

/// Fills a polygon that is antialiased, or whose drawable has samples.
template <class M, class L>
void PolygonSink<M, L>::fill_whole_polygon(const VisibleFace& at, int n, const Window& provoking,
                                           const std::int64_t* part) {
    const Window* some[clip_vertices];
    const Window** corner = some;
#if SPANGLE_GATHERS_POLYGONS
    if (has_gathered())
        corner = gathered_windows_;
#endif
    for (int i = 0; i < n; ++i)
        corner[i] = &at(i);
    fill_polygon(corner, n, provoking, part);
}

/// Fills the polygon with the given corners. An antialiased polygon is drawn as a whole, because two
/// triangles of a fan would both cover parts of the pixels on their common edge.
template <class M, class L>
void PolygonSink<M, L>::fill_polygon(const Window* const* corner, int n, const Window& provoking,
                                     const std::int64_t* part) {
    Window moved[clip_vertices];
    each_primitive_target(*context_, [&](const raster::Surface& target, raster::Position shift) {
#if SPANGLE_FEATURE_ANTIALIASING
        // Nothing is shifted, since POLYGON_SMOOTH has no effect under multisampling.
        if (modes_.has_smooth_polygons())
            return raster::draw_smooth_polygon(*state_, target, context_->fragments.primitive, corner, n,
                                               provoking);
#endif
        for (int i = 0; i < n; ++i)
            moved[i] = shifted(*corner[i], shift);
        for (int i = 1; i + 1 < n; ++i)
            if (part[i] != 0)
                raster::draw_triangle(*state_, target, moved[0], moved[i], moved[i + 1], provoking, part[i]);
    });
}

/// Sets the depth offset of all fragments of a polygon. If its triangles lie in different planes, the largest
/// triangle decides.
template <class M, class L>
void PolygonSink<M, L>::set_offset(const VisibleFace& at, int n, GLenum mode, const std::int64_t* part) {
    const PolygonState& polygon = context_->polygon;
    raster::PrimitiveState& out = context_->fragments.primitive;
    const bool on = mode == GL_FILL   ? polygon.offset_fill
                    : mode == GL_LINE ? polygon.offset_line
                                      : polygon.offset_point;
    raster::PolygonOffset offset;
    if (on)
        offset = {polygon.offset_factor, polygon.offset_units};
    int largest = 1;
    for (int i = 2; i + 1 < n; ++i)
        if (numeric::abs_u64(part[i]) > numeric::abs_u64(part[largest]))
            largest = i;
    raster::set_depth_offset(out, offset, state_->depth_format, at(0), at(largest), at(largest + 1),
                             part[largest]);
}

/// Draws the boundary edges as lines, or the vertices that start them as points (GL 1.3, 3.5.4).
template <class M, class L>
void PolygonSink<M, L>::outline(const VisibleFace& at, int n, const Window& provoking, GLenum mode) {
    Vertex* const* const corners = at.corners;
    // A POLYGON is drawn in several parts, and its stipple continues from part to part.
    restarts_stipple_ = restarts_stipple_ || modes_.mode() != GL_POLYGON;
    context_->fragments.primitive.stippled = false;
    for (int i = first_corner(n), next = 0, left = n; left > 0; i = next, --left) {
        next = i + 1 < n ? i + 1 : 0;
        if ((corners[i]->flags & boundary) == 0)
            continue;
        if (mode == GL_LINE) {
            draw_line(*corners[i], at(i), *corners[next], at(next), provoking);
            continue;
        }
        Window v = at(i);
        if (modes_.is_flat_shaded())
            M::copy_color(provoking, v);
        draw_point(*corners[i], v);
    }
    context_->fragments.primitive.stippled = true;
}

/// Draws a polygon whose back is visible, lit with the back material and reversed normals (GL 1.3, 2.13.1). A
/// vertex that clipping made is lit from its mixed normal and position. If the material changed within the
/// primitive, the back colours are mixed instead.
template <class M, class L>
void PolygonSink<M, L>::draw_back(Vertex* const* corners, int n, const Vertex& provoking,
                                  const std::int64_t* part) {
    Window flat = provoking.window;
    light_back(provoking, flat);
    if (has_gathered()) { // nobody else uses gathered corners, so they can be overwritten
        for (int i = 0; i < n; ++i)
            light_back(*corners[i], corners[i]->window);
        return draw({corners}, n, flat, 1, part);
    }
    Window back[clip_vertices];
    for (int i = 0; i < n; ++i) {
        back[i] = corners[i]->window;
        light_back(*corners[i], back[i]);
    }
    draw({corners, back}, n, flat, 1, part);
}

/// Clips the gathered polygon and draws what is left. `work` has room for 2 * `room` corners, and `part` for
/// `room` areas.
template <class M, class L>
inline void PolygonSink<M, L>::clip_gathered([[maybe_unused]] Vertex** work, [[maybe_unused]] int room,
                                             [[maybe_unused]] std::int64_t* part) {
#if SPANGLE_GATHERS_POLYGONS
    const int n = gathered_.count();
    unsigned all = outside_mask, any = 0, all_user = ~0u, any_user = 0;
    for (int i = 0; i < n; ++i) {
        const Vertex& v = *(work[i] = &gathered_[i]);
        const unsigned user = planes_.any() ? outside(v) : 0;
        all &= v.flags;
        any |= v.flags;
        all_user &= user;
        any_user |= user;
    }
    if (all != 0 || all_user != 0)
        return;
    const unsigned planes = clip_planes(any) | any_user << user_shift;
    const int left = planes != 0 ? clip_polygon(work, work + room, room, n, planes) : n;
    if (left >= 3)
        draw_visible(work, left, gathered_[0], part, 0);
#endif
}

/// True if the current polygon was gathered.
template <class M, class L> inline bool PolygonSink<M, L>::has_gathered() const {
#if SPANGLE_GATHERS_POLYGONS
    return gathered_.count() != 0;
#else
    return false;
#endif
}

/// Marks the edges that outlines of a triangle or quad draw. Edge flags apply to separate triangles and quads
/// only; strips and fans draw all edges (GL 1.3, 2.6.2).
template <class M, class L> inline void PolygonSink<M, L>::flag_edges(Vertex* const* corners, int n) {
    if (modes_.mode() == GL_POLYGON)
        return;
    const bool by_flag = modes_.mode() == GL_TRIANGLES || modes_.mode() == GL_QUADS;
    for (int i = 0; i < n; ++i) {
        std::uint32_t& flags = corners[i]->flags;
        flags = !by_flag || (flags & edge_flag) != 0 ? flags | boundary : flags & ~boundary;
    }
}

/// Index, of n corners, at which outlines and feedback begin: that of the vertex given first. A quad is
/// stored from its second vertex on, so that its first vertex comes last. GL leaves open where a clipped quad
/// begins.
template <class M, class L> inline int PolygonSink<M, L>::first_corner(int n) const {
    return modes_.mode() == GL_QUADS ? n - 1 : 0;
}

template <class M, class L>
inline std::int64_t PolygonSink<M, L>::area_of(const Window& a, const Window& b, const Window& c) {
    const raster::Position at_a = raster::position(a), at_b = raster::position(b), at_c = raster::position(c);
    return raster::signed_area(at_a.x, at_a.y, at_b.x, at_b.y, at_c.x, at_c.y);
}

/// Returns twice the signed area of a polygon whose corners have window coordinates.
template <class M, class L> inline std::int64_t PolygonSink<M, L>::area_of(Vertex* const* corners, int n) {
    std::int64_t area = 0;
    for (int i = 1; i + 1 < n; ++i)
        area += area_of(corners[0]->window, corners[i]->window, corners[i + 1]->window);
    return area;
}

} // namespace spangle::gl
