// From a vertex as given to primitives in window space: transform, assemble, clip, cull, light, draw. One
// template for every numeric policy; M supplies the arithmetic and L the lighting.
//
// Order (GL 1.3, figure 2.8) as far as it can be seen. Colours are computed late, for vertices of primitives
// that survive culling: a vertex's colour depends on nothing that happens in between.
#pragma once

#include "gl/context/context.hpp"
#include "gl/pixel/fragment_setup.hpp"
#include "gl/vertex/current_element.hpp"
#include "raster/primitive/draw.hpp"

namespace spangle::gl {

template <class M, class L> class Pipeline {
  public:
    using Window = typename M::Window;

    void begin(Context& context, GLenum mode) {
        context_ = &context;
        mode_ = mode;
        full_ = corners_of(mode);
        held_ = 0;
        odd_ = false;
        for (int i = 0; i < slot_count; ++i)
            corner_[i] = &slot_[i];
        derive(context);
        state_ = &draw_state(context);
    }

    void vertex(Context& context, Real x, Real y, Real z, Real w) {
        Vertex& v = *corner_[held_];
        v.position[0] = x;
        v.position[1] = y;
        v.position[2] = z;
        v.position[3] = w;
        give(context, v);
    }

    /// Elements of the arrays that are on, as ArrayElement gives them one by one.
    void elements(Context& context, std::uint32_t count, const Indices& indices) {
        const ElementReader reader(context.arrays);
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t index = indices.at(i);
            set_attributes(context, reader, index);
            if (!reader.vertex.on())
                continue;
            Vertex& v = *corner_[held_];
            v.position[2] = numeric::zero; // what the array leaves out
            v.position[3] = numeric::one;
            reader.vertex.read(index, v.position);
            give(context, v);
        }
    }

    void end() {
        if (mode_ == GL_LINE_LOOP && held_ == 2)
            line(*corner_[1], *corner_[0]);
    }

    /// A material is about to change: vertices given so far get their colours from the old one.
    void settle_colors() {
        for (int i = 0; i < held_; ++i)
            color(*corner_[i]);
        lighting_.materials_changed();
    }

  private:
    /// Vertex::flags: bits 0..5 the view-volume planes it lies outside of, from bit 8 on the planes (guard
    /// band, near, far) it must be clipped by, then what is still to be done.
    static constexpr unsigned outside_mask = 0x3F, beyond_shift = 8, beyond_mask = 0x3F << beyond_shift,
                              unprojected = 1 << 14, ///< has `clip` and no window coordinates yet
        uncolored = 1 << 15;

    struct Vertex {
        std::uint32_t flags = 0;
        Window window{};
        typename M::Depth eye_z{}; ///< with its sign: clipping mixes it, fog takes its size
        typename L::Input light{}; ///< what lighting needs, kept until the colour is
        Real position[4]{};        ///< as given
        typename M::Clip clip{};   ///< only while has_clip
        bool has_clip = false;
    };
    static constexpr int slot_count = 4, clip_vertices = 16;

    Context* context_ = nullptr;
    const raster::DrawState* state_ = nullptr;
    GLenum mode_ = GL_POINTS;
    int held_ = 0, full_ = 1; ///< corners held, and how many make a primitive
    bool odd_ = false;        ///< number of triangles of the strip so far
    Vertex* corner_[4];       ///< of the primitive being assembled
    Vertex slot_[slot_count];
    Vertex clipped_[clip_vertices];
    typename M::Transforms transforms_;
    L lighting_;
    bool fog_ = false, lit_ = false, needs_eye_ = false, flat_ = false, textured_[texture_units] = {};
    bool front_is_ccw_ = true, culls_ccw_ = false, culls_cw_ = false;
    std::int32_t point_size_ = 1, line_width_ = 1;

    void derive(Context& context) {
        if ((context.dirty & dirty_vertex) != 0) {
            M::derive(context.transform, transforms_);
            lighting_.derive(context);
            context.dirty = static_cast<std::uint8_t>(context.dirty & ~dirty_vertex);
        }
        fog_ = context.fog.fog;
        lit_ = context.lighting.lighting;
        needs_eye_ = lighting_.needs_eye();
        for (int u = 0; u < texture_units; ++u)
            textured_[u] = context.texture.unit[u].texture_2d;
        const PolygonState& polygon = context.polygon;
        flat_ = polygon.shade_model == GL_FLAT;
        front_is_ccw_ = polygon.front_face == GL_CCW;
        culls_ccw_ = culls(polygon, front_is_ccw_);
        culls_cw_ = culls(polygon, !front_is_ccw_);
        point_size_ = whole(polygon.point_size);
        line_width_ = whole(polygon.line_width);
    }

    static bool culls(const PolygonState& p, bool front) {
        if (!p.cull_face)
            return false;
        return p.cull_face_mode == GL_FRONT_AND_BACK || (p.cull_face_mode == GL_FRONT) == front;
    }

    /// Aliased sizes are rounded, 0 counts as 1 (GL 1.3, 3.3, 3.4.2); the largest is 64.
    static std::int32_t whole(Real size) {
        return numeric::clamp<std::int32_t>(numeric::to_i32_round(size), 1, 64);
    }

    // --- one vertex

    /// A vertex whose position is set takes the current attributes.
    SPANGLE_INLINE void give(const Context& context, Vertex& v) {
        process(context, v);
        if (++held_ == full_)
            primitive();
    }

    SPANGLE_INLINE void process(const Context& context, Vertex& v) {
        unsigned planes;
        v.has_clip = false;
        if (M::to_window(transforms_, v.position, v.window, planes, fog_ ? &v.eye_z : nullptr)) [[likely]]
            v.flags = planes;
        else
            classify(v, M::to_clip(transforms_, v.position));
        if (fog_)
            M::set_fog(v.eye_z, v.window);
        const CurrentState& current = context.current;
        for (int u = 0; u < texture_units; ++u)
            if (textured_[u])
                M::set_texture(transforms_, current.tex_coord[u], u, v.window);
        if (!lit_)
            return M::set_color(v.window, current.color);
        v.flags |= uncolored;
        if (needs_eye_)
            lighting_.take(context, M::to_eye(transforms_, v.position), v.light);
        else
            lighting_.take(context, v.light);
        if (lighting_.tracks_color())
            color(v); // the material is the current colour: now or never
    }

    /// Flags of a vertex that is to be projected only if it is seen.
    static void classify(Vertex& v, const typename M::Clip& clip) {
        unsigned flags = unprojected;
        for (unsigned plane = 0; plane < 6; ++plane) {
            flags |= M::volume_distance(clip, static_cast<int>(plane)) < 0 ? 1u << plane : 0u;
            flags |= M::distance(clip, static_cast<int>(plane)) < 0 ? 1u << (plane + beyond_shift) : 0u;
        }
        v.clip = clip;
        v.has_clip = true;
        v.flags = flags;
    }

    void needs_clip(Vertex& v) const {
        if (v.has_clip)
            return;
        v.clip = M::to_clip(transforms_, v.position);
        v.has_clip = true;
    }

    void color(Vertex& v) {
        if ((v.flags & uncolored) == 0)
            return;
        lighting_.light(*context_, v.light, 0, v.window);
        v.flags &= ~uncolored;
    }

    /// False: not in front, never drawn.
    bool project(Vertex& v) {
        if ((v.flags & unprojected) == 0)
            return true;
        if (!M::in_front(v.clip))
            return false;
        M::project(transforms_, v.clip, v.window);
        v.flags &= ~unprojected;
        return true;
    }

    // --- assembly (GL 1.3, 2.6.1); provoking vertices by table 2.11

    static int corners_of(GLenum mode) {
        constexpr std::int8_t corners[] = {1, 2, 2, 2, 3, 3, 3, 4, 4, 3}; // POINTS .. POLYGON
        return corners[mode];
    }

    void swap(int i, int j) {
        Vertex* const v = corner_[i];
        corner_[i] = corner_[j];
        corner_[j] = v;
    }

    /// All corners are there: draws, and leaves those that the next primitive shares in front.
    void primitive() {
        Vertex* const* const c = corner_;
        switch (mode_) {
        case GL_POINTS:
            held_ = 0;
            return point(*c[0]);
        case GL_LINES:
            held_ = 0;
            return line(*c[0], *c[1]);
        case GL_LINE_STRIP:
            held_ = 1;
            swap(0, 1);
            return line(*c[1], *c[0]);
        case GL_LINE_LOOP: // the first vertex stays in front
            held_ = 2;
            if (full_ == 2) {
                full_ = 3;
                return line(*c[0], *c[1]);
            }
            swap(1, 2);
            return line(*c[2], *c[1]);
        case GL_TRIANGLES:
            held_ = 0;
            return triangle(*c[0], *c[1], *c[2], *c[2]);
        case GL_TRIANGLE_STRIP:
            held_ = 2;
            return strip();
        case GL_TRIANGLE_FAN:
            held_ = 2;
            swap(1, 2);
            return triangle(*c[0], *c[2], *c[1], *c[1]);
        case GL_POLYGON:
            held_ = 2;
            swap(1, 2);
            return triangle(*c[0], *c[2], *c[1], *c[0]);
        case GL_QUADS:
            held_ = 0;
            return quad(*c[0], *c[1], *c[2], *c[3], *c[3]);
        default: // QUAD_STRIP: v0 v1 v3 v2
            held_ = 2;
            swap(0, 2);
            swap(1, 3);
            return quad(*c[2], *c[3], *c[1], *c[0], *c[1]);
        }
    }

    /// Triangle i of a strip is i, i+1, i+2, with the first two exchanged when i is odd, so all face one way.
    void strip() {
        Vertex &oldest = *corner_[0], &middle = *corner_[1], &last = *corner_[2];
        corner_[0] = &middle;
        corner_[1] = &last;
        corner_[2] = &oldest;
        odd_ = !odd_;
        if (odd_)
            triangle(oldest, middle, last, last);
        else
            triangle(middle, oldest, last, last);
    }

    // --- primitives

    void point(Vertex& v) {
        if ((v.flags & outside_mask) != 0 || !project(v))
            return;
        color(v);
        raster::draw_point(*state_, context_->drawable.surface, v.window, point_size_);
    }

    void line(Vertex& a, Vertex& b) {
        if ((a.flags & b.flags & outside_mask) != 0)
            return;
        if (!flat_ || ((a.flags | b.flags) & beyond_mask) != 0)
            color(a);
        color(b);
        Vertex* ends[2] = {&a, &b};
        if (((a.flags | b.flags) & beyond_mask) != 0 && !clip_line(ends))
            return;
        if (!project(*ends[0]) || !project(*ends[1]))
            return;
        raster::draw_line(*state_, context_->drawable.surface, ends[0]->window, ends[1]->window, b.window,
                          line_width_);
    }

    static std::int64_t area_of(const Window& a, const Window& b, const Window& c) {
        const raster::Position at_a = raster::position(a), at_b = raster::position(b),
                               at_c = raster::position(c);
        return raster::signed_area(at_a.x, at_a.y, at_b.x, at_b.y, at_c.x, at_c.y);
    }

    /// The usual triangle; what must be clipped, or lit from behind, goes the way of polygons.
    void triangle(Vertex& a, Vertex& b, Vertex& c, Vertex& provoking) {
        const unsigned all = a.flags & b.flags & c.flags, any = a.flags | b.flags | c.flags;
        if ((all & outside_mask) != 0)
            return;
        if ((any & (beyond_mask | unprojected)) != 0 || lighting_.two_sided()) {
            Vertex* corners[3] = {&a, &b, &c};
            return polygon(corners, 3, provoking);
        }
        const std::int64_t area = area_of(a.window, b.window, c.window);
        if (area == 0 || (area > 0 ? culls_ccw_ : culls_cw_))
            return;
        if ((any & uncolored) != 0) {
            if (!flat_)
                color(a), color(b), color(c);
            color(provoking);
        }
        raster::draw_triangle(*state_, context_->drawable.surface, a.window, b.window, c.window,
                              provoking.window, area);
    }

    /// Two triangles with one facing: that of the whole quad.
    void quad(Vertex& a, Vertex& b, Vertex& c, Vertex& d, Vertex& provoking) {
        Vertex* corners[4] = {&a, &b, &c, &d};
        polygon(corners, 4, provoking);
    }

    void polygon(Vertex* const* corners, int n, Vertex& provoking) {
        unsigned all = outside_mask, any = 0;
        for (int i = 0; i < n; ++i) {
            all &= corners[i]->flags;
            any |= corners[i]->flags;
        }
        if (all != 0)
            return;
        if ((any & beyond_mask) == 0)
            return visible(corners, n, provoking);
        // Clipping interpolates colours, so they come first.
        Vertex* work[2][clip_vertices];
        for (int i = 0; i < n; ++i) {
            color(*corners[i]);
            needs_clip(*corners[i]);
            work[0][i] = corners[i];
        }
        const int left = clip_polygon(work, n, any >> beyond_shift);
        if (left >= 3)
            visible(work[0], left, provoking);
    }

    void visible(Vertex* const* corners, int n, Vertex& provoking) {
        std::int64_t area = 0, part[clip_vertices]; // of triangle 0, i, i + 1
        for (int i = 0; i < n; ++i)
            if (!project(*corners[i]))
                return;
        for (int i = 1; i + 1 < n; ++i) {
            part[i] = area_of(corners[0]->window, corners[i]->window, corners[i + 1]->window);
            area += part[i];
        }
        if (area == 0 && n == 3)
            return;
        const bool ccw = area > 0;
        if (ccw ? culls_ccw_ : culls_cw_)
            return;
        if (ccw != front_is_ccw_ && lighting_.two_sided())
            return draw_back(corners, n, provoking, part);
        for (int i = 0; i < n && !flat_; ++i)
            color(*corners[i]);
        color(provoking);
        for (int i = 1; i + 1 < n; ++i)
            if (part[i] != 0)
                raster::draw_triangle(*state_, context_->drawable.surface, corners[0]->window,
                                      corners[i]->window, corners[i + 1]->window, provoking.window, part[i]);
    }

    /// The same triangles lit from behind: back material, normals turned (GL 1.3, 2.13.1). A vertex that
    /// clipping made is lit from its mixed normal and position.
    void draw_back(Vertex* const* corners, int n, const Vertex& provoking, const std::int64_t* part) {
        Window back[clip_vertices];
        for (int i = 0; i < n; ++i) {
            back[i] = corners[i]->window;
            lighting_.light(*context_, corners[i]->light, 1, back[i]);
        }
        Window flat = provoking.window;
        lighting_.light(*context_, provoking.light, 1, flat);
        for (int i = 1; i + 1 < n; ++i)
            if (part[i] != 0)
                raster::draw_triangle(*state_, context_->drawable.surface, back[0], back[i], back[i + 1],
                                      flat, part[i]);
    }

    // --- clipping (GL 1.3, 2.11)

    /// A new vertex on the edge from inside to outside; the same integers whichever polygon asks.
    void cut(const Vertex& inside, const Vertex& outside, int plane, Vertex& out) {
        const typename M::Parameter t = M::intersect(inside.clip, outside.clip, plane);
        M::mix(inside.window, outside.window, t, out.window);
        if (fog_) {
            out.eye_z = M::mix(inside.eye_z, outside.eye_z, t);
            M::set_fog(out.eye_z, out.window);
        }
        L::mix(inside.light, outside.light, t, out.light);
        classify(out, M::mix(inside.clip, outside.clip, t));
        // Rounding must not leave it outside of the plane it lies on.
        out.flags &= ~(1u << plane | 1u << (static_cast<unsigned>(plane) + beyond_shift));
    }

    bool clip_line(Vertex* (&ends)[2]) {
        int made = 0;
        needs_clip(*ends[0]);
        needs_clip(*ends[1]);
        for (int plane = 0; plane < 6; ++plane) {
            const bool first_out = M::distance(ends[0]->clip, plane) < 0,
                       second_out = M::distance(ends[1]->clip, plane) < 0;
            if (first_out && second_out)
                return false;
            if (!first_out && !second_out)
                continue;
            Vertex& fresh = clipped_[made++];
            cut(first_out ? *ends[1] : *ends[0], first_out ? *ends[0] : *ends[1], plane, fresh);
            ends[first_out ? 0 : 1] = &fresh;
        }
        return true;
    }

    /// Sutherland and Hodgman, plane by plane; the polygon ends up in work[0].
    int clip_polygon(Vertex* (&work)[2][clip_vertices], int n, unsigned planes) {
        int used = 0;
        for (int plane = 0; plane < 6; ++plane) {
            if ((planes & (1u << plane)) == 0)
                continue;
            int m = 0;
            for (int i = 0; i < n; ++i) {
                // A convex polygon meets a plane twice. A quad that crosses itself, or one that rounding bent
                // at the limits of the mantissas, may do so more often; it may be left out (GL 1.3, 2.6.1).
                if (used == clip_vertices || m + 2 > clip_vertices)
                    return 0;
                Vertex& here = *work[0][i];
                Vertex& next = *work[0][i + 1 == n ? 0 : i + 1];
                const bool here_in = M::distance(here.clip, plane) >= 0,
                           next_in = M::distance(next.clip, plane) >= 0;
                if (here_in)
                    work[1][m++] = &here;
                if (here_in == next_in)
                    continue;
                Vertex& fresh = clipped_[used++];
                cut(here_in ? here : next, here_in ? next : here, plane, fresh);
                work[1][m++] = &fresh;
            }
            n = m;
            for (int i = 0; i < n; ++i)
                work[0][i] = work[1][i];
            if (n < 3)
                return 0;
        }
        return n;
    }
};

} // namespace spangle::gl
