// Tests selection: hits, records, and the name stack (GL 1.3, 5.2).
#include <array>
#include <vector>

#include "gl/context/features.hpp"
#include "tests/gl/vertex/canvas.hpp"

namespace spangle::test {
namespace {

#if SPANGLE_FEATURE_SELECTION

using Words = std::vector<GLuint>;
constexpr GLuint deepest = 0xFFFFFFFF;

/// Returns the window depth of z in [-1, 1] as records have it.
GLuint depth(double z) {
    return static_cast<GLuint>((z + 1) / 2 * 4294967295.0 + 0.5);
}

class Selection : public Canvas {
  protected:
    /// Returns what `draw` selects with a buffer of `size` words; the result of RenderMode comes first.
    template <class F> Words select(F draw, std::size_t size = 64) {
        Words buffer(size + 1, 0xABABABAB);
        glSelectBuffer(static_cast<GLsizei>(size), buffer.data());
        glRenderMode(GL_SELECT);
        glInitNames();
        draw();
        const GLint hits = glRenderMode(GL_RENDER);
        EXPECT_EQ(buffer.back(), 0xABABABAB) << "written behind the buffer";
        buffer.pop_back();
        while (!buffer.empty() && buffer.back() == 0xABABABAB)
            buffer.pop_back();
        buffer.insert(buffer.begin(), static_cast<GLuint>(hits));
        return buffer;
    }
    static void triangle(GLfloat z0, GLfloat z1, GLfloat z2, GLfloat x = 0) {
        glBegin(GL_TRIANGLES);
        glVertex3f(x, 0, z0);
        glVertex3f(x + 0.5f, 0, z1);
        glVertex3f(x, 0.5f, z2);
        glEnd();
    }
    static void point(GLfloat x, GLfloat y, GLfloat z) {
        glBegin(GL_POINTS);
        glVertex3f(x, y, z);
        glEnd();
    }
};

TEST_F(Selection, RecordsHoldNamesBottomFirstAndTheDepthsOfAllHits) {
    const Words found = select([] {
        glPushName(7);
        glPushName(9);
        triangle(-0.5f, 0, 0.5f);
        triangle(0, 0.25f, 0.75f);
        glLoadName(10); // nothing hits this name
        glLoadName(11);
        point(0, 0, -1);
    });
    ASSERT_EQ(found.size(), 11u);
    EXPECT_EQ(found[0], 2u);
    EXPECT_EQ(found[1], 2u);
    EXPECT_NEAR(found[2], depth(-0.5), 8);
    EXPECT_NEAR(found[3], depth(0.75), 8);
    EXPECT_THAT(Words(found.begin() + 4, found.begin() + 6), testing::ElementsAre(7, 9));
    EXPECT_THAT(Words(found.begin() + 6, found.end()), testing::ElementsAre(2, 0, 0, 7, 11));
}

TEST_F(Selection, HitsWithoutNames) {
    EXPECT_THAT(select([] { point(0, 0, 1); }), testing::ElementsAre(1, 0, deepest, deepest));
    EXPECT_THAT(select([] {}), testing::ElementsAre(0));
}

TEST_F(Selection, EveryCommandOfTheNameStackEndsARecord) {
    const Words found = select([] {
        point(0, 0, -1);
        glPushName(1);
        point(0, 0, -1);
        glLoadName(2);
        point(0, 0, -1);
        glPopName();
        point(0, 0, -1);
        glInitNames();
        point(0, 0, -1);
    });
    EXPECT_THAT(found, testing::ElementsAre(5, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 2, 0, 0, 0, 0, 0, 0));
}

/// The view volume decides, not the guard band. A clipped primitive has the depths of its remaining part.
TEST_F(Selection, OnlyWhatIsLeftAfterClippingHits) {
    EXPECT_THAT(select([] { point(1.01f, 0, 0); }), testing::ElementsAre(0));
    EXPECT_THAT(select([] { triangle(0, 0, 0, 1.5f); }), testing::ElementsAre(0));
    EXPECT_EQ(select([] { triangle(0, 0, 0, 0.9f); })[0], 1u);
    EXPECT_EQ(select([] { // its box meets the volume, but the triangle does not
                  glBegin(GL_TRIANGLES);
                  glVertex2f(0.9f, 2.9f);
                  glVertex2f(2.9f, 0.9f);
                  glVertex2f(2.9f, 2.9f);
                  glEnd();
              })[0],
              0u);
    const Words line = select([] {
        glBegin(GL_LINES);
        glVertex3f(-2, 0, -0.5f);
        glVertex3f(2, 0, 0.5f);
        glEnd();
    });
    EXPECT_EQ(line[0], 1u);
    EXPECT_NEAR(line[2], depth(-0.25), 16);
    EXPECT_NEAR(line[3], depth(0.25), 16);
    const Words near = select([] { triangle(-3, 0, 0); });
    EXPECT_EQ(near[2], 0u);
}

#if SPANGLE_FEATURE_CLIP_PLANES
/// Hits are clipped by the view volume and the user's clip planes (GL 1.3, 2.11 and 5.2).
TEST_F(Selection, ClipPlanesCutToo) {
    const GLdouble right[4] = {1, 0, 0, -0.25}; // keeps x >= 0.25
    glClipPlane(GL_CLIP_PLANE0, right);
    glEnable(GL_CLIP_PLANE0);
    EXPECT_EQ(select([] { point(0.2f, 0, 0); })[0], 0u);
    EXPECT_EQ(select([] { point(0.3f, 0, 0); })[0], 1u);
    EXPECT_EQ(select([] { triangle(0, 0, 0, -0.5f); })[0], 0u);
    const Words line = select([] {
        glBegin(GL_LINES);
        glVertex3f(-0.25f, 0, -0.5f);
        glVertex3f(0.75f, 0, 0.5f);
        glEnd();
    });
    EXPECT_NEAR(line[2], depth(0), 16);
    EXPECT_NEAR(line[3], depth(0.5), 16);
}
#endif

TEST_F(Selection, CulledPolygonsDoNotHit) {
    glEnable(GL_CULL_FACE);
    EXPECT_EQ(select([] { triangle(0, 0, 0); })[0], 1u);
    glFrontFace(GL_CW);
    EXPECT_EQ(select([] { triangle(0, 0, 0); })[0], 0u);
    glDisable(GL_CULL_FACE);
    EXPECT_EQ(select([] { triangle(0, 0, 0); })[0], 1u);
}

#if SPANGLE_FEATURE_POLYGON_MODE
/// The polygon counts, not the points or lines that its mode would draw; here there are none.
TEST_F(Selection, PolygonModeMeansNothing) {
    glEdgeFlag(GL_FALSE);
    for (const GLenum mode : {GL_POINT, GL_LINE}) {
        glPolygonMode(GL_FRONT_AND_BACK, mode);
        EXPECT_EQ(select([] { triangle(0, 0, 0); })[0], 1u) << mode;
    }
}
#endif

/// A polygon seen edge-on, or smaller than a pixel, still hits.
TEST_F(Selection, ThinPolygonsHit) {
    EXPECT_EQ(select([] {
                  glScalef(1e-5f, 1e-5f, 1);
                  triangle(0, 0, 0);
                  glLoadIdentity();
              })[0],
              1u);
}

TEST_F(Selection, EveryPrimitiveAndArraysHit) {
    for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode) {
        const GLfloat v[4][2] = {{0, 0}, {0.5f, 0}, {0.5f, 0.5f}, {0, 0.5f}};
        const auto immediate = select([&] {
            glBegin(mode);
            for (const auto& corner : v)
                glVertex2fv(corner);
            glEnd();
        });
        EXPECT_EQ(immediate[0], 1u) << mode;
        const auto array = select([&] {
            glEnableClientState(GL_VERTEX_ARRAY);
            glVertexPointer(2, GL_FLOAT, 0, v);
            glDrawArrays(mode, 0, 4);
            glDisableClientState(GL_VERTEX_ARRAY);
        });
        EXPECT_EQ(array, immediate) << mode;
    }
    EXPECT_EQ(select([] { glRectf(0, 0, 1, 1); })[0], 1u);
}

TEST_F(Selection, NothingIsDrawn) {
    glClearColor(1, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glClearColor(0, 1, 0, 1);
    select([] {
        glClear(GL_COLOR_BUFFER_BIT);
        glRectf(-1, -1, 1, 1);
    });
    GLubyte pixel[4] = {};
    glReadPixels(32, 32, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    EXPECT_THAT(pixel, testing::ElementsAre(255, 0, 0, 255));
}

TEST_F(Selection, AFullBufferKeepsWhatFitsAndSaysSo) {
    const auto two_hits = [] {
        glPushName(5);
        point(0, 0, -1);
        glLoadName(6);
        point(0, 0, -1);
    };
    EXPECT_THAT(select(two_hits, 8), testing::ElementsAre(2, 1, 0, 0, 5, 1, 0, 0, 6));
    EXPECT_THAT(select(two_hits, 7), testing::ElementsAre(GLuint(-1), 1, 0, 0, 5, 1, 0, 0));
    EXPECT_THAT(select(two_hits, 0), testing::ElementsAre(GLuint(-1)));
    EXPECT_EQ(select(two_hits, 64)[0], 2u) << "the overflow is forgotten";
}

TEST_F(Selection, TheNameStackIs64DeepAndSaysWhenItIsFullOrEmpty) {
    GLint depth_now = -1;
    select([&] {
        glPopName();
        EXPECT_EQ(glGetError(), GLenum{GL_STACK_UNDERFLOW});
        glLoadName(1);
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
        for (GLuint i = 0; i < 64; ++i)
            glPushName(i);
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        glPushName(64);
        EXPECT_EQ(glGetError(), GLenum{GL_STACK_OVERFLOW});
        glGetIntegerv(GL_NAME_STACK_DEPTH, &depth_now);
    });
    EXPECT_EQ(depth_now, 64);
    glGetIntegerv(GL_NAME_STACK_DEPTH, &depth_now);
    EXPECT_EQ(depth_now, 0) << "RenderMode empties it";
}

TEST_F(Selection, RefusedCommandsEndNoRecord) {
    const Words found = select([] {
        point(0, 0, -1);
        glPopName();
        EXPECT_EQ(glGetError(), GLenum{GL_STACK_UNDERFLOW});
        point(0, 0, 1);
    });
    EXPECT_THAT(found, testing::ElementsAre(1, 0, 0, deepest));
}

TEST_F(Selection, NamesMeanNothingInOtherModes) {
    glPopName();
    glLoadName(3);
    for (int i = 0; i < 100; ++i)
        glPushName(4);
    GLint n = -1;
    glGetIntegerv(GL_NAME_STACK_DEPTH, &n);
    EXPECT_EQ(n, 0);
}

TEST_F(Selection, ModesAndTheirErrors) {
    EXPECT_EQ(glRenderMode(GL_SELECT), 0);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    GLint mode = 0;
    glGetIntegerv(GL_RENDER_MODE, &mode);
    EXPECT_EQ(mode, GL_RENDER);
    GLuint word = 0;
    glSelectBuffer(-1, &word);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    glSelectBuffer(1, &word);
    EXPECT_EQ(glRenderMode(GL_SELECT), 0);
    glGetIntegerv(GL_RENDER_MODE, &mode);
    EXPECT_EQ(mode, GL_SELECT);
    glSelectBuffer(1, &word);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    EXPECT_EQ(glRenderMode(0x1C03), 0);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    glGetIntegerv(GL_RENDER_MODE, &mode);
    EXPECT_EQ(mode, GL_SELECT);
    point(0, 0, 0);
    EXPECT_EQ(glRenderMode(GL_SELECT), -1) << "one word holds no record";
    EXPECT_EQ(glRenderMode(GL_RENDER), 0);
    void* pointer = nullptr;
    glGetPointerv(GL_SELECTION_BUFFER_POINTER, &pointer);
    EXPECT_EQ(pointer, &word);
    glGetIntegerv(GL_SELECTION_BUFFER_SIZE, &mode);
    EXPECT_EQ(mode, 1);
}

#if SPANGLE_FEATURE_LISTS
TEST_F(Selection, NamesAreCompiledModesAreNot) {
    glNewList(1, GL_COMPILE);
    glPushName(3);
    glRectf(0, 0, 1, 1);
    glPopName();
    glEndList();
    EXPECT_THAT(select([] { glCallList(1); }), testing::ElementsAre(1, 1, 0x80000000, 0x80000000, 3));
}
#endif

#endif

} // namespace
} // namespace spangle::test
