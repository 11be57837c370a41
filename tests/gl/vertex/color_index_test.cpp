// Rows B09, C08, C11: tests vertices of an index framebuffer: masked indices, their lighting, and their way
// to the rasterizer.
#include <cmath>
#include <random>
#include <vector>

#include "gl/context/context.hpp"
#include "tests/gl/vertex/canvas.hpp"
#include "tests/gl/vertex/lighting_equation.hpp"
#include "tests/gl/vertex/window_recorder.hpp"

namespace spangle::test {
namespace {

#if SPANGLE_FEATURE_COLOR_INDEX

class ColorIndex : public Canvas {
  protected:
    void SetUp() override {
        Canvas::SetUp();
        bits(8);
        glMatrixMode(GL_PROJECTION);
        glOrtho(-200, 200, -200, 200, -200, 200);
        glMatrixMode(GL_MODELVIEW);
    }
    static void bits(std::uint8_t n) {
        gl::current_context()->drawable.index_bits = n;
        gl::current_context()->changed(gl::dirty_all);
    }
    static double of(const raster::FixedVertex& v) { return v.color[0] / 1048576.0; }
    static double point(double index) {
        WindowRecorder recorder;
        glIndexd(index);
        glBegin(GL_POINTS);
        glVertex2f(0, 0);
        glEnd();
        return recorder.primitives.size() == 1 ? of(recorder.primitives[0].corner[0]) : -1;
    }
};

TEST_F(ColorIndex, TheMode) {
    GLint now[3];
    const auto ask = [&now] {
        glGetIntegerv(GL_RGBA_MODE, now);
        glGetIntegerv(GL_INDEX_MODE, now + 1);
        glGetIntegerv(GL_INDEX_BITS, now + 2);
    };
    ask();
    EXPECT_TRUE(now[0] == 0 && now[1] == 1 && now[2] == 8);
    bits(0);
    ask();
    EXPECT_TRUE(now[0] == 1 && now[1] == 0 && now[2] == 0);
}

/// The integer part of an index is masked, and the fraction is kept (GL 1.3, 2.13.6).
TEST_F(ColorIndex, IndicesAreMasked) {
    EXPECT_EQ(point(7.5), 7.5);
    EXPECT_EQ(point(255), 255);
    EXPECT_EQ(point(256), 0);
    EXPECT_EQ(point(300.25), 44.25);
    EXPECT_EQ(point(-1), 255);
    EXPECT_EQ(point(65537), 1);
    EXPECT_EQ(point(1e30), 0);
    EXPECT_EQ(point(1e-30), 0);
    bits(4);
    EXPECT_EQ(point(300.25), 12.25);
    bits(1);
    EXPECT_EQ(point(3), 1);
}

/// Primitives are smooth and flat, from commands and arrays; clipped vertices lie on the line between.
TEST_F(ColorIndex, Primitives) {
    const GLfloat index[3] = {10, 20, 40}, position[3][2] = {{-100, -100}, {100, -100}, {0, 100}};
    for (const bool arrays : {false, true})
        for (const bool flat : {false, true}) {
            glShadeModel(flat ? GL_FLAT : GL_SMOOTH);
            WindowRecorder recorder;
            if (arrays) {
                glEnableClientState(GL_VERTEX_ARRAY);
                glEnableClientState(GL_INDEX_ARRAY);
                glVertexPointer(2, GL_FLOAT, 0, position);
                glIndexPointer(GL_FLOAT, 0, index);
                glDrawArrays(GL_TRIANGLES, 0, 3);
            } else {
                glBegin(GL_TRIANGLES);
                for (int i = 0; i < 3; ++i) {
                    glIndexf(index[i]);
                    glVertex2fv(position[i]);
                }
                glEnd();
            }
            ASSERT_EQ(recorder.primitives.size(), 1u);
            EXPECT_EQ(of(recorder.primitives[0].provoking), 40);
            for (int i = 0; i < 3; ++i)
                EXPECT_EQ(of(recorder.primitives[0].corner[i]), index[i]);
        }
    glShadeModel(GL_SMOOTH);
    WindowRecorder recorder;
    glBegin(GL_LINES);
    glIndexf(10);
    glVertex3f(0, 0, 0);
    glIndexf(30);
    glVertex3f(0, 0, 400); // the near plane cuts the triangle in half
    glEnd();
    EXPECT_NEAR(of(recorder.primitives.at(0).corner[1]), 20, 1e-5);
}

#if SPANGLE_FEATURE_LIGHTING

constexpr double ramp[2][3] = {{3, 90, 200}, {20.5, 10, 120}};

/// The lighting of indices (GL 1.3, 2.13.5), from sums that the equation of colours gives for grey weights.
double index_equation(LitVertex v, int side, const double (&am_dm_sm)[3]) {
    double d = 0, s = 0;
    const double weight[3] = {.30, .59, .11};
    v.scene_ambient = {0, 0, 0, 1};
    v.separate_specular = true;
    for (std::size_t c = 0; c < 3; ++c) { // a hundredth of the light, so that nothing is clamped
        LitVertex one = v;
        SurfaceMaterial& m = one.material[side];
        m.ambient = m.emission = {0, 0, 0, 1};
        m.diffuse = m.specular = {0, 0, 0, 1};
        m.diffuse[c] = m.specular[c] = weight[c] / 100;
        const LitColor sums = equation(one, side);
        d += 100 * sums.primary[c];
        s += 100 * sums.secondary[c];
    }
    const double shine = std::fmin(s, 1);
    const double index =
        am_dm_sm[0] + d * (1 - shine) * (am_dm_sm[1] - am_dm_sm[0]) + shine * (am_dm_sm[2] - am_dm_sm[0]);
    return std::fmin(index, am_dm_sm[2]);
}

class IndexLighting : public ColorIndex {
  protected:
    void SetUp() override {
        ColorIndex::SetUp();
        glEnable(GL_LIGHTING);
        for (int side = 0; side < 2; ++side)
            glMaterialfv(side == 0 ? GL_FRONT : GL_BACK, GL_COLOR_INDEXES,
                         floats(std::array<double, 3>{ramp[side][0], ramp[side][1], ramp[side][2]}).data());
    }
};

TEST_F(IndexLighting, Indexes) {
    GLfloat now[3];
    glGetMaterialfv(GL_BACK, GL_COLOR_INDEXES, now);
    EXPECT_TRUE(now[0] == 20.5f && now[1] == 10 && now[2] == 120);
    const GLint whole[3] = {1, 2, 3};
    glMaterialiv(GL_FRONT_AND_BACK, GL_COLOR_INDEXES, whole);
    for (const GLenum face : {GL_FRONT, GL_BACK}) {
        GLint back[3];
        glGetMaterialiv(face, GL_COLOR_INDEXES, back);
        EXPECT_TRUE(back[0] == 1 && back[1] == 2 && back[2] == 3);
    }
    glMaterialf(GL_FRONT, GL_COLOR_INDEXES, 1);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM}) << "three numbers";
}

/// Compares random scenes of all kinds of lights, seen from both sides, with the equation.
TEST_F(IndexLighting, Equation) {
    std::mt19937 random(11);
    const auto real = [&random](double low, double high) {
        return static_cast<double>(static_cast<float>(std::uniform_real_distribution<>(low, high)(random)));
    };
    const auto flip = [&random] { return (random() & 1) != 0; };
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    int compared = 0;
    bool bright = false, shining = false;
    for (int n = 0; n < 4000; ++n) {
        LitVertex v;
        for (int i = 0; i < 3; ++i) {
            LightSource& l = v.light[static_cast<std::size_t>(i)];
            l.on = i == 0 || flip();
            l.ambient = {real(0, 1), real(0, 1), real(0, 1), 1}; // this ambient light has no effect
            l.diffuse = {real(0, 1), real(0, 1), real(0, 1), 1};
            l.specular = {real(0, 1), real(0, 1), real(0, 1), 1};
            l.position = {real(-30, 30), real(-30, 30), real(-30, 30), flip() ? 0.0 : 1.0};
            l.spot_direction = {real(-1, 1), real(-1, 1), real(-1, 1)};
            if (flip())
                l.spot_cutoff = real(20, 90), l.spot_exponent = flip() ? 0 : real(0, 128);
            if (flip())
                l.linear = real(0, 0.1);
        }
        v.material[0].shininess = real(0, 20);
        v.material[1].shininess = 0;
        v.local_viewer = flip();
        v.normalize = true;
        v.normal = {real(-1, 1), real(-1, 1), real(-1, 1)};
        v.position = {real(-20, 20), real(-20, 20), real(-20, 20), 1};
        const int side = flip() ? 1 : 0;
        v.material[0].specular = v.material[1].specular = {1, 1, 1, 1}; // highlights count in the margin
        if (equation(v, side).margin < 1e-6)
            continue;
        specify(v);
        WindowRecorder recorder;
        glNormal3fv(floats(v.normal).data());
        glBegin(GL_TRIANGLES);
        glVertex4fv(floats(v.position).data());
        for (int i = 0; i < 2; ++i)
            glVertex2f((i == side) == false ? 190 : -190, i == 0 ? -190 : 190);
        glEnd();
        if (recorder.primitives.empty())
            continue;
        const raster::FixedVertex &a = recorder.primitives[0].corner[0],
                                  &b = recorder.primitives[0].corner[1],
                                  &c = recorder.primitives[0].corner[2];
        const bool ccw = std::int64_t{b.x - a.x} * (c.y - a.y) > std::int64_t{c.x - a.x} * (b.y - a.y);
        if (ccw != (side == 0))
            continue;
        const double expected = index_equation(v, side, ramp[side]);
        EXPECT_NEAR(of(a), expected, 0.01) << n;
        bright = bright || expected == ramp[side][2];
        shining = shining || (expected > 100 && expected < 200);
        ++compared;
    }
    EXPECT_GT(compared, 1500);
    EXPECT_TRUE(bright && shining);
}

/// Ambient light, emission and ColorMaterial do not count (GL 1.3, 2.13.5). Without other light the first
/// index is drawn.
TEST_F(IndexLighting, WhatDoesNotCount) {
    const GLfloat white[4] = {1, 1, 1, 1}, black[4] = {0, 0, 0, 1};
    glLightfv(GL_LIGHT0, GL_DIFFUSE, black);
    glLightfv(GL_LIGHT0, GL_SPECULAR, black);
    glLightfv(GL_LIGHT0, GL_AMBIENT, white);
    glEnable(GL_LIGHT0);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, white);
    glMaterialfv(GL_FRONT, GL_EMISSION, white);
    EXPECT_EQ(point(77), 3);
    glEnable(GL_COLOR_MATERIAL);
    glColor4fv(white);
    EXPECT_EQ(point(77), 3);
    glDisable(GL_LIGHTING);
    EXPECT_EQ(point(77), 77);
}

/// Nothing is brighter than the specular index, whatever the order of the three indices.
TEST_F(IndexLighting, TheSpecularIndexIsTheLast) {
    const GLfloat indexes[3] = {3, 90, 50}, white[4] = {1, 1, 1, 1}, black[4] = {0, 0, 0, 1};
    glMaterialfv(GL_FRONT, GL_COLOR_INDEXES, indexes);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_SPECULAR, black);
    EXPECT_EQ(point(77), 50);
    const GLfloat half[4] = {0.5f, 0.5f, 0.5f, 1};
    glLightfv(GL_LIGHT0, GL_DIFFUSE, half);
    EXPECT_NEAR(point(77), 46.5, 1e-4);
    glLightfv(GL_LIGHT0, GL_DIFFUSE, white);
    EXPECT_EQ(point(77), 50);
}

/// Each vertex has the material indices that were current when it was given, also while its primitive waits.
TEST_F(IndexLighting, MaterialsBetweenVertices) {
    WindowRecorder recorder;
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 3; ++i) {
        const GLfloat all[3] = {10.0f * static_cast<GLfloat>(i + 1), 100, 100};
        glMaterialfv(GL_FRONT, GL_COLOR_INDEXES, all);
        glVertex2f(i == 1 ? 100 : 0, i == 2 ? 100 : 0);
    }
    glEnd();
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(of(recorder.primitives.at(0).corner[i]), 10 * (i + 1));
}

#endif

#if SPANGLE_FEATURE_RASTER_POS
TEST_F(ColorIndex, RasterPosition) {
    const auto get = [](GLenum name) {
        GLfloat v[4] = {};
        glGetFloatv(name, v);
        return v[0];
    };
    glIndexf(300.5f);
    glColor3f(0, 0, 0);
    glRasterPos2f(0, 0);
    EXPECT_EQ(get(GL_CURRENT_RASTER_INDEX), 44.5f);
    EXPECT_EQ(get(GL_CURRENT_RASTER_COLOR), 1) << "colours have their initial values in this mode";
    glIndexf(9);
    glWindowPos2f(0, 0);
    EXPECT_EQ(get(GL_CURRENT_RASTER_INDEX), 9);
    EXPECT_EQ(get(GL_CURRENT_RASTER_COLOR), 1);
#if SPANGLE_FEATURE_LIGHTING
    glEnable(GL_LIGHTING);
    const GLfloat indexes[3] = {33, 90, 200};
    glMaterialfv(GL_FRONT, GL_COLOR_INDEXES, indexes);
    glRasterPos2f(0, 0);
    EXPECT_EQ(get(GL_CURRENT_RASTER_INDEX), 33);
#endif
}
#endif

#if SPANGLE_FEATURE_FEEDBACK
/// Feedback returns one number for a colour instead of four (GL 1.3, table 5.2).
TEST_F(ColorIndex, Feedback) {
    std::vector<GLfloat> buffer(64);
    glFeedbackBuffer(64, GL_3D_COLOR_TEXTURE, buffer.data());
    glRenderMode(GL_FEEDBACK);
    glTexCoord2f(5, 6);
    glIndexf(258.75f);
    glBegin(GL_POINTS);
    glVertex2f(0, 0);
    glEnd();
    buffer.resize(static_cast<std::size_t>(glRenderMode(GL_RENDER)));
    EXPECT_EQ(buffer, (std::vector<GLfloat>{GL_POINT_TOKEN, 32, 32, 0.5f, 2.75f, 5, 6, 0, 1}));
}
#endif

#endif

} // namespace
} // namespace spangle::test
