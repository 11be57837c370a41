// Row C13: tests clipping by the view volume if the viewport is not the whole window (GL 1.3, 2.10.1 and
// 2.11).
#include <cmath>

#include "tests/gl/raster/window.hpp"

namespace spangle::test {
namespace {

struct Box {
    int x, y, w, h;
    bool holds(int px, int py) const { return px >= x && py >= y && px < x + w && py < y + h; }
};

/// Object coordinates are pixels of the window, whatever the viewport is; the view volume is the viewport's.
class Viewport : public Window {
  protected:
    static constexpr Box some{20, 9, 25, 40};

    static void set(const Box& box) {
        glViewport(box.x, box.y, box.w, box.h);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        if (box.w != 0 && box.h != 0)
            glOrtho(box.x, box.x + box.w, box.y, box.y + box.h, 0, 1);
        glMatrixMode(GL_MODELVIEW);
    }
    static int count(const std::vector<bool>& pixels) {
        return static_cast<int>(std::count(pixels.begin(), pixels.end(), true));
    }
    static bool at(const std::vector<bool>& pixels, int x, int y) {
        return pixels[static_cast<std::size_t>(y * size + x)];
    }
    /// Checks that exactly the pixels of a box are drawn.
    static void expect_box(const std::vector<bool>& pixels, const Box& box) {
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                ASSERT_EQ(at(pixels, x, y), box.holds(x, y)) << x << ',' << y;
    }
    static void everywhere(GLenum mode = GL_QUADS) {
        glBegin(mode);
        for (const auto& [x, y] : {std::pair{-70, -70}, {200, -70}, {200, 200}, {-70, 200}})
            glVertex2i(x, y);
        glEnd();
    }
    static void line(double ax, double ay, double bx, double by) {
        glBegin(GL_LINES);
        glVertex2d(ax, ay);
        glVertex2d(bx, by);
        glEnd();
    }
    static void dot(double x, double y) {
        glBegin(GL_POINTS);
        glVertex2d(x, y);
        glEnd();
    }
    struct Corner {
        GLfloat x, y;
    };
    Corner corner() {
        return {static_cast<GLfloat>(std::floor(lot(-60, 130) * 256) / 256),
                static_cast<GLfloat>(std::floor(lot(-60, 130) * 256) / 256)};
    }
};

/// This case was a bug: two thirds of what was drawn lay outside of the viewport.
TEST(ViewportAlone, AQuadEndsAtAViewportWithinTheSurface) {
    const HeadlessGl gl(256, 256);
    glClear(GL_COLOR_BUFFER_BIT);
    glViewport(20, 30, 50, 60);
    glBegin(GL_QUADS);
    for (const auto& [x, y] : {std::pair{-3, -3}, {3, -3}, {3, 3}, {-3, 3}})
        glVertex2i(x, y);
    glEnd();
    std::vector<Rgba> pixels(256 * 256);
    glReadPixels(0, 0, 256, 256, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    const Box box{20, 30, 50, 60};
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            ASSERT_EQ(pixels[static_cast<std::size_t>(y * 256 + x)][0] != 0, box.holds(x, y))
                << x << ',' << y;
}

/// Draws each kind of polygon, flat or not, with depth and blending: as tiles, trapezoids and rows.
TEST_F(Viewport, PolygonsOfAllKindsEndThere) {
    set(some);
    for (const GLenum mode : {GL_QUADS, GL_POLYGON, GL_TRIANGLE_FAN, GL_QUAD_STRIP, GL_TRIANGLE_STRIP}) {
        const auto pixels = covered([&] { everywhere(mode); });
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                ASSERT_FALSE(at(pixels, x, y) && !some.holds(x, y)) << x << ',' << y;
        if (mode != GL_QUAD_STRIP && mode != GL_TRIANGLE_STRIP) // strips cross themselves here
            expect_box(pixels, some);
    }
}

/// Compares clipping with brute force: a centre is covered if it is in the polygon and in the viewport.
/// Centres within 1/256 pixel of an edge are not compared, because of snapping.
TEST_F(Viewport, TrianglesCoverWhatTheirClippedPolygonsCover) {
    const Box boxes[] = {some, {0, 0, size, 20}, {-30, 10, 70, 5}, {63, 0, 1, 64}, {7, 7, 1, 1}};
    for (const Box& box : boxes) {
        set(box);
        int inside = 0, outside = 0;
        for (int n = 0; n < 300; ++n) {
            const Corner c[3] = {corner(), corner(), corner()};
            if (n % 7 == 0)
                glShadeModel(n % 2 == 0 ? GL_FLAT : GL_SMOOTH);
            const auto pixels = covered([&] {
                glBegin(GL_TRIANGLES);
                for (const Corner& v : c)
                    glVertex2f(v.x, v.y);
                glEnd();
            });
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    double least = 1e9;
                    int signs = 0;
                    for (int i = 0; i < 3; ++i) {
                        const Corner &a = c[i], &b = c[(i + 1) % 3];
                        const double side = (b.x - a.x) * (y + 0.5 - a.y) - (b.y - a.y) * (x + 0.5 - a.x);
                        least = std::fmin(least, std::fabs(side) / std::hypot(b.x - a.x, b.y - a.y));
                        signs += side > 0 ? 1 : -1;
                    }
                    if (!box.holds(x, y) || least > 1.0 / 256) {
                        ASSERT_EQ(at(pixels, x, y), box.holds(x, y) && (signs == 3 || signs == -3))
                            << n << " at " << x << ',' << y;
                    }
                    (at(pixels, x, y) ? inside : outside) += 1;
                }
        }
        EXPECT_GT(inside, 20);
        EXPECT_GT(outside, 20);
    }
}

TEST_F(Viewport, HoldsOrMissesTheWindow) {
    const auto quad = [] { everywhere(); };
    for (const Box& box : {Box{0, 0, size, size}, {-20, -30, 500, 600}, {-64, 0, 128, 64}}) {
        set(box);
        expect_box(covered(quad), {0, 0, size, size});
    }
    // The viewport ends within the window on one side only.
    for (const Box& box :
         {Box{0, 0, 10, size}, {50, 0, size - 50, size}, {0, 0, size, 7}, {0, 40, size, size - 40}}) {
        set(box);
        expect_box(covered(quad), box);
    }
    set({-64, -64, 64 + 10, 64 + 5});
    expect_box(covered(quad), {0, 0, 10, 5});
    for (const Box& box :
         {Box{64, 0, 20, 20}, {-20, 0, 20, 20}, {10, 10, 0, 20}, {10, 10, 20, 0}, {5, 5, 0, 0}}) {
        set(box);
        EXPECT_EQ(count(covered(quad)), 0) << box.x << ' ' << box.w << ' ' << box.h;
    }
}

/// State that was compiled for one viewport is not used in another.
TEST_F(Viewport, FollowsWhatItIsSetTo) {
    const auto drawn_in = [](const Box& box) {
        return covered([&] {
            set(box);
            everywhere();
        });
    };
    for (int n = 0; n < 20; ++n) {
        const Box box{static_cast<int>(lot(-9, 50)), static_cast<int>(lot(-9, 50)),
                      static_cast<int>(lot(1, 70)), static_cast<int>(lot(1, 70))};
        expect_box(drawn_in(box), box);
    }
    expect_box(drawn_in({0, 0, size, size}), {0, 0, size, size});
    set(some);
    glPushAttrib(GL_VIEWPORT_BIT);
    glViewport(0, 0, size, size);
    expect_box(covered([] { everywhere(); }), {0, 0, size, size});
    glPopAttrib();
    expect_box(covered([] { everywhere(); }), some);
}

TEST_F(Viewport, MeetsTheScissorBox) {
    set(some);
    glEnable(GL_SCISSOR_TEST);
    const Box scissors[] = {{0, 0, 30, 30}, {25, 12, 5, 5}, some, {50, 0, 14, 64}};
    for (const Box& box : scissors) {
        glDisable(GL_SCISSOR_TEST);
        clear();
        glEnable(GL_SCISSOR_TEST);
        glScissor(box.x, box.y, box.w, box.h);
        everywhere();
        const auto drawn = picture();
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                ASSERT_EQ(drawn[static_cast<std::size_t>(y * size + x)][0] != 0,
                          some.holds(x, y) && box.holds(x, y));
    }
    glDisable(GL_SCISSOR_TEST);
}

/// A point is kept or discarded by its centre; its square is not clipped.
TEST_F(Viewport, PointsAreClippedByTheirCentres) {
    set(some);
    glPointSize(9);
    const auto drawn = [](double x, double y) { return covered([&] { dot(x, y); }); };
    expect_box(drawn(20.5, 30.5), {16, 26, 9, 9});
    expect_box(drawn(44.5, 48.5), {40, 44, 9, 9});
    for (const auto& [x, y] : {std::pair{19.5, 30.5}, {45.5, 30.5}, {30.5, 8.5}, {30.5, 49.5}})
        EXPECT_EQ(count(drawn(x, y)), 0) << x << ' ' << y;
    // The points are in one batch with polygons, whose fragments end at the viewport.
    const auto both = covered([&] {
        everywhere();
        dot(20.5, 30.5);
        everywhere();
    });
    EXPECT_TRUE(at(both, 16, 30));
    EXPECT_FALSE(at(both, 15, 30));
    EXPECT_FALSE(at(both, 16, 12));
    glEnable(GL_POINT_SMOOTH);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    EXPECT_TRUE(at(drawn(20.5, 30.5), 17, 30));
    EXPECT_EQ(count(drawn(19.5, 30.5)), 0);
}

/// A line is clipped as a line: its width may reach beyond the viewport, its length may not.
TEST_F(Viewport, LinesAreClippedAsLines) {
    set(some);
    const auto drawn = [](double ax, double ay, double bx, double by) {
        return covered([&] { line(ax, ay, bx, by); });
    };
    expect_box(drawn(-50, 30.5, 150, 30.5), {20, 30, 25, 1});
    expect_box(drawn(30.5, -80, 30.5, 150), {30, 9, 1, 40});
    EXPECT_EQ(count(drawn(-50, 8.5, 150, 8.5)), 0);
    EXPECT_EQ(count(drawn(10, -5, 60, 12)), 0); // the line passes a corner
    glLineWidth(7);
    // An end on the edge between two diamonds belongs to the diamond of the lower column (GL 1.3, 3.4.1);
    // these ends do not lie there.
    expect_box(drawn(-50, 9.75, 150, 9.75), {20, 6, 25, 7});
    expect_box(drawn(44.5, -80, 44.75, 150), {41, 9, 7, 40});
    EXPECT_EQ(count(drawn(-50, 8.5, 150, 8.5)), 0);
    expect_box(drawn(25.5, 30.5, 35.5, 30.5), {25, 27, 10, 7});
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(1, 0xFFFF);
    expect_box(drawn(-50, 9.75, 150, 9.75), {20, 6, 25, 7});
    glDisable(GL_LINE_STIPPLE);
    glEnable(GL_LINE_SMOOTH);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    expect_box(drawn(-50, 12.5, 150, 12.5), {20, 9, 25, 7});
    expect_box(drawn(-50, 9.5, 150, 9.5), {20, 6, 25, 7});
    glLineWidth(1); // the line has parts in two pixels
    expect_box(drawn(-50, 9.25, 150, 9.25), {20, 8, 25, 2});
}

/// Lines of one pixel have the fragments that lie in the viewport. Only lines that are clipped by the guard
/// band, which is as large as the viewport asks for, may differ by snapping.
TEST_F(Viewport, ThinLinesKeepTheirFragments) {
    int fragments = 0, differences = 0;
    for (int n = 0; n < 400; ++n) {
        const Corner a = corner(), b = corner();
        if (n % 50 == 0) {
            glLineWidth(n % 100 == 0 ? 1.4F : 1);
            (n % 100 == 0 ? glEnable : glDisable)(GL_LINE_STIPPLE);
        }
        const auto drawn = [&](const Box& box) {
            return covered([&] {
                set(box);
                line(a.x, a.y, b.x, b.y);
            });
        };
        const auto whole = drawn({0, 0, size, size}), part = drawn(some);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                ASSERT_FALSE(at(part, x, y) && !some.holds(x, y)) << n << " at " << x << ',' << y;
                differences += some.holds(x, y) && at(part, x, y) != at(whole, x, y) ? 1 : 0;
                fragments += at(part, x, y) ? 1 : 0;
            }
    }
    EXPECT_GT(fragments, 2000);
    EXPECT_LT(differences, fragments / 200);
}

/// Edges and vertices of outlined polygons are clipped as polygons are; their width and size reach beyond the
/// viewport.
TEST_F(Viewport, OutlinesReachBeyondByTheirWidth) {
    set(some);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glLineWidth(5);
    const auto lines = covered([] { everywhere(); });
    EXPECT_TRUE(at(lines, 18, 30)); // an edge along the boundary (GL 1.3, 2.11)
    EXPECT_FALSE(at(lines, 30, 30));
    EXPECT_FALSE(at(lines, 10, 30));
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    glPointSize(5);
    const auto points = covered([] { everywhere(); });
    EXPECT_TRUE(at(points, 18, 7));
    EXPECT_FALSE(at(points, 30, 30));
    // Filled back faces are clipped exactly.
    glPolygonMode(GL_FRONT, GL_FILL);
    expect_box(covered([] { everywhere(); }), some);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    expect_box(covered([] { everywhere(); }), some);
}

/// Antialiased, stippled and offset polygons are drawn in other ways, and are clipped, too.
TEST_F(Viewport, PolygonsInOtherModesEndThere) {
    set(some);
    const auto quad = [] { everywhere(); };
    glEnable(GL_POLYGON_SMOOTH);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    expect_box(covered(quad), some);
    glDisable(GL_POLYGON_SMOOTH);
    glDisable(GL_BLEND);
    glEnable(GL_POLYGON_STIPPLE);
    expect_box(covered(quad), some);
    glDisable(GL_POLYGON_STIPPLE);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1, 1);
    expect_box(covered(quad), some);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glEnable(GL_STENCIL_TEST);
    glEnable(GL_DEPTH_TEST);
    expect_box(covered(quad), some);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_DEPTH_TEST);
    const GLdouble plane[4] = {1, 0, 0, -30};
    glClipPlane(GL_CLIP_PLANE0, plane);
    glEnable(GL_CLIP_PLANE0);
    expect_box(covered(quad), {30, 9, 15, 40});
    glDisable(GL_CLIP_PLANE0);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    expect_box(covered(quad), some);
}

TEST(ViewportAlone, SamplesEndAtItsEdges) {
    const HeadlessGl gl(64, 64, {EGL_SAMPLES, 4});
    glClear(GL_COLOR_BUFFER_BIT);
    glViewport(20, 9, 25, 40);
    glBegin(GL_TRIANGLES);
    glVertex2f(-3.3F, -3.1F);
    glVertex2f(3.7F, -3.2F);
    glVertex2f(0.1F, 3.9F);
    glEnd();
    std::vector<Rgba> pixels(64 * 64);
    glReadPixels(0, 0, 64, 64, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    const Box box{20, 9, 25, 40};
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            ASSERT_EQ(pixels[static_cast<std::size_t>(y * 64 + x)][0], box.holds(x, y) ? 255 : 0)
                << x << ',' << y;
    glClear(GL_COLOR_BUFFER_BIT);
    glLineWidth(6);
    glBegin(GL_LINES);
    glVertex2f(-4, -1 + 1 / 40.F);
    glVertex2f(4, -1 + 1 / 40.F);
    glEnd();
    glReadPixels(0, 0, 64, 64, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    EXPECT_EQ(pixels[7 * 64 + 30][0], 255); // a pixel below the line
    EXPECT_EQ(pixels[7 * 64 + 19][0], 0);   // a pixel beside the line
    EXPECT_EQ(pixels[9 * 64 + 19][0], 0);
}

/// Clears, pixel rectangles and bitmaps are not clipped by the view volume.
TEST_F(Viewport, DoesNotClipPixels) {
    set(some);
    const std::vector<GLubyte> white(16 * 16 * 3, 255);
    const auto rectangle = covered([&] {
        glRasterPos2f(44.5F, 48.5F);
        glDrawPixels(16, 16, GL_RGB, GL_UNSIGNED_BYTE, white.data());
    });
    EXPECT_EQ(count(rectangle), 16 * 15 + 16);
    EXPECT_TRUE(at(rectangle, 50, 55));
    const auto bitmap = covered([&] {
        everywhere();
        clear();
        glRasterPos2f(44.5F, 48.5F);
        glBitmap(8, 8, 4, 4, 0, 0, white.data());
    });
    expect_box(bitmap, {40, 44, 8, 8});
    GLboolean valid = 1;
    glRasterPos2f(45.5F, 30);
    glGetBooleanv(GL_CURRENT_RASTER_POSITION_VALID, &valid);
    EXPECT_FALSE(valid);
    glClearColor(1, 1, 1, 1);
    clear();
    for (const Rgba& pixel : picture())
        ASSERT_EQ(pixel[0], 255);
    glClearColor(0, 0, 0, 0);
}

} // namespace
} // namespace spangle::test
