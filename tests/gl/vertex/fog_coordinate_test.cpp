// Row B10: tests the fog coordinate, a vertex's own distance for fog (GL 1.4, 2.7 and 3.10).
#include <cmath>

#include "gl/context/features.hpp"
#include "tests/gl/vertex/canvas.hpp"
#include "tests/gl/vertex/window_recorder.hpp"

namespace spangle::test {
namespace {

#if SPANGLE_FEATURE_FOG

class FogCoordinate : public Canvas {
  protected:
    void SetUp() override {
        Canvas::SetUp();
        glEnable(GL_FOG);
    }
    static GLfloat current() {
        GLfloat v = -77;
        glGetFloatv(GL_CURRENT_FOG_COORDINATE, &v);
        return v;
    }
    static double of(const raster::FixedVertex& v) { return std::ldexp(v.fog_mantissa, v.fog_exponent); }
    /// Returns the red of a white point in black fog at the coordinate `coord`.
    static int left(GLfloat coord) {
        glClear(GL_COLOR_BUFFER_BIT);
        glFogCoordf(coord);
        glRectf(-1, -1, 1, 1);
        GLubyte pixel[4];
        glReadPixels(size / 2, size / 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
        return pixel[0];
    }
};

TEST_F(FogCoordinate, EveryForm) {
    EXPECT_EQ(current(), 0);
    glFogCoordf(-1.5f);
    EXPECT_EQ(current(), -1.5f);
    glFogCoordd(3e5);
    EXPECT_EQ(current(), 3e5f);
    const GLfloat f = 7;
    glFogCoordfv(&f);
    EXPECT_EQ(current(), 7);
    const GLdouble d = -0.25;
    glFogCoorddv(&d);
    EXPECT_EQ(current(), -0.25f);
    glPushAttrib(GL_CURRENT_BIT);
    glFogCoordf(1);
    glPopAttrib();
    EXPECT_EQ(current(), -0.25f);
}

TEST_F(FogCoordinate, Arrays) {
    const GLfloat f[2] = {1, -2.5f};
    const GLdouble d[2] = {1, 1e3};
    const auto second_is = [](GLenum type, const void* array, GLfloat expected) {
        glFogCoordPointer(type, 0, array);
        glArrayElement(1);
        EXPECT_EQ(current(), expected);
#if SPANGLE_FEATURE_LISTS
        glNewList(1, GL_COMPILE);
        glArrayElement(1);
        glEndList();
        glFogCoordf(0);
        glCallList(1);
        EXPECT_EQ(current(), expected);
#endif
    };
    glEnableClientState(GL_FOG_COORDINATE_ARRAY);
    second_is(GL_FLOAT, f, -2.5f);
    second_is(GL_DOUBLE, d, 1e3f);
    glFogCoordPointer(GL_FLOAT, 8, f);
    GLint now[2];
    glGetIntegerv(GL_FOG_COORDINATE_ARRAY_TYPE, now);
    glGetIntegerv(GL_FOG_COORDINATE_ARRAY_STRIDE, now + 1);
    EXPECT_EQ(now[0], GL_FLOAT);
    EXPECT_EQ(now[1], 8);
    void* pointer = nullptr;
    glGetPointerv(GL_FOG_COORDINATE_ARRAY_POINTER, &pointer);
    EXPECT_EQ(pointer, f);
    glFogCoordPointer(GL_INT, 0, f);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    glFogCoordPointer(GL_FLOAT, -1, f);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    EXPECT_TRUE(glIsEnabled(GL_FOG_COORDINATE_ARRAY));
    glInterleavedArrays(GL_V2F, 0, nullptr); // disables the array (GL 1.4, 2.8)
    EXPECT_FALSE(glIsEnabled(GL_FOG_COORDINATE_ARRAY));
}

/// Vertices have the distance to the eye or the given coordinate, from commands and from elements.
TEST_F(FogCoordinate, Source) {
    const auto triangle = [] {
        WindowRecorder recorder;
        glBegin(GL_TRIANGLES);
        for (int i = 0; i < 3; ++i) {
            glFogCoordf(static_cast<GLfloat>(10 * i) - 5);
            glVertex3f(i == 1 ? 1 : 0, i == 2 ? 1 : 0, -0.25f);
        }
        glEnd();
        return recorder.primitives.at(0);
    };
    const Primitive eye = triangle();
    for (const raster::FixedVertex& v : eye.corner)
        EXPECT_EQ(of(v), 0.25);
    glFogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
    const Primitive given = triangle();
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(of(given.corner[i]), 10 * i - 5);
    const GLfloat position[3][2] = {{0, 0}, {1, 0}, {0, 1}}, coord[3] = {-5, 5, 15};
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_FOG_COORDINATE_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, position);
    glFogCoordPointer(GL_FLOAT, 0, coord);
    WindowRecorder recorder;
    glDrawArrays(GL_TRIANGLES, 0, 3);
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(of(recorder.primitives.at(0).corner[i]), 10 * i - 5);
    GLint source = 0;
    glGetIntegerv(GL_FOG_COORDINATE_SOURCE, &source);
    EXPECT_EQ(source, GL_FOG_COORDINATE);
    glFogi(GL_FOG_COORDINATE_SOURCE, GL_LINEAR);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    glGetIntegerv(GL_FOG_COORDINATE_SOURCE, &source);
    EXPECT_EQ(source, GL_FOG_COORDINATE);
}

/// Vertices that clipping makes lie on the line between the coordinates, signs included (GL 1.3, 2.13.8).
TEST_F(FogCoordinate, Clipped) {
    glFogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
    WindowRecorder recorder;
    glBegin(GL_LINES);
    glFogCoordf(-8);
    glVertex3f(0, 0, 0);
    glFogCoordf(8);
    glVertex3f(0, 0.5f, 2);
    glEnd();
    ASSERT_EQ(recorder.primitives.size(), 1u);
    EXPECT_NEAR(of(recorder.primitives[0].corner[0]), -8, 1e-6);
    EXPECT_NEAR(of(recorder.primitives[0].corner[1]), 0, 1e-6);
}

TEST_F(FogCoordinate, FactorsOfAllModes) {
    glFogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
    glDisable(GL_DITHER);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_START, -10);
    glFogf(GL_FOG_END, 10);
    for (const GLfloat c : {-20.0f, -10.0f, -5.0f, 0.0f, 5.0f, 10.0f, 20.0f})
        EXPECT_NEAR(left(c), 255 * std::fmin(1, std::fmax(0, (10 - c) / 20)), 0.51) << c;
    glFogf(GL_FOG_DENSITY, 0.5f);
    glFogi(GL_FOG_MODE, GL_EXP);
    for (const GLfloat c : {-20.0f, -1.0f, 0.0f, 1.0f, 3.0f})
        EXPECT_NEAR(left(c), 255 * std::fmin(1, std::exp(-0.5 * c)), 0.51) << c;
    glFogi(GL_FOG_MODE, GL_EXP2);
    for (const GLfloat c : {-2.0f, 0.0f, 1.0f, 3.0f})
        EXPECT_NEAR(left(c), 255 * std::exp(-0.25 * c * c), 0.51) << c;
}

/// If START equals END, nothing is divided by 0. What lies nearer is clear, what lies beyond END is fog (the
/// limit of the formula), and the last unit before END is a ramp, as in Mesa.
TEST_F(FogCoordinate, LinearFogThatStartsWhereItEnds) {
    glFogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
    glDisable(GL_DITHER);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    for (const GLfloat end : {0.0f, 3.0f, -7.5f, 1000.0f, 1e6f}) {
        glFogf(GL_FOG_START, end);
        glFogf(GL_FOG_END, end);
        for (const GLfloat before : {1e9f, 2.0f, 1.0f, 0.5f, 0.25f, 0.0f, -0.5f, -100.0f, -1e9f})
            EXPECT_NEAR(left(end - before), 255 * std::fmin(1, std::fmax(0, before)), 0.51)
                << end << ' ' << before;
    }
}

#if SPANGLE_FEATURE_RASTER_POS
TEST_F(FogCoordinate, RasterPosition) {
    const auto distance = [] {
        GLfloat v = -77;
        glGetFloatv(GL_CURRENT_RASTER_DISTANCE, &v);
        return v;
    };
    glFogCoordf(-3);
    glRasterPos3f(0, 0, -0.5f);
    EXPECT_EQ(distance(), 0.5f);
    glWindowPos2i(0, 0);
    EXPECT_EQ(distance(), 0);
    glFogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
    glRasterPos3f(0, 0, -0.5f);
    EXPECT_EQ(distance(), -3);
    glFogCoordf(4);
    glWindowPos2i(0, 0);
    EXPECT_EQ(distance(), 4);
}
#endif

#endif

} // namespace
} // namespace spangle::test
