// Feedback: the grammar of its tokens for all five types of vertices (GL 1.3, 5.3).
#include <vector>

#include "gl/context/features.hpp"
#include "tests/gl_vertex/canvas.hpp"

namespace spangle::test {
namespace {

#if SPANGLE_FEATURE_FEEDBACK

using Words = std::vector<GLfloat>;

class Feedback : public Canvas {
  protected:
    template <class F> Words feed(GLenum type, F draw, std::size_t size = 256) {
        Words buffer(size + 1, -77);
        glFeedbackBuffer(static_cast<GLsizei>(size), type, buffer.data());
        glRenderMode(GL_FEEDBACK);
        draw();
        result = glRenderMode(GL_RENDER);
        EXPECT_EQ(buffer.back(), -77) << "written behind the buffer";
        buffer.resize(result < 0 ? size : static_cast<std::size_t>(result));
        return buffer;
    }
    static void quad() {
        glBegin(GL_QUADS);
        for (const auto& [x, y] : {std::pair{-0.5f, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}})
            glVertex2f(x, y);
        glEnd();
    }
    GLint result = 0;
};

TEST_F(Feedback, VerticesOfAllFiveTypes) {
    glColor4f(0.2f, 0.4f, 0.6f, 0.8f);
    glTexCoord4f(1, 2, 3, 4);
    glMatrixMode(GL_TEXTURE);
    glScalef(2, 3, 4);
    const auto point = [] {
        glBegin(GL_POINTS);
        glVertex4f(-1, 1, 0.5f, 2);
        glEnd();
    };
    const Words whole = {GL_POINT_TOKEN, 16, 48, 0.625f, 2, 0.2f, 0.4f, 0.6f, 0.8f, 2, 6, 12, 4};
    const auto expect = [&](GLenum type, int position, bool color, bool texture) {
        Words expected(whole.begin(), whole.begin() + 1 + position);
        if (color)
            expected.insert(expected.end(), whole.begin() + 5, whole.begin() + 9);
        if (texture)
            expected.insert(expected.end(), whole.begin() + 9, whole.end());
        EXPECT_THAT(feed(type, point), testing::Pointwise(testing::FloatNear(1e-5f), expected));
    };
    expect(GL_2D, 2, false, false);
    expect(GL_3D, 3, false, false);
    expect(GL_3D_COLOR, 3, true, false);
    expect(GL_3D_COLOR_TEXTURE, 3, true, true);
    expect(GL_4D_COLOR_TEXTURE, 4, true, true);
}

/// Positions are those before snapping to the subpixel grid.
TEST_F(Feedback, PositionsAreNotSnapped) {
    const Words found = feed(GL_3D, [] {
        glBegin(GL_POINTS);
        glVertex3f(0.12345678f, -0.3141592f, 0.7182818f);
        glEnd();
    });
    ASSERT_EQ(found.size(), 4u);
    EXPECT_NEAR(found[1], 32 + 32 * 0.12345678, 4e-6);
    EXPECT_NEAR(found[2], 32 - 32 * 0.3141592, 4e-6);
    EXPECT_NEAR(found[3], 0.5 + 0.5 * 0.7182818, 1e-7);
}

TEST_F(Feedback, LinesAndWhereTheirStippleStarts) {
    const auto strip = [](GLenum mode) {
        return [mode] {
            glBegin(mode);
            for (int i = 0; i < 4; ++i)
                glVertex2f(static_cast<GLfloat>(i) / 4 - 1, i == 2 ? 0.5f : 0);
            glEnd();
        };
    };
    const GLfloat reset = GL_LINE_RESET_TOKEN, on = GL_LINE_TOKEN;
    EXPECT_EQ(feed(GL_2D, strip(GL_LINES)), (Words{reset, 0, 32, 8, 32, reset, 16, 48, 24, 32}));
    EXPECT_EQ(feed(GL_2D, strip(GL_LINE_STRIP)),
              (Words{reset, 0, 32, 8, 32, on, 8, 32, 16, 48, on, 16, 48, 24, 32}));
    EXPECT_EQ(feed(GL_2D, strip(GL_LINE_LOOP)),
              (Words{reset, 0, 32, 8, 32, on, 8, 32, 16, 48, on, 16, 48, 24, 32, on, 24, 32, 0, 32}));
}

TEST_F(Feedback, PolygonsSayHowManyVerticesTheyHave) {
    EXPECT_EQ(feed(GL_2D, quad), (Words{GL_POLYGON_TOKEN, 4, 16, 16, 48, 16, 48, 48, 16, 48}));
    const Words cut = feed(GL_2D, [] {
        glBegin(GL_TRIANGLES);
        glVertex2f(0, 0);
        glVertex2f(2, 0);
        glVertex2f(0, 2);
        glEnd();
    });
    // The corner outside of two planes goes; (1, 1) lies on both.
    ASSERT_GE(cut.size(), 2u);
    EXPECT_EQ(cut[0], GL_POLYGON_TOKEN);
    EXPECT_EQ(cut.size(), 2 + 2 * static_cast<std::size_t>(cut[1]));
    for (std::size_t i = 2; i < cut.size(); ++i) {
        EXPECT_GE(cut[i], 32);
        EXPECT_LE(cut[i], 64);
    }
}

TEST_F(Feedback, WhatClippingMakesHasItsColorAndTexture) {
    const Words found = feed(GL_4D_COLOR_TEXTURE, [] {
        glBegin(GL_LINES);
        glColor4f(0, 0, 0, 0);
        glTexCoord4f(0, 0, 0, 1);
        glVertex2f(0, 0);
        glColor4f(1, 1, 1, 1);
        glTexCoord4f(8, 16, 32, 3);
        glVertex2f(2, 0);
        glEnd();
    });
    ASSERT_EQ(found.size(), 25u);
    const Words end(found.begin() + 13, found.end());
    EXPECT_THAT(end, testing::Pointwise(testing::FloatNear(1e-5f),
                                        Words{64, 32, 0.5f, 1, 0.5f, 0.5f, 0.5f, 0.5f, 4, 8, 16, 2}));
}

TEST_F(Feedback, FlatColorsComeFromTheProvokingVertex) {
    glShadeModel(GL_FLAT);
    const Words found = feed(GL_3D_COLOR, [] {
        glBegin(GL_TRIANGLES);
        for (int i = 0; i < 3; ++i) {
            glColor3f(static_cast<GLfloat>(i) / 2, 0, 0);
            glVertex2f(i == 1 ? 0.5f : 0, i == 2 ? 0.5f : 0);
        }
        glEnd();
    });
    ASSERT_EQ(found.size(), 23u);
    for (const std::size_t at : {5u, 12u, 19u})
        EXPECT_EQ(found[at], 1);
}

TEST_F(Feedback, CulledPolygonsAreNotFedBack) {
    glEnable(GL_CULL_FACE);
    EXPECT_FALSE(feed(GL_2D, quad).empty());
    glCullFace(GL_FRONT);
    EXPECT_TRUE(feed(GL_2D, quad).empty());
}

#if SPANGLE_FEATURE_LIGHTING
TEST_F(Feedback, ColorsAreLitFromTheSideThatIsSeen) {
    glEnable(GL_LIGHTING);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    const GLfloat none[4] = {0, 0, 0, 1}, front[4] = {0.25f, 0, 0, 1}, back[4] = {0, 0.75f, 0, 1};
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, none);
    glMaterialfv(GL_FRONT, GL_EMISSION, front);
    glMaterialfv(GL_BACK, GL_EMISSION, back);
    const Words seen = feed(GL_3D_COLOR, quad);
    glFrontFace(GL_CW);
    const Words turned = feed(GL_3D_COLOR, quad);
    ASSERT_EQ(seen.size(), 30u);
    ASSERT_EQ(turned.size(), 30u);
    EXPECT_NEAR(seen[5], 0.25, 1e-5);
    EXPECT_NEAR(turned[6], 0.75, 1e-5);
    EXPECT_EQ(turned[5], 0);
}
#endif

#if SPANGLE_FEATURE_POLYGON_MODE
TEST_F(Feedback, PolygonModeIsAppliedBefore) {
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    const GLfloat reset = GL_LINE_RESET_TOKEN, on = GL_LINE_TOKEN, point = GL_POINT_TOKEN;
    EXPECT_EQ(feed(GL_2D, quad),
              (Words{reset, 16, 16, 48, 16, on, 48, 16, 48, 48, on, 48, 48, 16, 48, on, 16, 48, 16, 16}));
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    EXPECT_EQ(feed(GL_2D, quad), (Words{point, 16, 16, point, 48, 16, point, 48, 48, point, 16, 48}));
}
#endif

TEST_F(Feedback, ArraysAreFedBackAsVertices) {
    const GLfloat v[4][2] = {{-0.5f, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}};
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, v);
    EXPECT_EQ(feed(GL_4D_COLOR_TEXTURE, [] { glDrawArrays(GL_QUADS, 0, 4); }),
              feed(GL_4D_COLOR_TEXTURE, quad));
}

TEST_F(Feedback, MarkersPassThrough) {
    EXPECT_EQ(feed(GL_2D,
                   [] {
                       glPassThrough(1.5f);
                       glBegin(GL_POINTS);
                       glVertex2f(0, 0);
                       glEnd();
                       glPassThrough(-2);
                   }),
              (Words{GL_PASS_THROUGH_TOKEN, 1.5f, GL_POINT_TOKEN, 32, 32, GL_PASS_THROUGH_TOKEN, -2}));
    glPassThrough(3); // in other modes it means nothing
}

TEST_F(Feedback, AFullBufferKeepsWhatFitsAndSaysSo) {
    for (std::size_t size = 0; size < 11; ++size) {
        const Words found = feed(GL_2D, quad, size);
        EXPECT_EQ(result, size < 10 ? -1 : 10) << size;
        const Words all = {GL_POLYGON_TOKEN, 4, 16, 16, 48, 16, 48, 48, 16, 48};
        EXPECT_EQ(found, Words(all.begin(), all.begin() + static_cast<int>(std::min<std::size_t>(size, 10))));
    }
}

TEST_F(Feedback, NothingIsDrawn) {
    glClear(GL_COLOR_BUFFER_BIT);
    feed(GL_2D, quad);
    GLubyte pixel[4] = {};
    glReadPixels(32, 32, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    EXPECT_EQ(pixel[0], 0);
}

TEST_F(Feedback, ModesAndTheirErrors) {
    EXPECT_EQ(glRenderMode(GL_FEEDBACK), 0);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    GLfloat word = 0;
    glFeedbackBuffer(-1, GL_2D, &word);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    glFeedbackBuffer(1, GL_2D - 1, &word);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    glFeedbackBuffer(1, GL_3D, &word);
    glRenderMode(GL_FEEDBACK);
    glFeedbackBuffer(1, GL_2D, &word);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    EXPECT_EQ(glRenderMode(GL_RENDER), 0);
    GLint value = 0;
    glGetIntegerv(GL_FEEDBACK_BUFFER_TYPE, &value);
    EXPECT_EQ(value, GL_3D);
    glGetIntegerv(GL_FEEDBACK_BUFFER_SIZE, &value);
    EXPECT_EQ(value, 1);
    void* pointer = nullptr;
    glGetPointerv(GL_FEEDBACK_BUFFER_POINTER, &pointer);
    EXPECT_EQ(pointer, &word);
}

#if SPANGLE_FEATURE_FIXED_POINT
TEST_F(Feedback, FixedPointBuffers) {
    GLfixed buffer[8] = {};
    glFeedbackBufferxOES(8, GL_2D, buffer);
    glRenderMode(GL_FEEDBACK);
    glPassThroughxOES(0x18000);
    glBegin(GL_POINTS);
    glVertex2f(0.015625f, 0);
    glEnd();
    EXPECT_EQ(glRenderMode(GL_RENDER), 5);
    EXPECT_THAT(std::vector<GLfixed>(buffer, buffer + 5),
                testing::ElementsAre(GL_PASS_THROUGH_TOKEN << 16, 0x18000, GL_POINT_TOKEN << 16,
                                     32 * 65536 + 32768, 32 << 16));
}
#endif

#endif

} // namespace
} // namespace spangle::test
