// Row D12: tests depth offsets of polygons (GL 1.3, 3.5.5).
#include <cmath>

#include "tests/gl/raster/window.hpp"

namespace spangle::test {
namespace {

constexpr double codes = 16777215;
constexpr int codes_of_unit = 2; ///< the minimum resolvable difference of 24 bits

class PolygonOffset : public Window {
  protected:
    void SetUp() override {
        Window::SetUp();
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_ALWAYS);
    }
    /// A plane of depth through the corners of a quad.
    struct Plane {
        double at, dx, dy;
        double depth(double x, double y) const { return at + dx * x + dy * y; }
    };
    static void quad(const Plane& plane, double low = 8, double high = 56) {
        const double corner[4][2] = {{low, low}, {high, low}, {high, high}, {low, high}};
        for (const auto& c : corner)
            glVertex3d(c[0], c[1], -plane.depth(c[0], c[1]));
    }
    static void draw(const Plane& plane) {
        clear();
        glBegin(GL_QUADS);
        quad(plane);
        glEnd();
    }
    static int difference(GLuint a, GLuint b) { return static_cast<int>(a) - static_cast<int>(b); }
};

/// An offset of n units moves each fragment of a level polygon by exactly 2 n codes.
TEST_F(PolygonOffset, UnitsAreTwoCodes) {
    glEnable(GL_POLYGON_OFFSET_FILL);
    for (const int units : {0, 1, 2, -1, -7, 1000, -5000}) {
        const Plane level{lot(0.2, 0.8), 0, 0};
        glPolygonOffset(0, 0);
        draw(level);
        const auto before = depths();
        glPolygonOffset(3, static_cast<GLfloat>(units)); // without a slope the factor has no effect
        draw(level);
        const auto after = depths();
        for (int y = 8; y < 56; ++y)
            for (int x = 8; x < 56; ++x)
                ASSERT_EQ(difference(after[y * size + x], before[y * size + x]), codes_of_unit * units);
    }
}

TEST_F(PolygonOffset, FactorsMultiplyTheLargerSlope) {
    glEnable(GL_POLYGON_OFFSET_FILL);
    for (int n = 0; n < 200; ++n) {
        const Plane plane{0.5, lot(-0.002, 0.002), lot(-0.002, 0.002)};
        const double factor = lot(-8, 8), units = std::floor(lot(-50, 50));
        glPolygonOffset(0, 0);
        draw(plane);
        const auto before = depths();
        glPolygonOffset(static_cast<GLfloat>(factor), static_cast<GLfloat>(units));
        draw(plane);
        const auto after = depths();
        const double expected =
            factor * std::fmax(std::fabs(plane.dx), std::fabs(plane.dy)) * codes + codes_of_unit * units;
        for (int y = 8; y < 56; y += 5)
            for (int x = 8; x < 56; x += 3)
                ASSERT_NEAR(difference(after[y * size + x], before[y * size + x]), expected,
                            1.5 + std::fabs(factor)) // the margin, because corners are rounded to Q0.30
                    << n;
    }
}

/// The slope of a polygon is that of its plane, however small the polygon is.
TEST_F(PolygonOffset, SlopesOfSmallPolygons) {
    glEnable(GL_POLYGON_OFFSET_FILL);
    for (const double side : {1., 1.25, 2., 3., 5., 8., 12., 20., 60.})
        for (int n = 0; n < 30; ++n) {
            const double steep = 0.1 / side;
            const Plane plane{0.5, lot(-steep, steep) / 8, lot(-steep, steep) / 8};
            const double factor = lot(-8, 8), low = side < 30 ? 20 : 2;
            const auto drawn = [&](double times) {
                glPolygonOffset(static_cast<GLfloat>(times), 0);
                clear();
                glBegin(GL_QUADS);
                quad(plane, low, low + side);
                glEnd();
                return depths();
            };
            const auto before = drawn(0), after = drawn(factor);
            const double expected = factor * std::fmax(std::fabs(plane.dx), std::fabs(plane.dy)) * codes;
            int fragments = 0;
            for (std::size_t i = 0; i < after.size(); ++i)
                if (before[i] != codes) {
                    ++fragments;
                    ASSERT_NEAR(difference(after[i], before[i]), expected, 1.5 + std::fabs(factor)) << side;
                }
            EXPECT_GE(fragments, static_cast<int>(side) * static_cast<int>(side));
        }
}

/// Depth 1 is the largest code, 2^24 - 1. Offsets of nearly the whole range are right in the mean of many.
TEST_F(PolygonOffset, SlopesAreFractionsOfTheLargestCode) {
    glEnable(GL_POLYGON_OFFSET_FILL);
    double sum = 0;
    int fragments = 0;
    for (int n = 0; n < 1000; ++n) {
        const Plane plane{lot(0.02, 0.03), lot(0.0005, 0.0009), lot(-0.0001, 0.0001)};
        const auto factor = static_cast<GLfloat>(0.9 / plane.dx);
        glPolygonOffset(0, 0);
        draw(plane);
        const auto before = depths();
        glPolygonOffset(factor, 0);
        draw(plane);
        const auto after = depths();
        const double expected = double{factor} * plane.dx * codes;
        for (int y = 8; y < 56; y += 5)
            for (int x = 8; x < 56; x += 3, ++fragments)
                sum += difference(after[y * size + x], before[y * size + x]) - expected;
    }
    EXPECT_NEAR(sum / fragments, 0, 0.3);
}

/// Each fragment is clamped by itself, so the rest of the polygon keeps its slope.
TEST_F(PolygonOffset, FragmentsAreClamped) {
    const Plane plane{0, 1.0 / size, 0};
    draw(plane);
    const auto before = depths();
    glEnable(GL_POLYGON_OFFSET_FILL);
    for (const double units : {0.2 * codes, -0.2 * codes, 3e9, -3e9, 3e38, -3e38}) {
        glPolygonOffset(0, static_cast<GLfloat>(units));
        draw(plane);
        const auto after = depths();
        for (int y = 8; y < 56; ++y)
            for (int x = 8; x < 56; ++x) {
                const double moved = before[y * size + x] + codes_of_unit * units;
                ASSERT_NEAR(after[y * size + x], std::fmin(std::fmax(moved, 0), codes), 1) << units;
            }
    }
    glPolygonOffset(3e38f, 0);
    draw(plane);
    EXPECT_EQ(depths()[30 * size + 30], static_cast<GLuint>(codes));
}

/// The three modes of polygons have three enables. Primitives that are lines and points have no offset.
TEST_F(PolygonOffset, EachModeHasItsEnable) {
    constexpr GLenum enables[] = {GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT};
    constexpr GLenum modes[] = {GL_FILL, GL_LINE, GL_POINT};
    const Plane plane{0.25, 0.001, 0.002};
    glPolygonOffset(2, 100);
    const double expected = 2 * 0.002 * codes + codes_of_unit * 100;
    for (int on = 0; on < 3; ++on)
        for (int mode = 0; mode < 3; ++mode) {
            glPolygonMode(GL_FRONT_AND_BACK, modes[mode]);
            glDisable(enables[on]);
            draw(plane);
            const auto before = depths();
            glEnable(enables[on]);
            draw(plane);
            const auto after = depths();
            glDisable(enables[on]);
            int drawn = 0;
            for (std::size_t i = 0; i < after.size(); ++i)
                if (before[i] != codes) {
                    ++drawn;
                    ASSERT_NEAR(difference(after[i], before[i]), on == mode ? expected : 0, 4) << on << mode;
                }
            EXPECT_GT(drawn, mode == 2 ? 3 : 100);
        }
    for (const GLenum enable : enables)
        glEnable(enable);
    for (const GLenum primitive : {GL_POINTS, GL_LINE_LOOP}) {
        clear();
        glBegin(primitive);
        quad({0.5, 0, 0}, 8.5, 50.5);
        glEnd();
        EXPECT_EQ(depths()[8 * size + 8], static_cast<GLuint>(codes / 2 + 0.5));
    }
}

TEST_F(PolygonOffset, StencilSeesTheOffsetDepth) {
    glPolygonOffset(0, 5);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glEnable(GL_STENCIL_TEST);
    const Plane level{0.5, 0, 0};
    draw(level);
    glDepthFunc(GL_LESS);
    glPolygonOffset(0, 4);
    glBegin(GL_QUADS);
    quad(level, 16, 32);
    glEnd();
    glPolygonOffset(0, 6);
    glBegin(GL_QUADS);
    quad(level, 32, 48);
    glEnd();
    const auto z = depths();
    EXPECT_EQ(difference(z[20 * size + 20], z[40 * size + 40]), -codes_of_unit);
}

/// Tests the definition of the minimum resolvable difference r (GL 1.3, 3.5.5). A polygon may lie anywhere
/// between the near plane and one that is infinitely far away. A polygon that is nearer by r in window depth,
/// as floats give it, must be in front of it.
TEST_F(PolygonOffset, FloatsThatDifferByOneUnitAreDistinct) {
    static const GLfloat near_1_far_infinity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -2, 0};
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(near_1_far_infinity);
    const auto at = [](double distance) { // draws a quad that fills the window
        clear();
        glBegin(GL_QUADS);
        for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
            glVertex3d(x * distance, y * distance, -distance);
        glEnd();
        return depths()[0];
    };
    constexpr double r = codes_of_unit / codes;
    for (int n = 0; n < 2000; ++n) {
        // The first rounds are near the near plane.
        const double window = n < 1000 ? n * r : lot(0, 1 - 4 * r);
        const double distance = 1 / (1 - window), farther = 1 / (1 - window - r);
        const double rounded = double{static_cast<float>(distance)};
        // Finds the next float that is at least r farther away.
        auto next = static_cast<float>(farther);
        while (1 / rounded - 1 / double{next} < r)
            next = std::nextafter(next, 1e30f);
        ASSERT_LT(at(rounded), at(double{next})) << n;
    }
    // One code is less than what separates floats here: neighbours are two codes apart.
    EXPECT_EQ(difference(at(1 + 0x1p-23), at(1)), 2);
}

/// With sixteen bits r is one code. Slopes are those of depths in codes of 65535, not of 65536.
TEST(PolygonOffset16, CodesAndSlopes) {
    const HeadlessGl gl(64, 64, {EGL_DEPTH_SIZE, 16});
    GLint bits = 0;
    glGetIntegerv(GL_DEPTH_BITS, &bits);
    ASSERT_EQ(bits, 16);
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, 64, 0, 64, 0, 1);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glEnable(GL_POLYGON_OFFSET_FILL);
    const auto code = [](GLfloat factor, GLfloat units, double slope) {
        glPolygonOffset(factor, units);
        glBegin(GL_QUADS);
        for (const auto& [x, y] : {std::pair{0, 0}, {64, 0}, {64, 64}, {0, 64}})
            glVertex3d(x, y, -slope * x);
        glEnd();
        GLushort depth = 0;
        glReadPixels(0, 32, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, &depth);
        return int{depth};
    };
    for (const int units : {1, 2, 77, 30000})
        EXPECT_EQ(code(0, static_cast<GLfloat>(units), 0), units);
    // The centre of the first pixel lies half a step of the slope behind the edge, where depth is 0. A slope
    // in 65536ths in place of 65535ths would end one code behind.
    for (const int factor : {40, 50, 62})
        EXPECT_EQ(code(static_cast<GLfloat>(factor), 0, 1. / 64), std::lround((factor + 0.5) / 64 * 65535));
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

} // namespace
} // namespace spangle::test
