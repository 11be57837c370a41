#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "raster/primitive/setup_double.hpp"

namespace spangle::raster {

namespace {

double pixels(std::int32_t v) {
    return static_cast<double>(v) / subpixel_one;
}

/// A coordinate before it was snapped, where that is known. A value that is 0.75 subpixels or more away
/// belongs to another vertex.
double exact(std::int32_t snapped, double before) {
    return std::fabs(before * subpixel_one - snapped) < 0.75 ? before : pixels(snapped);
}

} // namespace

Setup<Double>::Plane Setup<Double>::plane_through(double ax, double ay, double bx, double by, double cx,
                                                  double cy) {
    const double x1 = bx - ax, y1 = by - ay, x2 = cx - ax, y2 = cy - ay, area = x1 * y2 - x2 * y1;
    return {ax, ay, y2 / area, -x2 / area, -y1 / area, x1 / area};
}

Setup<Double>::Setup(Span<Double>& span, const Vertex& a, const Vertex& b, const Vertex& c,
                     const Vertex& provoking, std::int64_t)
    : span_(span), v_{&a, &b, &c},
      snapped_(plane_through(pixels(a.x), pixels(a.y), pixels(b.x), pixels(b.y), pixels(c.x), pixels(c.y))),
      exact_(plane_through(exact(a.x, a.x_exact), exact(a.y, a.y_exact), exact(b.x, b.x_exact),
                           exact(b.y, b.y_exact), exact(c.x, c.x_exact), exact(c.y, c.y_exact))) {
    // These are the rules of Setup<Fixed>::unsnap_plane() and snap_where_w_ends(). Vertices too near to one
    // line say little about the area between them. 1/w must not come near 0 beyond its least vertex.
    const double sum =
        2 * std::fabs(exact_.x1) + std::fabs(exact_.y1) + std::fabs(exact_.y2); // x1 stands for x2, too
    const double beyond = sum / (2 * subpixel_one);
    const auto [least, most] = std::minmax({a.inv_w, b.inv_w, c.inv_w});
    if (!(beyond <= 1.0 / 16) ||
        (span.state->fragment.perspective && (most - least) * beyond > least * 7 / 8))
        exact_ = snapped_;
    attributes(provoking);
}

Setup<Double>::Setup(Span<Double>& span, const Vertex& a, const Vertex& b, const Vertex& provoking,
                     bool along_x, std::int32_t begin, std::int32_t end)
    : span_(span), v_{&a, &b, &a}, snapped_{}, exact_{} {
    const auto along = [&](double from, double to) {
        const double one = to != from ? 1 / (to - from) : 0;
        return along_x ? Plane{from, 0, one, 0, 0, 0} : Plane{0, from, 0, one, 0, 0};
    };
    snapped_ = exact_ = along(pixels(begin), pixels(end));
    const auto end_of = [&](const Vertex& v, std::int32_t at) {
        const bool moved = at != (along_x ? v.x : v.y);
        return moved ? pixels(at) : exact(at, along_x ? v.x_exact : v.y_exact);
    };
    if (std::abs(end - begin) >= 16)
        exact_ = along(end_of(a, begin), end_of(b, end));
    attributes(provoking);
}

Setup<Double>::Setup(Span<Double>& span, const Vertex& v) : Setup(span, v, v, v, true, v.x, v.x) {}

void Setup<Double>::add(const Plane& plane, Interpolant<double>& at, double v0, double v1, double v2,
                        double* dy) {
    const double d1 = v1 - v0, d2 = v2 - v0;
    at.dx = d1 * plane.x1 + d2 * plane.x2;
    at.dy = d1 * plane.y1 + d2 * plane.y2;
    at.value = v0 + at.dx * (span_.anchor_x + 0.5 - plane.origin_x) +
               at.dy * (span_.anchor_y + 0.5 - plane.origin_y);
    if (dy != nullptr)
        *dy = at.dy;
}

void Setup<Double>::attributes(const Vertex& provoking) {
    const DrawState& state = *span_.state;
    span_.anchor_x = v_[0]->x >> subpixel_bits;
    span_.anchor_y = v_[0]->y >> subpixel_bits;
    span_.kind = Kind::full;
    double w[3];
    for (int i = 0; i < 3; ++i)
        w[i] = state.fragment.perspective ? v_[i]->inv_w : 1;
    const auto over_w = [&](Interpolant<double>& at, double a, double b, double c, double* dy = nullptr) {
        add(exact_, at, a * w[0], b * w[1], c * w[2], dy);
    };
    add(snapped_, span_.z, v_[0]->z, v_[1]->z, v_[2]->z);
    over_w(span_.q, 1, 1, 1, &span_.q_dy);
    const bool flat = state.fragment.flat;
    const Vertex& a = flat ? provoking : *v_[0];
    const Vertex& b = flat ? provoking : *v_[1];
    const Vertex& c = flat ? provoking : *v_[2];
    for (int i = 0; i < 4; ++i)
        over_w(span_.color_q[i], a.color[i], b.color[i], c.color[i]);
    if (state.needs.secondary)
        for (int i = 0; i < 3; ++i)
            over_w(span_.secondary_q[i], a.secondary[i], b.secondary[i], c.secondary[i]);
    if (state.needs.fog)
        over_w(span_.fog_q, v_[0]->fog, v_[1]->fog, v_[2]->fog);
    for (int i = 0; i < max_texture_units; ++i) {
        if (!state.needs.unit[i])
            continue;
        auto& unit = span_.unit[i];
        unit.shares_q = false;
        over_w(unit.s, v_[0]->tex[i].s, v_[1]->tex[i].s, v_[2]->tex[i].s, &unit.s_dy);
        over_w(unit.t, v_[0]->tex[i].t, v_[1]->tex[i].t, v_[2]->tex[i].t, &unit.t_dy);
        over_w(unit.r, v_[0]->tex[i].r, v_[1]->tex[i].r, v_[2]->tex[i].r, &unit.r_dy);
        over_w(unit.q, v_[0]->tex[i].q, v_[1]->tex[i].q, v_[2]->tex[i].q, &unit.q_dy);
    }
}

} // namespace spangle::raster
