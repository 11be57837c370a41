// Draws lines (GL 1.3, 3.4).
//
// LineSink owns the stipple of lines. It takes vertices of the program, or window vertices of outlines. It
// promises that a line is clipped, that its colours are computed only if it is visible, and that the stipple
// starts anew with each primitive, and with each line of LINES.
#pragma once

#include "gl/vertex/point_sink.hpp"
#include "gl/vertex/primitive_paths.hpp"
#include "raster/primitive/line_stipple.hpp"

namespace spangle::gl {

template <class M, class L> class LineSink : public PointSink<M, L> {
    using Base = PointSink<M, L>;
    template <class Sink, class Vertex> friend void draw_single_line(Sink& to, Vertex& a, Vertex& b);

  public:
    using Window = typename M::Window;
    using Vertex = gl::Vertex<M>;
    using ClippedVertex = gl::ClippedVertex<M, L>;

    /// Begins a draw: its first line starts the stipple pattern anew.
    void begin_lines([[maybe_unused]] const Context& context) {
        restarts_stipple_ = true;
#if SPANGLE_FEATURE_STIPPLE
        stipple_.pattern = context.polygon.stipple_pattern;
        stipple_.factor = static_cast<std::uint32_t>(context.polygon.stipple_factor);
#endif
    }
    void line(Vertex& a, Vertex& b);
    [[gnu::noinline]] void lines(Vertex* const* vertex, int n, int step, bool one_color);
    void draw_line(const Vertex& a, const Window& at_a, const Vertex& b, const Window& at_b,
                   const Window& provoking);

  protected:
    using Base::begin_capture;
    using Base::capture_vertex;
    using Base::clip_planes;
    using Base::color;
    using Base::context_;
    using Base::modes_;
    using Base::planes_;
    using Base::project;
    using Base::refuse_clipping;
    using Base::state_;
    using typename Base::Corner;
#if SPANGLE_CLIPPING
    using Base::clip_line;
#endif

    [[gnu::noinline]] void draw_special_line(const Window& a, const Window& b, const Window& provoking);
    [[gnu::noinline]] void draw_visible_line(Vertex& a, Vertex& b);
    [[gnu::noinline]] void clip_and_draw_line(Vertex& a, Vertex& b);
    [[gnu::noinline]] void capture_line(const Corner& a, const Corner& b, const Window& provoking);
    [[gnu::noinline]] void capture_clipped_line(Vertex& a, Vertex& b);

    bool restarts_stipple_ = false; ///< true if the next line starts the stipple pattern anew

  private:
    raster::LineStipple stipple_;

    /// True if the stipple pattern starts anew with this line. It does with each primitive, and with each
    /// line of LINES (GL 1.3, 3.4.2).
    bool starts_stipple() {
        const bool starts = restarts_stipple_;
        restarts_stipple_ = modes_.mode() == GL_LINES;
        return starts;
    }
};

template <class M, class L> inline void LineSink<M, L>::line(Vertex& a, Vertex& b) {
    if constexpr (!has_lines)
        return;
    if (modes_.is_capturing())
        return capture_clipped_line(a, b);
    draw_single_line(*this, a, b);
}

/// Draws lines between vertices i and i + 1, for i = 0, step, 2 step and so on. `one_color` says that all
/// vertices have the same colour.
template <class M, class L>
void LineSink<M, L>::lines(Vertex* const* vertex, int n, int step, bool one_color) {
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

template <class M, class L>
inline void LineSink<M, L>::draw_line(const Vertex& a, const Window& at_a, const Vertex& b,
                                      const Window& at_b, const Window& provoking) {
    if (modes_.is_capturing())
        return capture_line({a, at_a}, {b, at_b}, provoking);
    if (modes_.has_special_lines())
        return draw_special_line(at_a, at_b, provoking);
    raster::draw_line(*state_, context_->drawable.surface, at_a, at_b, provoking, modes_.line_width());
}

/// Draws a line that is stippled or antialiased, or whose drawable has samples.
template <class M, class L>
void LineSink<M, L>::draw_special_line(const Window& a, const Window& b, const Window& provoking) {
    if (starts_stipple())
        stipple_.position = 0;
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

/// Draws a line that may lie outside of the view volume.
template <class M, class L> void LineSink<M, L>::draw_visible_line(Vertex& a, Vertex& b) {
    if ((a.flags & b.flags & outside_mask) != 0)
        return;
    if (!modes_.is_flat_shaded())
        color(a);
    color(b);
    clip_and_draw_line(a, b);
}

/// Clips and draws a line. Its ends may have no window coordinates yet.
template <class M, class L> void LineSink<M, L>::clip_and_draw_line(Vertex& a, Vertex& b) {
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
void LineSink<M, L>::capture_line(const Corner& a, const Corner& b, const Window& provoking) {
    begin_capture(starts_stipple() ? GL_LINE_RESET_TOKEN : GL_LINE_TOKEN, 2);
    capture_vertex({a.vertex, modes_.is_flat_shaded() ? provoking : a.window});
    capture_vertex({b.vertex, modes_.is_flat_shaded() ? provoking : b.window});
}

template <class M, class L> void LineSink<M, L>::capture_clipped_line(Vertex& a, Vertex& b) {
    const unsigned both = a.flags & b.flags;
    if ((both & outside_mask) != 0)
        return;
    color(a);
    color(b);
    clip_and_draw_line(a, b);
}

} // namespace spangle::gl
