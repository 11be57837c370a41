// Row B08: tests secondary colours of vertices, and that COLOR_SUM adds them (GL 1.4, 2.7, 2.8 and 3.9).
#include <array>

#include "gl/context/features.hpp"
#include "tests/gl/vertex/canvas.hpp"

namespace spangle::test {
namespace {

#if SPANGLE_FEATURE_SECONDARY_COLOR

using Rgb = std::array<GLfloat, 4>;

class SecondaryColor : public Canvas {
  protected:
    static Rgb current() {
        Rgb v{-7, -7, -7, -7};
        glGetFloatv(GL_CURRENT_SECONDARY_COLOR, v.data());
        return v;
    }
    static std::array<int, 3> middle() {
        GLubyte pixel[4];
        glReadPixels(size / 2, size / 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
        return {pixel[0], pixel[1], pixel[2]};
    }
    static std::array<int, 3> rectangle() {
        glClear(GL_COLOR_BUFFER_BIT);
        glRectf(-1, -1, 1, 1);
        return middle();
    }
};

TEST_F(SecondaryColor, EveryForm) {
    EXPECT_EQ(current(), (Rgb{0, 0, 0, 1}));
    glSecondaryColor3f(-2, 0.5f, 3);
    EXPECT_EQ(current(), (Rgb{-2, 0.5f, 3, 1})) << "clamped when it is used";
    glSecondaryColor3d(0.25, 0.5, 0.75);
    EXPECT_EQ(current(), (Rgb{0.25f, 0.5f, 0.75f, 1}));
    glSecondaryColor3ub(0, 255, 51);
    EXPECT_EQ(current(), (Rgb{0, 1, 0.2f, 1}));
    glSecondaryColor3b(127, -128, 127);
    EXPECT_EQ(current(), (Rgb{1, -1, 1, 1}));
    glSecondaryColor3us(65535, 0, 65535);
    EXPECT_EQ(current(), (Rgb{1, 0, 1, 1}));
    glSecondaryColor3s(32767, 32767, -32768);
    EXPECT_EQ(current(), (Rgb{1, 1, -1, 1}));
    glSecondaryColor3ui(4294967295u, 0, 0);
    EXPECT_EQ(current(), (Rgb{1, 0, 0, 1}));
    glSecondaryColor3i(2147483647, 0x80000000, 2147483647);
    EXPECT_EQ(current(), (Rgb{1, -1, 1, 1}));
    const GLubyte ub[3] = {255, 0, 255};
    glSecondaryColor3ubv(ub);
    EXPECT_EQ(current(), (Rgb{1, 0, 1, 1}));
    const GLfloat f[3] = {0.125f, 0.25f, 0.5f};
    glSecondaryColor3fv(f);
    EXPECT_EQ(current(), (Rgb{0.125f, 0.25f, 0.5f, 1}));
    GLint bits[4];
    glSecondaryColor3f(1, 0, 0);
    glGetIntegerv(GL_CURRENT_SECONDARY_COLOR, bits);
    EXPECT_EQ(bits[0], 2147483647) << "colours map to the whole range";
    EXPECT_EQ(bits[3], 2147483647);
#if SPANGLE_FEATURE_ATTRIB_STACKS
    glPushAttrib(GL_CURRENT_BIT | GL_FOG_BIT);
    glSecondaryColor3f(0, 0, 1);
    glEnable(GL_COLOR_SUM);
    glPopAttrib();
    EXPECT_EQ(current(), (Rgb{1, 0, 0, 1}));
    EXPECT_FALSE(glIsEnabled(GL_COLOR_SUM));
#endif
#if SPANGLE_FEATURE_LISTS
    glNewList(1, GL_COMPILE);
    glSecondaryColor3f(0, 0, 0.5f);
    glEndList();
    EXPECT_EQ(current(), (Rgb{1, 0, 0, 1}));
    glCallList(1);
    EXPECT_EQ(current(), (Rgb{0, 0, 0.5f, 1}));
#endif
}

TEST_F(SecondaryColor, IsAddedWhereColorSumIsOn) {
    glColor4f(0.2f, 0.8f, 0, 1);
    glSecondaryColor3f(0.4f, 0.4f, -1);
    EXPECT_EQ(rectangle(), (std::array{51, 204, 0})) << "off at first";
    glEnable(GL_COLOR_SUM);
    EXPECT_TRUE(glIsEnabled(GL_COLOR_SUM));
    EXPECT_EQ(rectangle(), (std::array{153, 255, 0})) << "the sum is clamped, and so is what is added";
    glSecondaryColor3f(0, 0, 0.4f); // the cached conversion of the unchanged primary colour must not be used
    EXPECT_EQ(rectangle(), (std::array{51, 204, 102}));
    glDisable(GL_COLOR_SUM);
    EXPECT_EQ(rectangle(), (std::array{51, 204, 0}));
    glEnable(GL_COLOR_SUM);
    EXPECT_EQ(rectangle(), (std::array{51, 204, 102}));
#if SPANGLE_FEATURE_LIGHTING
    glEnable(GL_LIGHTING); // lighting makes a secondary colour of its own, or none (GL 1.4, 3.9)
    const GLfloat gray[4] = {0.2f, 0.2f, 0.2f, 1}, black[4] = {0, 0, 0, 1};
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, gray);
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, black);
    EXPECT_EQ(rectangle(), (std::array{51, 51, 51}));
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    EXPECT_EQ(rectangle(), (std::array{51, 51, 51}));
    glDisable(GL_LIGHTING);
    EXPECT_EQ(rectangle(), (std::array{51, 204, 102}));
#endif
}

TEST_F(SecondaryColor, IsAddedBehindTheTexture) {
    const GLubyte half[4] = {128, 128, 128, 255};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, half);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_COLOR_SUM);
    glColor3f(0, 0.2f, 0);
    glSecondaryColor3f(0.2f, 0, 0);
    const auto seen = rectangle();
    EXPECT_NEAR(seen[0], 51, 1);
    EXPECT_NEAR(seen[1], 26, 2);
    EXPECT_EQ(seen[2], 0);
}

/// Each vertex has its own secondary colour, which is interpolated. A flat primitive has that of the
/// provoking vertex.
TEST_F(SecondaryColor, OfEachVertex) {
    glEnable(GL_COLOR_SUM);
    glColor3f(0, 0, 0);
    const auto quad = [] {
        glClear(GL_COLOR_BUFFER_BIT);
        glBegin(GL_QUADS);
        for (int i = 0; i < 4; ++i) {
            glSecondaryColor3f(i == 1 || i == 2 ? 1.0f : 0.0f, 0, i == 3 ? 1.0f : 0.0f);
            glVertex2f(i == 1 || i == 2 ? 1.0f : -1.0f, i < 2 ? -1.0f : 1.0f);
        }
        glEnd();
    };
    quad();
    EXPECT_NEAR(middle()[0], 128, 5);
    GLubyte right[4];
    glReadPixels(size - 1, size / 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, right);
    EXPECT_GT(right[0], 240);
    glShadeModel(GL_FLAT);
    quad();
    EXPECT_EQ(middle(), (std::array{0, 0, 255}));
}

TEST_F(SecondaryColor, Arrays) {
    glEnable(GL_COLOR_SUM);
    glColor3f(0.2f, 0, 0);
    const GLfloat corners[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    GLubyte bytes[4][4] = {};
    GLdouble doubles[4][3] = {};
    for (int i = 0; i < 4; ++i)
        bytes[i][1] = 102, doubles[i][2] = 0.4;
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_SECONDARY_COLOR_ARRAY);
    EXPECT_TRUE(glIsEnabled(GL_SECONDARY_COLOR_ARRAY));
    glVertexPointer(2, GL_FLOAT, 0, corners);
    const auto drawn = [] {
        glClear(GL_COLOR_BUFFER_BIT);
        glDrawArrays(GL_QUADS, 0, 4);
        const auto by_arrays = middle();
        const GLubyte order[4] = {0, 1, 2, 3};
        glClear(GL_COLOR_BUFFER_BIT);
        glDrawElements(GL_QUADS, 4, GL_UNSIGNED_BYTE, order);
        EXPECT_EQ(middle(), by_arrays);
#if SPANGLE_FEATURE_LISTS
        glNewList(2, GL_COMPILE);
        glDrawArrays(GL_QUADS, 0, 4);
        glEndList();
        glClear(GL_COLOR_BUFFER_BIT);
        glSecondaryColor3f(1, 1, 1);
        glCallList(2);
        EXPECT_EQ(middle(), by_arrays);
#endif
        return by_arrays;
    };
    glSecondaryColorPointer(3, GL_UNSIGNED_BYTE, 4, bytes);
    EXPECT_EQ(drawn(), (std::array{51, 102, 0}));
    glSecondaryColorPointer(3, GL_DOUBLE, 0, doubles);
    EXPECT_EQ(drawn(), (std::array{51, 0, 102}));
    GLint now[3];
    glGetIntegerv(GL_SECONDARY_COLOR_ARRAY_SIZE, now);
    glGetIntegerv(GL_SECONDARY_COLOR_ARRAY_TYPE, now + 1);
    glGetIntegerv(GL_SECONDARY_COLOR_ARRAY_STRIDE, now + 2);
    EXPECT_EQ(now[0], 3);
    EXPECT_EQ(now[1], GL_DOUBLE);
    EXPECT_EQ(now[2], 0);
    void* pointer = nullptr;
    glGetPointerv(GL_SECONDARY_COLOR_ARRAY_POINTER, &pointer);
    EXPECT_EQ(pointer, doubles);
    for (const GLint size : {2, 4, -1}) {
        glSecondaryColorPointer(size, GL_FLOAT, 0, bytes);
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE}) << size;
    }
    glSecondaryColorPointer(3, GL_FLOAT, -1, bytes);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    glSecondaryColorPointer(3, GL_RGB, 0, bytes);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    glGetPointerv(GL_SECONDARY_COLOR_ARRAY_POINTER, &pointer);
    EXPECT_EQ(pointer, doubles);
    glInterleavedArrays(GL_V2F, 0, nullptr); // disables the array (GL 1.4, 2.8)
    EXPECT_FALSE(glIsEnabled(GL_SECONDARY_COLOR_ARRAY));
}

#endif

} // namespace
} // namespace spangle::test
