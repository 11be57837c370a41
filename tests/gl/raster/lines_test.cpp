// Row D05: draws strips of lines with XOR, so that a pixel drawn twice disappears (GL 1.3, 3.4.1, rules 3 and
// 4).
#include <algorithm>
#include <cmath>

#include "tests/gl/raster/window.hpp"

namespace spangle::test {
namespace {

class LineStrips : public Window {
  protected:
    using Point = std::array<GLfloat, 2>;

    /// Returns a strip in one of eight directions. Each line goes more along the strip's axis than across,
    /// and its ends lie on the n.8 grid.
    std::vector<Point> one_way(unsigned direction) {
        std::vector<Point> strip;
        double along = lot(1, 4), across = lot(16, size - 16.0);
        while (along < size - 1) {
            const double u = (direction & 1) != 0 ? size - along : along;
            const double v = (direction & 2) != 0 ? size - across : across;
            const auto grid = [](double c) { return static_cast<GLfloat>(std::floor(c * 256) / 256); };
            strip.push_back((direction & 4) != 0 ? Point{grid(v), grid(u)} : Point{grid(u), grid(v)});
            const double step = lot(0.02, direction < 4 ? 9 : 2.5);
            along += step;
            across = std::clamp(across + lot(-step, step) * 0.98, 2.0, size - 2.0);
        }
        return strip;
    }
    static void give(const std::vector<Point>& strip) {
        glEnableClientState(GL_VERTEX_ARRAY);
        glVertexPointer(2, GL_FLOAT, 0, strip.data());
        glDrawArrays(GL_LINE_STRIP, 0, static_cast<GLsizei>(strip.size()));
        glDisableClientState(GL_VERTEX_ARRAY);
    }
    static long count(const std::vector<bool>& on) { return std::count(on.begin(), on.end(), true); }
};

TEST_F(LineStrips, DrawEachPixelOnce) {
    glLogicOp(GL_XOR);
    for (unsigned n = 0; n < 400; ++n) {
        const auto strip = one_way(n % 8);
        const auto plain = covered([&] { give(strip); });
        EXPECT_GT(count(plain), size - 16) << n;
        glEnable(GL_COLOR_LOGIC_OP);
        EXPECT_EQ(covered([&] { give(strip); }), plain) << n;
        EXPECT_EQ(count(covered([&] { give(strip), give(strip); })), 0) << n;
        glDisable(GL_COLOR_LOGIC_OP);
    }
}

/// Drawn in the other direction, a strip differs only in the fragments at its ends: where a line ends no
/// fragment is drawn.
TEST_F(LineStrips, AreTheSameInBothDirections) {
    for (unsigned n = 0; n < 400; ++n) {
        auto strip = one_way(n % 8);
        const auto there = covered([&] { give(strip); });
        std::reverse(strip.begin(), strip.end());
        const auto back = covered([&] { give(strip); });
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const auto at_end = [&](const Point& end) {
                    return std::fabs(end[0] - x - 0.5f) <= 1 && std::fabs(end[1] - y - 0.5f) <= 1;
                };
                const auto i = static_cast<std::size_t>(y * size + x);
                EXPECT_TRUE(there[i] == back[i] || at_end(strip.front()) || at_end(strip.back()))
                    << n << " at " << x << ',' << y;
            }
    }
}

/// A line has as many columns as fragments along it, each as high as the line is wide. Widths to 16 are
/// whole, others are rounded (GL 1.3, 3.4.2).
TEST_F(LineStrips, HaveTheirWidths) {
    for (int eighths = 8; eighths <= 128; eighths += 3) {
        const int width = (eighths + 4) / 8;
        glLineWidth(static_cast<GLfloat>(eighths) / 8);
        for (const bool along_x : {true, false}) {
            const auto on = covered([&] {
                give({along_x ? Point{10.5f, 30.25f} : Point{30.25f, 10.5f},
                      along_x ? Point{50.5f, 37.75f} : Point{37.75f, 50.5f}});
            });
            EXPECT_EQ(count(on), 40 * width) << eighths;
        }
    }
}

} // namespace
} // namespace spangle::test
