// Row D13: the coverage of a pixel is that of the polygon, whatever the number of its vertices. The edges
// between the triangles of which it is painted are not visible (GL 1.3, 3.5.3).
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/gl/raster/window.hpp"
#include "tests/unit/primitive/clipped_area.hpp"

namespace spangle::test {
namespace {

class AntialiasPolygon : public Window {
  protected:
    void SetUp() override {
        Window::SetUp();
        glEnable(GL_POLYGON_SMOOTH);
        // Blending adds fragments, so a pixel that is drawn twice shows, and so does coverage that is missing
        // between two fragments.
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
    }
    using Corner = std::array<GLfloat, 2>;
    using Corners = std::vector<Corner>;

    /// Returns a polygon whose vertices lie on an ellipse, on the n.8 grid.
    Corners convex(unsigned n, double least, double most) {
        const double a = lot(least, most), b = lot(least, most), x = lot(24, 40), y = lot(24, 40),
                     tilt = lot(0, std::numbers::pi);
        std::vector<double> angles(n);
        for (double& angle : angles)
            angle = lot(0, 2 * std::numbers::pi);
        std::sort(angles.begin(), angles.end());
        Corners out;
        for (const double angle : angles) {
            const double u = a * std::cos(angle), v = b * std::sin(angle);
            const auto snapped = [](double at) { return static_cast<GLfloat>(std::round(at * 256) / 256); };
            out.push_back({snapped(x + u * std::cos(tilt) - v * std::sin(tilt)),
                           snapped(y + u * std::sin(tilt) + v * std::cos(tilt))});
        }
        return out;
    }
    static void give(GLenum mode, const Corners& corners) {
        glBegin(mode);
        for (const Corner& c : corners)
            glVertex2fv(c.data());
        glEnd();
    }
    static oracle::Polygon polygon(const Corners& corners) {
        oracle::Polygon out;
        for (const Corner& c : corners)
            out.push_back({c[0], c[1]});
        return out;
    }
    template <class Draw> static std::vector<Rgba> drawn(Draw draw) {
        clear();
        draw();
        return picture();
    }
    static void expect_areas(const std::vector<Rgba>& got, const oracle::Polygon& polygon, int trial,
                             double tolerance = 0.5 + 255.0 / 256) {
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const Rgba& pixel = got[static_cast<std::size_t>(y * size + x)];
                const double area = oracle::area_in(polygon, x, y);
                ASSERT_NEAR(pixel[3], 255 * area, tolerance) << trial << " at " << x << ',' << y;
                // Each pixel is drawn once, because its colour is the same everywhere.
                if (area > tolerance / 255) {
                    ASSERT_EQ(pixel[0], 128) << trial << " at " << x << ',' << y;
                } else {
                    ASSERT_TRUE(pixel[0] == 128 || pixel[0] == 0) << trial << " at " << x << ',' << y;
                }
            }
    }
    void gray() { glColor4f(128 / 255.0f, 0.25f, 0, 1); }
};

TEST_F(AntialiasPolygon, CoverageIsThePolygons) {
    gray();
    for (int n = 0; n < 250; ++n) {
        const unsigned corners = n % 5 == 0 ? 120 : 4 + random_() % 30;
        // Small polygons have more edges in a row than the rasterizer keeps.
        const Corners p = n % 3 == 0 ? convex(corners, 0.5, 3) : convex(corners, 3, 24);
        expect_areas(drawn([&] { give(GL_POLYGON, p); }), polygon(p), n);
    }
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

/// Arrays and lists draw the same polygon.
TEST_F(AntialiasPolygon, ArraysAndListsGiveTheSame) {
    gray();
    for (int n = 0; n < 30; ++n) {
        const Corners p = convex(9, 5, 24);
        const auto once = drawn([&] { give(GL_POLYGON, p); });
        std::vector<std::array<GLfloat, 3>> xyz;
        for (const Corner& c : p)
            xyz.push_back({c[0], c[1], 0});
        glEnableClientState(GL_VERTEX_ARRAY);
        if (n % 2 != 0)
            glVertexPointer(3, GL_FLOAT, 0, xyz.data());
        else
            glVertexPointer(2, GL_FLOAT, 0, p.data());
        EXPECT_EQ(drawn([&] { glDrawArrays(GL_POLYGON, 0, 9); }), once);
        const GLubyte indices[] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
        EXPECT_EQ(drawn([&] { glDrawElements(GL_POLYGON, 9, GL_UNSIGNED_BYTE, indices); }), once);
        glDisableClientState(GL_VERTEX_ARRAY);
        glNewList(1, GL_COMPILE);
        give(GL_POLYGON, p);
        glEndList();
        EXPECT_EQ(drawn([] { glCallList(1); }), once);
    }
}

TEST_F(AntialiasPolygon, QuadsAreWholesToo) {
    gray();
    for (int n = 0; n < 100; ++n) {
        const Corners p = convex(4, 5, 24);
        expect_areas(drawn([&] { give(GL_QUADS, p); }), polygon(p), n);
        expect_areas(drawn([&] { give(GL_QUAD_STRIP, {p[0], p[1], p[3], p[2]}); }), polygon(p), n);
    }
}

/// Quads of a strip, and polygons side by side, cover what they cover together. Each part of a pixel is
/// rounded once.
TEST_F(AntialiasPolygon, AbuttingOnesSumToOne) {
    glColor4f(0, 0, 0, 1);
    for (int n = 0; n < 60; ++n) {
        const GLfloat split = static_cast<GLfloat>(lot(20, 44)), bend = static_cast<GLfloat>(lot(20, 44));
        const auto got = drawn([&] {
            if (n % 2 != 0) {
                give(GL_QUAD_STRIP, {{4, 4}, {4, 60}, {split, 4}, {bend, 60}, {60, 4}, {60, 60}});
                return;
            }
            const GLfloat x = (split + bend) / 2, y = split;
            give(GL_POLYGON, {{4, 4}, {split, 4}, {x, y}, {bend, 60}, {4, 60}, {4, 32}});
            give(GL_POLYGON, {{split, 4}, {60, 4}, {60, 32}, {60, 60}, {bend, 60}, {x, y}});
        });
        for (int y = 4; y < 60; ++y)
            for (int x = 4; x < 60; ++x)
                ASSERT_GE(got[static_cast<std::size_t>(y * size + x)][3], 254) << n << ' ' << x << ',' << y;
    }
}

/// Polygons are clipped by a plane of the user and by the sides of the view volume.
TEST_F(AntialiasPolygon, ClippedPolygons) {
    gray();
    for (int n = 0; n < 100; ++n) {
        Corners p = convex(5 + random_() % 30, 8, 24);
        if (n % 4 == 0) // corners lie far beyond the window
            for (Corner& c : p)
                c = {(c[0] - 32) * 400 + 32, (c[1] - 32) * 400 + 32};
        const double angle = lot(0, 2 * std::numbers::pi), a = std::cos(angle), b = std::sin(angle),
                     c = -a * lot(24, 40) - b * lot(24, 40);
        const GLdouble plane[] = {a, b, 0, c};
        glClipPlane(GL_CLIP_PLANE2, plane);
        glEnable(GL_CLIP_PLANE2);
        const auto got = drawn([&] { give(GL_POLYGON, p); });
        glDisable(GL_CLIP_PLANE2);
        // Vertices that the plane makes are snapped, so the edge is off by up to half a subpixel.
        expect_areas(got, oracle::clipped(polygon(p), a, b, c), n, 2.1);
    }
}

/// Inside of a polygon, colour, depth and side are those without antialiasing.
TEST_F(AntialiasPolygon, InsideNothingChanges) {
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glEnable(GL_LIGHT0);
    const GLfloat front[] = {0.2f, 0.9f, 0.4f, 1}, back[] = {0.8f, 0.1f, 0.6f, 1};
    glMaterialfv(GL_FRONT, GL_EMISSION, front);
    glMaterialfv(GL_BACK, GL_EMISSION, back);
    for (int n = 0; n < 120; ++n) {
        Corners p = convex(5 + random_() % 12, 10, 24);
        if (n % 2 != 0)
            std::reverse(p.begin(), p.end());
        glShadeModel(n % 3 == 0 ? GL_FLAT : GL_SMOOTH);
        (n % 5 < 2 ? glEnable : glDisable)(GL_LIGHTING);
        glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, n % 5 == 0);
        (n % 7 == 0 ? glEnable : glDisable)(GL_CULL_FACE);
        (n % 6 == 0 ? glEnable : glDisable)(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(0, 40);
        glPolygonMode(GL_BACK, n % 11 == 1 ? GL_LINE : GL_FILL);
        const auto draw = [&] {
            std::mt19937 color(static_cast<unsigned>(n));
            glBegin(GL_POLYGON);
            for (const Corner& c : p) {
                glColor3ub(static_cast<GLubyte>(color()), static_cast<GLubyte>(color()), 77);
                glVertex3f(c[0], c[1], -(c[0] + c[1]) / 256 - 0.1f);
            }
            glEnd();
        };
        glDisable(GL_POLYGON_SMOOTH);
        const auto hard = drawn(draw);
        const auto hard_z = depths();
        glEnable(GL_POLYGON_SMOOTH);
        const auto soft = drawn(draw);
        const auto soft_z = depths();
        const oracle::Polygon outline = polygon(p);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                if (oracle::area_in(outline, x, y) < 1)
                    continue;
                const auto i = static_cast<std::size_t>(y * size + x);
                for (std::size_t c = 0; c < 4; ++c)
                    ASSERT_NEAR(soft[i][c], hard[i][c], 1) << n << ' ' << x << ',' << y;
                ASSERT_NEAR(static_cast<double>(soft_z[i]), static_cast<double>(hard_z[i]), 1) << n;
            }
    }
}

/// Facing is that of the whole polygon, and each vertex has the material that was current when it was given.
TEST_F(AntialiasPolygon, MaterialsChangeFromVertexToVertex) {
    glDisable(GL_BLEND);
    glEnable(GL_LIGHTING);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    const Corners p = {{10, 10}, {12, 40}, {20, 50}, {50, 48}, {54, 14}}; // clockwise, so the back is seen
    const auto draw = [&] {
        glBegin(GL_POLYGON);
        GLfloat level = 0.1f;
        for (const Corner& c : p) {
            const GLfloat emission[] = {level, 1 - level, 0.5f, 1};
            glMaterialfv(GL_BACK, GL_EMISSION, emission);
            glVertex2fv(c.data());
            level += 0.2f;
        }
        glEnd();
    };
    const auto soft = drawn(draw);
    glDisable(GL_POLYGON_SMOOTH);
    const auto hard = drawn(draw);
    const oracle::Polygon outline = polygon(p);
    for (int i = 0; i < size * size; ++i)
        if (oracle::area_in(outline, i % size, i / size) == 1) {
            ASSERT_NEAR(soft[static_cast<std::size_t>(i)][0], hard[static_cast<std::size_t>(i)][0], 1) << i;
        }
}

/// Vertices that triangles of a folded strip share have the colours of the front in one and of the back in
/// another.
TEST_F(AntialiasPolygon, FoldedStripsShareTheirCorners) {
    glEnable(GL_LIGHTING);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    const GLfloat front[] = {0.2f, 0.9f, 0.4f, 1}, back[] = {0.8f, 0.1f, 0.6f, 1};
    glMaterialfv(GL_FRONT, GL_EMISSION, front);
    glMaterialfv(GL_BACK, GL_EMISSION, back);
    for (int n = 0; n < 40; ++n) {
        Corners p(6);
        for (Corner& c : p)
            c = {place(), place()};
        const auto strip = drawn([&] { give(GL_TRIANGLE_STRIP, p); });
        const auto one_by_one = drawn([&] {
            for (std::size_t i = 0; i < 4; ++i)
                give(GL_TRIANGLES, {p[i + i % 2], p[i + 1 - i % 2], p[i + 2]});
        });
        ASSERT_EQ(strip, one_by_one) << n;
    }
}

/// Without memory for its vertices a polygon is not drawn, and an error reports it.
TEST_F(AntialiasPolygon, TooManyCornersForTheArena) {
    gray();
    glBegin(GL_POLYGON);
    for (int i = 0; i < 1 << 20; ++i)
        glVertex2f(static_cast<GLfloat>(10 + i % 2), static_cast<GLfloat>(20 + i % 3));
    glEnd();
    EXPECT_EQ(glGetError(), GLenum{GL_OUT_OF_MEMORY});
    const Corners p = convex(7, 8, 24);
    expect_areas(drawn([&] { give(GL_POLYGON, p); }), polygon(p), 0); // the next polygon is drawn as usual
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

} // namespace
} // namespace spangle::test
