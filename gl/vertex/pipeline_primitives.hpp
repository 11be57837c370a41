// Draws points, lines and polygons: rejects primitives that are not visible, then clips, culls and colours
// them.
#pragma once

#include "gl/vertex/pipeline.hpp"

namespace spangle::gl {

template <class M, class L> inline void Pipeline<M, L>::point(Vertex& v) {
    if constexpr (!has_points)
        return;
    if ((v.flags & outside_mask) != 0 || (planes_.any() && outside(v) != 0) || refuse_clipping(v.flags) ||
        !project(v))
        return;
    color(v);
    draw_point(v, v.window);
}

template <class M, class L> inline void Pipeline<M, L>::draw_point(const Vertex& v, const Window& window) {
    if (modes_.is_capturing()) {
        begin_capture(GL_POINT_TOKEN, 1);
        return capture_vertex({v, window});
    }
    if (modes_.has_special_points())
        return draw_special_point(v, window);
    raster::draw_point(*state_, context_->drawable.surface, window, modes_.point_size());
}

template <class M, class L>
inline void Pipeline<M, L>::draw_line(const Vertex& a, const Window& at_a, const Vertex& b,
                                      const Window& at_b, const Window& provoking) {
    if (modes_.is_capturing())
        return capture_line({a, at_a}, {b, at_b}, provoking);
    if (modes_.has_special_lines())
        return draw_special_line(at_a, at_b, provoking);
    raster::draw_line(*state_, context_->drawable.surface, at_a, at_b, provoking, modes_.line_width());
}

/// Draws a line that is stippled or antialiased, or whose drawable has samples. The stipple starts anew with
/// each primitive, and with each line of LINES (GL 1.3, 3.4.2).
template <class M, class L>
void Pipeline<M, L>::draw_special_line(const Window& a, const Window& b, const Window& provoking) {
    if (restarts_stipple_)
        stipple_.position = 0;
    restarts_stipple_ = modes_.mode() == GL_LINES;
    const PolygonState& polygon = context_->polygon;
    const raster::LineStipple start = stipple_;
    each_primitive_target(*context_, [&](const raster::Surface& target, raster::Position shift) {
        const Window from = shifted(a, shift), to = shifted(b, shift);
        [[maybe_unused]] raster::LineStipple* const stipple = polygon.line_stipple ? &stipple_ : nullptr;
        stipple_ = start;
        if constexpr (raster::has_samples)
            if (modes_.is_multisampling())
                return raster::draw_line_rectangle(*state_, target, from, to, provoking,
                                                   eighths(polygon.line_width), stipple);
#if SPANGLE_FEATURE_ANTIALIASING
        if (polygon.line_smooth)
            return raster::draw_smooth_line(*state_, target, context_->fragments.primitive, from, to,
                                            provoking, eighths(polygon.line_width), stipple);
#endif
#if SPANGLE_FEATURE_STIPPLE
        if (polygon.line_stipple)
            return raster::draw_stippled_line(*state_, target, from, to, provoking, modes_.line_width(),
                                              stipple_);
#endif
        raster::draw_line(*state_, target, from, to, provoking, modes_.line_width());
    });
}

template <class M, class L> inline void Pipeline<M, L>::line(Vertex& a, Vertex& b) {
    if constexpr (!has_lines)
        return;
    if (modes_.is_capturing())
        return capture_clipped_line(a, b);
    if constexpr (!raster::has_shortcuts)
        return draw_visible_line(a, b);
    Vertex* const ends[2] = {&a, &b};
    lines(ends, 2, 1, false);
}

/// Draws lines between vertices i and i + 1, for i = 0, step, 2 step and so on. `one_color` says that all
/// vertices have the same colour.
template <class M, class L>
void Pipeline<M, L>::lines(Vertex* const* vertex, int n, int step, bool one_color) {
    unsigned any = 0;
    const Window* window[line_batch + 1];
    for (int i = 0; i < n; ++i) {
        any |= vertex[i]->flags;
        window[i] = &vertex[i]->window;
    }
    const bool one_by_one = planes_.any() || modes_.has_special_lines();
    if ((any & (outside_mask | beyond_mask | unprojected)) != 0 || one_by_one) [[unlikely]] {
        for (int i = 0; i + 1 < n; i += step)
            draw_visible_line(*vertex[i], *vertex[i + 1]);
        return;
    }
    if ((any & uncolored) != 0)
        for (int i = modes_.is_flat_shaded() ? 1 : 0; i < n; i += modes_.is_flat_shaded() ? step : 1)
            color(*vertex[i]);
    const Window* const painted = one_color ? window[0] : nullptr;
    if constexpr (line_batch > 2)
        return raster::draw_lines(*state_, context_->drawable.surface, window, n, step, painted,
                                  modes_.line_width());
    for (int i = 0; i + 1 < n; i += step)
        raster::draw_line(*state_, context_->drawable.surface, *window[i], *window[i + 1], *window[i + 1],
                          modes_.line_width());
}

/// Draws a line that may lie outside of the view volume.
template <class M, class L> void Pipeline<M, L>::draw_visible_line(Vertex& a, Vertex& b) {
    if ((a.flags & b.flags & outside_mask) != 0)
        return;
    if (!modes_.is_flat_shaded())
        color(a);
    color(b);
    clip_and_draw_line(a, b);
}

/// Clips and draws a line. Its ends may have no window coordinates yet.
template <class M, class L> void Pipeline<M, L>::clip_and_draw_line(Vertex& a, Vertex& b) {
    Vertex* ends[2] = {&a, &b};
    if (refuse_clipping(a.flags | b.flags))
        return;
#if SPANGLE_CLIPPING
    if ((clip_planes(a.flags | b.flags) != 0 || planes_.any()) && !clip_line(ends))
        return;
#endif
    if (((ends[0]->flags | ends[1]->flags) & unprojected) != 0 && (!project(*ends[0]) || !project(*ends[1])))
        return;
    draw_line(*ends[0], ends[0]->window, *ends[1], ends[1]->window, b.window);
}

template <class M, class L>
inline std::int64_t Pipeline<M, L>::area_of(const Window& a, const Window& b, const Window& c) {
    const raster::Position at_a = raster::position(a), at_b = raster::position(b), at_c = raster::position(c);
    return raster::signed_area(at_a.x, at_a.y, at_b.x, at_b.y, at_c.x, at_c.y);
}

/// Returns twice the signed area of a polygon whose corners have window coordinates.
template <class M, class L> inline std::int64_t Pipeline<M, L>::area_of(Vertex* const* corners, int n) {
    std::int64_t area = 0;
    for (int i = 1; i + 1 < n; ++i)
        area += area_of(corners[0]->window, corners[i]->window, corners[i + 1]->window);
    return area;
}

/// True if a callback draws bands, and all corners of a filled triangle or quad are below or above the
/// current band. The colours of such corners need not be computed.
template <class M, class L>
template <class... V>
inline bool Pipeline<M, L>::is_outside_rows([[maybe_unused]] const V&... corner) const {
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

/// Draws a triangle whose last corner is the provoking vertex. polygon() draws triangles that need clipping
/// or two-sided lighting.
template <class M, class L> void Pipeline<M, L>::draw_triangle(Vertex& a, Vertex& b, Vertex& c) {
    draw_common_triangle(a, b, c, modes_.needs_polygon_path());
}

template <class M, class L>
SPANGLE_INLINE void Pipeline<M, L>::draw_common_triangle(Vertex& a, Vertex& b, Vertex& c, bool whole) {
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

/// Draws a quad as two triangles. The area of the whole quad decides which way both triangles face.
template <class M, class L>
void Pipeline<M, L>::draw_quad(Vertex& a, Vertex& b, Vertex& c, Vertex& d, Vertex& provoking) {
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

/// Clips and draws a polygon of n corners, in any mode.
template <class M, class L> void Pipeline<M, L>::polygon(Vertex* const* corners, int n, Vertex& provoking) {
    unsigned all = outside_mask, any = 0;
    for (int i = 0; i < n; ++i) {
        all &= corners[i]->flags;
        any |= corners[i]->flags;
    }
    if (all != 0 || refuse_clipping(any))
        return;
    if (modes_.has_outlines())
        flag_edges(corners, n);
    unsigned planes = clip_planes(any);
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
            clipped[i] = &to_clip_vertex(*corners[i], clipped_vertex_[i]);
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

/// Culls, colours and draws a clipped polygon.
template <class M, class L>
inline void Pipeline<M, L>::draw_visible(Vertex* const* corners, int n, Vertex& provoking, std::int64_t* part,
                                         std::int64_t whole) {
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
SPANGLE_INLINE void Pipeline<M, L>::draw(const VisibleFace& at, int n, const Window& provoking, int side,
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
void Pipeline<M, L>::fill_whole_polygon(const VisibleFace& at, int n, const Window& provoking,
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
void Pipeline<M, L>::fill_polygon(const Window* const* corner, int n, const Window& provoking,
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
void Pipeline<M, L>::set_offset(const VisibleFace& at, int n, GLenum mode, const std::int64_t* part) {
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
void Pipeline<M, L>::outline(const VisibleFace& at, int n, const Window& provoking, GLenum mode) {
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
void Pipeline<M, L>::draw_back(Vertex* const* corners, int n, const Vertex& provoking,
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

} // namespace spangle::gl
