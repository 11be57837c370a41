// Compares antialiased figures with areas in double, and with Mesa. What Mesa draws is known pixel by pixel,
// so nothing else may differ. Its points are the pixels whose centres lie in the disc, of radius 1 at least.
// Its lines have ramps of one pixel along their sides and ends, and are fainter if they are shorter than
// that. Its polygons are not antialiased.
#include <cmath>
#include <numbers>

#include <spangle/GL/gl.h>

#include "tests/oracle/mesa/mesa_planes.hpp"
#include "tests/oracle/mesa/smooth_states.hpp"
#include "tests/support/headless_gl.hpp"
#include "tests/unit/primitive/clipped_area.hpp"

namespace spangle::oracle {
namespace {

constexpr int alpha = 3;
/// In 255ths: an area that is off by 1/256, rounded.
constexpr double tolerance = 0.5 + 255.0 / 256;
/// The error of a product of two ramps in floats, in 255ths.
constexpr double rounding = 1.5;

SmoothFigure unsmoothed; ///< drawn by a family of one drawing

struct SmoothFigures : testing::Test {
    test::HeadlessGl current{
        state_size, state_size, {EGL_STENCIL_SIZE, 8, EGL_PRECISION_SPANGLE, EGL_PRECISION_EXACT_SPANGLE}};

    /// area(figure, x, y) is the true area in a pixel. mesa(figure, drawing, x, y) is Mesa's, from 0 to 1.
    template <class Area, class Mesa> static void compare(int which, int corners, Area area, Mesa mesa) {
        const Family& family = smooth_families()[static_cast<std::size_t>(which)];
        const Planes theirs = draw_with_mesa(family, 0, family.drawings);
        ASSERT_EQ(theirs.size(), bytes_of_drawing * static_cast<std::size_t>(family.drawings));
        double worst = 0, worst_of_mesa = 0;
        for (int n = 0; n < family.drawings; ++n) {
            const Planes ours = draw_state(family, n).planes;
            const SmoothFigure it = smooth_figure(n, corners);
            for (int i = 0; i < state_size * state_size; ++i) {
                const int x = i % state_size, y = i / state_size;
                const auto at = static_cast<std::size_t>(i) * pixel_channels + alpha;
                const double off = std::fabs(ours[at] - 255 * area(it, x, y)),
                             off_of_mesa =
                                 std::fabs(theirs[bytes_of_drawing * static_cast<std::size_t>(n) + at] -
                                           255 * mesa(it, n, x, y));
                worst = std::max(worst, off);
                worst_of_mesa = std::max(worst_of_mesa, off_of_mesa);
                ASSERT_LE(off, tolerance) << "drawing " << n << ", pixel " << x << ' ' << y;
                ASSERT_LE(off_of_mesa, rounding) << "drawing " << n << ", pixel " << x << ' ' << y;
            }
        }
        std::printf("%s: off by %.2f of 255 at most, Mesa's from what is known of it by %.2f\n", family.id,
                    worst, worst_of_mesa);
    }
};

double between_0_and_1(double v) {
    return std::fmin(1, std::fmax(0, v));
}

TEST_F(SmoothFigures, Points) {
    compare(
        0, 1,
        [](const SmoothFigure& it, int x, int y) {
            const auto& [cx, cy] = it.corner[0];
            const double r = it.point_size / 2, away = std::hypot(x + 0.5 - cx, y + 0.5 - cy);
            if (std::fabs(away - r) > 1) // farther than the corners of a pixel
                return away < r ? 1.0 : 0.0;
            constexpr int fine = 4096;
            Polygon circle;
            for (int i = 0; i < fine; ++i)
                circle.push_back({cx + r * std::cos(2 * std::numbers::pi * i / fine),
                                  cy + r * std::sin(2 * std::numbers::pi * i / fine)});
            return area_in(circle, x, y);
        },
        [](const SmoothFigure& it, int, int x, int y) {
            const double r = std::fmax(it.point_size / 2, 1);
            return std::hypot(x + 0.5 - it.corner[0].x, y + 0.5 - it.corner[0].y) <= r ? 1.0 : 0.0;
        });
}

TEST_F(SmoothFigures, Lines) {
    compare(
        1, 2,
        [](const SmoothFigure& it, int x, int y) {
            return area_in(
                rectangle({it.corner[0].x, it.corner[0].y}, {it.corner[1].x, it.corner[1].y}, it.line_width),
                x, y);
        },
        [](const SmoothFigure& it, int, int x, int y) {
            const auto& [ax, ay] = it.corner[0];
            const auto& [bx, by] = it.corner[1];
            const double length = std::hypot(bx - ax, by - ay), px = x + 0.5 - (ax + bx) / 2,
                         py = y + 0.5 - (ay + by) / 2;
            const double along = std::fabs(px * (bx - ax) + py * (by - ay)) / length,
                         aside = std::fabs(py * (bx - ax) - px * (by - ay)) / length;
            const double faint = length < 1 ? 2 * length / (length + 1) : 1;
            return faint * between_0_and_1(it.line_width / 2 + 0.5 - aside) *
                   between_0_and_1(length / 2 + 0.5 - along);
        });
}

/// Mesa's polygons are those that Spangle draws without antialiasing.
TEST_F(SmoothFigures, Polygons) {
    Planes aliased;
    int drawn = -1;
    compare(
        2, 3,
        [](const SmoothFigure& it, int x, int y) {
            const auto& c = it.corner;
            return area_in({{c[0].x, c[0].y}, {c[1].x, c[1].y}, {c[2].x, c[2].y}}, x, y);
        },
        [&](const SmoothFigure& it, int n, int x, int y) {
            if (drawn != n) {
                const Family hard = {"", 1, 0, 0, [](test::Random&, Quads&) {
                                         glClear(GL_COLOR_BUFFER_BIT);
                                         glBegin(GL_TRIANGLES);
                                         for (const auto& corner : unsmoothed.corner)
                                             glVertex2d(corner.x, corner.y);
                                         glEnd();
                                     }};
                unsmoothed = it;
                aliased = draw_state(hard, n).planes;
                drawn = n;
            }
            return aliased[static_cast<std::size_t>(y * state_size + x) * pixel_channels + alpha] / 255.0;
        });
}

} // namespace
} // namespace spangle::oracle
