// Computes how much of a pixel a polygon covers, by clipping the polygon to the pixel. The error is below
// 1e-9.
#pragma once

#include <cmath>
#include <vector>

namespace spangle::oracle {

struct Point {
    double x, y;
};
using Polygon = std::vector<Point>;

/// Returns the polygon in pixels; `corners` are in subpixels.
template <class P> Polygon polygon(const std::vector<P>& corners) {
    Polygon out;
    for (const P& p : corners)
        out.push_back({p.x / 256.0, p.y / 256.0});
    return out;
}

/// Returns the part of the polygon where a x + b y + c >= 0.
inline Polygon clipped(const Polygon& in, double a, double b, double c) {
    Polygon out;
    for (std::size_t i = 0; i < in.size(); ++i) {
        const Point &p = in[i], &q = in[(i + 1) % in.size()];
        const double dp = a * p.x + b * p.y + c, dq = a * q.x + b * q.y + c;
        if (dp >= 0)
            out.push_back(p);
        if ((dp < 0) != (dq < 0)) {
            const double t = dp / (dp - dq);
            out.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
        }
    }
    return out;
}

inline double area(const Polygon& p) {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Point &a = p[i], &b = p[(i + 1) % p.size()];
        sum += a.x * b.y - b.x * a.y;
    }
    return std::fabs(sum) / 2;
}

inline double area_in(const Polygon& p, int x, int y) {
    return area(clipped(clipped(clipped(clipped(p, 1, 0, -x), -1, 0, x + 1), 0, 1, -y), 0, -1, y + 1));
}

/// Returns the rectangle of `width` pixels around a line.
inline Polygon rectangle(const Point& a, const Point& b, double width) {
    const double length = std::hypot(b.x - a.x, b.y - a.y), h = width / 2 / length;
    const Point n = {-(b.y - a.y) * h, (b.x - a.x) * h};
    return {{a.x - n.x, a.y - n.y}, {b.x - n.x, b.y - n.y}, {b.x + n.x, b.y + n.y}, {a.x + n.x, a.y + n.y}};
}

} // namespace spangle::oracle
