// A small surface on which any policy can draw, and vertices given in plain doubles.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "raster/primitive/draw.hpp"
#include "raster/surface/pixel.hpp"

namespace spangle::raster::test {

struct Canvas {
    std::int32_t width, height;
    PixelFormat format;
    DepthFormat depth_format;
    std::vector<std::uint8_t> color, depth;

    explicit Canvas(PixelFormat f = PixelFormat::rgb565_be, std::int32_t w = 32, std::int32_t h = 32,
                    DepthFormat d = DepthFormat::z24s8)
        : width(w), height(h), format(f), depth_format(d),
          color(static_cast<std::size_t>(row_bytes(f, w) * stored_rows(f, h))),
          depth(static_cast<std::size_t>(w * h * 4), 0xFF) {}

    Surface surface() {
        Surface s;
        s.color = color.data();
        s.depth = depth_format == DepthFormat::none ? nullptr : depth.data();
        s.color_stride = row_bytes(format, width);
        s.depth_stride = width * (depth_format == DepthFormat::z16 ? 2 : 4);
        s.width = width;
        s.height = height;
        s.format = format;
        s.depth_format = depth_format;
        return s;
    }
    StoredColor at(std::int32_t x, std::int32_t y) { return read_color(surface(), x, y); }
};

/// A vertex: window x and y in pixels, depth 0..1, clip w, colours 0..1, eye distance, texture coordinates.
struct Point {
    double x = 0, y = 0, z = 0.5, w = 1;
    double color[4] = {1, 1, 1, 1};
    double secondary[3] = {0, 0, 0};
    double fog = 0;
    double s = 0, t = 0, r = 0, q = 1;
};

inline FixedVertex fixed_vertex(const Point& p) {
    FixedVertex v{};
    const auto mantissa = []<class T>(double value, T& m, std::int16_t& e) {
        constexpr int bits = std::numeric_limits<T>::digits;
        int exponent = 0;
        m = static_cast<T>(std::ldexp(std::frexp(value, &exponent), bits));
        e = static_cast<std::int16_t>(exponent - bits);
    };
    v.x = static_cast<std::int32_t>(std::lround(p.x * 256));
    v.y = static_cast<std::int32_t>(std::lround(p.y * 256));
    const auto rest = [](double at, std::int32_t snapped) {
        return static_cast<std::int16_t>(std::fmin(std::floor((at * 256 - snapped) * 65536), 32767));
    };
    v.x_rest = rest(p.x, v.x);
    v.y_rest = rest(p.y, v.y);
    v.z = static_cast<std::uint32_t>(std::lround(p.z * depth_one));
    mantissa(1 / p.w, v.w_mantissa, v.w_exponent);
    mantissa(p.fog, v.fog_mantissa, v.fog_exponent);
    for (int i = 0; i < 4; ++i)
        v.color[i] = static_cast<std::uint32_t>(std::lround(p.color[i] * color_one));
    for (int i = 0; i < 3; ++i)
        v.secondary[i] = static_cast<std::uint32_t>(std::lround(p.secondary[i] * color_one));
    int exponent = 0;
    std::frexp(
        std::fmax(std::fmax(std::fabs(p.s), std::fabs(p.t)), std::fmax(std::fabs(p.r), std::fabs(p.q))),
        &exponent);
    for (auto& unit : v.tex) {
        unit.exponent = static_cast<std::int16_t>(exponent - 30);
        unit.s = static_cast<std::int32_t>(std::lround(std::ldexp(p.s, 30 - exponent)));
        unit.t = static_cast<std::int32_t>(std::lround(std::ldexp(p.t, 30 - exponent)));
        unit.q = static_cast<std::int32_t>(std::lround(std::ldexp(p.q, 30 - exponent)));
        unit.q_is_one = p.q == 1;
    }
    for (auto& r : v.r)
        r = static_cast<std::int32_t>(std::lround(std::ldexp(p.r, 30 - exponent)));
    return v;
}

inline DoubleVertex double_vertex(const Point& p) {
    DoubleVertex v{};
    v.x = static_cast<std::int32_t>(std::lround(p.x * 256));
    v.y = static_cast<std::int32_t>(std::lround(p.y * 256));
    v.z = p.z;
    v.inv_w = 1 / p.w;
    v.fog = p.fog;
    std::memcpy(v.color, p.color, sizeof v.color);
    std::memcpy(v.secondary, p.secondary, sizeof v.secondary);
    for (auto& unit : v.tex)
        unit = {p.s, p.t, p.q, p.r};
    v.x_exact = p.x;
    v.y_exact = p.y;
    return v;
}

template <class V> V make(const Point& p) {
    if constexpr (std::is_same_v<V, FixedVertex>)
        return fixed_vertex(p);
    else if constexpr (std::is_same_v<V, DoubleVertex>)
        return double_vertex(p);
    else
        return V{fixed_vertex(p), double_vertex(p)};
}

inline FragmentState plain_state(const Canvas& c) {
    FragmentState f;
    f.scissor = {0, 0, c.width, c.height};
    f.dither = false;
    return f;
}

template <class V>
void triangle(const FragmentState& f, Canvas& canvas, const Point& a, const Point& b, const Point& c) {
    const Surface surface = canvas.surface();
    const DrawState state = compile<V>(f, surface);
    const V va = make<V>(a), vb = make<V>(b), vc = make<V>(c);
    const Position pa = position(va), pb = position(vb), pc = position(vc);
    draw_triangle<V>(state, surface, va, vb, vc, vc, signed_area(pa.x, pa.y, pb.x, pb.y, pc.x, pc.y));
}

/// Draws a quad of corners counter-clockwise from the lower left, split along the diagonal from the first
/// corner.
template <class V> void quad(const FragmentState& f, Canvas& canvas, const Point (&corner)[4]) {
    triangle<V>(f, canvas, corner[0], corner[1], corner[2]);
    triangle<V>(f, canvas, corner[0], corner[2], corner[3]);
}

/// Draws a quad over the whole canvas with all attributes of `p`.
template <class V> void cover(const FragmentState& f, Canvas& canvas, const Point& p) {
    Point corner[4] = {p, p, p, p};
    corner[1].x = corner[2].x = canvas.width;
    corner[2].y = corner[3].y = canvas.height;
    corner[0].x = corner[0].y = corner[1].y = corner[3].x = 0;
    quad<V>(f, canvas, corner);
}

/// The largest difference of a stored component, and the number of pixels that differ.
struct Difference {
    int largest = 0, pixels = 0;
};
/// Compares two canvases. Pixels whose components differ by at most `ignored` steps count as equal.
inline Difference difference(Canvas& a, Canvas& b, int ignored = 0) {
    Difference d;
    for (std::int32_t y = 0; y < a.height; ++y)
        for (std::int32_t x = 0; x < a.width; ++x) {
            int here = 0;
            for (int i = 0; i < 4; ++i)
                here = std::max(here, std::abs(a.at(x, y).c[i].k - b.at(x, y).c[i].k));
            d.largest = std::max(d.largest, here);
            d.pixels += here > ignored;
        }
    return d;
}

} // namespace spangle::raster::test
