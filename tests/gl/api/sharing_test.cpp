// Tests two contexts of one share group: which of them sees a change, and how long deleted objects live (GL
// 1.3, 3.8.11 and 5.4; GL 1.5, 2.9; EGL 1.4, 2.4).
#include <array>

#include "tests/gl/api/recording_context.hpp"

namespace spangle::test {
namespace {

class Sharing : public RecordingContext {
  protected:
    Sharing() {
        other =
            gl::create_context(arena, {.tier = raster::Tier::exact, .engine = &recording_engine}, context);
        in(other);
        in(context);
    }
    ~Sharing() override {
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        gl::destroy_context(other);
    }
    void in(gl::Context* now) { gl::make_current(now, surface(), true); }
    static GLint get(GLenum name) {
        GLint v = -77;
        glGetIntegerv(name, &v);
        return v;
    }

    gl::Context* other = nullptr;
};

#if SPANGLE_FEATURE_BUFFERS

GLint size_of_buffer() {
    GLint v = -77;
    glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &v);
    return v;
}

TEST_F(Sharing, ABufferLivesWhileItIsBoundElsewhere) {
    const std::array<GLubyte, 3> bytes = {1, 2, 3};
    glBindBuffer(GL_ARRAY_BUFFER, 7);
    const std::size_t before = arena.used();
    glBufferData(GL_ARRAY_BUFFER, 3, bytes.data(), GL_STATIC_DRAW);
    in(other);
    glBindBuffer(GL_ARRAY_BUFFER, 7);
    EXPECT_EQ(size_of_buffer(), 3);
    in(context);
    const GLuint name = 7;
    glDeleteBuffers(1, &name);
    EXPECT_EQ(get(GL_ARRAY_BUFFER_BINDING), 0) << "unbound where it was deleted";
    EXPECT_FALSE(glIsBuffer(7));
    glBindBuffer(GL_ARRAY_BUFFER, 7); // makes another buffer with the same name
    EXPECT_EQ(size_of_buffer(), 0);
    in(other);
    EXPECT_EQ(get(GL_ARRAY_BUFFER_BINDING), 7) << "bound where it was not";
    EXPECT_EQ(size_of_buffer(), 3);
    std::array<GLubyte, 3> back{};
    glGetBufferSubData(GL_ARRAY_BUFFER, 0, 3, back.data());
    EXPECT_EQ(back, bytes);
    glBindBuffer(GL_ARRAY_BUFFER, 7);
    EXPECT_EQ(size_of_buffer(), 0) << "the name is the new one's";
    EXPECT_LE(arena.used(), before) << "the last binding took the old one with it";
}

TEST_F(Sharing, ABufferLivesInArraysThatWereSetBefore) {
    const GLfloat position[6] = {0, 0, 1, 0, 0, 1};
    glBindBuffer(GL_ARRAY_BUFFER, 7);
    glBufferData(GL_ARRAY_BUFFER, sizeof position, position, GL_STATIC_DRAW);
    in(other);
    glBindBuffer(GL_ARRAY_BUFFER, 7);
    glVertexPointer(2, GL_FLOAT, 0, nullptr);
    glEnableClientState(GL_VERTEX_ARRAY);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    in(context);
    const GLuint name = 7;
    glDeleteBuffers(1, &name);
    in(other);
    EXPECT_EQ(get(GL_VERTEX_ARRAY_BUFFER_BINDING), 7);
    events().clear();
    glBegin(GL_POINTS);
    glArrayElement(1);
    glEnd();
    ASSERT_EQ(events().size(), 3u);
    EXPECT_EQ(events()[1].position[0], 0x3F800000u);
}

#if SPANGLE_FEATURE_ATTRIB_STACKS
TEST_F(Sharing, ABufferLivesOnTheStack) {
    glBindBuffer(GL_ARRAY_BUFFER, 7);
    glBufferData(GL_ARRAY_BUFFER, 3, nullptr, GL_STATIC_DRAW);
    glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    const GLuint name = 7;
    glDeleteBuffers(1, &name);
    EXPECT_EQ(get(GL_ARRAY_BUFFER_BINDING), 0);
    glPopClientAttrib();
    EXPECT_EQ(get(GL_ARRAY_BUFFER_BINDING), 7);
    EXPECT_EQ(size_of_buffer(), 3);
    glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT); // never popped; the end of the context frees it
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}
#endif

#if SPANGLE_FEATURE_VERTEX_ARRAY_OBJECTS
/// Array objects of either context hold the buffer, too, whether they are bound or not.
TEST_F(Sharing, ABufferLivesInVertexArrayObjects) {
    in(other);
    GLuint arrays[2];
    glGenVertexArrays(2, arrays);
    for (const GLuint array : arrays) {
        glBindVertexArray(array);
        glBindBuffer(GL_ARRAY_BUFFER, 7);
        if (array == arrays[0])
            glBufferData(GL_ARRAY_BUFFER, 32, nullptr, GL_STATIC_DRAW);
        glVertexPointer(2, GL_FLOAT, 0, nullptr);
    }
    const GLuint name = 7;
    glDeleteBuffers(1, &name);
    EXPECT_EQ(get(GL_VERTEX_ARRAY_BUFFER_BINDING), 0) << "of the array object that is bound";
    glBindVertexArray(arrays[0]);
    EXPECT_EQ(get(GL_VERTEX_ARRAY_BUFFER_BINDING), 7);
    in(context);
    EXPECT_FALSE(glIsVertexArray(arrays[0])) << "array objects are not shared";
    glBindVertexArray(arrays[0]);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    in(other);
    const std::size_t before = arena.used();
    glDeleteVertexArrays(1, arrays);
    EXPECT_LE(arena.used() + 32, before) << "the store went with the last array";
}
#endif

#endif

TEST_F(Sharing, ATextureLivesWhileItIsBoundElsewhere) {
    const auto width = [] {
        GLint v = -77;
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &v);
        return v;
    };
    const GLubyte texels[64] = {};
    const std::size_t before = arena.used();
    glBindTexture(GL_TEXTURE_2D, 7);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    in(other);
    glBindTexture(GL_TEXTURE_2D, 7);
    EXPECT_EQ(width(), 4);
    in(context);
    const GLuint name = 7;
    glDeleteTextures(1, &name);
    EXPECT_EQ(get(GL_TEXTURE_BINDING_2D), 0);
    EXPECT_FALSE(glIsTexture(7));
    glBindTexture(GL_TEXTURE_2D, 7);
    EXPECT_EQ(width(), 0) << "another one of the same name";
    glDeleteTextures(1, &name);
    in(other);
    EXPECT_EQ(get(GL_TEXTURE_BINDING_2D), 7);
    EXPECT_EQ(width(), 4);
    glBindTexture(GL_TEXTURE_2D, 0);
    EXPECT_LE(arena.used(), before + 256) << "names of objects keep their room";
}

#if SPANGLE_FEATURE_LISTS
/// Lists cannot be bound, so a deleted list is deleted for all contexts.
TEST_F(Sharing, Lists) {
    glNewList(3, GL_COMPILE);
    glShadeModel(GL_FLAT);
    glEndList();
    in(other);
    EXPECT_TRUE(glIsList(3));
    glCallList(3);
    EXPECT_EQ(get(GL_SHADE_MODEL), GL_FLAT);
    in(context);
    EXPECT_EQ(get(GL_SHADE_MODEL), GL_SMOOTH) << "state is each context's own";
    glDeleteLists(3, 1);
    in(other);
    EXPECT_FALSE(glIsList(3));
    glShadeModel(GL_SMOOTH);
    glCallList(3);
    EXPECT_EQ(get(GL_SHADE_MODEL), GL_SMOOTH);
}
#endif

/// The context that was made first may be destroyed first.
TEST_F(Sharing, TheGroupGoesWithItsLastContext) {
    glBindTexture(GL_TEXTURE_2D, 9);
#if SPANGLE_FEATURE_BUFFERS
    glBindBuffer(GL_ARRAY_BUFFER, 9);
    glBufferData(GL_ARRAY_BUFFER, 5, nullptr, GL_STATIC_DRAW);
#endif
    in(other);
    glBindTexture(GL_TEXTURE_2D, 9);
    gl::destroy_context(context);
    context = other;
    other = nullptr;
    EXPECT_TRUE(glIsTexture(9));
#if SPANGLE_FEATURE_BUFFERS
    glBindBuffer(GL_ARRAY_BUFFER, 9);
    EXPECT_EQ(size_of_buffer(), 5);
#endif
}

} // namespace
} // namespace spangle::test
