#include "raster/primitive/setup_double.hpp"

namespace spangle::raster {

namespace {

double pixels(std::int32_t v) {
    return static_cast<double>(v) / subpixel_one;
}

} // namespace

Setup<Double>::Setup(Span<Double>& span, const Vertex& a, const Vertex& b, const Vertex& c,
                     const Vertex& provoking, std::int64_t)
    : span_(span), v_{&a, &b, &c}, origin_x_(pixels(a.x)), origin_y_(pixels(a.y)) {
    const double bx = pixels(b.x) - origin_x_, by = pixels(b.y) - origin_y_;
    const double cx = pixels(c.x) - origin_x_, cy = pixels(c.y) - origin_y_;
    const double area = bx * cy - cx * by;
    x1_ = cy / area;
    x2_ = -by / area;
    y1_ = -cx / area;
    y2_ = bx / area;
    attributes(provoking);
}

Setup<Double>::Setup(Span<Double>& span, const Vertex& a, const Vertex& b, const Vertex& provoking,
                     bool along_x, std::int32_t begin, std::int32_t end)
    : span_(span), v_{&a, &b, &a}, origin_x_(along_x ? pixels(begin) : 0),
      origin_y_(along_x ? 0 : pixels(begin)), x1_(0), y1_(0), x2_(0), y2_(0) {
    const double length = pixels(end) - pixels(begin);
    (along_x ? x1_ : y1_) = length != 0 ? 1 / length : 0;
    attributes(provoking);
}

Setup<Double>::Setup(Span<Double>& span, const Vertex& v) : Setup(span, v, v, v, true, v.x, v.x) {}

void Setup<Double>::add(Interpolant<double>& at, double v0, double v1, double v2, double* dy) {
    const double d1 = v1 - v0, d2 = v2 - v0;
    at.dx = d1 * x1_ + d2 * x2_;
    at.dy = d1 * y1_ + d2 * y2_;
    at.value = v0 + at.dx * (span_.anchor_x + 0.5 - origin_x_) + at.dy * (span_.anchor_y + 0.5 - origin_y_);
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
        add(at, a * w[0], b * w[1], c * w[2], dy);
    };
    add(span_.z, v_[0]->z, v_[1]->z, v_[2]->z);
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
