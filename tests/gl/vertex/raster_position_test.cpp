// Rows C17, C18: compares the current raster position with formulas in double.
#include <array>
#include <cmath>
#include <random>

#include "tests/gl/vertex/canvas.hpp"
#include "tests/gl/vertex/lighting_equation.hpp"

namespace spangle::test {
namespace {

class RasterPosition : public Canvas {
  protected:
    std::mt19937 random_{23};
    double number(double low, double high) {
        return static_cast<float>(std::uniform_real_distribution<>(low, high)(random_));
    }
    static Vec4 get(GLenum name) {
        Vec4 v{};
        glGetDoublev(name, v.data());
        return v;
    }
    static bool valid() {
        GLboolean v = GL_FALSE;
        glGetBooleanv(GL_CURRENT_RASTER_POSITION_VALID, &v);
        return v != GL_FALSE;
    }
    static void near(const Vec4& got, const Vec4& expected, double tolerance, const char* what) {
        for (std::size_t c = 0; c < 4; ++c)
            EXPECT_NEAR(got[c], expected[c], tolerance) << what << ' ' << c;
    }
};

#define SPANGLE_RASTER_POS(suffix, T, scale)                                                                 \
    {                                                                                                        \
        const T a[4] = {static_cast<T>(2 * (scale)), static_cast<T>(-1 * (scale)),                           \
                        static_cast<T>(1 * (scale)), static_cast<T>(4 * (scale))};                           \
        glRasterPos2##suffix(a[0], a[1]), is({48, 24, 0.5, 1});                                              \
        glRasterPos3##suffix(a[0], a[1], a[2]), is({48, 24, 0.625, 1});                                      \
        glRasterPos4##suffix(a[0], a[1], a[2], a[3]), is({36, 30, 0.53125, 4});                              \
    }
#define SPANGLE_RASTER_POS_VECTOR(suffix, T, scale)                                                          \
    {                                                                                                        \
        const T a[4] = {static_cast<T>(2 * (scale)), static_cast<T>(-1 * (scale)),                           \
                        static_cast<T>(1 * (scale)), static_cast<T>(4 * (scale))};                           \
        glRasterPos2##suffix(a), is({48, 24, 0.5, 1});                                                       \
        glRasterPos3##suffix(a), is({48, 24, 0.625, 1});                                                     \
        glRasterPos4##suffix(a), is({36, 30, 0.53125, 4});                                                   \
    }

TEST_F(RasterPosition, EveryForm) {
    glOrtho(-4, 4, -4, 4, 4, -4);
    const auto is = [](const Vec4& expected) {
        near(get(GL_CURRENT_RASTER_POSITION), expected, 1e-6, "position");
        EXPECT_TRUE(valid());
        glRasterPos2f(0, 0);
    };
    SPANGLE_RASTER_POS(s, GLshort, 1)
    SPANGLE_RASTER_POS(i, GLint, 1)
    SPANGLE_RASTER_POS(f, GLfloat, 1)
    SPANGLE_RASTER_POS(d, GLdouble, 1)
    SPANGLE_RASTER_POS(xOES, GLfixed, 65536)
    SPANGLE_RASTER_POS_VECTOR(sv, GLshort, 1)
    SPANGLE_RASTER_POS_VECTOR(iv, GLint, 1)
    SPANGLE_RASTER_POS_VECTOR(fv, GLfloat, 1)
    SPANGLE_RASTER_POS_VECTOR(dv, GLdouble, 1)
    SPANGLE_RASTER_POS_VECTOR(xvOES, GLfixed, 65536)
}

/// Positions are not rounded: they are right to 1 part in 100,000 (GL 1.3, 2.1.1).
TEST_F(RasterPosition, TransformsAndValidity) {
    int inside = 0, outside = 0;
    glViewport(3, 5, 50, 40);
    glDepthRange(0.9, 0.2);
    for (int round = 0; round < 3000; ++round) {
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        glFrustum(-1, 1, -1, 1, 1, 20);
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
        const double back = number(-12, 2);
        glTranslated(0, 0, back);
        glScaled(2, 0.5, 1);
        const Vec4 plane{number(-1, 1), number(-1, 1), number(-1, 1), number(0, 9)};
        glClipPlane(GL_CLIP_PLANE2, plane.data());
        (round % 2 == 0 ? glEnable : glDisable)(GL_CLIP_PLANE2);
        const Vec4 v{number(-2, 2), number(-6, 6), number(-3, 3), 1};
        const double x = v[0] * 2, y = v[1] * 0.5, z = v[2] + back;
        const double clip_z = -21.0 / 19 * z - 40.0 / 19, w = -z;
        double margin = std::fmin(w - std::fabs(x), std::fmin(w - std::fabs(y), w - std::fabs(clip_z)));
        if (round % 2 == 0)
            margin = std::fmin(margin, v[0] * plane[0] + v[1] * plane[1] + v[2] * plane[2] + plane[3]);
        if (std::fabs(margin) < 1e-4)
            continue;
        glRasterPos4dv(v.data());
        ASSERT_EQ(valid(), margin > 0) << round;
        ++(margin > 0 ? inside : outside);
        if (margin < 0)
            continue;
        const Vec4 got = get(GL_CURRENT_RASTER_POSITION);
        EXPECT_NEAR(got[0], 3 + 25 + 25 * x / w, 1e-5 * 28);
        EXPECT_NEAR(got[1], 5 + 20 + 20 * y / w, 1e-5 * 25);
        EXPECT_NEAR(got[2], 0.55 - 0.35 * clip_z / w, 1e-5);
        EXPECT_NEAR(got[3], w, 1e-5 * w);
        EXPECT_NEAR(get(GL_CURRENT_RASTER_DISTANCE)[0], -z, 1e-5 * w);
    }
    EXPECT_GT(inside, 500);
    EXPECT_GT(outside, 500);
}

/// The colour is the clamped current colour, or the result of lighting. Texture coordinates go through texgen
/// and their matrices. Later changes do not affect them.
TEST_F(RasterPosition, AssociatedData) {
    glColor4f(2, -1, 0.25f, 0.5f);
    glMultiTexCoord4f(GL_TEXTURE0, 1, 2, 3, 4);
    glMultiTexCoord4f(GL_TEXTURE1, 5, 6, 7, 8);
    glMatrixMode(GL_TEXTURE);
    glActiveTexture(GL_TEXTURE1);
    glScalef(2, 3, 1);
    glEnable(GL_TEXTURE_GEN_R);
    glTexGeni(GL_R, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    const GLfloat plane[4] = {4, 0, 0, 1};
    glTexGenfv(GL_R, GL_OBJECT_PLANE, plane);
    glMatrixMode(GL_MODELVIEW);
    glIndexf(7.5f);
    glRasterPos2f(0.5f, 0.25f);
    glIndexf(1);
    glColor3f(0, 0, 0);
    glMultiTexCoord4f(GL_TEXTURE0, 0, 0, 0, 1);
    near(get(GL_CURRENT_RASTER_COLOR), {1, 0, 0.25, 0.5}, 0, "colour");
    EXPECT_EQ(get(GL_CURRENT_RASTER_INDEX)[0], 1) << "has its initial value where there are colours";
    near(get(GL_CURRENT_RASTER_TEXTURE_COORDS), {10, 18, 3, 8}, 1e-6, "unit 1");
    glActiveTexture(GL_TEXTURE0);
    near(get(GL_CURRENT_RASTER_TEXTURE_COORDS), {1, 2, 3, 4}, 1e-6, "unit 0");

    LitVertex lit;
    lit.material[0].diffuse = {0.5f, 0.25f, 1, 0.75f};
    lit.light[0].position = {0.5f, 0.5f, 1, 0};
    lit.normal = {0, 0.6f, 0.8f};
    specify(lit);
    glNormal3dv(lit.normal.data());
    glEnable(GL_LIGHTING);
    glRasterPos2f(0, 0);
    near(get(GL_CURRENT_RASTER_COLOR), equation(lit, 0).primary, 1e-5, "lit");
    const Vec4 kept = get(GL_CURRENT_RASTER_POSITION);
    glNewList(1, GL_COMPILE);
    glRasterPos2f(0.5f, 0.5f);
    glEndList();
    EXPECT_EQ(get(GL_CURRENT_RASTER_POSITION), kept);
    glCallList(1);
    near(get(GL_CURRENT_RASTER_POSITION), {48, 48, 0.5, 1}, 1e-5, "list");
}

#define SPANGLE_WINDOW_POS(suffix, T)                                                                        \
    {                                                                                                        \
        const T a[3] = {static_cast<T>(7), static_cast<T>(-300), static_cast<T>(1)};                         \
        glWindowPos2##suffix(a[0], a[1]), is({7, -300, 0.25, 1});                                            \
        glWindowPos3##suffix(a[0], a[1], a[2]), is({7, -300, 0.75, 1});                                      \
        glWindowPos2##suffix##v(a), is({7, -300, 0.25, 1});                                                  \
        glWindowPos3##suffix##v(a), is({7, -300, 0.75, 1});                                                  \
    }

/// WindowPos does not depend on matrices and planes, and may lie outside of the window (GL 1.4, 2.13).
TEST_F(RasterPosition, WindowPos) {
    glDepthRange(0.25, 0.75);
    glScalef(100, 100, 100);
    const GLdouble nothing[4] = {0, 0, 0, -1};
    glClipPlane(GL_CLIP_PLANE0, nothing);
    glEnable(GL_CLIP_PLANE0);
    glColor4f(3, 0.5f, -1, 1);
    glTexCoord4f(1, 2, 3, 4);
    const auto is = [](const Vec4& expected) {
        EXPECT_EQ(get(GL_CURRENT_RASTER_POSITION), expected);
        EXPECT_TRUE(valid());
        glRasterPos2f(0, 0);
        EXPECT_FALSE(valid());
    };
    SPANGLE_WINDOW_POS(s, GLshort)
    SPANGLE_WINDOW_POS(i, GLint)
    SPANGLE_WINDOW_POS(f, GLfloat)
    SPANGLE_WINDOW_POS(d, GLdouble)
    glWindowPos3f(1.25f, 2.5f, 0.5f), is({1.25, 2.5, 0.5, 1});
    glWindowPos3f(1, 2, -7), is({1, 2, 0.25, 1});
    glWindowPos3f(1, 2, 7), is({1, 2, 0.75, 1});
    near(get(GL_CURRENT_RASTER_COLOR), {1, 0.5, 0, 1}, 0, "colour");
    near(get(GL_CURRENT_RASTER_TEXTURE_COORDS), {1, 2, 3, 4}, 0, "texture coordinates");
    EXPECT_EQ(get(GL_CURRENT_RASTER_DISTANCE)[0], 0);
}

/// A valid raster position is a hit of selection (GL 1.3, 5.2).
TEST_F(RasterPosition, Selection) {
    GLuint hits[8] = {};
    glSelectBuffer(8, hits);
    const auto count = [](auto position) {
        glRenderMode(GL_SELECT);
        position();
        return glRenderMode(GL_RENDER);
    };
    EXPECT_EQ(count([] { glRasterPos3f(0, 0, 0.5f); }), 1);
    EXPECT_NEAR(hits[1], 0.75 * 4294967295.0, 4);
    EXPECT_EQ(hits[1], hits[2]);
    EXPECT_EQ(count([] { glRasterPos3f(0, 0, 1.5f); }), 0);
    EXPECT_EQ(count([] { glWindowPos3f(0, 0, 0.5f); }), 1);
    EXPECT_NEAR(hits[1], 0.5 * 4294967295.0, 4);
}

} // namespace
} // namespace spangle::test
