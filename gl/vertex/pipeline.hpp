// From a vertex as given to primitives in window space: transform, assemble, clip, cull, light, draw. One
// template for every numeric policy; M supplies the arithmetic and L the lighting.
//
// Order (GL 1.3, figure 2.8) as far as it can be seen. Colours are computed late, for vertices of primitives
// that survive culling: a vertex's colour depends on nothing that happens in between.
#pragma once

#include "gl/context/context.hpp"
#include "gl/pixel/fragment_setup.hpp"
#include "raster/primitive/draw.hpp"

namespace spangle::gl {

template <class M, class L> class Pipeline {
  public:
    using Window = typename M::Window;

    void begin(Context& context, GLenum mode) {
        context_ = &context;
        mode_ = mode;
        count_ = 0;
        derive(context);
        state_ = &draw_state(context);
    }

    void vertex(Context& context, const Real (&position)[4]) {
        Vertex& v = slot_[slot_for_next()];
        process(context, position, v);
        ++count_;
        assemble(v);
    }

    void end() {
        if (mode_ == GL_LINE_LOOP && count_ >= 2)
            line(slot_[1 + (count_ & 1)], slot_[0]);
    }

    /// A material is about to change: vertices given so far get their colours from the old one.
    void settle_colors() {
        for (Vertex& v : slot_)
            color(v);
        lighting_.materials_changed();
    }

  private:
    struct Vertex {
        typename M::Clip clip;
        Window window;
        typename M::Depth eye_z;  ///< with its sign: clipping mixes it, fog takes its size
        typename L::Input light;  ///< what lighting needs, kept until the colour is
        std::uint8_t outside = 0; ///< view-volume planes it lies outside of
        std::uint8_t beyond = 0;  ///< planes (guard band, near, far) it must be clipped by
        bool projected = false, colored = true;
    };
    static constexpr int slot_count = 4, clip_vertices = 16;

    Context* context_ = nullptr;
    const raster::DrawState* state_ = nullptr;
    GLenum mode_ = GL_POINTS;
    std::uint32_t count_ = 0; ///< vertices since Begin
    Vertex slot_[slot_count];
    Vertex clipped_[clip_vertices];
    typename M::Transforms transforms_;
    L lighting_;
    bool needs_eye_ = false;
    std::int32_t point_size_ = 1, line_width_ = 1;

    void derive(Context& context) {
        if ((context.dirty & dirty_vertex) != 0) {
            M::derive(context.transform, transforms_);
            lighting_.derive(context);
            context.dirty = static_cast<std::uint8_t>(context.dirty & ~dirty_vertex);
        }
        needs_eye_ = context.fog.fog || lighting_.needs_eye();
        point_size_ = whole(context.polygon.point_size);
        line_width_ = whole(context.polygon.line_width);
    }

    /// Aliased sizes are rounded, 0 counts as 1 (GL 1.3, 3.3, 3.4.2); the largest is 64.
    static std::int32_t whole(Real size) {
        return numeric::clamp<std::int32_t>(numeric::to_i32_round(size), 1, 64);
    }

    void process(Context& context, const Real (&position)[4], Vertex& v) {
        v.clip = M::to_clip(transforms_, position);
        v.projected = false;
        classify(v);
        const CurrentState& current = context.current;
        for (int u = 0; u < texture_units; ++u)
            if (context.texture.unit[u].texture_2d)
                M::set_texture(transforms_, current.tex_coord[u], u, v.window);
        if (needs_eye_) {
            const typename M::Eye eye = M::to_eye(transforms_, position);
            if (context.fog.fog) {
                v.eye_z = M::depth(eye);
                M::set_fog(v.eye_z, v.window);
            }
            lighting_.take(context, eye, v.light);
        } else {
            lighting_.take(context, v.light);
        }
        if (!context.lighting.lighting) {
            M::set_color(v.window, current.color);
            v.colored = true;
            return;
        }
        v.colored = false;
        if (lighting_.tracks_color())
            color(v); // the material is the current colour: now or never
    }

    static void classify(Vertex& v) {
        unsigned outside = 0, beyond = 0;
        for (int plane = 0; plane < 6; ++plane) {
            outside |= M::volume_distance(v.clip, plane) < 0 ? 1u << plane : 0u;
            beyond |= M::distance(v.clip, plane) < 0 ? 1u << plane : 0u;
        }
        v.outside = static_cast<std::uint8_t>(outside);
        v.beyond = static_cast<std::uint8_t>(beyond);
    }

    void color(Vertex& v) {
        if (v.colored)
            return;
        lighting_.light(*context_, v.light, 0, v.window);
        v.colored = true;
    }

    void project(Vertex& v) {
        if (v.projected)
            return;
        M::project(transforms_, v.clip, v.window);
        v.projected = true;
    }

    // --- assembly (GL 1.3, 2.6.1); provoking vertices by table 2.11

    /// Where vertex `count_` goes: fans and loops keep their first vertex in slot 0.
    std::uint32_t slot_for_next() const {
        switch (mode_) {
        case GL_POINTS:
            return 0;
        case GL_LINES:
        case GL_LINE_STRIP:
            return count_ & 1;
        case GL_TRIANGLES:
        case GL_TRIANGLE_STRIP:
            return count_ % 3;
        case GL_QUADS:
        case GL_QUAD_STRIP:
            return count_ & 3;
        default:
            return count_ == 0 ? 0 : 1 + ((count_ - 1) & 1); // LINE_LOOP, TRIANGLE_FAN, POLYGON
        }
    }

    void assemble(Vertex& last) {
        const std::uint32_t n = count_;
        switch (mode_) {
        case GL_POINTS:
            return point(last);
        case GL_LINES:
            if (n % 2 == 0)
                line(slot_[0], slot_[1]);
            return;
        case GL_LINE_STRIP:
            if (n >= 2)
                line(slot_[n & 1], last);
            return;
        case GL_LINE_LOOP:
            if (n == 2)
                line(slot_[0], last);
            if (n > 2)
                line(slot_[1 + ((n - 2) & 1 ? 0 : 1)], last);
            return;
        case GL_TRIANGLES:
            if (n % 3 == 0)
                triangle(slot_[0], slot_[1], slot_[2], last);
            return;
        case GL_TRIANGLE_STRIP:
            return strip(last);
        case GL_TRIANGLE_FAN:
            if (n >= 3)
                triangle(slot_[0], slot_[1 + (n & 1 ? 0 : 1)], last, last);
            return;
        case GL_POLYGON:
            if (n >= 3)
                triangle(slot_[0], slot_[1 + (n & 1 ? 0 : 1)], last, slot_[0]);
            return;
        case GL_QUADS:
            if (n % 4 == 0)
                quad(slot_[0], slot_[1], slot_[2], slot_[3], last);
            return;
        default: // QUAD_STRIP: v0 v1 v3 v2
            if (n >= 4 && n % 2 == 0)
                quad(slot_[n & 3], slot_[(n + 1) & 3], slot_[(n + 3) & 3], slot_[(n + 2) & 3], last);
            return;
        }
    }

    /// Triangle i of a strip is i, i+1, i+2, with the first two exchanged when i is odd, so all face one way.
    void strip(Vertex& last) {
        if (count_ < 3)
            return;
        Vertex& oldest = slot_[count_ % 3];
        Vertex& middle = slot_[(count_ + 1) % 3];
        if ((count_ & 1) != 0)
            triangle(oldest, middle, last, last);
        else
            triangle(middle, oldest, last, last);
    }

    // --- primitives

    void point(Vertex& v) {
        if (v.outside != 0 || !M::in_front(v.clip))
            return;
        project(v);
        color(v);
        raster::draw_point(*state_, context_->drawable.surface, v.window, point_size_);
    }

    void line(Vertex& a, Vertex& b) {
        if ((a.outside & b.outside) != 0)
            return;
        color(a);
        color(b);
        Vertex* ends[2] = {&a, &b};
        if ((a.outside | b.outside) != 0 && !clip_line(ends))
            return;
        if (!M::in_front(ends[0]->clip) || !M::in_front(ends[1]->clip))
            return;
        project(*ends[0]);
        project(*ends[1]);
        raster::draw_line(*state_, context_->drawable.surface, ends[0]->window, ends[1]->window, b.window,
                          line_width_);
    }

    void triangle(Vertex& a, Vertex& b, Vertex& c, Vertex& provoking) {
        Vertex* corners[3] = {&a, &b, &c};
        polygon(corners, 3, provoking);
    }

    /// Two triangles with one facing: that of the whole quad.
    void quad(Vertex& a, Vertex& b, Vertex& c, Vertex& d, Vertex& provoking) {
        Vertex* corners[4] = {&a, &b, &c, &d};
        polygon(corners, 4, provoking);
    }

    void polygon(Vertex* const* corners, int n, Vertex& provoking) {
        unsigned all = 0x3F, any = 0;
        for (int i = 0; i < n; ++i) {
            all &= corners[i]->outside;
            any |= corners[i]->beyond;
        }
        if (all != 0)
            return;
        if (any == 0)
            return visible(corners, n, provoking);
        // Clipping interpolates colours, so they come first; of the provoking vertex too.
        for (int i = 0; i < n; ++i)
            color(*corners[i]);
        Vertex* work[2][clip_vertices];
        for (int i = 0; i < n; ++i)
            work[0][i] = corners[i];
        const int left = clip_polygon(work, n, any);
        if (left >= 3)
            visible(work[0], left, provoking);
    }

    void visible(Vertex* const* corners, int n, Vertex& provoking) {
        std::int64_t area = 0, part[clip_vertices] = {};
        for (int i = 0; i < n; ++i) {
            if (!M::in_front(corners[i]->clip))
                return;
            project(*corners[i]);
        }
        for (int i = 1; i + 1 < n; ++i) {
            const raster::Position a = raster::position(corners[0]->window),
                                   b = raster::position(corners[i]->window),
                                   c = raster::position(corners[i + 1]->window);
            part[i] = raster::signed_area(a.x, a.y, b.x, b.y, c.x, c.y);
            area += part[i];
        }
        const bool front = (area > 0) == (context_->polygon.front_face == GL_CCW);
        if (area == 0 && n == 3)
            return;
        if (culled(front))
            return;
        for (int i = 0; i < n; ++i)
            color(*corners[i]);
        color(provoking);
        if (!front && lighting_.two_sided())
            return draw_back(corners, n, provoking, part);
        for (int i = 1; i + 1 < n; ++i)
            if (part[i] != 0)
                raster::draw_triangle(*state_, context_->drawable.surface, corners[0]->window,
                                      corners[i]->window, corners[i + 1]->window, provoking.window, part[i]);
    }

    bool culled(bool front) const {
        const PolygonState& p = context_->polygon;
        if (!p.cull_face)
            return false;
        return p.cull_face_mode == GL_FRONT_AND_BACK || (p.cull_face_mode == GL_FRONT) == front;
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
        out.clip = M::mix(inside.clip, outside.clip, t);
        M::mix(inside.window, outside.window, t, out.window);
        if (context_->fog.fog) {
            out.eye_z = M::mix(inside.eye_z, outside.eye_z, t);
            M::set_fog(out.eye_z, out.window);
        }
        L::mix(inside.light, outside.light, t, out.light);
        out.projected = false;
        out.colored = true;
        classify(out);
        // Rounding must not leave it outside of the plane it lies on.
        out.outside = static_cast<std::uint8_t>(out.outside & ~(1u << plane));
        out.beyond = static_cast<std::uint8_t>(out.beyond & ~(1u << plane));
    }

    bool clip_line(Vertex* (&ends)[2]) {
        int made = 0;
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
