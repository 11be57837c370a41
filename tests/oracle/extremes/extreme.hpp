// Shared parts of the extreme cases: vertices in every type, exact coverage, and a row of the page.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "tests/oracle/extremes/screen.hpp"
#include "tests/support/random.hpp"

namespace spangle::test {

enum class Form { of_float, of_double, of_fixed, of_int };
inline constexpr Form forms[] = {Form::of_float, Form::of_double, Form::of_fixed, Form::of_int};
inline constexpr Form fractions[] = {Form::of_float, Form::of_double, Form::of_fixed};

inline GLfixed fixed(double v) {
    return static_cast<GLfixed>(std::clamp(std::nearbyint(v * 65536), -2147483648.0, 2147483647.0));
}
inline GLint whole(double v) {
    return static_cast<GLint>(std::clamp(std::nearbyint(v), -2147483648.0, 2147483647.0));
}

using Place = std::array<double, 4>; ///< a vertex as x, y, z, w

inline void vertex(Form form, const Place& v) {
    const auto f = [&](std::size_t i) { return static_cast<GLfloat>(v[i]); };
    switch (form) {
    case Form::of_float:
        return glVertex4f(f(0), f(1), f(2), f(3));
    case Form::of_double:
        return glVertex4d(v[0], v[1], v[2], v[3]);
    case Form::of_fixed:
        return glVertex4xOES(fixed(v[0]), fixed(v[1]), fixed(v[2]), fixed(v[3]));
    case Form::of_int:
        return glVertex4i(whole(v[0]), whole(v[1]), whole(v[2]), whole(v[3]));
    }
}
template <std::size_t N> void polygon(Form form, GLenum mode, const std::array<Place, N>& v) {
    glBegin(mode);
    for (const Place& place : v)
        vertex(form, place);
    glEnd();
}
inline void rectangle(double x0, double y0, double x1, double y1, double z = 0) {
    polygon(Form::of_float, GL_QUADS,
            std::array<Place, 4>{{{x0, y0, z, 1}, {x1, y0, z, 1}, {x1, y1, z, 1}, {x0, y1, z, 1}}});
}

/// A place of the window and a triangle of clip coordinates. The place is inside if (x, y, 1) is a sum of the
/// corners with factors that are not negative (GL 1.3, 2.11 and 3.5.1).
struct Seen {
    bool inside;
    double distance; ///< distance to the next edge in pixels
};
inline Seen seen(const std::array<Place, 3>& v, int px, int py, int size = side) {
    using Row = std::array<long double, 3>;
    Row edge[3];
    const auto at = [&](std::size_t i) {
        return Row{static_cast<long double>(v[i][0]), static_cast<long double>(v[i][1]),
                   static_cast<long double>(v[i][3])};
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const Row a = at((i + 1) % 3), b = at((i + 2) % 3);
        edge[i] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }
    const Row first = at(0);
    const long double volume = edge[0][0] * first[0] + edge[0][1] * first[1] + edge[0][2] * first[2];
    const long double x = (2 * px + 1.0L) / size - 1, y = (2 * py + 1.0L) / size - 1;
    Seen out{volume != 0, 1e9};
    for (const Row& e : edge) {
        const long double side_of = e[0] * x + e[1] * y + e[2];
        out.inside = out.inside && (side_of > 0) == (volume > 0);
        const long double slope = std::hypot(e[0], e[1]);
        if (slope != 0)
            out.distance =
                std::fmin(out.distance, static_cast<double>(std::fabs(side_of) / slope * size / 2));
    }
    return out;
}

/// Counts differences between pictures and formulas, and the fragments of the formulas.
struct Tally {
    long fragments = 0, wrong = 0;
    /// Compares `drawn` with a place. Closer to an edge than half a step of the grid of 1/256 pixel, both
    /// results are right.
    void count(bool drawn, const Seen& place, double grid = 1.0 / 128) {
        fragments += place.inside ? 1 : 0;
        wrong += drawn != place.inside && place.distance > grid ? 1 : 0;
    }
    void count(const Picture& picture, const std::array<Place, 3>& v) {
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                count(picture[static_cast<std::size_t>(y * side + x)][0] != 0, seen(v, x, y));
    }
};

/// Returns twice the area of a triangle in 256ths of a pixel, exactly.
inline std::int64_t area(const std::array<std::int64_t, 2>& a, const std::array<std::int64_t, 2>& b,
                         const std::array<std::int64_t, 2>& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
/// Returns 1 if the centre of the pixel is inside, 0 on the outline, and -1 outside.
inline int covers(const std::array<std::array<std::int64_t, 2>, 3>& v, int px, int py) {
    const std::array<std::int64_t, 2> center{px * 256 + 128, py * 256 + 128};
    const std::int64_t whole_area = area(v[0], v[1], v[2]);
    if (whole_area == 0)
        return -1;
    bool touches = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::int64_t part = area(v[i], v[(i + 1) % 3], center);
        if (part != 0 && (part > 0) != (whole_area > 0))
            return -1;
        touches = touches || part == 0;
    }
    return touches ? 0 : 1;
}

/// Prints the row of docs/extremes.md that belongs to the running test.
[[gnu::format(printf, 3, 4)]] inline void row(const char* required, const char* judged, const char* observed,
                                              ...) {
    std::array<char, 400> text{};
    va_list arguments;
    va_start(arguments, observed);
    std::vsnprintf(text.data(), text.size(), observed, arguments);
    va_end(arguments);
    std::printf("| %s | %s | %s | %s |\n", testing::UnitTest::GetInstance()->current_test_info()->name(),
                required, judged, text.data());
}

} // namespace spangle::test
