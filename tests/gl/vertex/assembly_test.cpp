// Tests primitive assembly: counts of the ten modes, provoking vertices, and stacks. Immediate mode, arrays
// and lists must be equal.
#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>
#include <spangle/GL/gl.h>

#include "gl/pixel/fragment_setup.hpp"
#include "tests/gl/vertex/canvas.hpp"

namespace {

class Vertices : public spangle::test::Canvas {
  protected:
    static constexpr int size = 128;
    Vertices() : Canvas(size) {}
    void SetUp() override {
        Canvas::SetUp();
        spangle::gl::observe(*spangle::gl::current_context(), &counters_, false);
        glOrtho(0, size, 0, size, -1, 1);
    }

    /// Sends vertex i of a circle of nine vertices.
    static void vertex(int i) {
        glVertex2f(64.0f + 60.0f * std::cos(0.7f * static_cast<float>(i)),
                   64.0f + 60.0f * std::sin(0.7f * static_cast<float>(i)));
    }
    static std::vector<GLubyte> picture() {
        std::vector<GLubyte> rows(size * size * 4);
        glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
        return rows;
    }
    std::vector<GLubyte> drawn(const std::function<void()>& draw) {
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw();
        return picture();
    }

    spangle::raster::Counters counters_;
};

TEST_F(Vertices, EveryModeMakesItsPrimitives) {
    const struct {
        GLenum mode;
        int (*primitives)(int n); ///< number of triangles, lines or points of n vertices
    } modes[] = {
        {GL_POINTS, [](int n) { return n; }},
        {GL_LINES, [](int n) { return n / 2; }},
        {GL_LINE_STRIP, [](int n) { return n < 2 ? 0 : n - 1; }},
        {GL_LINE_LOOP, [](int n) { return n < 2 ? 0 : n; }},
        {GL_TRIANGLES, [](int n) { return n / 3; }},
        {GL_TRIANGLE_STRIP, [](int n) { return n < 3 ? 0 : n - 2; }},
        {GL_TRIANGLE_FAN, [](int n) { return n < 3 ? 0 : n - 2; }},
        {GL_QUADS, [](int n) { return n / 4 * 2; }},
        {GL_QUAD_STRIP, [](int n) { return n < 4 ? 0 : n / 2 * 2 - 2; }},
        {GL_POLYGON, [](int n) { return n < 3 ? 0 : n - 2; }},
    };
    for (const auto& m : modes)
        for (int n = 0; n <= 9; ++n) {
            counters_.triangles = 0;
            glBegin(m.mode);
            for (int i = 0; i < n; ++i)
                vertex(i);
            glEnd();
            EXPECT_EQ(static_cast<int>(counters_.triangles), m.primitives(n))
                << "mode " << m.mode << ", " << n << " vertices";
        }
}

/// GL 1.3, table 2.11 says which vertex colours a flat primitive.
TEST_F(Vertices, ProvokingVertices) {
    const struct {
        GLenum mode;
        int count, provoking;
    } cases[] = {{GL_TRIANGLES, 3, 2}, {GL_TRIANGLE_STRIP, 3, 2}, {GL_TRIANGLE_FAN, 3, 2}, {GL_POLYGON, 5, 0},
                 {GL_QUADS, 4, 3},     {GL_QUAD_STRIP, 4, 3},     {GL_LINES, 2, 1}};
    glShadeModel(GL_FLAT);
    for (const auto& c : cases) {
        const std::vector<GLubyte> image = drawn([&c] {
            glBegin(c.mode);
            for (int i = 0; i < c.count; ++i) {
                glColor3ub(static_cast<GLubyte>(50 + 40 * i), 0, 255);
                vertex(i);
            }
            glEnd();
        });
        int seen = 0;
        for (std::size_t p = 0; p < image.size(); p += 4)
            if (image[p + 2] == 255) {
                ++seen;
                ASSERT_EQ(image[p], 50 + 40 * c.provoking) << "mode " << c.mode;
            }
        EXPECT_GT(seen, 20) << "mode " << c.mode;
    }
}

TEST_F(Vertices, StripsAndFansFaceOneWay) {
    glEnable(GL_CULL_FACE);
    for (const GLenum mode : {GL_TRIANGLE_FAN, GL_POLYGON}) {
        counters_.triangles = 0;
        glBegin(mode);
        for (int i = 0; i < 6; ++i)
            vertex(i);
        glEnd();
        EXPECT_EQ(counters_.triangles, 4u) << mode;
    }
    const auto zigzag = [this](GLenum mode) {
        counters_.triangles = 0;
        glBegin(mode);
        for (int i = 0; i < 8; ++i)
            glVertex2i(8 + 14 * i, (i & 1) != 0 ? 20 : 100);
        glEnd();
        return counters_.triangles;
    };
    EXPECT_EQ(zigzag(GL_TRIANGLE_STRIP), 6u);
    EXPECT_EQ(zigzag(GL_QUAD_STRIP), 6u);
    glFrontFace(GL_CW);
    EXPECT_EQ(zigzag(GL_TRIANGLE_STRIP), 0u);
}

TEST_F(Vertices, ImmediateArraysAndListsAreOne) {
    static const GLfloat position[6][3] = {{10, 10, 0.1f}, {110, 15, -0.4f},   {60.3f, 110.7f, 0.9f},
                                           {20, 90, 0},    {90.5f, 3.25f, -1}, {120, 120, 1}};
    static const GLubyte color[6][4] = {{255, 0, 0, 255},  {0, 255, 0, 255},   {0, 0, 255, 255},
                                        {9, 200, 90, 255}, {255, 255, 0, 255}, {0, 90, 200, 255}};
    glEnable(GL_DEPTH_TEST);
    const auto immediate = [] {
        glBegin(GL_TRIANGLES);
        for (int i = 0; i < 6; ++i) {
            glColor4ubv(color[i]);
            glVertex3fv(position[i]);
        }
        glEnd();
    };
    const auto arrays = [] {
        glEnableClientState(GL_VERTEX_ARRAY);
        glEnableClientState(GL_COLOR_ARRAY);
        glVertexPointer(3, GL_FLOAT, 0, position);
        glColorPointer(4, GL_UNSIGNED_BYTE, 0, color);
        glDrawArrays(GL_TRIANGLES, 0, 6);
    };
    const std::vector<GLubyte> first = drawn(immediate);
    EXPECT_EQ(first, drawn(immediate)) << "twice";
    EXPECT_EQ(first, drawn(arrays));
    static const GLushort indices[6] = {0, 1, 2, 3, 4, 5};
    EXPECT_EQ(first, drawn([] { glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, indices); }));
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    immediate();
    glEndList();
    EXPECT_EQ(first, drawn([list] { glCallList(list); }));
}

/// Twelve triangles around a point far outside of every plane draw each pixel exactly once.
TEST_F(Vertices, ClippedFansLeaveNoCracks) {
    glLoadIdentity();
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-1, 1, -1, 1, 1, 50);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glColor4ub(16, 0, 0, 0);
    const std::vector<GLubyte> image = drawn([] {
        glBegin(GL_TRIANGLE_FAN);
        glVertex3f(0.3f, -0.2f, -5.0f);
        for (int i = 0; i <= 12; ++i) {
            const float a = 0.5235988f * static_cast<float>(i % 12);
            glVertex3f(4000.0f * std::cos(a), 4000.0f * std::sin(a), i % 3 == 0 ? -6.0f : -4.5f);
        }
        glEnd();
    });
    for (std::size_t p = 0; p < image.size(); p += 4)
        ASSERT_EQ(image[p], 16) << "pixel " << p / 4 % size << ", " << p / 4 / size;
}

TEST_F(Vertices, ExtremesAreHarmless) {
    const float extreme[] = {NAN, INFINITY, -INFINITY, 3e38f, -3e38f, 1e-45f, 0.0f, 1.0f};
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glScalef(0, 0, 0); // makes the matrix singular
    for (const float a : extreme)
        for (const float b : extreme) {
            glBegin(GL_TRIANGLE_STRIP);
            for (int i = 0; i < 6; ++i) {
                glNormal3f(i == 0 ? a : b, 0, i == 2 ? b : 0);
                glVertex4f(i & 1 ? a : 1, b, i & 2 ? a : b, i == 3 ? a : 1);
            }
            glEnd();
            const GLfloat matrix[16] = {a, b, 0, 0, 0, a, b, 0, 1, 0, a, 0, b, 0, 0, a};
            glMultMatrixf(matrix);
        }
}

} // namespace
