// Rows B05, B12, C01, F20: tests texture units, each with its own coordinates, array, matrix, enables and
// image.
#include <array>
#include <cmath>
#include <vector>

#include "tests/gl/vertex/canvas.hpp"
#include "tests/gl/vertex/window_recorder.hpp"

namespace spangle::test {
namespace {

using Coord = std::array<double, 4>;

class TextureUnits : public Canvas {
  protected:
    static Coord current(GLenum unit) {
        GLint active = 0;
        glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
        glActiveTexture(unit);
        Coord v{};
        glGetDoublev(GL_CURRENT_TEXTURE_COORDS, v.data());
        glActiveTexture(static_cast<GLenum>(active));
        return v;
    }
    static void both_on() {
        for (const GLenum unit : {GL_TEXTURE0, GL_TEXTURE1}) {
            glActiveTexture(unit);
            glEnable(GL_TEXTURE_2D);
        }
    }
    static Coord coord_of(const raster::FixedVertex& v, std::size_t unit) {
        const auto& t = v.tex[unit];
        return {std::ldexp(t.s, t.exponent), std::ldexp(t.t, t.exponent), 0,
                t.q_is_one != 0 ? 1 : std::ldexp(t.q, t.exponent)};
    }
};

#define SPANGLE_MULTI(suffix, T, scale)                                                                      \
    {                                                                                                        \
        const T a[4] = {static_cast<T>(2 * (scale)), static_cast<T>(3 * (scale)),                            \
                        static_cast<T>(5 * (scale)), static_cast<T>(7 * (scale))};                           \
        const auto is = [](Coord expected) {                                                                 \
            EXPECT_EQ(current(GL_TEXTURE1), expected) << #suffix;                                            \
            EXPECT_EQ(current(GL_TEXTURE0), (Coord{9, 9, 9, 9})) << #suffix;                                 \
            glMultiTexCoord4f(GL_TEXTURE1, 0, 0, 0, 0);                                                      \
        };                                                                                                   \
        glMultiTexCoord1##suffix(GL_TEXTURE1, a[0]), is({2, 0, 0, 1});                                       \
        glMultiTexCoord2##suffix(GL_TEXTURE1, a[0], a[1]), is({2, 3, 0, 1});                                 \
        glMultiTexCoord3##suffix(GL_TEXTURE1, a[0], a[1], a[2]), is({2, 3, 5, 1});                           \
        glMultiTexCoord4##suffix(GL_TEXTURE1, a[0], a[1], a[2], a[3]), is({2, 3, 5, 7});                     \
    }
#define SPANGLE_MULTI_VECTOR(suffix, T, scale)                                                               \
    {                                                                                                        \
        const T a[4] = {static_cast<T>(2 * (scale)), static_cast<T>(3 * (scale)),                            \
                        static_cast<T>(5 * (scale)), static_cast<T>(7 * (scale))};                           \
        glMultiTexCoord1##suffix(GL_TEXTURE1, a);                                                            \
        EXPECT_EQ(current(GL_TEXTURE1), (Coord{2, 0, 0, 1})) << #suffix;                                     \
        glMultiTexCoord2##suffix(GL_TEXTURE1, a);                                                            \
        EXPECT_EQ(current(GL_TEXTURE1), (Coord{2, 3, 0, 1})) << #suffix;                                     \
        glMultiTexCoord3##suffix(GL_TEXTURE1, a);                                                            \
        EXPECT_EQ(current(GL_TEXTURE1), (Coord{2, 3, 5, 1})) << #suffix;                                     \
        glMultiTexCoord4##suffix(GL_TEXTURE1, a);                                                            \
        EXPECT_EQ(current(GL_TEXTURE1), (Coord{2, 3, 5, 7})) << #suffix;                                     \
    }

TEST_F(TextureUnits, EveryFormOfMultiTexCoord) {
    EXPECT_EQ(current(GL_TEXTURE1), (Coord{0, 0, 0, 1}));
    glTexCoord4f(9, 9, 9, 9);
    SPANGLE_MULTI(s, GLshort, 1)
    SPANGLE_MULTI(i, GLint, 1)
    SPANGLE_MULTI(f, GLfloat, 1)
    SPANGLE_MULTI(d, GLdouble, 1)
    SPANGLE_MULTI(xOES, GLfixed, 65536)
    SPANGLE_MULTI_VECTOR(sv, GLshort, 1)
    SPANGLE_MULTI_VECTOR(iv, GLint, 1)
    SPANGLE_MULTI_VECTOR(fv, GLfloat, 1)
    SPANGLE_MULTI_VECTOR(dv, GLdouble, 1)
    SPANGLE_MULTI_VECTOR(xvOES, GLfixed, 65536)
}

/// TexCoord sets the coordinates of unit 0, whatever unit is active (GL 1.3, 2.7).
TEST_F(TextureUnits, TexCoordIsOfUnitZero) {
    glActiveTexture(GL_TEXTURE1);
    glTexCoord2f(0.5f, 0.25f);
    glMultiTexCoord2f(GL_TEXTURE1, 3, 4);
    EXPECT_EQ(current(GL_TEXTURE0), (Coord{0.5, 0.25, 0, 1}));
    EXPECT_EQ(current(GL_TEXTURE1), (Coord{3, 4, 0, 1}));
    glMultiTexCoord3f(GL_TEXTURE0, 1, 2, 3);
    EXPECT_EQ(current(GL_TEXTURE0), (Coord{1, 2, 3, 1}));
}

TEST_F(TextureUnits, UnitsThatDoNotExist) {
    GLint units = 0;
    glGetIntegerv(GL_MAX_TEXTURE_UNITS, &units);
    EXPECT_EQ(units, 2);
    for (const GLenum unit : {GL_TEXTURE0 - 1u, GL_TEXTURE2 + 0u, GL_TEXTURE31 + 0u, 0u, 1u, 0xFFFFFFFFu}) {
        glActiveTexture(unit);
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
        glClientActiveTexture(unit);
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
        glMultiTexCoord1f(unit, 5);
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    }
    GLint active = 0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    EXPECT_EQ(active, GL_TEXTURE0);
}

TEST_F(TextureUnits, EnablesAndArraysOfEachUnit) {
    glActiveTexture(GL_TEXTURE1);
    glEnable(GL_TEXTURE_2D);
    EXPECT_TRUE(glIsEnabled(GL_TEXTURE_2D));
    glActiveTexture(GL_TEXTURE0);
    EXPECT_FALSE(glIsEnabled(GL_TEXTURE_2D));
    const GLfloat first[2] = {1, 2};
    const GLshort second[3] = {3, 4, 5};
    glTexCoordPointer(2, GL_FLOAT, 0, first);
    glClientActiveTexture(GL_TEXTURE1);
    glTexCoordPointer(3, GL_SHORT, 6, second);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    const auto query = [](GLenum name) {
        GLint v = 0;
        glGetIntegerv(name, &v);
        return v;
    };
    const auto pointer = [] {
        void* p = nullptr;
        glGetPointerv(GL_TEXTURE_COORD_ARRAY_POINTER, &p);
        return static_cast<const void*>(p);
    };
    EXPECT_EQ(query(GL_CLIENT_ACTIVE_TEXTURE), GL_TEXTURE1);
    EXPECT_EQ(query(GL_ACTIVE_TEXTURE), GL_TEXTURE0);
    EXPECT_TRUE(glIsEnabled(GL_TEXTURE_COORD_ARRAY));
    EXPECT_EQ(query(GL_TEXTURE_COORD_ARRAY_SIZE), 3);
    EXPECT_EQ(query(GL_TEXTURE_COORD_ARRAY_TYPE), GL_SHORT);
    EXPECT_EQ(query(GL_TEXTURE_COORD_ARRAY_STRIDE), 6);
    EXPECT_EQ(pointer(), second);
    glClientActiveTexture(GL_TEXTURE0);
    EXPECT_FALSE(glIsEnabled(GL_TEXTURE_COORD_ARRAY));
    EXPECT_EQ(query(GL_TEXTURE_COORD_ARRAY_SIZE), 2);
    EXPECT_EQ(pointer(), first);
    glArrayElement(0);
    EXPECT_EQ(current(GL_TEXTURE0), (Coord{0, 0, 0, 1})) << "off";
    EXPECT_EQ(current(GL_TEXTURE1), (Coord{3, 4, 5, 1}));
    glClientActiveTexture(GL_TEXTURE1);
    const GLfloat interleaved[5] = {6, 7, 0, 0, 0};
    glInterleavedArrays(GL_T2F_V3F, 0, interleaved);
    EXPECT_EQ(query(GL_TEXTURE_COORD_ARRAY_SIZE), 2);
    glClientActiveTexture(GL_TEXTURE0);
    EXPECT_FALSE(glIsEnabled(GL_TEXTURE_COORD_ARRAY));
}

/// Immediate mode, arrays and a list give the same vertices, and each unit uses its own matrix.
TEST_F(TextureUnits, CoordinatesReachTheRasterizer) {
    both_on();
    glMatrixMode(GL_TEXTURE);
    glActiveTexture(GL_TEXTURE1);
    glScalef(2, 4, 1);
    glPushMatrix();
    GLint depth[2] = {};
    glGetIntegerv(GL_TEXTURE_STACK_DEPTH, depth);
    glActiveTexture(GL_TEXTURE0);
    glGetIntegerv(GL_TEXTURE_STACK_DEPTH, depth + 1);
    EXPECT_EQ(depth[0], 2);
    EXPECT_EQ(depth[1], 1);
    const GLfloat position[3][2] = {{-0.5f, -0.5f}, {0.5f, -0.5f}, {0, 0.5f}},
                  first[3][2] = {{0, 0.25f}, {1, 0.5f}, {0.75f, 1}};
    const GLshort second[3][2] = {{1, 2}, {3, 4}, {5, 6}};
    const auto is_drawn = [&](const char* how, auto draw) {
        WindowRecorder recorder;
        draw();
        ASSERT_EQ(recorder.primitives.size(), 1u) << how;
        for (std::size_t i = 0; i < 3; ++i) {
            const raster::FixedVertex& v = recorder.primitives[0].corner[i];
            EXPECT_EQ(coord_of(v, 0), (Coord{first[i][0], first[i][1], 0, 1})) << how;
            EXPECT_EQ(coord_of(v, 1), (Coord{second[i][0] * 2.0, second[i][1] * 4.0, 0, 1})) << how;
        }
    };
    is_drawn("immediate", [&] {
        glBegin(GL_TRIANGLES);
        for (int i = 0; i < 3; ++i) {
            glTexCoord2fv(first[i]);
            glMultiTexCoord2sv(GL_TEXTURE1, second[i]);
            glVertex2fv(position[i]);
        }
        glEnd();
    });
    glVertexPointer(2, GL_FLOAT, 0, position);
    glEnableClientState(GL_VERTEX_ARRAY);
    glTexCoordPointer(2, GL_FLOAT, 0, first);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glClientActiveTexture(GL_TEXTURE1);
    glTexCoordPointer(2, GL_SHORT, 0, second);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    is_drawn("arrays", [] { glDrawArrays(GL_TRIANGLES, 0, 3); });
    glNewList(1, GL_COMPILE);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glEndList();
    is_drawn("list", [] { glCallList(1); });
    // Only the second array is left, so unit 0 has its current coordinates.
    glClientActiveTexture(GL_TEXTURE0);
    glDisableClientState(GL_TEXTURE_COORD_ARRAY);
    glTexCoord2f(0.5f, 0.125f);
    WindowRecorder recorder;
    glDrawArrays(GL_TRIANGLES, 0, 3);
    ASSERT_EQ(recorder.primitives.size(), 1u);
    EXPECT_EQ(coord_of(recorder.primitives[0].corner[2], 0), (Coord{0.5, 0.125, 0, 1}));
    EXPECT_EQ(coord_of(recorder.primitives[0].corner[2], 1), (Coord{10, 24, 0, 1}));
}

/// Attribute groups save the state of every unit, and which unit is active (GL 1.3, 6.1.12).
TEST_F(TextureUnits, AttributeGroups) {
    const auto set = [](GLenum active, GLfloat s, bool on) {
        for (const GLenum unit : {GL_TEXTURE0, GL_TEXTURE1}) {
            const GLfloat at = s + static_cast<GLfloat>(unit - GL_TEXTURE0);
            glActiveTexture(unit);
            glClientActiveTexture(unit);
            glMultiTexCoord1f(unit, at);
            (on ? glEnable : glDisable)(GL_TEXTURE_2D);
            (on ? glEnableClientState : glDisableClientState)(GL_TEXTURE_COORD_ARRAY);
        }
        glActiveTexture(active);
        glClientActiveTexture(active);
    };
    const auto state = [] {
        GLint active[2];
        glGetIntegerv(GL_ACTIVE_TEXTURE, active);
        glGetIntegerv(GL_CLIENT_ACTIVE_TEXTURE, active + 1);
        std::vector<double> v{double(active[0]), double(active[1])};
        for (const GLenum unit : {GL_TEXTURE0, GL_TEXTURE1}) {
            glActiveTexture(unit);
            glClientActiveTexture(unit);
            GLfloat at[4];
            glGetFloatv(GL_CURRENT_TEXTURE_COORDS, at);
            v.insert(v.end(), {double(at[0]), double(glIsEnabled(GL_TEXTURE_2D)),
                               double(glIsEnabled(GL_TEXTURE_COORD_ARRAY))});
        }
        glActiveTexture(static_cast<GLenum>(active[0]));
        glClientActiveTexture(static_cast<GLenum>(active[1]));
        return v;
    };
    const struct {
        GLbitfield server, client;
        std::vector<double> left; ///< selectors, then for each unit: coordinate, texturing, array
    } cases[] = {
        {GL_CURRENT_BIT, 0, {GL_TEXTURE0, GL_TEXTURE0, 2, 0, 0, 3, 0, 0}},
        {GL_ENABLE_BIT, 0, {GL_TEXTURE0, GL_TEXTURE0, 8, 1, 0, 9, 1, 0}},
        {GL_TEXTURE_BIT, 0, {GL_TEXTURE1, GL_TEXTURE0, 8, 1, 0, 9, 1, 0}},
        {0, GL_CLIENT_VERTEX_ARRAY_BIT, {GL_TEXTURE0, GL_TEXTURE1, 8, 0, 1, 9, 0, 1}},
    };
    for (const auto& c : cases) {
        set(GL_TEXTURE1, 2, true);
        glPushAttrib(c.server);
        glPushClientAttrib(c.client);
        set(GL_TEXTURE0, 8, false);
        glPopClientAttrib();
        glPopAttrib();
        EXPECT_EQ(state(), c.left) << std::hex << c.server << ' ' << c.client;
    }
}

/// Vertices that clipping makes have the coordinates of both units.
TEST_F(TextureUnits, ClippedCoordinates) {
    both_on();
    WindowRecorder recorder;
    glBegin(GL_LINES);
    glMultiTexCoord2f(GL_TEXTURE1, 0, 8);
    glVertex3f(0, 0, 0);
    glMultiTexCoord2f(GL_TEXTURE1, 4, 0);
    glVertex3f(0, 0, 4); // the near plane cuts at z = 1
    glEnd();
    ASSERT_EQ(recorder.primitives.size(), 1u);
    const Coord cut = coord_of(recorder.primitives[0].corner[1], 1);
    EXPECT_NEAR(cut[0] / cut[3], 1, 1e-6);
    EXPECT_NEAR(cut[1] / cut[3], 6, 1e-6);
}

/// Unit 1 works on the result of unit 0 (GL 1.3, 3.8.13).
TEST_F(TextureUnits, UnitsInTurn) {
    const GLubyte red[4] = {200, 100, 50, 255}, half[4] = {128, 255, 0, 255};
    GLuint names[2];
    glGenTextures(2, names);
    for (GLenum unit = 0; unit < 2; ++unit) {
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_2D, names[unit]);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, unit == 0 ? red : half);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, unit == 0 ? GL_REPLACE : GL_MODULATE);
        GLint bound = 0;
        glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
        EXPECT_EQ(bound, static_cast<GLint>(names[unit]));
    }
    const auto pixel = [](bool first, bool second) {
        glActiveTexture(GL_TEXTURE0);
        (first ? glEnable : glDisable)(GL_TEXTURE_2D);
        glActiveTexture(GL_TEXTURE1);
        (second ? glEnable : glDisable)(GL_TEXTURE_2D);
        glRectf(-1, -1, 1, 1);
        std::array<GLubyte, 4> rgba{};
        glReadPixels(5, 5, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
        return rgba;
    };
    using Pixel = std::array<GLubyte, 4>;
    EXPECT_EQ(pixel(false, false), (Pixel{255, 255, 255, 255}));
    EXPECT_EQ(pixel(true, false), (Pixel{200, 100, 50, 255}));
    EXPECT_EQ(pixel(false, true), (Pixel{128, 255, 0, 255}));
    EXPECT_EQ(pixel(true, true), (Pixel{100, 100, 0, 255})); // 200 x 128 / 255
    glDeleteTextures(2, names);
}

} // namespace
} // namespace spangle::test
