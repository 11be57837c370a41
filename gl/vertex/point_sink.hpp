// Draws points (GL 1.3, 3.3; GL 1.4, 3.3; GL 2.0, 3.3).
//
// PointSink owns nothing. It takes a vertex of the program, or a window vertex of an outline. It promises
// that a point outside of the view volume is not drawn. Points in samples, antialiased points, sprites, and
// points whose size depends on their distance take a longer way.
#pragma once

#include "gl/vertex/capture_sink.hpp"
#include "raster/numeric/root.hpp"

namespace spangle::gl {

template <class M, class L> class PointSink : public CaptureSink<M, L> {
    using Base = CaptureSink<M, L>;

  public:
    using Window = typename M::Window;
    using Vertex = gl::Vertex<M>;
    using ClippedVertex = gl::ClippedVertex<M, L>;

    void point(Vertex& v);
    void draw_point(const Vertex& v, const Window& window);

  protected:
    using Base::begin_capture;
    using Base::capture_vertex;
    using Base::color;
    using Base::context_;
    using Base::modes_;
    using Base::outside;
    using Base::planes_;
    using Base::project;
    using Base::refuse_clipping;
    using Base::state_;
    using Base::transforms_;

    [[gnu::noinline]] void draw_special_point(const Vertex& v, const Window& window);
#if SPANGLE_FEATURE_POINT_PARAMETERS
    Real attenuated_size(const Vertex& v) const;
    Real fade_point(Real size, Window& point) const;
    void draw_sprite(const raster::Surface& target, const Window& point, std::int32_t eighths);
#endif
};

template <class M, class L> inline void PointSink<M, L>::point(Vertex& v) {
    if constexpr (!has_points)
        return;
    if ((v.flags & outside_mask) != 0 || (planes_.any() && outside(v) != 0) || refuse_clipping(v.flags) ||
        !project(v))
        return;
    color(v);
    draw_point(v, v.window);
}

template <class M, class L> inline void PointSink<M, L>::draw_point(const Vertex& v, const Window& window) {
    if (modes_.is_capturing()) {
        begin_capture(GL_POINT_TOKEN, 1);
        return capture_vertex({v, window});
    }
    if (modes_.has_special_points())
        return draw_special_point(v, window);
    raster::draw_point(*state_, context_->drawable.surface, window, modes_.point_size());
}

template <class M, class L>
void PointSink<M, L>::draw_special_point([[maybe_unused]] const Vertex& v, const Window& window) {
    const PolygonState& polygon = context_->polygon;
    Window point = window;
    Real size = polygon.point_size;
#if SPANGLE_FEATURE_POINT_PARAMETERS
    size = attenuated_size(v);
    if (modes_.is_multisampling())
        size = fade_point(size, point);
#endif
    each_primitive_target(*context_, [&](const raster::Surface& target, raster::Position shift) {
        const Window moved = shifted(point, shift);
#if SPANGLE_FEATURE_POINT_PARAMETERS
        if (polygon.point_sprite)
            return draw_sprite(target, moved, eighths(size));
#endif
        if constexpr (raster::has_samples)
            if (modes_.is_multisampling())
                return raster::draw_disc(*state_, target, moved, eighths(size));
#if SPANGLE_FEATURE_ANTIALIASING
        if (polygon.point_smooth)
            return raster::draw_smooth_point(*state_, target, context_->fragments.primitive, moved,
                                             eighths(size));
#endif
        raster::draw_point(*state_, target, moved, rounded_size(size));
    });
}

#if SPANGLE_FEATURE_POINT_PARAMETERS

/// Returns the size of a point: size sqrt(1 / (a + b d + c d^2)), clamped to the minimum and maximum size. a,
/// b and c are the attenuation factors, and d is the distance from the eye (GL 1.4, 3.3).
template <class M, class L> Real PointSink<M, L>::attenuated_size(const Vertex& v) const {
    const PolygonState& p = context_->polygon;
    const auto& [a, b, c] = p.point_attenuation;
    Real size = p.point_size;
    if (a != numeric::one || b != numeric::zero || c != numeric::zero) {
        Real eye[4], squares = numeric::zero;
        M::to_reals((v.flags & is_clipped_vertex) != 0 ? M::narrow(static_cast<const ClippedVertex&>(v).eye)
                                                       : M::to_eye(transforms_, v.position),
                    eye);
        for (int i = 0; i < 3; ++i) {
            const Real part = eye[3] == numeric::one ? eye[i] : numeric::div(eye[i], eye[3]);
            squares = numeric::add(squares, numeric::mul(part, part));
        }
        const Real linear = numeric::mul(b, numeric::sqrt(squares)), square = numeric::mul(c, squares);
        const Real by = numeric::sqrt(numeric::add(numeric::add(a, linear), square));
        size = by == numeric::zero ? p.point_size_max : numeric::div(size, by);
    }
    size = size < p.point_size_min ? p.point_size_min : size;
    return p.point_size_max < size ? p.point_size_max : size;
}

/// Returns the size of a point, raised to the fade threshold. The alpha of a point below the threshold is
/// scaled by the ratio of the areas (GL 1.4, 3.3).
template <class M, class L> Real PointSink<M, L>::fade_point(Real size, Window& point) const {
    const Real threshold = context_->polygon.point_fade_threshold;
    if (!(size < threshold))
        return size;
    const Real ratio = numeric::div(size, threshold);
    M::fade(numeric::mul(ratio, ratio), point);
    return threshold;
}

/// Draws a square around the point. For texture units with COORD_REPLACE, s and t run from 0 to 1 across the
/// square (GL 2.0, 3.3). `eighths` is the side of the square in eighths of a pixel.
template <class M, class L>
void PointSink<M, L>::draw_sprite(const raster::Surface& target, const Window& point, std::int32_t eighths) {
    const PolygonState& polygon = context_->polygon;
    const raster::Position at = raster::position(point);
    const std::int32_t half = eighths * (raster::subpixel_one / 16);
    const std::int64_t area = std::int64_t{4} * half * half;
    const bool down = polygon.sprite_origin == GL_UPPER_LEFT;
    Window corner[4];
    for (int i = 0; i < 4; ++i) {
        const bool right = i == 1 || i == 2, top = i >= 2;
        corner[i] = point;
        raster::place(corner[i], {right ? at.x + half : at.x - half, top ? at.y + half : at.y - half});
        for (int u = 0; u < texture_units; ++u)
            if ((modes_.units() >> u & 1) != 0 && polygon.coord_replace[u])
                M::set_sprite(u, right, top != down, corner[i]);
    }
    for (int i = 1; i < 3; ++i)
        raster::draw_triangle(*state_, target, corner[0], corner[i], corner[i + 1], point, area);
}

#endif

} // namespace spangle::gl
