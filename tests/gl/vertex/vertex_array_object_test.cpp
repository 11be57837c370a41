// Rows B18 and B26: tests primitive restart and vertex array objects (GL 3.0, 2.10; GL 3.1, 2.8).
#include <cstdint>
#include <vector>

#include "gl/context/features.hpp"
#include "tests/gl/vertex/canvas.hpp"
#include "tests/gl/vertex/window_recorder.hpp"

namespace spangle::test {
namespace {

GLint get(GLenum name) {
    GLint v = -77;
    glGetIntegerv(name, &v);
    return v;
}
void refused(GLenum code, const char* what) {
    EXPECT_EQ(glGetError(), code) << what;
}

#if SPANGLE_FEATURE_VERTEX_ARRAY_OBJECTS

class VertexArrayObjects : public Canvas {};

TEST_F(VertexArrayObjects, Names) {
    GLuint names[2] = {};
    glGenVertexArrays(2, names);
    EXPECT_TRUE(names[0] != 0 && names[1] != 0 && names[0] != names[1]);
    EXPECT_FALSE(glIsVertexArray(names[0])) << "a name becomes an object when it is bound";
    EXPECT_EQ(get(GL_VERTEX_ARRAY_BINDING), 0);
    glBindVertexArray(names[0]);
    EXPECT_TRUE(glIsVertexArray(names[0]));
    EXPECT_EQ(get(GL_VERTEX_ARRAY_BINDING), static_cast<GLint>(names[0]));
    glBindVertexArray(4711);
    refused(GL_INVALID_OPERATION, "not a name of GenVertexArrays");
    EXPECT_EQ(get(GL_VERTEX_ARRAY_BINDING), static_cast<GLint>(names[0]));
    const GLuint gone[3] = {names[0], 0, 4711};
    glDeleteVertexArrays(3, gone);
    EXPECT_EQ(get(GL_VERTEX_ARRAY_BINDING), 0) << "deleted while bound";
    EXPECT_FALSE(glIsVertexArray(names[0]));
    glBindVertexArray(names[0]);
    refused(GL_INVALID_OPERATION, "deleted");
    glDeleteVertexArrays(-1, gone);
    refused(GL_INVALID_VALUE, "count");
    glGenVertexArrays(1, nullptr);
    refused(GL_INVALID_VALUE, "null");
    EXPECT_FALSE(glIsVertexArray(0));
}

/// All state of arrays belongs to the object that is bound, except ARRAY_BUFFER and the client's active unit.
TEST_F(VertexArrayObjects, HoldTheArrays) {
    GLuint names[2];
    glGenVertexArrays(2, names);
    static const GLfloat memory[8] = {};
    const auto set = [](GLsizei k) {
        (k % 2 != 0 ? glEnableClientState : glDisableClientState)(GL_VERTEX_ARRAY);
        (k % 2 != 0 ? glDisableClientState : glEnableClientState)(GL_COLOR_ARRAY);
#if SPANGLE_FEATURE_BUFFERS
        glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(k) + 1);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLuint>(k) + 10);
        const void* const at = reinterpret_cast<const void*>(std::uintptr_t{4} * static_cast<unsigned>(k));
#else
        const void* const at = nullptr;
#endif
        glVertexPointer(2, GL_FLOAT, k, at);
        glTexCoordPointer(3, GL_SHORT, 10 * k, at);
    };
    const auto is = [](GLsizei k) {
        EXPECT_EQ(glIsEnabled(GL_VERTEX_ARRAY), k % 2 != 0);
        EXPECT_EQ(glIsEnabled(GL_COLOR_ARRAY), k % 2 == 0);
        EXPECT_EQ(get(GL_VERTEX_ARRAY_STRIDE), k);
        EXPECT_EQ(get(GL_TEXTURE_COORD_ARRAY_STRIDE), 10 * k);
        EXPECT_EQ(get(GL_TEXTURE_COORD_ARRAY_TYPE), GL_SHORT);
#if SPANGLE_FEATURE_BUFFERS
        EXPECT_EQ(get(GL_VERTEX_ARRAY_BUFFER_BINDING), k + 1);
        EXPECT_EQ(get(GL_ELEMENT_ARRAY_BUFFER_BINDING), k + 10);
        void* at = nullptr;
        glGetPointerv(GL_VERTEX_ARRAY_POINTER, &at);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(at), 4u * static_cast<unsigned>(k));
#endif
    };
    set(1);
    glBindVertexArray(names[0]);
    EXPECT_FALSE(glIsEnabled(GL_VERTEX_ARRAY)) << "as a context begins";
    EXPECT_EQ(get(GL_VERTEX_ARRAY_STRIDE), 0);
    EXPECT_EQ(get(GL_VERTEX_ARRAY_SIZE), 4);
    set(2);
    glBindVertexArray(names[1]);
    set(3);
    glClientActiveTexture(GL_TEXTURE0);
    glBindVertexArray(names[0]);
    is(2);
#if SPANGLE_FEATURE_BUFFERS
    EXPECT_EQ(get(GL_ARRAY_BUFFER_BINDING), 4) << "no state of array objects";
#endif
    glBindVertexArray(0);
    is(1);
    glBindVertexArray(names[1]);
    is(3);
#if SPANGLE_FEATURE_ATTRIB_STACKS
    glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    set(5);
    glBindVertexArray(names[0]);
    glPopClientAttrib();
    EXPECT_EQ(get(GL_VERTEX_ARRAY_BINDING), static_cast<GLint>(names[1]));
    is(3);
    glBindVertexArray(names[0]);
    is(2);
    glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    glDeleteVertexArrays(1, names);
    glPopClientAttrib();
    EXPECT_EQ(get(GL_VERTEX_ARRAY_BINDING), 0) << "the one that was saved is gone";
    glBindVertexArray(names[1]);
#endif
#if SPANGLE_FEATURE_BUFFERS
    glBindBuffer(GL_ARRAY_BUFFER, 0);
#endif
    for (const bool interleaved : {false, true}) { // both ways of setting arrays (GL 3.0, 2.8)
        interleaved ? glInterleavedArrays(GL_V2F, 0, memory) : glVertexPointer(2, GL_FLOAT, 0, memory);
        refused(GL_INVALID_OPERATION, "client memory in an object with a name");
    }
    glBindVertexArray(0);
    glVertexPointer(2, GL_FLOAT, 0, memory);
}

#endif

#if SPANGLE_FEATURE_PRIMITIVE_RESTART

class PrimitiveRestart : public Canvas {
  protected:
    void SetUp() override {
        Canvas::SetUp();
        for (int i = 0; i < 16; ++i)
            position_.insert(position_.end(), {0.1f * static_cast<GLfloat>(i % 5) - 0.3f,
                                               0.15f * static_cast<GLfloat>(i / 3) - 0.4f});
        glVertexPointer(2, GL_FLOAT, 0, position_.data());
        glEnableClientState(GL_VERTEX_ARRAY);
    }
    template <class Draw> static std::vector<std::int32_t> drawn(Draw draw) {
        WindowRecorder recorder;
        draw();
        std::vector<std::int32_t> all;
        for (const Primitive& p : recorder.primitives)
            for (int c = 0; c < p.corners; ++c)
                all.insert(all.end(), {p.corner[c].x, p.corner[c].y});
        return all;
    }
    std::vector<GLfloat> position_;
};

constexpr GLubyte index[] = {0, 1, 2, 3, 9, 4, 5, 6, 9, 9, 7, 9, 8, 10, 11, 12};
constexpr GLsizei indices = sizeof index;

/// Draws the runs of indices between the nines.
void pieces(GLenum mode) {
    for (const auto& [first, count] : {std::pair{0, 4}, {5, 3}, {10, 1}, {12, 4}})
        glDrawElements(mode, count, GL_UNSIGNED_BYTE, index + first);
}

TEST_F(PrimitiveRestart, EveryMode) {
    EXPECT_EQ(get(GL_PRIMITIVE_RESTART_INDEX), 0);
    EXPECT_FALSE(glIsEnabled(GL_PRIMITIVE_RESTART));
    glPrimitiveRestartIndex(9);
    EXPECT_EQ(get(GL_PRIMITIVE_RESTART_INDEX), 9);
    std::vector<GLushort> shorts(index, index + indices);
    std::vector<GLuint> words(index, index + indices);
    for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode) {
        const auto whole = [mode] { glDrawElements(mode, indices, GL_UNSIGNED_BYTE, index); };
        const auto expected = drawn([mode] { pieces(mode); }), one = drawn(whole);
        EXPECT_NE(one, expected) << "off";
        glEnable(GL_PRIMITIVE_RESTART);
        EXPECT_EQ(drawn(whole), expected) << mode;
        EXPECT_EQ(drawn([&] { glDrawElements(mode, indices, GL_UNSIGNED_SHORT, shorts.data()); }), expected);
        EXPECT_EQ(drawn([&] { glDrawRangeElements(mode, 0, 12, indices, GL_UNSIGNED_INT, words.data()); }),
                  expected);
        EXPECT_EQ(drawn([mode] {
                      glBegin(mode);
                      for (const GLubyte i : index)
                          glArrayElement(i);
                      glEnd();
                  }),
                  expected);
#if SPANGLE_FEATURE_LISTS
        glNewList(1, GL_COMPILE);
        whole();
        glEndList();
        glNewList(2, GL_COMPILE);
        glBegin(mode);
        for (const GLubyte i : index)
            glArrayElement(i);
        glEnd();
        glEndList();
        EXPECT_EQ(drawn([] { glCallList(1); }), expected);
        glDisable(GL_PRIMITIVE_RESTART); // lists use the client state of their compilation
        EXPECT_EQ(drawn([] { glCallList(2); }), expected);
#endif
        glDisable(GL_PRIMITIVE_RESTART);
    }
}

/// DrawArrays and its multiple form restart at elements, too, because they are defined by ArrayElement (GL
/// 3.1, 2.8).
TEST_F(PrimitiveRestart, DrawArrays) {
    glPrimitiveRestartIndex(4);
    const auto expected = drawn([] {
        glDrawArrays(GL_LINE_STRIP, 1, 3);
        glDrawArrays(GL_LINE_STRIP, 5, 3);
    });
    glEnable(GL_PRIMITIVE_RESTART);
    EXPECT_EQ(drawn([] { glDrawArrays(GL_LINE_STRIP, 1, 7); }), expected);
    const GLint first = 1;
    const GLsizei count = 7;
    EXPECT_EQ(drawn([&] { glMultiDrawArrays(GL_LINE_STRIP, &first, &count, 1); }), expected);
}

TEST_F(PrimitiveRestart, NamesNoElement) {
    glPrimitiveRestartIndex(0xFFFFFFFF);
    glEnable(GL_PRIMITIVE_RESTART);
    const GLuint words[4] = {0, 1, 0xFFFFFFFF, 2};
#if SPANGLE_FEATURE_BUFFERS
    glBindBuffer(GL_ARRAY_BUFFER, 1);
    glBufferData(GL_ARRAY_BUFFER, 3 * 8, position_.data(), GL_STATIC_DRAW);
    glVertexPointer(2, GL_FLOAT, 0, nullptr);
    const GLuint beyond[4] = {0, 1, 0xFFFFFFFF, 3};
    EXPECT_TRUE(drawn([&] { glDrawElements(GL_LINE_STRIP, 4, GL_UNSIGNED_INT, beyond); }).empty());
    refused(GL_INVALID_OPERATION, "an element beyond its buffer, behind a restart");
#endif
    EXPECT_EQ(drawn([&] { glDrawElements(GL_LINE_STRIP, 4, GL_UNSIGNED_INT, words); }).size(), 4u);
    glPrimitiveRestartIndex(2); // bytes of indices are never larger than this
    EXPECT_EQ(drawn([] { glDrawArrays(GL_LINE_STRIP, 0, 3); }).size(), 4u);
    glColor3f(0.25f, 0, 0);
    const GLfloat colors[3][3] = {};
    glEnableClientState(GL_COLOR_ARRAY);
#if SPANGLE_FEATURE_BUFFERS
    glBindBuffer(GL_ARRAY_BUFFER, 0);
#endif
    glColorPointer(3, GL_FLOAT, 0, colors);
    glBegin(GL_POINTS);
    glArrayElement(2); // no attribute changes
    glEnd();
    GLfloat color[4];
    glGetFloatv(GL_CURRENT_COLOR, color);
    EXPECT_EQ(color[0], 0.25f);
    glArrayElement(2); // outside of Begin and End it is an element like any other
    glGetFloatv(GL_CURRENT_COLOR, color);
    EXPECT_EQ(color[0], 0);
}

#endif

} // namespace
} // namespace spangle::test
