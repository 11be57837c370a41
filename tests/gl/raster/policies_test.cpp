// Draws stipples, offsets and antialiasing with every numeric policy: the shadow draws the product's bytes,
// and the reference in double nearly the same.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <spangle/GL/gl.h>
#include <spangle/reference.hpp>

#include "tests/support/headless_gl.hpp"

namespace spangle::test {
namespace {

constexpr int size = 64;

void draw_modes() {
    std::mt19937 random(11);
    const auto lot = [&](float low, float high) {
        return low + (high - low) * static_cast<float>(random() % 10000) / 10000;
    };
    std::array<GLubyte, 128> pattern;
    for (GLubyte& byte : pattern)
        byte = static_cast<GLubyte>(random());
    glPolygonStipple(pattern.data());
    glMatrixMode(GL_PROJECTION);
    glFrustum(-1, 1, -1, 1, 1, 10);
    glMatrixMode(GL_MODELVIEW);
    glTranslatef(0, 0, -3);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    constexpr GLenum caps[] = {GL_POINT_SMOOTH,        GL_LINE_SMOOTH,         GL_POLYGON_SMOOTH,
                               GL_LINE_STIPPLE,        GL_POLYGON_STIPPLE,     GL_POLYGON_OFFSET_FILL,
                               GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT};
    constexpr GLenum modes[] = {GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_TRIANGLES, GL_QUADS, GL_POLYGON};
    constexpr GLenum fills[] = {GL_FILL, GL_FILL, GL_LINE, GL_POINT};
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (int n = 0; n < 200; ++n) {
        for (const GLenum cap : caps)
            (random() % 2 != 0 ? glEnable : glDisable)(cap);
        glPolygonMode(GL_FRONT_AND_BACK, fills[random() % 4]);
        glPolygonOffset(lot(-2, 2), lot(-9, 9));
        glLineStipple(static_cast<GLint>(1 + random() % 4), static_cast<GLushort>(random()));
        glLineWidth(lot(0.5f, 6));
        glPointSize(lot(0.5f, 9));
        glBegin(modes[random() % 6]);
        for (int i = 0; i < 6; ++i) {
            glColor4f(lot(0, 1), lot(0, 1), lot(0, 1), lot(0.3f, 1));
            glVertex3f(lot(-3, 3), lot(-3, 3), lot(-1, 1.5f));
        }
        glEnd();
    }
}

struct Picture {
    std::vector<GLubyte> color;
    std::vector<GLuint> depth;
};

Picture picture_of(EGLint precision) {
    const HeadlessGl gl(size, size, {EGL_PRECISION_SPANGLE, precision});
    draw_modes();
    Picture out{std::vector<GLubyte>(4 * size * size), std::vector<GLuint>(size * size)};
    glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, out.color.data());
    glReadPixels(0, 0, size, size, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, out.depth.data());
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    return out;
}

struct Policies : testing::Test {
    void SetUp() override { use_reference_engines(); }
};

TEST_F(Policies, ShadowDrawsThePicture) {
    const Picture fixed = picture_of(EGL_PRECISION_EXACT_SPANGLE),
                  shadow = picture_of(EGL_PRECISION_SHADOW_SPANGLE);
    EXPECT_EQ(fixed.color, shadow.color);
    EXPECT_EQ(fixed.depth, shadow.depth);
}

TEST_F(Policies, DoubleAgrees) {
    const Picture fixed = picture_of(EGL_PRECISION_EXACT_SPANGLE),
                  twin = picture_of(EGL_PRECISION_DOUBLE_SPANGLE);
    int differ = 0, drawn = 0;
    for (std::size_t i = 0; i < fixed.color.size(); ++i) {
        drawn += fixed.color[i] != 0;
        differ += std::abs(fixed.color[i] - twin.color[i]) > 2;
    }
    EXPECT_GT(drawn, size * size);
    EXPECT_LE(differ,
              4 * size * size / 200); // vertices may snap to other places, and depths may be nearly equal
}

} // namespace
} // namespace spangle::test
