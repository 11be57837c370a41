// A surface that counts how often each fragment is drawn: its span function adds one to a 16-bit word of the
// pixel.
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

#include "raster/primitive/draw.hpp"
#include "raster/span/rows.hpp"

namespace spangle::raster::test {

inline void count_span(const Span<Fixed>& span) {
    for (std::int32_t i = 0; i < span.end - span.begin; ++i) {
        std::uint16_t word;
        std::memcpy(&word, span.color + 2 * i, 2);
        ++word;
        std::memcpy(span.color + 2 * i, &word, 2);
    }
}

struct CountingTarget {
    int width, height;
    std::vector<std::uint16_t> hits;
    DrawState state;
    Surface surface;

    CountingTarget(int w, int h) : width(w), height(h), hits(static_cast<std::size_t>(w) * h) {
        surface.color = reinterpret_cast<std::uint8_t*>(hits.data());
        surface.color_stride = 2 * w;
        surface.width = w;
        surface.height = h;
        state.color_bytes = 2;
        state.fragment.scissor = {0, 0, w, h};
        for (auto& variant : state.variant)
            variant.run = reinterpret_cast<AnyFunction>(&by_row<Fixed, &count_span>);
    }
    CountingTarget(const CountingTarget&) = delete;

    void clear() { std::memset(hits.data(), 0, hits.size() * 2); }
    std::uint16_t at(int x, int y) const { return hits[static_cast<std::size_t>(y) * width + x]; }

    void triangle(const std::int32_t x[3], const std::int32_t y[3]) {
        FixedVertex v[3] = {};
        for (int i = 0; i < 3; ++i)
            v[i].x = x[i], v[i].y = y[i];
        const std::int64_t area = signed_area(x[0], y[0], x[1], y[1], x[2], y[2]);
        if (area != 0)
            draw_triangle<FixedVertex>(state, surface, v[0], v[1], v[2], v[0], area);
    }
    void line(std::int32_t ax, std::int32_t ay, std::int32_t bx, std::int32_t by, int line_width = 1) {
        FixedVertex a{}, b{};
        a.x = ax, a.y = ay, b.x = bx, b.y = by;
        draw_line<FixedVertex>(state, surface, a, b, b, line_width);
    }
    void point(std::int32_t px, std::int32_t py, int size) {
        FixedVertex v{};
        v.x = px, v.y = py;
        draw_point<FixedVertex>(state, surface, v, size);
    }
};

} // namespace spangle::raster::test
