// Draws points that are more than squares of whole pixels: points in samples, antialiased points, sprites,
// and points whose size depends on their distance (GL 1.3, 3.3; GL 1.4, 3.3; GL 2.0, 3.3).
#pragma once

#include "gl/vertex/pipeline.hpp"
#include "raster/numeric/root.hpp"

namespace spangle::gl {

template <class M, class L>
void Pipeline<M, L>::draw_special_point([[maybe_unused]] const Vertex& v, const Window& window) {
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
template <class M, class L> Real Pipeline<M, L>::attenuated_size(const Vertex& v) const {
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
template <class M, class L> Real Pipeline<M, L>::fade_point(Real size, Window& point) const {
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
void Pipeline<M, L>::draw_sprite(const raster::Surface& target, const Window& point, std::int32_t eighths) {
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
