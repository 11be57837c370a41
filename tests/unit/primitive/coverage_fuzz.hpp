// Compares triangles, pixel by pixel, with the edge equations in 64-bit integers.
#pragma once

#include <algorithm>
#include <random>

#include "raster/primitive/edge.hpp"
#include "tests/unit/primitive/counting_target.hpp"

namespace spangle::raster::test {

/// The rule of coverage as textbooks have it (edge.hpp states it). A centre is covered if it is inside, or on
/// an edge that owns its centres. In a counter-clockwise triangle these are left edges, which go down, and
/// level bottom edges, which go right.
inline bool covers(const std::int32_t x[3], const std::int32_t y[3], std::int64_t area, std::int64_t px,
                   std::int64_t py) {
    const std::int64_t sign = area > 0 ? 1 : -1;
    for (int i = 0; i < 3; ++i) {
        const int a = i, b = (i + 1) % 3;
        const std::int64_t dx = sign * (std::int64_t{x[b]} - x[a]), dy = sign * (std::int64_t{y[b]} - y[a]);
        const std::int64_t e = dx * (py - y[a]) - dy * (px - x[a]);
        const bool owns = dy < 0 || (dy == 0 && dx > 0);
        if (e < 0 || (e == 0 && !owns))
            return false;
    }
    return true;
}

struct FuzzTriangle {
    std::int32_t x[3], y[3];
};

/// Returns a triangle of one of these kinds: random, far outside, vertices on centres, slivers,
/// axis-aligned, tiny.
inline FuzzTriangle fuzz_triangle(std::mt19937& random, int kind, int width, int height) {
    const auto within = [&](std::int32_t low, std::int32_t high) {
        return low + static_cast<std::int32_t>(random() % static_cast<std::uint32_t>(high - low));
    };
    FuzzTriangle t{};
    const std::int32_t w = width * subpixel_one, h = height * subpixel_one;
    for (int k = 0; k < 3; ++k) {
        t.x[k] = kind == 1   ? within(-guard_band, guard_band)
                 : kind == 6 ? within(-4 * w, 5 * w)
                             : within(0, w);
        t.y[k] = kind == 1   ? within(-guard_band, guard_band)
                 : kind == 6 ? within(-4 * h, 5 * h)
                             : within(0, h);
        if (kind == 2) {
            t.x[k] = (t.x[k] & -subpixel_one) + subpixel_one / 2;
            t.y[k] = (t.y[k] & -subpixel_one) + subpixel_one / 2;
        }
        if (kind == 5 && k > 0) {
            t.x[k] = t.x[0] + within(-600, 600);
            t.y[k] = t.y[0] + within(-600, 600);
        }
    }
    if (kind == 3) {
        t.x[2] = t.x[1] + within(-1, 2);
        t.y[2] = t.y[1] + within(-1, 2);
    }
    if (kind == 4) {
        t.y[1] = t.y[0];
        t.x[2] = t.x[0];
    }
    return t;
}

/// Returns the number of mismatching pixels of `count` triangles.
inline long coverage_mismatches(std::uint32_t seed, int count, int width, int height) {
    std::mt19937 random(seed);
    CountingTarget target(width, height);
    long wrong = 0;
    for (int n = 0; n < count; ++n) {
        const FuzzTriangle t = fuzz_triangle(random, n % 7, width, height);
        const std::int64_t area = signed_area(t.x[0], t.y[0], t.x[1], t.y[1], t.x[2], t.y[2]);
        target.triangle(t.x, t.y);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const bool want = area != 0 && covers(t.x, t.y, area, x * 256 + 128, y * 256 + 128);
                wrong += target.at(x, y) != (want ? 1 : 0);
            }
        }
        target.clear();
    }
    return wrong;
}

} // namespace spangle::raster::test
