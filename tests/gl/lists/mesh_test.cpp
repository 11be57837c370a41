// Compares draws of arrays in display lists with the same draw, made when the list is compiled.
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_LISTS

#include "gl/context/share_group.hpp"
#include "tests/gl/api/recording_context.hpp"
#include "tests/support/random.hpp"

namespace spangle::test {
namespace {

constexpr int vertices = 700;

class Meshes : public RecordingContext {
  protected:
    void SetUp() override {
        Random random(5);
        for (GLubyte& byte : data_)
            byte = static_cast<GLubyte>(random.below(120)); // as floats these bytes are never NaN
    }

    /// Points all enabled arrays at numbers of a type, `stride` bytes apart.
    void point(GLenum type, GLint size, GLsizei stride) {
        glVertexPointer(size < 2 ? 2 : size, type, stride, data_.data());
        glNormalPointer(type, stride, data_.data() + 3);
        glColorPointer(size < 3 ? 3 : size, type, stride, data_.data() + 40);
        glTexCoordPointer(size, type, stride, data_.data() + 77);
    }
    void enable(unsigned which) {
        constexpr GLenum arrays[] = {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY,
                                     GL_TEXTURE_COORD_ARRAY};
        for (unsigned i = 0; i < 4; ++i)
            ((which >> i & 1) != 0 ? glEnableClientState : glDisableClientState)(arrays[i]);
    }

    /// Compares a draw with a list of it that is called when its arrays and indices no longer exist. The list
    /// is called with all arrays disabled, and with all enabled.
    template <class Draw> void same_from_list(const Draw& draw, const std::string& what) {
        glColor4f(0.25F, 0.5F, 0.125F, 1.F);
        events().clear();
        draw();
        const std::vector<Event> expected = events();
        glNewList(1, GL_COMPILE);
        draw();
        glEndList();
        const std::vector<GLubyte> kept = data_;
        std::fill(data_.begin(), data_.end(), GLubyte{1});
        std::vector<GLuint> indices;
        indices.swap(indices_);
        for (const unsigned enabled : {0u, 15u}) {
            enable(enabled);
            const auto before = snapshot();
            events().clear();
            glCallList(1);
            EXPECT_EQ(events(), expected) << what << ", called with arrays " << enabled;
            EXPECT_EQ(snapshot(), before) << what << ": arrays and what is current stay";
        }
        data_ = kept;
        indices_.swap(indices);
    }

    std::vector<GLubyte> data_ = std::vector<GLubyte>(vertices * 64 + 256);
    std::vector<GLuint> indices_;
};

TEST_F(Meshes, ArraysOfEveryTypeAndStride) {
    for (const GLenum type : {GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE})
        for (const GLint size : {1, 2, 3, 4})
            for (const GLsizei stride : {0, 64, 37})
                for (const unsigned which : {1u, 3u, 9u, 15u, 14u}) {
                    enable(which);
                    point(type, size, stride);
                    same_from_list(
                        [&] {
                            enable(which);
                            glDrawArrays(GL_TRIANGLE_STRIP, 5, 23);
                        },
                        std::to_string(type) + ", " + std::to_string(size) + " components, stride " +
                            std::to_string(stride) + ", arrays " + std::to_string(which));
                }
}

/// Indices are near each other, far apart, single, or all the same; they are bytes, shorts and words.
TEST_F(Meshes, IndicesOfEveryKind) {
    Random random(9);
    enable(15);
    point(GL_FLOAT, 3, 0);
    const struct {
        unsigned first, range;
        int count;
    } kinds[] = {{0, 200, 600}, {40, 256, 900}, {44, 257, 900}, {0, 700, 900}, {3, 690, 9},
                 {699, 1, 1},   {500, 1, 40},   {0, 2, 0},      {100, 3, 2}};
    for (const auto& kind : kinds) {
        std::vector<GLuint> words;
        for (int i = 0; i < kind.count; ++i)
            words.push_back(kind.first + random.below(kind.range));
        if (kind.count > 1) {
            words.front() = kind.first;
            words.back() = kind.first + kind.range - 1;
        }
        for (const GLenum type : {GL_UNSIGNED_INT, GL_UNSIGNED_SHORT, GL_UNSIGNED_BYTE}) {
            if (type == GL_UNSIGNED_BYTE && kind.first + kind.range > 256)
                continue;
            std::vector<GLubyte> bytes;
            for (const GLuint word : words)
                for (unsigned b = 0; b < gl::bytes_of(type); ++b)
                    bytes.push_back(reinterpret_cast<const GLubyte*>(&word)[b]);
            same_from_list(
                [&] {
                    enable(15);
                    glDrawElements(GL_TRIANGLES, kind.count, type, bytes.data());
                },
                std::to_string(kind.count) + " of " + std::to_string(kind.range));
        }
    }
}

#if SPANGLE_FEATURE_PRIMITIVE_RESTART

TEST_F(Meshes, RestartsAndSeveralDraws) {
    enable(1);
    point(GL_FLOAT, 3, 0);
    const GLubyte indices[] = {4, 5, 6, 255, 255, 7, 8, 9, 10, 255};
    glPrimitiveRestartIndex(255);
    glEnable(GL_PRIMITIVE_RESTART); // used when the list is compiled
    same_from_list(
        [&] {
            enable(1);
            glDrawElements(GL_TRIANGLE_STRIP, 10, GL_UNSIGNED_BYTE, indices);
            const GLint first[] = {3, 9};
            const GLsizei count[] = {4, 5};
            glMultiDrawArrays(GL_LINE_STRIP, first, count, 2);
        },
        "restarts");
    glDisable(GL_PRIMITIVE_RESTART);
}

#endif

TEST_F(Meshes, NothingBetweenBeginAndEnd) {
    enable(1);
    point(GL_FLOAT, 3, 0);
    glNewList(1, GL_COMPILE);
    glDrawArrays(GL_TRIANGLES, 0, 6);
    glVertex2f(7, 7);
    glEndList();
    glBegin(GL_POINTS);
    events().clear();
    glCallList(1);
    EXPECT_EQ(events().size(), 1U) << "the vertex behind the draw";
    glEnd();
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
}

/// A model with six uses of each vertex takes memory for its arrays and indices only.
TEST_F(Meshes, TakeTheirArraysAndTheirIndices) {
    enable(3);
    point(GL_FLOAT, 3, 0);
    std::vector<GLushort> indices;
    Random random(2);
    for (int i = 0; i < 6 * vertices; ++i)
        indices.push_back(static_cast<GLushort>(i < vertices ? i : static_cast<int>(random.below(vertices))));
    const std::size_t before = arena.used();
    glNewList(1, GL_COMPILE);
    glDrawElements(GL_TRIANGLES, 6 * vertices, GL_UNSIGNED_SHORT, indices.data());
    glEndList();
    EXPECT_LT(arena.used() - before, vertices * 24 + 6 * vertices * 2 + 400);
    // Short positions are stored as shorts, so the list takes less memory.
    const std::size_t next = arena.used();
    point(GL_SHORT, 4, 0);
    glNewList(2, GL_COMPILE);
    glDrawArrays(GL_TRIANGLES, 0, vertices);
    glEndList();
    EXPECT_LT(arena.used() - next, vertices * 16 + 400);
}

/// If a mesh needs more memory than there is, the list is empty, and EndList raises an error.
TEST_F(Meshes, WithoutMemory) {
    enable(1);
    point(GL_FLOAT, 3, 0);
    const std::size_t used = arena.used();
    glNewList(1, GL_COMPILE);
    for (int i = 0; i < 1000; ++i)
        glDrawArrays(GL_TRIANGLES, 0, vertices);
    glEndList();
    EXPECT_EQ(glGetError(), GLenum{GL_OUT_OF_MEMORY});
    EXPECT_EQ(arena.used(), used);
}

} // namespace
} // namespace spangle::test

#endif
