// Row D15: compares the samples that a primitive covers with brute force at their positions.
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_MULTISAMPLE

#include <algorithm>
#include <optional>

#include "tests/gl/raster/multisample.hpp"
#include "tests/unit/primitive/clipped_area.hpp"

namespace spangle::test::samples {
namespace {

/// The four positions are the pattern with which nearly all hardware draws.
TEST_F(Multisample, PositionsAreTheUsualOnes) {
    constexpr double usual[][2] = {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}};
    for (unsigned s = 0; s < raster::sample_count; ++s) {
        EXPECT_EQ(offset(s, false), usual[s][0]);
        EXPECT_EQ(offset(s, true), usual[s][1]);
    }
}

TEST_F(Multisample, TrianglesCoverTheSamplesInside) {
    Target target(4);
    for (int n = 0; n < 500; ++n) {
        std::array<double, 6> t;
        for (double& v : t) // every other vertex lies on rows and columns of samples
            v = n % 2 != 0 ? place() : below(size * 8) / 8.0;
        if (n % 3 == 0) // these modes have no effect on samples
            glEnable(GL_POLYGON_SMOOTH);
        glClear(GL_COLOR_BUFFER_BIT);
        glBegin(GL_TRIANGLES);
        for (unsigned i = 0; i < 3; ++i)
            glVertex2d(t[2 * i], t[2 * i + 1]);
        glEnd();
        ASSERT_EQ(drawn_counts(), counts([&](double x, double y) { return holds(t, x, y); })) << n;
    }
}

TEST_F(Multisample, PointsAreDiscs) {
    Target target(4);
    for (int n = 0; n < 300; ++n) {
        const double cx = place(), cy = place(), width = 1 + below(12 * 8) / 8.0;
        glClear(GL_COLOR_BUFFER_BIT);
        glPointSize(static_cast<GLfloat>(width));
        if (n % 2 != 0) // these modes have no effect on samples
            glEnable(GL_POINT_SMOOTH);
        glBegin(GL_POINTS);
        glVertex2d(cx, cy);
        glEnd();
        ASSERT_EQ(drawn_counts(), counts([&](double x, double y) {
                      return (x - cx) * (x - cx) + (y - cy) * (y - cy) <= width * width / 4;
                  }))
            << n;
    }
}

/// The vertices of a rectangle are snapped, so samples very close to its edge may be on either side.
void expect_rectangles(const std::vector<oracle::Polygon>& parts, const std::vector<int>& got, int trial) {
    constexpr double snap = 1.0 / 256;
    const auto count = [&](double margin) {
        return counts([&](double x, double y) {
            return std::any_of(parts.begin(), parts.end(), [&](const oracle::Polygon& part) {
                double least = 1e9;
                for (std::size_t i = 0; i < part.size(); ++i) {
                    const oracle::Point &a = part[i], &b = part[(i + 1) % part.size()];
                    const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
                    least = std::min(least, (dx * (y - a.y) - dy * (x - a.x)) / length);
                }
                return least >= margin;
            });
        });
    };
    const std::vector<int> inner = count(snap), outer = count(-snap);
    for (std::size_t p = 0; p < got.size(); ++p) {
        ASSERT_GE(got[p], inner[p]) << trial << " at " << p % size << ',' << p / size;
        ASSERT_LE(got[p], outer[p]) << trial << " at " << p % size << ',' << p / size;
    }
}

TEST_F(Multisample, LinesAreRectangles) {
    Target target(4);
    for (int n = 0; n < 300; ++n) {
        const double ax = place(), ay = place(), bx = place(), by = place(), width = 1 + below(9 * 8) / 8.0;
        glLineWidth(static_cast<GLfloat>(width));
        if (n % 2 != 0) // these modes have no effect on samples
            glEnable(GL_LINE_SMOOTH);
        const unsigned pattern = below(0x10000), factor = 1 + below(4);
        const bool stippled = n % 3 == 0;
        stippled ? glEnable(GL_LINE_STIPPLE) : glDisable(GL_LINE_STIPPLE);
        glLineStipple(static_cast<GLint>(factor), static_cast<GLushort>(pattern));
        glClear(GL_COLOR_BUFFER_BIT);
        glBegin(GL_LINES);
        glVertex2d(ax, ay);
        glVertex2d(bx, by);
        glEnd();
        std::vector<oracle::Polygon> parts;
        const double length = std::hypot(bx - ax, by - ay);
        const auto at = [&](double t) { return oracle::Point{ax + t * (bx - ax), ay + t * (by - ay)}; };
        for (unsigned i = 0; i < length; i += stippled ? 1 : size * 2)
            if (!stippled || (pattern >> (i / factor % 16) & 1) != 0)
                parts.push_back(oracle::rectangle(at(i / length),
                                                  at(stippled ? std::min(1.0, (i + 1) / length) : 1), width));
        expect_rectangles(parts, drawn_counts(), n);
    }
}

/// The stipple of a strip divides it: two complementary patterns draw every sample once.
TEST_F(Multisample, StippleRunsOnAlongAStrip) {
    Target target(4);
    glEnable(GL_LINE_STIPPLE);
    glLineWidth(3);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    for (int n = 0; n < 40; ++n) {
        GLfloat v[4];
        for (GLfloat& c : v)
            c = place();
        const unsigned pattern = below(0x10000);
        const auto strip = [&](unsigned bits) {
            glLineStipple(3, static_cast<GLushort>(bits));
            glBegin(GL_LINE_STRIP);
            glVertex2f(v[0], v[1]);
            glVertex2f((v[0] + v[2]) / 2, (v[1] + v[3]) / 2);
            glVertex2f(v[2], v[3]);
            glEnd();
        };
        const auto drawn = [&](auto draw) {
            glClear(GL_COLOR_BUFFER_BIT);
            glColor3f(0.25f, 0.25f, 0.25f);
            draw();
            return picture();
        };
        const Picture whole = drawn([&] { strip(0xFFFF); });
        ASSERT_EQ(drawn([&] { strip(pattern), strip(~pattern); }), whole) << n;
    }
}

TEST_F(Multisample, LinesHaveColoursAlongThemAndNotAcross) {
    Target target(4);
    glLineWidth(8);
    glBegin(GL_LINES);
    glColor3f(0, 0, 1);
    glVertex3f(4, 24, 0);
    glColor3f(1, 0, 1);
    glVertex3f(44, 24, -1);
    glEnd();
    const Picture got = picture();
    GLfloat depth = 0;
    for (int x = 4; x < 44; ++x) {
        for (int y = 20; y < 28; ++y) {
            const Rgba& pixel = got[static_cast<std::size_t>(y * size + x)];
            EXPECT_NEAR(pixel[0], 255 * (x + 0.5 - 4) / 40, 1.5) << x << ',' << y;
            EXPECT_EQ(pixel[2], 255);
        }
    }
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glBegin(GL_LINES);
    glVertex3f(4, 24, 0);
    glVertex3f(44, 24, -1);
    glEnd();
    glReadPixels(33, 24, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    EXPECT_NEAR(depth, (33 + offset(0, false) - 4) / 40, 1e-4); // the depth of the first sample
}

/// Bits of a bitmap are squares from the raster position on.
TEST_F(Multisample, BitmapsCoverTheSamplesInTheirSquares) {
    Target target(4);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (int n = 0; n < 200; ++n) {
        GLubyte bits[11];
        for (GLubyte& b : bits)
            b = static_cast<GLubyte>(below(256));
        const double x0 = 1 + below(30 * 256) / 256.0, y0 = 1 + below(30 * 256) / 256.0, ox = below(16) / 8.0,
                     oy = below(16) / 8.0;
        glClear(GL_COLOR_BUFFER_BIT);
        glRasterPos2d(x0, y0);
        glBitmap(8, 11, static_cast<GLfloat>(ox), static_cast<GLfloat>(oy), 0, 0, bits);
        ASSERT_EQ(drawn_counts(), counts([&](double x, double y) {
                      const int i = static_cast<int>(std::floor(x - (x0 - ox))),
                                j = static_cast<int>(std::floor(y - (y0 - oy)));
                      return i >= 0 && i < 8 && j >= 0 && j < 11 && (bits[j] >> (7 - i) & 1) != 0;
                  }))
            << n;
    }
}

/// A surface of the reference policy has samples, too, and the same are covered.
TEST_F(Multisample, PoliciesCoverTheSame) {
    std::optional<std::vector<int>> first;
    for (const EGLint precision : {EGL_PRECISION_EXACT_SPANGLE, EGL_PRECISION_FAST_SPANGLE}) {
        Target target(4, {EGL_PRECISION_SPANGLE, precision});
        random_.seed(9);
        glLineWidth(2.5f);
        glPointSize(6);
        for (int i = 0; i < 5; ++i) {
            glBegin(i % 2 != 0 ? GL_LINE_LOOP : GL_POINTS);
            for (int k = 0; k < 3; ++k)
                glVertex2f(place(), place());
            glEnd();
        }
        const std::vector<int> got = drawn_counts();
        if (first.has_value()) {
            EXPECT_EQ(got, *first);
        }
        first = got;
    }
}

} // namespace
} // namespace spangle::test::samples

#endif
