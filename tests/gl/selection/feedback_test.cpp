// Tests feedback: the grammar of its tokens for all five types of vertices (GL 1.3, 5.3).
#include <cmath>
#include <vector>

#include "gl/context/arena.hpp"
#include "gl/context/create.hpp"
#include "gl/vertex/engine.hpp"
#include "tests/gl/vertex/canvas.hpp"

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

/// Positions are not snapped to the subpixel grid.
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
    // The vertex outside of two planes is removed; (1, 1) lies on both planes.
    ASSERT_GE(cut.size(), 2u);
    EXPECT_EQ(cut[0], GL_POLYGON_TOKEN);
    EXPECT_EQ(cut.size(), 2 + 2 * static_cast<std::size_t>(cut[1]));
    for (std::size_t i = 2; i < cut.size(); ++i) {
        EXPECT_GE(cut[i], 32);
        EXPECT_LE(cut[i], 64);
    }
}

/// A POLYGON is one token, whatever the number of its vertices (GL 1.3, 5.3).
TEST_F(Feedback, APolygonIsOnePolygon) {
    for (const int n : {3, 4, 5, 9, 40}) {
        Words expected = {GL_POLYGON_TOKEN, static_cast<GLfloat>(n)};
        std::vector<GLfloat> at;
        for (int i = 0; i < n; ++i) {
            const double turn = 6.283185307 * i / n;
            at.insert(at.end(), {static_cast<GLfloat>(0.5 * std::cos(turn)),
                                 static_cast<GLfloat>(0.5 * std::sin(turn))});
            expected.insert(expected.end(), {32 + 32 * at[at.size() - 2], 32 + 32 * at.back()});
        }
        const auto draw = [&] {
            glBegin(GL_POLYGON);
            for (int i = 0; i < n; ++i)
                glVertex2fv(&at[2 * static_cast<std::size_t>(i)]);
            glEnd();
        };
        EXPECT_THAT(feed(GL_2D, draw), testing::Pointwise(testing::FloatNear(1e-4f), expected));
        glEnableClientState(GL_VERTEX_ARRAY);
        glVertexPointer(2, GL_FLOAT, 0, at.data());
        EXPECT_THAT(feed(GL_2D, [n] { glDrawArrays(GL_POLYGON, 0, n); }),
                    testing::Pointwise(testing::FloatNear(1e-4f), expected));
    }
    EXPECT_EQ(feed(GL_2D, [] { glRectf(-0.5f, -0.5f, 0.5f, 0.5f); }),
              (Words{GL_POLYGON_TOKEN, 4, 16, 16, 48, 16, 48, 48, 16, 48}));
    EXPECT_TRUE(feed(GL_2D, [] {
                    glBegin(GL_POLYGON);
                    glVertex2f(0, 0);
                    glVertex2f(1, 0);
                    glEnd();
                }).empty());
}

/// A context may be destroyed in the middle of a polygon. A polygon that does not fit the arena is an error.
TEST_F(Feedback, PolygonsAndTheirMemory) {
    std::vector<std::uint64_t> memory(128 * 1024 + gl::fixed_engine.pipeline_bytes / 8);
    gl::Arena arena;
    arena.give(memory.data(), 8 * memory.size());
    gl::Context* const before = gl::current_context();
    gl::Context* const context =
        gl::create_context(arena, {.tier = raster::Tier::exact, .engine = &gl::fixed_engine}, nullptr);
    gl::make_current(context, before->drawable.surface, false);
    const std::size_t used = arena.used();
    const Words all = feed(GL_2D, quad);
    const auto corners = [](int n) {
        glBegin(GL_POLYGON);
        for (int i = 0; i < n; ++i)
            glVertex2f(0, 0);
    };
    EXPECT_EQ(feed(GL_2D, [&] { corners(20), glEnd(); }).size(), 42u);
    EXPECT_EQ(arena.used(), used) << "as before";
    EXPECT_TRUE(feed(GL_2D, [&] { corners(1 << 16), glEnd(); }).empty());
    EXPECT_EQ(glGetError(), GLenum{GL_OUT_OF_MEMORY});
    EXPECT_EQ(feed(GL_2D, quad), all) << "the next one is whole again";
    glRenderMode(GL_FEEDBACK);
    corners(9);
    gl::destroy_context(context);
    EXPECT_EQ(arena.used(), 0u);
    gl::set_current_context(before);
}

/// A polygon is clipped, culled and coloured as a whole. A flat polygon has the colour of its first vertex,
/// also if that vertex is clipped away.
TEST_F(Feedback, APolygonIsCutAsOne) {
    const auto house = [](GLfloat shift) { // five vertices; the first is the one on the left
        return [shift] {
            const GLfloat at[5][2] = {
                {-0.5f, 0}, {-0.25f, -0.5f}, {0.25f, -0.5f}, {0.25f, 0.5f}, {-0.25f, 0.5f}};
            glBegin(GL_POLYGON);
            for (int i = 0; i < 5; ++i) {
                glColor4f(static_cast<GLfloat>(i) / 4, 0, 0, 1);
                glVertex2f(at[i][0] + shift, at[i][1]);
            }
            glEnd();
        };
    };
    EXPECT_EQ(feed(GL_2D, house(-1)), // the window's left edge goes through (0, 16), (0, 48)
              (Words{GL_POLYGON_TOKEN, 4, 0, 16, 8, 16, 8, 48, 0, 48}));
    glShadeModel(GL_FLAT);
    const Words flat = feed(GL_3D_COLOR, house(-1));
    ASSERT_EQ(flat.size(), 2u + 4 * 7);
    for (std::size_t corner = 0; corner < 4; ++corner)
        EXPECT_EQ(flat[2 + 7 * corner + 3], 0) << "red of corner " << corner;
    EXPECT_TRUE(feed(GL_2D, house(-2)).empty()) << "out of sight";
    glEnable(GL_CULL_FACE);
    EXPECT_FALSE(feed(GL_2D, house(0)).empty());
    glCullFace(GL_FRONT);
    EXPECT_TRUE(feed(GL_2D, house(0)).empty());
    glDisable(GL_CULL_FACE);
#if SPANGLE_FEATURE_CLIP_PLANES
    const GLdouble plane[4] = {0, -1, 0, -0.25};
    glClipPlane(GL_CLIP_PLANE2, plane);
    glEnable(GL_CLIP_PLANE2);
    EXPECT_EQ(feed(GL_2D, house(0)), (Words{GL_POLYGON_TOKEN, 4, 20, 24, 24, 16, 40, 16, 40, 24}));
    const GLdouble none[4] = {0, -1, 0, -1};
    glClipPlane(GL_CLIP_PLANE2, none);
    EXPECT_TRUE(feed(GL_2D, house(0)).empty());
#endif
}

#if SPANGLE_FEATURE_POLYGON_MODE
/// Edges that are not boundaries give no lines, and only faces with this mode are outlined.
TEST_F(Feedback, OutlinesOfPolygons) {
    const auto pentagon = [] {
        const GLfloat at[5][2] = {{-0.5f, 0}, {0, -0.5f}, {0.5f, 0}, {0.25f, 0.5f}, {-0.25f, 0.5f}};
        glBegin(GL_POLYGON);
        for (int i = 0; i < 5; ++i) {
            glEdgeFlag(i != 1 && i != 3);
            glVertex2fv(at[i]);
        }
        glEnd();
        glEdgeFlag(GL_TRUE);
    };
    const GLfloat reset = GL_LINE_RESET_TOKEN, on = GL_LINE_TOKEN, point = GL_POINT_TOKEN;
    glPolygonMode(GL_FRONT, GL_LINE);
    EXPECT_EQ(feed(GL_2D, pentagon), (Words{reset, 16, 32, 32, 16, on, 48, 32, 40, 48, on, 24, 48, 16, 32}));
    glPolygonMode(GL_FRONT, GL_POINT);
    EXPECT_EQ(feed(GL_2D, pentagon), (Words{point, 16, 32, point, 48, 32, point, 24, 48}));
    glFrontFace(GL_CW); // the polygon's back is filled
    EXPECT_EQ(feed(GL_2D, pentagon), (Words{GL_POLYGON_TOKEN, 5, 16, 32, 32, 16, 48, 32, 40, 48, 24, 48}));
}

/// The outline of a quad begins with its first vertex.
TEST_F(Feedback, OutlinesOfQuads) {
    const GLfloat reset = GL_LINE_RESET_TOKEN, on = GL_LINE_TOKEN, point = GL_POINT_TOKEN;
    glPolygonMode(GL_FRONT, GL_LINE);
    EXPECT_EQ(feed(GL_2D, quad),
              (Words{reset, 16, 16, 48, 16, on, 48, 16, 48, 48, on, 48, 48, 16, 48, on, 16, 48, 16, 16}));
    glPolygonMode(GL_FRONT, GL_POINT);
    EXPECT_EQ(feed(GL_2D, quad), (Words{point, 16, 16, point, 48, 16, point, 48, 48, point, 16, 48}));
}
#endif

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
/// Each vertex has the material that was current when it was given, on both sides.
TEST_F(Feedback, PolygonsHaveTheMaterialsOfTheirCorners) {
    glEnable(GL_LIGHTING);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    const GLfloat none[4] = {0, 0, 0, 1};
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, none);
    const auto polygon = [] {
        const GLfloat at[5][2] = {{-0.5f, 0}, {0, -0.5f}, {0.5f, 0}, {0.25f, 0.5f}, {-0.25f, 0.5f}};
        glBegin(GL_POLYGON);
        for (int i = 0; i < 5; ++i) {
            const GLfloat front[4] = {0.1f * static_cast<GLfloat>(i), 0, 0, 1},
                          back[4] = {0, 0.2f * static_cast<GLfloat>(i), 0, 1};
            glMaterialfv(GL_FRONT, GL_EMISSION, front);
            glMaterialfv(GL_BACK, GL_EMISSION, back);
            glVertex2fv(at[i]);
        }
        glEnd();
    };
    for (const bool back : {false, true}) {
        glFrontFace(back ? GL_CW : GL_CCW);
        const Words seen = feed(GL_3D_COLOR, polygon);
        ASSERT_EQ(seen.size(), 2u + 5 * 7);
        for (std::size_t i = 0; i < 5; ++i) {
            EXPECT_NEAR(seen[2 + 7 * i + 3], back ? 0 : 0.1 * static_cast<double>(i), 1e-5) << i;
            EXPECT_NEAR(seen[2 + 7 * i + 4], back ? 0.2 * static_cast<double>(i) : 0, 1e-5) << i;
        }
    }
}

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
    glPassThrough(3); // has no effect in other render modes
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
