// Rows B05, C12, C13, C16, D09: tests clipping and its associated data, facing, and texture coordinates
// through their matrix.
#include <cmath>
#include <random>
#include <vector>

#include "raster/surface/units.hpp"
#include "tests/gl/vertex/canvas.hpp"
#include "tests/gl/vertex/window_recorder.hpp"

namespace spangle::test {
namespace {

class Window : public Canvas {
  protected:
    static std::size_t drawn(GLenum mode, std::vector<std::array<GLfloat, 4>> vertices) {
        WindowRecorder recorder;
        glBegin(mode);
        for (const auto& v : vertices)
            glVertex4fv(v.data());
        glEnd();
        return recorder.primitives.size();
    }
};

/// A point is drawn if -w <= x, y, z <= w, both ends included (GL 1.3, 2.11).
TEST_F(Window, PointsInTheViewVolume) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f})
            for (const float w : {1.0f, 3.0f}) {
                std::array<GLfloat, 4> v{0, 0, 0, w};
                v[axis] = side * w;
                EXPECT_EQ(drawn(GL_POINTS, {v}), 1u) << axis << side;
                v[axis] = side * w * 1.0001f;
                EXPECT_EQ(drawn(GL_POINTS, {v}), 0u) << axis << side;
                v[axis] = side * w * 0.9999f;
                EXPECT_EQ(drawn(GL_POINTS, {v}), 1u) << axis << side;
                for (GLfloat& c : v)
                    c = -c;
                EXPECT_EQ(drawn(GL_POINTS, {v}), 0u) << "w < 0";
            }
    EXPECT_EQ(drawn(GL_POINTS, {{0, 0, 0, 0}}), 0u);
}

/// Lines and triangles cross each plane. Every vertex that clipping makes lies on the edge that it cuts, with
/// the colour, texture coordinate and fog distance of that place.
TEST_F(Window, AssociatedDataOfClippedVertices) {
    std::mt19937 random(9);
    const auto real = [&random](double low, double high) {
        return static_cast<GLfloat>(std::uniform_real_distribution<>(low, high)(random));
    };
    glMatrixMode(GL_PROJECTION);
    glFrustum(-1, 1, -1, 1, 1, 100);
    glMatrixMode(GL_MODELVIEW);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_FOG);
    int cut = 0;
    double worst = 0;
    for (int n = 0; n < 4000; ++n) {
        // w is the depth. Colour and texture coordinates are linear in the position, so every point of the
        // edge has known values.
        const GLfloat ends[2][3] = {{real(-0.9, 0.9), real(-0.9, 0.9), real(-3, -1.5f)},
                                    {real(-300, 300), real(-300, 300), real(-90, 20)}};
        const GLfloat color[2][3] = {{0, 1, 0.25f}, {1, 0, 0.75f}}, tex[2][2] = {{0, 5}, {1, -5}};
        WindowRecorder recorder;
        glBegin(GL_LINES);
        for (int i = 0; i < 2; ++i) {
            glColor3fv(color[i]);
            glTexCoord2fv(tex[i]);
            glVertex3fv(ends[i]);
        }
        glEnd();
        ASSERT_EQ(recorder.primitives.size(), 1u);
        for (int i = 0; i < 2; ++i) {
            const raster::FixedVertex& v = recorder.primitives[0].corner[i];
            // Red tells the place on the edge.
            const double t = v.color[0] / static_cast<double>(raster::color_one);
            const bool made = t > 0 && t < 1;
            cut += made ? 1 : 0;
            double at[3];
            for (int c = 0; c < 3; ++c)
                at[c] = ends[0][c] + t * (ends[1][c] - double{ends[0][c]});
            const double w = -at[2];
            const double errors[] = {
                v.color[1] / static_cast<double>(raster::color_one) - (1 - t),
                v.color[2] / static_cast<double>(raster::color_one) - (0.25 + t / 2),
                (v.x / 256.0 - size / 2 * (at[0] / w + 1)) / size / 64,
                (v.y / 256.0 - size / 2 * (at[1] / w + 1)) / size / 64,
                std::ldexp(v.w_mantissa, v.w_exponent) * w - 1,
                std::ldexp(v.fog_mantissa, v.fog_exponent) / w - 1,
                std::ldexp(v.tex[0].s, v.tex[0].exponent) - t,
                (std::ldexp(v.tex[0].t, v.tex[0].exponent) - (5 - 10 * t)) / 10,
            };
            for (std::size_t item = 0; item < std::size(errors); ++item) {
                worst = std::fmax(worst, std::fabs(errors[item]));
                ASSERT_LT(std::fabs(errors[item]), 1e-4) << n << ": t = " << t << ", item " << item;
            }
            ASSERT_TRUE(!made || (std::abs(v.x) <= 4 * 256 * size && std::abs(v.y) <= 4 * 256 * size))
                << n << ": outside the guard band";
        }
    }
    std::printf("%d cuts, worst error %.2g\n", cut, worst);
    EXPECT_GT(cut, 2000);
}

TEST_F(Window, NothingOfAPrimitiveBeyondOnePlaneIsDrawn) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            std::array<GLfloat, 4> a{0.5f, -0.5f, 0.25f, 1}, b{-0.5f, 0.25f, 0.5f, 1},
                c{0.25f, 0.5f, -0.5f, 1};
            a[axis] = 1.5f * side, b[axis] = 2 * side, c[axis] = 3 * side;
            EXPECT_EQ(drawn(GL_TRIANGLES, {a, b, c}), 0u);
            EXPECT_EQ(drawn(GL_LINES, {a, b}), 0u);
        }
}

/// A triangle through the near plane becomes a quadrilateral in front of it.
TEST_F(Window, NearPlane) {
    for (const GLfloat depth : {1.5f, 1.9f, 3.0f, 100.0f}) {
        WindowRecorder recorder;
        glBegin(GL_TRIANGLES);
        glVertex3f(-0.5f, -0.5f, 0);
        glVertex3f(0.5f, -0.5f, 0);
        glVertex3f(0, 0.5f, -depth);
        glEnd();
        ASSERT_EQ(recorder.primitives.size(), 2u) << depth;
        const double top = size / 2.0 * (0.5 + 1 / depth); // the row at which z reaches -1
        for (const Primitive& p : recorder.primitives)
            for (const raster::FixedVertex& v : p.corner)
                EXPECT_LE(v.y / 256.0, top + 1.0 / 256) << depth;
    }
}

/// Tests all combinations of facing and culling (GL 1.3, 3.5.1).
TEST_F(Window, FacingAndCulling) {
    const std::vector<std::array<GLfloat, 4>> counterclockwise = {{0, 0, 0, 1},
                                                                  {0.5f, 0, 0, 1},
                                                                  {0, 0.5f, 0, 1}},
                                              clockwise = {{0, 0, 0, 1}, {0, 0.5f, 0, 1}, {0.5f, 0, 0, 1}};
    for (const GLenum front : {GL_CCW, GL_CW})
        for (const GLenum face : {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK})
            for (const bool enabled : {false, true})
                for (const bool turned : {false, true}) {
                    glFrontFace(front);
                    glCullFace(face);
                    (enabled ? glEnable : glDisable)(GL_CULL_FACE);
                    const bool is_front = turned == (front == GL_CW);
                    const bool gone =
                        enabled && (face == GL_FRONT_AND_BACK || (face == GL_FRONT) == is_front);
                    EXPECT_EQ(drawn(GL_TRIANGLES, turned ? clockwise : counterclockwise), gone ? 0u : 1u)
                        << front << ' ' << face << ' ' << turned;
                    EXPECT_EQ(drawn(GL_LINES, {clockwise[0], clockwise[1]}), 1u) << "lines have no faces";
                    EXPECT_EQ(drawn(GL_POINTS, {clockwise[0]}), 1u);
                }
}

/// A mirrored modelview matrix turns faces over.
TEST_F(Window, FacingIsThatOfTheWindow) {
    glEnable(GL_CULL_FACE);
    glScalef(-1, 1, 1);
    EXPECT_EQ(drawn(GL_TRIANGLES, {{0, 0, 0, 1}, {0.5f, 0, 0, 1}, {0, 0.5f, 0, 1}}), 0u);
    EXPECT_EQ(drawn(GL_TRIANGLES, {{0, 0, 0, 1}, {0, 0.5f, 0, 1}, {0.5f, 0, 0, 1}}), 1u);
}

/// The provoking vertex has the flat colour, which clipping does not change.
TEST_F(Window, FlatColorOfAClippedTriangle) {
    glShadeModel(GL_FLAT);
    WindowRecorder recorder;
    glBegin(GL_TRIANGLES);
    glColor3ub(10, 0, 0);
    glVertex2f(0, 0);
    glColor3ub(20, 0, 0);
    glVertex2f(0, 0.5f);
    glColor3ub(30, 0, 0);
    glVertex2f(9, 0.25f);
    glEnd();
    ASSERT_FALSE(recorder.primitives.empty());
    for (const Primitive& p : recorder.primitives)
        EXPECT_EQ((p.provoking.color[0] + (1u << 19)) >> 20, 30u);
}

/// Compares T (s, t, r, q) with the texture matrix, row by row.
TEST_F(Window, TextureCoordinatesThroughTheirMatrix) {
    std::mt19937 random(4);
    const auto real = [&random] {
        return static_cast<GLfloat>(std::uniform_real_distribution<>(-4, 4)(random));
    };
    glEnable(GL_TEXTURE_2D);
    double worst = 0;
    for (int n = 0; n < 5000; ++n) {
        GLfloat m[16], v[4];
        for (GLfloat& e : m)
            e = real();
        for (GLfloat& e : v)
            e = real();
        glMatrixMode(GL_TEXTURE);
        glLoadMatrixf(m);
        WindowRecorder recorder;
        glTexCoord4fv(v);
        glBegin(GL_POINTS);
        glVertex2f(0, 0);
        glEnd();
        ASSERT_EQ(recorder.primitives.size(), 1u);
        const auto& tex = recorder.primitives[0].corner[0].tex[0];
        const std::int32_t got[4] = {tex.s, tex.t, 0, tex.q};
        for (const int row : {0, 1, 3}) {
            double expected = 0, terms = 0;
            for (int c = 0; c < 4; ++c) {
                expected += double{m[4 * c + row]} * v[c];
                terms += std::fabs(double{m[4 * c + row]} * v[c]);
            }
            const double error = std::fabs(std::ldexp(got[row], tex.exponent) - expected) / (terms + 1);
            worst = std::fmax(worst, error);
        }
    }
    std::printf("texture coordinates: worst error 2^%.1f of their terms\n", std::log2(worst));
    EXPECT_LT(worst, std::ldexp(1, -23));
}

} // namespace
} // namespace spangle::test
