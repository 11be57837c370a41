// Rows A02, B05 to B07, B09, B12, B13, B19: tests every form of the attribute commands, rectangles, and the
// current values after arrays.
#include <cmath>
#include <limits>
#include <vector>

#include "gl/vertex/array_element.hpp"
#include "tests/gl/vertex/canvas.hpp"
#include "tests/gl/vertex/window_recorder.hpp"

namespace spangle::test {
namespace {

class Attributes : public Canvas {
  protected:
    /// Compares current values with these numbers as floats, within half a unit of the last place.
    static void current_is(const char* command, GLenum name, std::vector<double> expected) {
        GLdouble got[4] = {};
        glGetDoublev(name, got);
        for (std::size_t c = 0; c < expected.size(); ++c)
            EXPECT_NEAR(got[c], expected[c], std::ldexp(std::fabs(expected[c]), -24)) << command << ' ' << c;
    }
};

/// Table 2.6 converts an unsigned c to c / (2^b - 1), and a signed c to (2c + 1) / (2^b - 1).
template <class T> double fraction(T c) {
    using U = std::make_unsigned_t<T>;
    const double most = static_cast<double>(std::numeric_limits<U>::max());
    return std::is_signed_v<T> ? (2.0 * static_cast<double>(c) + 1) / most : static_cast<double>(c) / most;
}
double as_is(double v) {
    return v;
}
double from_fixed(GLfixed v) {
    return v / 65536.0;
}

#define SPANGLE_CASE(name, T, meaning, current, count, rest)                                                 \
    {                                                                                                        \
        const T v[4] = {values<T>(0), values<T>(1), values<T>(2), values<T>(3)};                             \
        std::vector<double> expected rest;                                                                   \
        for (std::size_t c = 0; c < count; ++c)                                                              \
            expected[c] = meaning(v[c]);                                                                     \
        name##v(v);                                                                                          \
        current_is(#name "v", current, expected);                                                            \
    }

/// Returns the least value, the largest, or one between.
template <class T> T values(int i) {
    using L = std::numeric_limits<T>;
    if constexpr (std::is_floating_point_v<T>)
        return static_cast<T>(i == 0 ? -2.5 : i == 1 ? 0.1 : i == 2 ? 7 : 0.75);
    else
        return static_cast<T>(i == 0 ? L::min() : i == 1 ? L::max() : i == 2 ? 77 : L::max() / 3);
}

#define SPANGLE_COLOR(suffix, T, meaning)                                                                    \
    SPANGLE_CASE(glColor3##suffix, T, meaning, GL_CURRENT_COLOR, 3, ({9, 9, 9, 1}))                          \
    SPANGLE_CASE(glColor4##suffix, T, meaning, GL_CURRENT_COLOR, 4, ({9, 9, 9, 9})) {                        \
        const T a = values<T>(0), b = values<T>(1), c = values<T>(2), d = values<T>(3);                      \
        glColor4##suffix(a, b, c, d);                                                                        \
        current_is("glColor4" #suffix, GL_CURRENT_COLOR, {meaning(a), meaning(b), meaning(c), meaning(d)});  \
        glColor3##suffix(c, a, b);                                                                           \
        current_is("glColor3" #suffix, GL_CURRENT_COLOR, {meaning(c), meaning(a), meaning(b), 1});           \
    }

TEST_F(Attributes, EveryFormOfColor) {
    SPANGLE_COLOR(b, GLbyte, fraction);
    SPANGLE_COLOR(s, GLshort, fraction);
    SPANGLE_COLOR(i, GLint, fraction);
    SPANGLE_COLOR(f, GLfloat, as_is);
    SPANGLE_COLOR(d, GLdouble, as_is);
    SPANGLE_COLOR(ub, GLubyte, fraction);
    SPANGLE_COLOR(us, GLushort, fraction);
    SPANGLE_COLOR(ui, GLuint, fraction);
    const GLfixed v[4] = {-0x18000, 0x8000, 0x10000, 0x4000};
    glColor4xvOES(v);
    current_is("glColor4xvOES", GL_CURRENT_COLOR, {-1.5, 0.5, 1, 0.25});
    glColor3xOES(v[1], v[2], v[3]);
    current_is("glColor3xOES", GL_CURRENT_COLOR, {0.5, 1, 0.25, 1});
}

#define SPANGLE_NORMAL(suffix, T, meaning)                                                                   \
    SPANGLE_CASE(glNormal3##suffix, T, meaning, GL_CURRENT_NORMAL, 3, ({9, 9, 9})) {                         \
        const T a = values<T>(3), b = values<T>(1), c = values<T>(0);                                        \
        glNormal3##suffix(a, b, c);                                                                          \
        current_is("glNormal3" #suffix, GL_CURRENT_NORMAL, {meaning(a), meaning(b), meaning(c)});            \
    }

TEST_F(Attributes, EveryFormOfNormal) {
    SPANGLE_NORMAL(b, GLbyte, fraction);
    SPANGLE_NORMAL(s, GLshort, fraction);
    SPANGLE_NORMAL(i, GLint, fraction);
    SPANGLE_NORMAL(f, GLfloat, as_is);
    SPANGLE_NORMAL(d, GLdouble, as_is);
    const GLfixed v[3] = {-0x18000, 0x8000, 0x10000};
    glNormal3xvOES(v);
    current_is("glNormal3xvOES", GL_CURRENT_NORMAL, {-1.5, 0.5, 1});
}

#define SPANGLE_TEX_COORD(suffix, tail, T, meaning)                                                          \
    {                                                                                                        \
        const T v[4] = {values<T>(0), values<T>(1), values<T>(2), values<T>(3)};                             \
        const double e[4] = {meaning(v[0]), meaning(v[1]), meaning(v[2]), meaning(v[3])};                    \
        glTexCoord4##suffix##v##tail(v);                                                                     \
        current_is("glTexCoord4" #suffix "v", GL_CURRENT_TEXTURE_COORDS, {e[0], e[1], e[2], e[3]});          \
        glTexCoord3##suffix##v##tail(v);                                                                     \
        current_is("glTexCoord3" #suffix "v", GL_CURRENT_TEXTURE_COORDS, {e[0], e[1], e[2], 1});             \
        glTexCoord2##suffix##v##tail(v);                                                                     \
        current_is("glTexCoord2" #suffix "v", GL_CURRENT_TEXTURE_COORDS, {e[0], e[1], 0, 1});                \
        glTexCoord1##suffix##v##tail(v);                                                                     \
        current_is("glTexCoord1" #suffix "v", GL_CURRENT_TEXTURE_COORDS, {e[0], 0, 0, 1});                   \
        glTexCoord4##suffix##tail(v[1], v[2], v[3], v[0]);                                                   \
        current_is("glTexCoord4" #suffix, GL_CURRENT_TEXTURE_COORDS, {e[1], e[2], e[3], e[0]});              \
        glTexCoord3##suffix##tail(v[1], v[2], v[3]);                                                         \
        current_is("glTexCoord3" #suffix, GL_CURRENT_TEXTURE_COORDS, {e[1], e[2], e[3], 1});                 \
        glTexCoord2##suffix##tail(v[1], v[2]);                                                               \
        current_is("glTexCoord2" #suffix, GL_CURRENT_TEXTURE_COORDS, {e[1], e[2], 0, 1});                    \
        glTexCoord1##suffix##tail(v[1]);                                                                     \
        current_is("glTexCoord1" #suffix, GL_CURRENT_TEXTURE_COORDS, {e[1], 0, 0, 1});                       \
    }

TEST_F(Attributes, EveryFormOfTexCoord) {
    SPANGLE_TEX_COORD(s, , GLshort, as_is);
    SPANGLE_TEX_COORD(i, , GLint, as_is);
    SPANGLE_TEX_COORD(f, , GLfloat, as_is);
    SPANGLE_TEX_COORD(d, , GLdouble, as_is);
    SPANGLE_TEX_COORD(x, OES, GLfixed, from_fixed);
}

/// Rect(x1, y1, x2, y2) is the polygon (x1, y1), (x2, y1), (x2, y2), (x1, y2) (GL 1.3, 2.9).
TEST_F(Attributes, EveryFormOfRect) {
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, size, 0, size, -1, 1);
    const auto is = [](const char* command, auto draw) {
        WindowRecorder recorder;
        draw();
        ASSERT_EQ(recorder.primitives.size(), 2u) << command;
        const int corner[2][3][2] = {{{3, 5}, {20, 5}, {20, 40}}, {{3, 5}, {20, 40}, {3, 40}}};
        for (std::size_t t = 0; t < 2; ++t)
            for (int c = 0; c < 3; ++c) {
                EXPECT_EQ(recorder.primitives[t].corner[c].x, corner[t][c][0] * 256) << command << t << c;
                EXPECT_EQ(recorder.primitives[t].corner[c].y, corner[t][c][1] * 256) << command << t << c;
            }
    };
    const GLshort s[4] = {3, 5, 20, 40};
    const GLint i[4] = {3, 5, 20, 40};
    const GLfloat f[4] = {3, 5, 20, 40};
    const GLdouble d[4] = {3, 5, 20, 40};
    const GLfixed x[4] = {3 << 16, 5 << 16, 20 << 16, 40 << 16};
    is("s", [&] { glRects(s[0], s[1], s[2], s[3]); });
    is("sv", [&] { glRectsv(s, s + 2); });
    is("i", [&] { glRecti(i[0], i[1], i[2], i[3]); });
    is("iv", [&] { glRectiv(i, i + 2); });
    is("f", [&] { glRectf(f[0], f[1], f[2], f[3]); });
    is("fv", [&] { glRectfv(f, f + 2); });
    is("d", [&] { glRectd(d[0], d[1], d[2], d[3]); });
    is("dv", [&] { glRectdv(d, d + 2); });
    is("x", [&] { glRectxOES(x[0], x[1], x[2], x[3]); });
    is("xv", [&] { glRectxvOES(x, x + 2); });
    glEnable(GL_CULL_FACE);
    WindowRecorder recorder;
    glRecti(20, 5, 3, 40); // the corners are exchanged
    EXPECT_TRUE(recorder.primitives.empty());
}

#define SPANGLE_INDEX(suffix, T)                                                                             \
    SPANGLE_CASE(glIndex##suffix, T, as_is, GL_CURRENT_INDEX, 1, ({9})) {                                    \
        const T a = values<T>(2);                                                                            \
        glIndex##suffix(a);                                                                                  \
        current_is("glIndex" #suffix, GL_CURRENT_INDEX, {as_is(a)});                                         \
    }

/// Row B09: indices are not scaled, in every form and from arrays of every type.
TEST_F(Attributes, EveryFormOfIndex) {
    current_is("initially", GL_CURRENT_INDEX, {1});
    SPANGLE_INDEX(s, GLshort);
    SPANGLE_INDEX(i, GLint);
    SPANGLE_INDEX(f, GLfloat);
    SPANGLE_INDEX(d, GLdouble);
    SPANGLE_INDEX(ub, GLubyte);
    const GLfixed x = -0x18000;
    glIndexxOES(x);
    current_is("glIndexxOES", GL_CURRENT_INDEX, {-1.5});
    const GLubyte ub[2] = {3, 200};
    const GLshort s[2] = {3, -200};
    const GLint i[2] = {3, -70000};
    const GLfloat f[2] = {3, 0.25f};
    const GLdouble d[2] = {3, 1e3};
    glEnableClientState(GL_INDEX_ARRAY);
    const auto second_is = [](GLenum type, const void* array, double expected) {
        glIndexPointer(type, 0, array);
        glArrayElement(1);
        current_is("glIndexPointer", GL_CURRENT_INDEX, {expected});
        glIndexf(0);
        glNewList(1, GL_COMPILE);
        glArrayElement(1);
        glEndList();
        current_is("compiled", GL_CURRENT_INDEX, {0});
        glCallList(1);
        current_is("called", GL_CURRENT_INDEX, {expected});
    };
    second_is(GL_UNSIGNED_BYTE, ub, 200);
    second_is(GL_SHORT, s, -200);
    second_is(GL_INT, i, -70000);
    second_is(GL_FLOAT, f, 0.25);
    second_is(GL_DOUBLE, d, 1e3);
    const GLfixed fixed[2] = {0, x};
    second_is(GL_FIXED, fixed, -1.5);
    glInterleavedArrays(GL_V2F, 0, nullptr); // disables the array (GL 1.3, 2.8)
    EXPECT_FALSE(glIsEnabled(GL_INDEX_ARRAY));
}

/// ArrayElement outside of Begin and End sets current values and draws nothing (GL 1.3, 2.8).
TEST_F(Attributes, ArrayElementSetsCurrentValues) {
    const GLubyte color[2][3] = {{1, 2, 3}, {51, 102, 204}};
    const GLshort normal[2][3] = {{0, 0, 0}, {32767, -32768, 100}};
    const GLdouble tex[2][2] = {{0, 0}, {0.5, 2.5}};
    const GLfloat position[2][2] = {{0, 0}, {0.25f, 0.25f}};
    glColorPointer(3, GL_UNSIGNED_BYTE, 0, color);
    glNormalPointer(GL_SHORT, 0, normal);
    glTexCoordPointer(2, GL_DOUBLE, 0, tex);
    glVertexPointer(2, GL_FLOAT, 0, position);
    for (const GLenum array : {GL_COLOR_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_VERTEX_ARRAY})
        glEnableClientState(array);
    WindowRecorder recorder;
    glArrayElement(1);
    EXPECT_TRUE(recorder.primitives.empty());
    current_is("colour", GL_CURRENT_COLOR, {0.2, 0.4, 0.8, 1});
    current_is("normal", GL_CURRENT_NORMAL, {1, -1, 201.0 / 65535});
    current_is("texture coordinate", GL_CURRENT_TEXTURE_COORDS, {0.5, 2.5, 0, 1});
    glDisableClientState(GL_VERTEX_ARRAY);
    glDrawArrays(GL_POINTS, 0, 2);
    EXPECT_TRUE(recorder.primitives.empty()) << "without vertices there is no geometry";
}

/// Drivers keep the current values when arrays are drawn, and programs rely on it. The test has each enabled
/// array and every command that draws arrays, at once and from a list, with a material that follows the
/// colour and without.
TEST_F(Attributes, DrawnArraysLeaveCurrentValues) {
    const GLfloat four[3][4] = {{0.1f, 0.2f, 0.3f, 0.4f}, {0.5f, 0.6f, 0.7f, 0.8f}, {0.9f, 1, 0, 0.5f}};
    const GLubyte flags[3] = {0, 0, 0};
    for (GLint unit = 0; unit < 2; ++unit) {
        glClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glTexCoordPointer(4, GL_FLOAT, 0, four);
        glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    }
    glVertexPointer(3, GL_FLOAT, 16, four);
    glNormalPointer(GL_FLOAT, 16, four);
    glColorPointer(4, GL_FLOAT, 0, four);
    glSecondaryColorPointer(3, GL_FLOAT, 16, four);
    glFogCoordPointer(GL_FLOAT, 16, four);
    glIndexPointer(GL_FLOAT, 16, four);
    glEdgeFlagPointer(0, flags);
    const GLubyte indices[3] = {0, 1, 2};
    const void* const many[] = {indices};
    const GLint first = 0;
    const GLsizei count = 3;
    const auto draw = [&](int how) {
        how == 0   ? glDrawArrays(GL_TRIANGLES, 0, 3)
        : how == 1 ? glDrawElements(GL_LINE_LOOP, 3, GL_UNSIGNED_BYTE, indices)
        : how == 2 ? glDrawRangeElements(GL_POINTS, 0, 2, 3, GL_UNSIGNED_BYTE, indices)
        : how == 3 ? glMultiDrawArrays(GL_POLYGON, &first, &count, 1)
                   : glMultiDrawElements(GL_TRIANGLE_STRIP, &count, GL_UNSIGNED_BYTE,
                                         const_cast<const void**>(many), 1);
    };
    constexpr GLenum arrays[] = {GL_NORMAL_ARRAY,         GL_COLOR_ARRAY, GL_SECONDARY_COLOR_ARRAY,
                                 GL_FOG_COORDINATE_ARRAY, GL_INDEX_ARRAY, GL_EDGE_FLAG_ARRAY};
    for (unsigned on = 0; on < 64 * 4; ++on) {
        (on & 64 ? glEnable : glDisable)(GL_LIGHTING);
        (on & 128 ? glEnable : glDisable)(GL_COLOR_MATERIAL);
        for (unsigned i = 0; i < 6; ++i)
            (on >> i & 1 ? glEnableClientState : glDisableClientState)(arrays[i]);
        glEnableClientState(GL_VERTEX_ARRAY);
        glColor4f(0.25f, 0.5f, 0.75f, 1);
        glSecondaryColor3f(0.125f, 0.25f, 0.5f);
        glNormal3f(0, -1, 0);
        glIndexf(7);
        glFogCoordf(3);
        glEdgeFlag(GL_TRUE);
        glMultiTexCoord4f(GL_TEXTURE0, 1, 2, 3, 4);
        glMultiTexCoord4f(GL_TEXTURE1, 5, 6, 7, 8);
        const int how = static_cast<int>(on % 5);
        if (on % 3 == 0) {
            draw(how);
        } else {
            glNewList(1, on % 3 == 1 ? GL_COMPILE : GL_COMPILE_AND_EXECUTE);
            draw(how);
            glEndList();
            glCallList(1);
        }
        current_is("colour", GL_CURRENT_COLOR, {0.25, 0.5, 0.75, 1});
        current_is("secondary colour", GL_CURRENT_SECONDARY_COLOR, {0.125, 0.25, 0.5, 1});
        current_is("normal", GL_CURRENT_NORMAL, {0, -1, 0});
        current_is("index", GL_CURRENT_INDEX, {7});
        current_is("fog coordinate", GL_CURRENT_FOG_COORDINATE, {3});
        current_is("edge flag", GL_EDGE_FLAG, {1});
        current_is("texture coordinates", GL_CURRENT_TEXTURE_COORDS, {1, 2, 3, 4});
        glActiveTexture(GL_TEXTURE1);
        current_is("texture coordinates", GL_CURRENT_TEXTURE_COORDS, {5, 6, 7, 8});
        glActiveTexture(GL_TEXTURE0);
        if (on & 128) {
            GLfloat diffuse[4];
            glGetMaterialfv(GL_FRONT, GL_DIFFUSE, diffuse);
            EXPECT_EQ(diffuse[2], 0.75f) << "the material follows the colour";
        }
        ASSERT_FALSE(HasFailure()) << on;
    }
    glDisable(GL_COLOR_MATERIAL);
}

/// A vertex has the colour that was current when it was given, to the last component.
TEST_F(Attributes, EachComponentOfTheColorCounts) {
    GLubyte rgba[4] = {10, 20, 30, 40};
    WindowRecorder recorder;
    glBegin(GL_POINTS);
    for (GLubyte& c : rgba) {
        c = static_cast<GLubyte>(c + 100);
        glColor4ubv(rgba);
        glVertex2f(0, 0);
    }
    glEnd();
    ASSERT_EQ(recorder.primitives.size(), 4u);
    for (unsigned i = 0; i < 4; ++i)
        for (unsigned c = 0; c < 4; ++c)
            EXPECT_EQ((recorder.primitives[i].corner[0].color[c] + (1u << 19)) >> 20,
                      10 * (c + 1) + (c <= i ? 100 : 0))
                << i << ' ' << c;
}

/// Components that an array leaves out have the values that the command of the same size gives them (GL 1.3,
/// 2.8).
TEST_F(Attributes, ArraysOfFewComponents) {
    const GLfloat s[] = {0.5f, 0.25f, 0.125f, 1, 2, 3}, other[4] = {7, 8, 9, 10};
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    for (GLint size = 1; size <= 3; ++size) {
        glTexCoord4fv(other);
        glTexCoordPointer(size, GL_FLOAT, 0, s);
        glArrayElement(1);
        std::vector<double> expected(s + size, s + 2 * size);
        expected.resize(3, 0);
        expected.push_back(1);
        current_is("glTexCoordPointer", GL_CURRENT_TEXTURE_COORDS, expected);
    }
}

/// The range of indices is the program's promise. A range that no index can keep is an error (GL 1.3, 2.8).
TEST_F(Attributes, ElementsAndTheirErrors) {
    const GLfloat position[3][2] = {{0, 0}, {0.5f, 0}, {0, 0.5f}};
    const GLubyte index[4] = {2, 0, 1, 2};
    glVertexPointer(2, GL_FLOAT, 0, position);
    glEnableClientState(GL_VERTEX_ARRAY);
    const auto drawn = [](auto draw, GLenum code) {
        WindowRecorder recorder;
        draw();
        EXPECT_EQ(glGetError(), code);
        return recorder.primitives.size();
    };
    const GLenum byte = GL_UNSIGNED_BYTE, none = GL_NO_ERROR, value = GL_INVALID_VALUE,
                 word = GL_INVALID_ENUM;
    EXPECT_EQ(drawn([&] { glDrawRangeElements(GL_POINTS, 0, 2, 4, byte, index); }, none), 4u);
    EXPECT_EQ(drawn([&] { glDrawRangeElements(GL_POINTS, 2, 2, 1, byte, index); }, none), 1u);
    EXPECT_EQ(drawn([&] { glDrawRangeElements(GL_POINTS, 2, 1, 1, byte, index); }, value), 0u);
    EXPECT_EQ(drawn([&] { glDrawElements(GL_POINTS, -1, byte, index); }, value), 0u);
    EXPECT_EQ(drawn([&] { glDrawElements(GL_POINTS, 1, GL_INT, index); }, word), 0u);
    EXPECT_EQ(drawn([&] { glDrawElements(GL_POLYGON + 1, 1, byte, index); }, word), 0u);
    EXPECT_EQ(drawn([&] { glDrawElements(GL_POINTS, 1, byte, nullptr); }, value), 0u);
    EXPECT_EQ(drawn([&] { glDrawElements(GL_POINTS, 0, byte, nullptr); }, none), 0u);
    EXPECT_EQ(drawn([&] { glDrawArrays(GL_POINTS, 1, 2); }, none), 2u);
    WindowRecorder recorder;
    glDrawArrays(GL_POINTS, 1, 1);
    ASSERT_EQ(recorder.primitives.size(), 1u);
    EXPECT_EQ(recorder.primitives[0].corner[0].x, size * 3 / 4 * 256) << "the second one";
    EXPECT_EQ(drawn([&] { glDrawArrays(GL_POINTS, -1, 2); }, value), 0u);
    EXPECT_EQ(drawn([&] { glDrawArrays(GL_POINTS, 0, -2); }, value), 0u);
    EXPECT_EQ(drawn([&] { glArrayElement(-1); }, value), 0u);
}

/// Colour and normal arrays of every type give what the commands of that type give.
TEST_F(Attributes, ArraysOfEveryTypeEqualTheCommands) {
    const GLubyte ub[4] = {0, 255, 77, 99};
    const GLbyte b[4] = {-128, 127, 77, 5};
    const GLushort us[4] = {0, 65535, 7777, 99};
    const GLshort s[4] = {-32768, 32767, 7777, 99};
    const GLuint ui[4] = {0, 0xFFFFFFFF, 777777777, 99};
    const GLint i[4] = {INT32_MIN, INT32_MAX, 777777777, 99};
    const GLfloat f[4] = {-3, 0.3f, 1, 9};
    const GLdouble d[4] = {-3, 0.3, 1, 9};
    const GLfixed x[4] = {-0x10000, 0x3000, 0x10000, 7};
    const auto value = [](GLenum name) {
        std::array<GLdouble, 4> v{};
        glGetDoublev(name, v.data());
        return v;
    };
    const auto same = [&](GLenum type, const void* array, auto color, auto normal, bool has_normal) {
        glDisableClientState(GL_NORMAL_ARRAY);
        color();
        const auto four = value(GL_CURRENT_COLOR);
        glColor3f(0, 0, 0);
        glColorPointer(4, type, 0, array);
        glEnableClientState(GL_COLOR_ARRAY);
        glArrayElement(0);
        EXPECT_EQ(value(GL_CURRENT_COLOR), four) << type;
        glColorPointer(3, type, 0, array);
        glArrayElement(0);
        EXPECT_EQ(value(GL_CURRENT_COLOR)[2], four[2]) << type;
        EXPECT_EQ(value(GL_CURRENT_COLOR)[3], 1.0) << type;
        if (!has_normal)
            return;
        normal();
        const auto three = value(GL_CURRENT_NORMAL);
        glNormal3f(0, 0, 0);
        glNormalPointer(type, 0, array);
        glEnableClientState(GL_NORMAL_ARRAY);
        glArrayElement(0);
        EXPECT_EQ(value(GL_CURRENT_NORMAL), three) << type;
    };
    const auto none = [] {};
    same(
        GL_UNSIGNED_BYTE, ub, [&] { glColor4ubv(ub); }, none, false);
    same(
        GL_BYTE, b, [&] { glColor4bv(b); }, [&] { glNormal3bv(b); }, true);
    same(
        GL_UNSIGNED_SHORT, us, [&] { glColor4usv(us); }, none, false);
    same(
        GL_SHORT, s, [&] { glColor4sv(s); }, [&] { glNormal3sv(s); }, true);
    same(
        GL_UNSIGNED_INT, ui, [&] { glColor4uiv(ui); }, none, false);
    same(
        GL_INT, i, [&] { glColor4iv(i); }, [&] { glNormal3iv(i); }, true);
    same(
        GL_FLOAT, f, [&] { glColor4fv(f); }, [&] { glNormal3fv(f); }, true);
    same(
        GL_DOUBLE, d, [&] { glColor4dv(d); }, [&] { glNormal3dv(d); }, true);
    same(
        GL_FIXED, x, [&] { glColor4xvOES(x); }, [&] { glNormal3xvOES(x); }, true);
}

/// With OES_byte_coordinates, bytes of coordinates are numbers, not fractions.
TEST_F(Attributes, BytesAsCoordinates) {
    static const GLbyte corner[4][2] = {{-128, 127}, {-1, -1}, {1, -1}, {-1, 1}};
    glTexCoordPointer(2, GL_BYTE, 0, corner);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glArrayElement(0);
    GLint st[4] = {};
    glGetIntegerv(GL_CURRENT_TEXTURE_COORDS, st);
    EXPECT_EQ(st[0], -128);
    EXPECT_EQ(st[1], 127);
    glDisableClientState(GL_TEXTURE_COORD_ARRAY);
    const auto drawn = [] { // draws the lower left half of the window
        GLubyte pixel[4] = {};
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glDrawArrays(GL_TRIANGLES, 1, 3);
        glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
        return pixel[0];
    };
    glColor3f(1, 1, 1);
    glVertexPointer(2, GL_BYTE, 0, corner);
    glEnableClientState(GL_VERTEX_ARRAY);
    EXPECT_EQ(drawn(), 255);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

/// Types and sizes that the table of arrays does not list are refused (GL 1.3, 2.8).
TEST_F(Attributes, PointersOfOtherTypes) {
    const auto refused = [](const char* what) {
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM)) << what;
    };
    for (const GLenum type : {GL_BYTE, GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT, GL_2_BYTES}) {
        if (type != GL_BYTE) { // OES_byte_coordinates allows bytes
            glVertexPointer(2, type, 0, nullptr);
            refused("vertices");
            glTexCoordPointer(2, type, 0, nullptr);
            refused("texture coordinates");
        }
        if (type != GL_UNSIGNED_BYTE) {
            glIndexPointer(type, 0, nullptr);
            refused("indices");
        }
        if (type == GL_BYTE)
            continue;
        glNormalPointer(type, 0, nullptr);
        refused("normals");
    }
    glColorPointer(3, GL_2_BYTES, 0, nullptr);
    refused("colours");
}

// Words are loaded only from aligned addresses, because some processors fault elsewhere; this processor may
// not.
TEST(ArrayReaders, FloatsAtOddPlacesAreNoWords) {
    alignas(float) std::uint8_t memory[64] = {};
    const auto is_floats = [&](std::size_t place, GLsizei stride, GLenum type, unsigned count) {
        gl::ClientArray array(3, type);
        array.enabled = true;
        array.stride = stride;
        array.pointer = memory + place;
        return gl::ArrayReader(array, false).is_floats(count);
    };
    EXPECT_TRUE(is_floats(0, 0, GL_FLOAT, 3));
    EXPECT_TRUE(is_floats(4, 16, GL_FLOAT, 3));
    EXPECT_FALSE(is_floats(0, 0, GL_FLOAT, 2));
    EXPECT_FALSE(is_floats(0, 0, GL_INT, 3));
    for (const std::size_t odd : {1u, 2u, 3u}) {
        EXPECT_FALSE(is_floats(odd, 0, GL_FLOAT, 3)) << odd;
        EXPECT_FALSE(is_floats(0, static_cast<GLsizei>(12 + odd), GL_FLOAT, 3)) << odd;
    }
}

} // namespace
} // namespace spangle::test
