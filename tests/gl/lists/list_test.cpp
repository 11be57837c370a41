// Compares display lists (GL 1.3, 5.4) with immediate mode: the same commands must reach the pipeline and
// leave the same state.
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_LISTS

#include <functional>

#include "gl/context/share_group.hpp"
#include "tests/gl/api/recording_context.hpp"

namespace spangle::test {
namespace {

class Lists : public RecordingContext {
  protected:
    using Drawing = std::function<void()>;

    std::vector<Event> drawn(const Drawing& drawing) {
        events().clear();
        drawing();
        return events();
    }

    /// Compiled and called, or compiled and executed, a list gives the events of `drawing` itself.
    void same_as_immediate(const Drawing& drawing) {
        const auto start = snapshot();
        const auto expected = drawn(drawing);
        const auto after = snapshot();
        restore(start);
        glNewList(1, GL_COMPILE);
        EXPECT_TRUE(drawn(drawing).empty()) << "COMPILE executes nothing";
        glEndList();
        EXPECT_EQ(start, snapshot()) << "COMPILE changes nothing";
        EXPECT_EQ(drawn([] { glCallList(1); }), expected);
        EXPECT_EQ(after, snapshot());
        restore(start);
        glNewList(2, GL_COMPILE_AND_EXECUTE);
        EXPECT_EQ(drawn(drawing), expected);
        glEndList();
        EXPECT_EQ(after, snapshot());
        restore(start);
        EXPECT_EQ(drawn([] { glCallList(2); }), expected);
        EXPECT_EQ(after, snapshot());
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        glDeleteLists(1, 2);
    }

    void restore(const std::vector<unsigned char>& bytes) {
        std::memcpy(static_cast<void*>(context), bytes.data(), bytes.size());
    }
};

TEST_F(Lists, VerticesWithEveryMixOfAttributes) {
    for (int mix = 0; mix < 64; ++mix)
        same_as_immediate([mix] {
            glBegin(GL_TRIANGLE_STRIP);
            for (int i = 0; i < 10; ++i) {
                const float f = static_cast<float>(i) + 0.1f;
                if (mix & 1)
                    glColor4f(f, 2 * f, 3 * f, 0.5f);
                if (mix & 2)
                    glNormal3f(-f, f, 1);
                if (mix & 4)
                    glTexCoord2f(f, -f);
                if (mix & 8)
                    glTexCoord4f(f, -f, i == 3 ? 0.f : 1.f, 2);
                if ((mix & 16) && i % 3 == 0)
                    // Only some vertices of the run give a colour.
                    glColor3ub(static_cast<GLubyte>(i), 200, 255);
                if (mix & 32)
                    glVertex4f(f, f, f, i % 2 == 0 ? 1.f : 2.f);
                else
                    glVertex3f(f, f, i % 4 == 0 ? 0.f : f);
            }
            glEnd();
        });
}

TEST_F(Lists, LongRunsCrossChunks) {
    for (int n : {1, 9, 10, 11, 100, 5000})
        same_as_immediate([n] {
            glBegin(GL_POINTS);
            for (int i = 0; i < n; ++i) {
                glNormal3f(static_cast<float>(i), 0, 1);
                glVertex3f(static_cast<float>(i), 1, 2);
            }
            glEnd();
            glBegin(GL_LINES);
            glVertex2i(1, 2);
            glVertex2i(3, 4);
            glEnd();
        });
}

TEST_F(Lists, AttributesWithoutAVertex) {
    same_as_immediate([] {
        glColor3f(0.5f, 0.25f, 0);
        glNormal3b(127, -128, 0);
        glTexCoord1f(4);
    });
    same_as_immediate([] {
        glColor3f(1, 0, 0);
        glBegin(GL_POINTS);
        glVertex2f(1, 1);
        glColor3f(0, 1, 0);
        glEnd();
        glColor3f(0, 0, 1);
        glTranslatef(1, 2, 3);
        glTexCoord2f(7, 8);
    });
}

TEST_F(Lists, StateCommands) {
    same_as_immediate([] {
        glEnable(GL_DEPTH_TEST);
        glDisable(GL_DITHER);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        glFrustum(-1, 1, -1, 1, 1, 10);
        glMatrixMode(GL_MODELVIEW);
        const GLfloat m[16] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
        glMultMatrixf(m);
        glPushMatrix();
        glRotatef(30, 0, 0, 1);
        glScaled(2, 3, 4);
        glViewport(1, 2, 30, 40);
        glDepthRange(0.25, 0.75);
        glClearColor(0.1f, 0.2f, 0.3f, 0.4f);
        glColorMask(1, 0, 1, 0);
        glStencilFunc(GL_LESS, 3, 0xF0);
        glListBase(77);
        glPointSize(3);
        glShadeModel(GL_FLAT);
        const GLfloat color[4] = {0.5f, 0.25f, 0.125f, 1};
        glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
#if SPANGLE_FEATURE_FOG
        glFogfv(GL_FOG_COLOR, color);
        glFogi(GL_FOG_MODE, GL_LINEAR);
#endif
#if SPANGLE_FEATURE_LIGHTING
        glLightfv(GL_LIGHT3, GL_DIFFUSE, color);
        glMaterialf(GL_FRONT, GL_SHININESS, 20);
#endif
        glPopMatrix();
    });
}

TEST_F(Lists, ArraysAreReadWhenCompiled) {
    GLfloat position[] = {0, 0, 1, 0, 1, 1, 2, 2, 3, 3};
    GLubyte color[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20};
    glVertexPointer(2, GL_FLOAT, 0, position);
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, color);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    const GLubyte index[] = {4, 0, 2};
    const GLushort index16[] = {1, 3, 2};
    const auto drawing = [&] {
        glDrawArrays(GL_TRIANGLE_STRIP, 1, 4);
        glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, index);
        glDrawRangeElements(GL_LINES, 0, 4, 3, GL_UNSIGNED_SHORT, index16);
        glBegin(GL_POINTS);
        glArrayElement(2);
        glEnd();
    };
    const auto expected = drawn(drawing);
    glNewList(1, GL_COMPILE);
    drawing();
    glEndList();
    std::fill(std::begin(position), std::end(position), -1.f);
    glDisableClientState(GL_VERTEX_ARRAY);
    EXPECT_EQ(drawn([] { glCallList(1); }), expected);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(Lists, PlayedDrawsFailWholeInsideBeginEnd) {
    const GLfloat position[] = {0, 0, 1, 0, 1, 1};
    glVertexPointer(2, GL_FLOAT, 0, position);
    glEnableClientState(GL_VERTEX_ARRAY);
    glNewList(1, GL_COMPILE);
    for (int i = 0; i < 30; ++i) // fills several chunks
        glDrawArrays(GL_TRIANGLES, 0, 3);
    glEndList();
    const auto events = drawn([] {
        glBegin(GL_LINES);
        glCallList(1);
        glVertex2f(5, 6);
        glEnd();
    });
    EXPECT_EQ(events.size(), 3u);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
}

TEST_F(Lists, ErrorsArriveAtExecution) {
    const std::pair<Drawing, GLenum> wrong[] = {
        {[] { glEnable(0xDEAD); }, GL_INVALID_ENUM},
        {[] { glViewport(0, 0, -1, 0); }, GL_INVALID_VALUE},
        {[] { glBegin(99); }, GL_INVALID_ENUM},
        {[] { glEnd(); }, GL_INVALID_OPERATION},
        {[] { glDrawArrays(77, 0, 1); }, GL_INVALID_ENUM},
        {[] { glDrawArrays(GL_POINTS, 0, -1); }, GL_INVALID_VALUE},
        {[] { glDrawElements(GL_POINTS, 1, GL_FLOAT, ""); }, GL_INVALID_ENUM},
        {[] { glDrawRangeElements(GL_POINTS, 2, 1, 0, GL_UNSIGNED_BYTE, ""); }, GL_INVALID_VALUE},
        {[] { glCallLists(-1, GL_BYTE, ""); }, GL_INVALID_VALUE},
        {[] { glCallLists(1, GL_DOUBLE, ""); }, GL_INVALID_ENUM},
        {[] { glCallList(0); }, GL_INVALID_VALUE},
        {[] { glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, 0xDEAD, GL_UNSIGNED_BYTE, ""); },
         GL_INVALID_ENUM},
        {[] { glTexSubImage2D(GL_TEXTURE_2D, -1, 0, 0, 0, 0, GL_RGBA, GL_UNSIGNED_BYTE, ""); },
         GL_INVALID_VALUE},
        {[] { glTexParameteri(GL_TEXTURE_2D, 0xDEAD, 0); }, GL_INVALID_ENUM},
    };
    int i = 0;
    for (const auto& [command, code] : wrong) {
        glNewList(1, GL_COMPILE);
        command();
        EXPECT_EQ(context->error_code, GLenum{GL_NO_ERROR}) << i;
        glEndList();
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << i;
        glCallList(1);
        EXPECT_EQ(glGetError(), code) << i;
        ++i;
    }
}

TEST_F(Lists, ImmediateCommandsAreNotCompiled) {
    glNewList(1, GL_COMPILE);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
    glEnableClientState(GL_COLOR_ARRAY);
    GLuint name = 0;
    glGenTextures(1, &name);
    EXPECT_NE(name, 0u);
    EXPECT_TRUE(glIsEnabled(GL_DITHER));
    EXPECT_EQ(glGenLists(2), 1u) << "the list being compiled has no name yet";
    glNewList(3, GL_COMPILE);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    GLint value;
    glGetIntegerv(GL_LIST_INDEX, &value);
    EXPECT_EQ(value, 1);
    glGetIntegerv(GL_LIST_MODE, &value);
    EXPECT_EQ(value, GL_COMPILE);
    glEndList();
    EXPECT_TRUE(glIsEnabled(GL_COLOR_ARRAY));
    const auto before = snapshot();
    glCallList(1);
    EXPECT_EQ(before, snapshot());
    glDeleteTextures(1, &name);
    glDeleteLists(1, 2);
}

TEST_F(Lists, NestingAndRedefinition) {
    glNewList(1, GL_COMPILE);
    glBegin(GL_POINTS);
    glVertex2i(1, 0);
    glCallList(2); // defined later; called between Begin and End
    glVertex2i(3, 0);
    glEnd();
    glEndList();
    EXPECT_EQ(drawn([] { glCallList(1); }).size(), 4u) << "an unknown list is ignored";
    glNewList(2, GL_COMPILE);
    glVertex2i(2, 0);
    glEndList();
    auto all = drawn([] { glCallList(1); });
    ASSERT_EQ(all.size(), 5u);
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(all[1 + static_cast<unsigned>(i)].position[0],
                  std::bit_cast<std::uint32_t>(static_cast<float>(i + 1)));
    glNewList(2, GL_COMPILE);
    glEndList();
    EXPECT_EQ(drawn([] { glCallList(1); }).size(), 4u);
}

TEST_F(Lists, EachReturnsToItsCaller) {
    const auto point = [](GLint x) {
        glBegin(GL_POINTS);
        glVertex2i(x, 0);
        glEnd();
    };
    for (GLuint level = 4; level >= 1; --level) {
        glNewList(level, GL_COMPILE);
        point(static_cast<GLint>(level));
        glCallList(level + 1);
        point(static_cast<GLint>(10 * level));
        glEndList();
    }
    std::vector<std::uint32_t> got, expected;
    for (const auto& event : drawn([] { glCallList(1); }))
        if (event.position[0] != 0)
            got.push_back(event.position[0]);
    for (const float x : {1.0f, 2.0f, 3.0f, 4.0f, 40.0f, 30.0f, 20.0f, 10.0f})
        expected.push_back(std::bit_cast<std::uint32_t>(x));
    EXPECT_EQ(got, expected);
}

TEST_F(Lists, OldContentUntilEndList) {
    glNewList(1, GL_COMPILE);
    glColor3f(1, 0, 0);
    glEndList();
    glNewList(1, GL_COMPILE_AND_EXECUTE);
    glColor3f(0, 1, 0);
    glCallList(1); // plays the list 1 that existed before
    GLfloat color[4];
    glGetFloatv(GL_CURRENT_COLOR, color);
    EXPECT_EQ(color[0], 1);
    glEndList();
    glNewList(1, GL_COMPILE);
    glColor3f(0, 0, 1);
    glEndList();
    glCallList(1);
    glGetFloatv(GL_CURRENT_COLOR, color);
    EXPECT_EQ(color[2], 1);
}

TEST_F(Lists, NestingLimit) {
    for (GLuint i = 1; i <= 70; ++i) {
        glNewList(i, GL_COMPILE);
        glBegin(GL_POINTS);
        glVertex2i(static_cast<GLint>(i), 0);
        glEnd();
        glCallList(i + 1);
        glEndList();
    }
    EXPECT_EQ(drawn([] { glCallList(1); }).size(), 3u * 64);
    EXPECT_EQ(drawn([] { glCallList(60); }).size(), 3u * 11);
    glNewList(1, GL_COMPILE); // list 1 calls itself, 64 times
    glBegin(GL_POINTS);
    glEnd();
    glCallList(1);
    glEndList();
    EXPECT_EQ(drawn([] { glCallList(1); }).size(), 2u * 64);
    EXPECT_EQ(context->list.depth, 0u);
}

TEST_F(Lists, CallListsOfEveryType) {
    for (GLuint i = 0; i < 300; ++i) {
        glNewList(1000 + i, GL_COMPILE);
        glColor3us(static_cast<GLushort>(i), 0, 0);
        glBegin(GL_POINTS);
        glVertex2i(static_cast<GLint>(i), 0);
        glEnd();
        glEndList();
    }
    const auto called = [&](GLuint base, GLsizei n, GLenum type, const void* lists) {
        std::vector<int> which;
        for (int compiled = 0; compiled < 2; ++compiled) {
            if (compiled != 0) {
                glNewList(1, GL_COMPILE);
                glListBase(5); // the base at execution decides, not this one
                glListBase(base);
                glCallLists(n, type, lists);
                glEndList();
            } else {
                glListBase(base);
            }
            std::vector<int> now;
            for (const Event& e : drawn([&] { compiled != 0 ? glCallList(1) : glCallLists(n, type, lists); }))
                if (e.what == Event::vertex)
                    now.push_back(static_cast<int>(std::bit_cast<float>(e.position[0])));
            if (compiled != 0) {
                EXPECT_EQ(now, which);
            }
            which = now;
        }
        return which;
    };
    using V = std::vector<int>;
    const GLbyte b[] = {-1, 0, 127};
    EXPECT_EQ(called(1001, 3, GL_BYTE, b), (V{0, 1, 128}));
    const GLubyte ub[] = {255, 0};
    EXPECT_EQ(called(1000, 2, GL_UNSIGNED_BYTE, ub), (V{255, 0}));
    const GLshort s[] = {-30, 250};
    EXPECT_EQ(called(1030, 2, GL_SHORT, s), (V{0, 280}));
    const GLushort us[] = {1001, 65535};
    EXPECT_EQ(called(0, 2, GL_UNSIGNED_SHORT, us), (V{1}));
    const GLint i[] = {-1000, 3};
    EXPECT_EQ(called(2000, 2, GL_INT, i), (V{0}));
    const GLuint ui[] = {0xFFFFFFFF, 12};
    EXPECT_EQ(called(1001, 2, GL_UNSIGNED_INT, ui), (V{0, 13}));
    const GLfloat f[] = {2.9f, -1.9f, 1e30f, -1e30f, 0.1f};
    EXPECT_EQ(called(1001, 5, GL_FLOAT, f),
              (V{3, 0, 0, 2, 1})); // 1e30 and -1e30 saturate to -1 and 1 modulo 2^32
    const GLubyte bytes[] = {0, 0, 1, 2, 0, 0, 3, 231};
    EXPECT_EQ(called(1000, 2, GL_2_BYTES, bytes), (V{0, 258}));
    EXPECT_EQ(called(1000, 2, GL_3_BYTES, bytes + 1), (V{258, 3}));
    EXPECT_EQ(called(1000, 2, GL_4_BYTES, bytes), (V{258}));
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(Lists, Names) {
    EXPECT_EQ(glGenLists(0), 0u);
    const GLuint first = glGenLists(5);
    ASSERT_NE(first, 0u);
    for (GLuint i = 0; i < 5; ++i)
        EXPECT_TRUE(glIsList(first + i));
    EXPECT_FALSE(glIsList(first + 5));
    EXPECT_FALSE(glIsList(0));
    glDeleteLists(first + 1, 2);
    EXPECT_TRUE(glIsList(first));
    EXPECT_FALSE(glIsList(first + 1));
    EXPECT_FALSE(glIsList(first + 2));
    EXPECT_TRUE(glIsList(first + 3));
    glNewList(0xFFFFFFFF, GL_COMPILE);
    glEndList();
    EXPECT_TRUE(glIsList(0xFFFFFFFF));
    glDeleteLists(0xFFFFFFF0, 0x7FFFFFFF); // ends at the last name, and does not wrap
    EXPECT_FALSE(glIsList(0xFFFFFFFF));
    EXPECT_TRUE(glIsList(first));
    glNewList(100, GL_COMPILE);
    glEndList();
    glDeleteLists(50, 50); // more names than the table holds; ends before 100
    EXPECT_TRUE(glIsList(100));
    glDeleteLists(50, 51);
    EXPECT_FALSE(glIsList(100));
    glDeleteLists(1, 0x7FFFFFFF);
    EXPECT_FALSE(glIsList(first));
    EXPECT_EQ(context->share->lists.count(), 0u);
    EXPECT_EQ(glGenLists(0x7FFFFFFF), 0u);
    EXPECT_EQ(glGetError(), GLenum{GL_OUT_OF_MEMORY});
}

TEST_F(Lists, ArgumentErrors) {
    glNewList(0, GL_COMPILE);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    glNewList(1, GL_FLOAT);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    glEndList();
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    glDeleteLists(1, -1);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(glGenLists(-1), 0u);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    glNewList(1, GL_COMPILE_AND_EXECUTE);
    glBegin(GL_POINTS);
    glEndList(); // this list is executed between Begin and End
    EXPECT_EQ(context->error_code, GLenum{GL_INVALID_OPERATION});
    glEnd();
    glEndList();
    glGetError();
    EXPECT_TRUE(glIsList(1));
}

TEST_F(Lists, UnbalancedBeginEnd) {
    glNewList(1, GL_COMPILE);
    glBegin(GL_TRIANGLES);
    glEndList();
    glNewList(2, GL_COMPILE);
    glEnd();
    glEndList();
    const auto all = drawn([] {
        glCallList(1);
        glVertex2i(1, 1);
        glCallList(2);
    });
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[0].mode, GLenum{GL_TRIANGLES});
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(Lists, SharedBetweenContexts) {
    glNewList(9, GL_COMPILE);
    glColor3f(0.5f, 0, 0);
    glEndList();
    gl::Context* const other = gl::create_context(arena, {.engine = &recording_engine}, context);
    gl::make_current(other, surface(), false);
    EXPECT_TRUE(glIsList(9));
    glCallList(9);
    GLfloat color[4];
    glGetFloatv(GL_CURRENT_COLOR, color);
    EXPECT_EQ(color[0], 0.5f);
    glNewList(10, GL_COMPILE); // the list is never ended
    glVertex2f(1, 2);
    gl::destroy_context(other);
    EXPECT_EQ(gl::current_context(), nullptr);
    gl::make_current(context, surface(), true);
    EXPECT_TRUE(glIsList(9));
    EXPECT_FALSE(glIsList(10));
}

TEST_F(Lists, ExhaustionKeepsTheOldList) {
    glNewList(1, GL_COMPILE);
    glColor3f(0.5f, 0, 0);
    glEndList();
    const std::size_t used = arena.used();
    glNewList(1, GL_COMPILE);
    for (int i = 0; i < 600'000; ++i)
        glVertex4f(1, 2, 3, static_cast<float>(i) + 2);
    EXPECT_EQ(context->error_code, GLenum{GL_NO_ERROR});
    glEndList();
    EXPECT_EQ(glGetError(), GLenum{GL_OUT_OF_MEMORY});
    EXPECT_EQ(arena.used(), used) << "what was compiled is given back";
    EXPECT_EQ(context->list.index, 0u);
    glCallList(1);
    GLfloat color[4];
    glGetFloatv(GL_CURRENT_COLOR, color);
    EXPECT_EQ(color[0], 0.5f);
}

TEST_F(Lists, RunsAreCompact) {
    const std::size_t before = arena.used();
    glNewList(1, GL_COMPILE);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 3000; ++i) {
        glNormal3f(0, 0, 1);
        glVertex3f(static_cast<float>(i), 1, 2);
    }
    glEnd();
    glEndList();
    EXPECT_LT(arena.used() - before, 3000 * 24 * 1.02 + 256) << "24 bytes for each normal and position";
}

} // namespace
} // namespace spangle::test

#endif
