// Rows B15, B21, B22, B24: tests buffer objects, arrays and indices in them, and draws of many primitives.
#include <algorithm>
#include <array>
#include <climits>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <vector>

#include "gl/vertex/array_source.hpp"
#include "tests/gl/vertex/canvas.hpp"
#include "tests/gl/vertex/window_recorder.hpp"

namespace spangle::test {
namespace {

class Buffers : public Canvas {
  protected:
    static void refused(GLenum code, const char* what) { EXPECT_EQ(glGetError(), code) << what; }
    static const void* at(std::size_t offset) { return reinterpret_cast<const void*>(offset); }
    static GLint parameter(GLenum name, GLenum target = GL_ARRAY_BUFFER) {
        GLint v = -1;
        glGetBufferParameteriv(target, name, &v);
        return v;
    }
    template <class Draw> static std::vector<std::int32_t> drawn(Draw draw) {
        WindowRecorder recorder;
        draw();
        std::vector<std::int32_t> all;
        for (const Primitive& p : recorder.primitives)
            for (int c = 0; c < p.corners; ++c)
                all.insert(all.end(),
                           {p.corner[c].x, p.corner[c].y, static_cast<std::int32_t>(p.corner[c].color[0])});
        return all;
    }
};

constexpr GLenum value = GL_INVALID_VALUE, operation = GL_INVALID_OPERATION, token = GL_INVALID_ENUM;

TEST_F(Buffers, NamesAndBinding) {
    GLuint names[3] = {};
    glGenBuffers(3, names);
    EXPECT_EQ(std::accumulate(names, names + 3, 0u), 6u);
    EXPECT_FALSE(glIsBuffer(names[0])) << "a name becomes a buffer when it is bound";
    glBindBuffer(GL_ARRAY_BUFFER, names[0]);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 77); // a name that the program chose
    EXPECT_TRUE(glIsBuffer(names[0]) && glIsBuffer(77));
    EXPECT_FALSE(glIsBuffer(0));
    GLint bound[2];
    glGetIntegerv(GL_ARRAY_BUFFER_BINDING, bound);
    glGetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, bound + 1);
    EXPECT_EQ(bound[0], static_cast<GLint>(names[0]));
    EXPECT_EQ(bound[1], 77);
    glVertexPointer(2, GL_FLOAT, 0, at(8));
    glGetIntegerv(GL_VERTEX_ARRAY_BUFFER_BINDING, bound);
    EXPECT_EQ(bound[0], static_cast<GLint>(names[0])) << "latched";
    const GLuint gone[4] = {names[0], 0, 77, 12345};
    glDeleteBuffers(4, gone);
    for (const GLenum name :
         {GL_ARRAY_BUFFER_BINDING, GL_ELEMENT_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_BUFFER_BINDING}) {
        glGetIntegerv(name, bound);
        EXPECT_EQ(bound[0], 0);
    }
    EXPECT_FALSE(glIsBuffer(names[0]));
    glBindBuffer(GL_TEXTURE_2D, 1);
    refused(token, "target");
    glBufferData(GL_ARRAY_BUFFER, 4, nullptr, GL_STATIC_DRAW);
    refused(operation, "nothing is bound");
}

TEST_F(Buffers, DataAndItsErrors) {
    const std::array<GLubyte, 6> bytes = {1, 2, 3, 4, 5, 6};
    std::array<GLubyte, 6> back{};
    glBindBuffer(GL_ARRAY_BUFFER, 1);
    EXPECT_EQ(parameter(GL_BUFFER_SIZE), 0);
    EXPECT_EQ(parameter(GL_BUFFER_USAGE), GL_STATIC_DRAW);
    EXPECT_EQ(parameter(GL_BUFFER_ACCESS), GL_READ_WRITE);
    glBufferData(GL_ARRAY_BUFFER, 6, bytes.data(), GL_DYNAMIC_COPY);
    EXPECT_EQ(parameter(GL_BUFFER_SIZE), 6);
    EXPECT_EQ(parameter(GL_BUFFER_USAGE), GL_DYNAMIC_COPY);
    glBufferSubData(GL_ARRAY_BUFFER, 2, 3, bytes.data());
    glGetBufferSubData(GL_ARRAY_BUFFER, 0, 6, back.data());
    EXPECT_EQ(back, (std::array<GLubyte, 6>{1, 2, 1, 2, 3, 6}));
    glGetBufferSubData(GL_ARRAY_BUFFER, 4, 2, back.data());
    EXPECT_EQ(back[0], 3);
    for (const std::pair<GLintptr, GLsizeiptr>& range : {std::pair<GLintptr, GLsizeiptr>{-1, 2},
                                                         {0, -1},
                                                         {0, 7},
                                                         {6, 1},
                                                         {7, 0},
                                                         {INTPTR_MAX, INTPTR_MAX}}) {
        glBufferSubData(GL_ARRAY_BUFFER, range.first, range.second, bytes.data());
        refused(value, "range");
        glGetBufferSubData(GL_ARRAY_BUFFER, range.first, range.second, back.data());
        refused(value, "range");
        glMapBufferRange(GL_ARRAY_BUFFER, range.first, range.second, GL_MAP_READ_BIT);
        refused(value, "range");
    }
    glBufferSubData(GL_ARRAY_BUFFER, 6, 0, bytes.data());
    glBufferData(GL_ARRAY_BUFFER, -1, nullptr, GL_STATIC_DRAW);
    refused(value, "size");
    for (const GLenum usage :
         {GL_STREAM_DRAW - 1u, GL_STREAM_COPY + 1u, GL_STATIC_COPY + 1u, GL_DYNAMIC_COPY + 1u}) {
        glBufferData(GL_ARRAY_BUFFER, 1, nullptr, usage);
        refused(token, "usage");
    }
    glBufferData(GL_ARRAY_BUFFER, INTPTR_MAX, nullptr, GL_STATIC_DRAW);
    refused(GL_OUT_OF_MEMORY, "memory");
    EXPECT_EQ(parameter(GL_BUFFER_SIZE), 6) << "what was there is there";
}

TEST_F(Buffers, Mapping) {
    glBindBuffer(GL_ARRAY_BUFFER, 1);
    const std::array<GLubyte, 8> bytes = {1, 2, 3, 4, 5, 6, 7, 8};
    glBufferData(GL_ARRAY_BUFFER, 8, bytes.data(), GL_STATIC_DRAW);
    EXPECT_FALSE(glUnmapBuffer(GL_ARRAY_BUFFER));
    refused(operation, "not mapped");
    auto* all = static_cast<GLubyte*>(glMapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY));
    ASSERT_NE(all, nullptr);
    EXPECT_EQ(parameter(GL_BUFFER_MAPPED), 1);
    EXPECT_EQ(parameter(GL_BUFFER_ACCESS), GL_WRITE_ONLY);
    EXPECT_EQ(parameter(GL_BUFFER_ACCESS_FLAGS), GL_MAP_WRITE_BIT);
    EXPECT_EQ(parameter(GL_BUFFER_MAP_LENGTH), 8);
    void* pointer = nullptr;
    glGetBufferPointerv(GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, &pointer);
    EXPECT_EQ(pointer, all);
    EXPECT_EQ(glMapBuffer(GL_ARRAY_BUFFER, GL_READ_ONLY), nullptr);
    refused(operation, "mapped already");
    glBufferSubData(GL_ARRAY_BUFFER, 0, 1, bytes.data());
    refused(operation, "mapped");
    all[3] = 99;
    EXPECT_TRUE(glUnmapBuffer(GL_ARRAY_BUFFER));
    auto* part = static_cast<GLubyte*>(
        glMapBufferRange(GL_ARRAY_BUFFER, 2, 4, GL_MAP_WRITE_BIT | GL_MAP_FLUSH_EXPLICIT_BIT));
    EXPECT_EQ(part[1], 99);
    EXPECT_EQ(parameter(GL_BUFFER_MAP_OFFSET), 2);
    EXPECT_EQ(parameter(GL_BUFFER_MAP_LENGTH), 4);
    glFlushMappedBufferRange(GL_ARRAY_BUFFER, 1, 3);
    glFlushMappedBufferRange(GL_ARRAY_BUFFER, 1, 4);
    refused(value, "beyond what is mapped");
    glBufferData(GL_ARRAY_BUFFER, 4, bytes.data(), GL_STATIC_DRAW); // unmaps the buffer
    EXPECT_EQ(parameter(GL_BUFFER_MAPPED), 0);
    glFlushMappedBufferRange(GL_ARRAY_BUFFER, 0, 1);
    refused(operation, "not mapped");
    const struct {
        GLbitfield access;
        GLenum code;
    } wrong[] = {{0, operation},
                 {GL_MAP_UNSYNCHRONIZED_BIT, operation},
                 {GL_MAP_READ_BIT | GL_MAP_INVALIDATE_RANGE_BIT, operation},
                 {GL_MAP_READ_BIT | GL_MAP_INVALIDATE_BUFFER_BIT, operation},
                 {GL_MAP_READ_BIT | GL_MAP_UNSYNCHRONIZED_BIT, operation},
                 {GL_MAP_READ_BIT | GL_MAP_FLUSH_EXPLICIT_BIT, operation},
                 {GL_MAP_READ_BIT | 0x40, value}};
    for (const auto& w : wrong) {
        EXPECT_EQ(glMapBufferRange(GL_ARRAY_BUFFER, 0, 4, w.access), nullptr);
        refused(w.code, "access");
    }
    EXPECT_EQ(glMapBuffer(GL_ARRAY_BUFFER, GL_READ_WRITE + 1), nullptr);
    refused(token, "access");
}

/// A range that shares a byte with a mapping is refused. A range that only touches a mapping, or is empty, is
/// not (GL 3.0, 2.9.3).
TEST_F(Buffers, RangesBesideAMappingAreNotMapped) {
    constexpr GLintptr size = 8;
    std::array<GLubyte, size> bytes = {1, 2, 3, 4, 5, 6, 7, 8};
    glBindBuffer(GL_ARRAY_BUFFER, 1);
    glBufferData(GL_ARRAY_BUFFER, size, bytes.data(), GL_STATIC_DRAW);
    for (GLintptr begin = 0; begin <= size; ++begin)
        for (GLintptr end = begin; end <= size; ++end) {
            ASSERT_NE(
                glMapBufferRange(GL_ARRAY_BUFFER, begin, end - begin, GL_MAP_READ_BIT | GL_MAP_WRITE_BIT),
                nullptr);
            for (GLintptr from = 0; from <= size; ++from)
                for (GLintptr to = from; to <= size; ++to) {
                    const bool common = std::max(begin, from) < std::min(end, to);
                    const GLenum wanted = common ? operation : GLenum{GL_NO_ERROR};
                    glBufferSubData(GL_ARRAY_BUFFER, from, to - from, bytes.data() + from);
                    EXPECT_EQ(glGetError(), wanted) << begin << ' ' << end << ", " << from << ' ' << to;
                    glGetBufferSubData(GL_ARRAY_BUFFER, from, to - from, bytes.data() + from);
                    EXPECT_EQ(glGetError(), wanted) << begin << ' ' << end << ", " << from << ' ' << to;
                }
            EXPECT_TRUE(glUnmapBuffer(GL_ARRAY_BUFFER));
        }
    // This succeeds, because the buffer is no longer mapped.
    glBufferSubData(GL_ARRAY_BUFFER, 0, size, bytes.data());
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

/// An offset into a deleted buffer is not an address, so the array has none afterwards. Other arrays keep
/// their addresses.
TEST_F(Buffers, ADeletedBufferLeavesNoAddresses) {
    const GLfloat mesh[3][2] = {{-0.5f, -0.5f}, {0.5f, -0.5f}, {0, 0.5f}};
    const GLubyte own[9] = {};
    struct Array {
        GLenum pointer, binding;
    };
    const Array arrays[] = {{GL_VERTEX_ARRAY_POINTER, GL_VERTEX_ARRAY_BUFFER_BINDING},
                            {GL_NORMAL_ARRAY_POINTER, GL_NORMAL_ARRAY_BUFFER_BINDING},
                            {GL_COLOR_ARRAY_POINTER, GL_COLOR_ARRAY_BUFFER_BINDING},
                            {GL_INDEX_ARRAY_POINTER, GL_INDEX_ARRAY_BUFFER_BINDING},
                            {GL_TEXTURE_COORD_ARRAY_POINTER, GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING},
                            {GL_EDGE_FLAG_ARRAY_POINTER, GL_EDGE_FLAG_ARRAY_BUFFER_BINDING}};
    const auto set = [](std::size_t i, const void* pointer) {
        switch (i) {
        case 0:
            return glVertexPointer(2, GL_FLOAT, 0, pointer);
        case 1:
            return glNormalPointer(GL_BYTE, 0, pointer);
        case 2:
            return glColorPointer(3, GL_UNSIGNED_BYTE, 0, pointer);
        case 3:
            return glIndexPointer(GL_UNSIGNED_BYTE, 0, pointer);
        case 4:
            return glTexCoordPointer(2, GL_FLOAT, 0, pointer);
        default:
            return glEdgeFlagPointer(0, pointer);
        }
    };
    const GLuint gone = 1, kept = 2;
    for (std::size_t i = 0; i < std::size(arrays); ++i) {
        for (const GLuint name : {gone, kept}) {
            glBindBuffer(GL_ARRAY_BUFFER, name);
            glBufferData(GL_ARRAY_BUFFER, sizeof mesh, mesh, GL_STATIC_DRAW);
        }
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        for (std::size_t j = 0; j < std::size(arrays); ++j)
            set(j, own);
        glBindBuffer(GL_ARRAY_BUFFER, kept);
        set((i + 1) % std::size(arrays), at(4));
        glBindBuffer(GL_ARRAY_BUFFER, gone);
        set(i, at(8));
        glDeleteBuffers(1, &gone);
        for (std::size_t j = 0; j < std::size(arrays); ++j) {
            void* pointer = &pointer;
            glGetPointerv(arrays[j].pointer, &pointer);
            const bool in_kept = j == (i + 1) % std::size(arrays);
            EXPECT_EQ(pointer, j == i ? nullptr : in_kept ? at(4) : own) << i << ' ' << j;
            GLint binding = -1;
            glGetIntegerv(arrays[j].binding, &binding);
            EXPECT_EQ(binding, in_kept ? static_cast<GLint>(kept) : 0) << i << ' ' << j;
        }
        glDeleteBuffers(1, &kept);
    }
    glBindBuffer(GL_ARRAY_BUFFER, gone);
    glBufferData(GL_ARRAY_BUFFER, sizeof mesh, mesh, GL_STATIC_DRAW);
    glVertexPointer(2, GL_FLOAT, 0, at(0));
    glEnableClientState(GL_VERTEX_ARRAY);
    const auto draw = [] { glDrawArrays(GL_TRIANGLES, 0, 3); };
    EXPECT_EQ(drawn(draw).size(), 9u);
    glDeleteBuffers(1, &gone);
    EXPECT_TRUE(drawn(draw).empty()) << "no array, no vertices";
}

/// A mesh in flash is drawn from where it is.
TEST_F(Buffers, ConstantMemoryIsNotCopied) {
    static const GLfloat mesh[3][2] = {{-0.5f, -0.5f}, {0.5f, -0.5f}, {0, 0.5f}};
    glBindBuffer(GL_ARRAY_BUFFER, 1);
    glBufferConstantDataSPANGLE(GL_ARRAY_BUFFER, sizeof mesh, mesh);
    EXPECT_EQ(parameter(GL_BUFFER_SIZE), static_cast<GLint>(sizeof mesh));
    EXPECT_EQ(glMapBuffer(GL_ARRAY_BUFFER, GL_READ_ONLY), mesh);
    glUnmapBuffer(GL_ARRAY_BUFFER);
    for (const GLenum access : {GL_WRITE_ONLY, GL_READ_WRITE}) {
        EXPECT_EQ(glMapBuffer(GL_ARRAY_BUFFER, access), nullptr);
        refused(operation, "constant");
    }
    EXPECT_EQ(glMapBufferRange(GL_ARRAY_BUFFER, 0, 4, GL_MAP_WRITE_BIT), nullptr);
    refused(operation, "constant");
    glBufferSubData(GL_ARRAY_BUFFER, 0, 4, mesh);
    refused(operation, "constant");
    glBufferConstantDataSPANGLE(GL_ARRAY_BUFFER, 4, nullptr);
    refused(value, "null");
    glVertexPointer(2, GL_FLOAT, 0, at(0));
    glEnableClientState(GL_VERTEX_ARRAY);
    EXPECT_EQ(drawn([] { glDrawArrays(GL_TRIANGLES, 0, 3); }).size(), 9u);
    // From now on the buffer has its own memory.
    glBufferData(GL_ARRAY_BUFFER, sizeof mesh, mesh, GL_STATIC_DRAW);
    EXPECT_NE(glMapBuffer(GL_ARRAY_BUFFER, GL_READ_ONLY), mesh);
}

/// A draw of no elements reads no buffer. The fuzzer found this: an array had an offset into a buffer without
/// a store (UBSan sees the address).
TEST_F(Buffers, DrawsOfNoElementsAskNothingOfTheirBuffers) {
    glBindBuffer(GL_ARRAY_BUFFER, 5);
    glVertexPointer(3, GL_FLOAT, 0, at(16));
    glEnableClientState(GL_VERTEX_ARRAY);
    EXPECT_TRUE(drawn([] {
                    const GLubyte none = 0;
                    glDrawElements(GL_TRIANGLES, 0, GL_UNSIGNED_BYTE, &none);
                    glDrawArrays(GL_TRIANGLES, 0, 0);
                }).empty());
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    glDrawArrays(GL_TRIANGLES, 0, 3);
    refused(operation, "elements beyond the store");
}

/// No address is made of the offset of an array or index unless the offset lies in its buffer.
TEST_F(Buffers, OffsetsBeyondTheirBuffersAreNoAddresses) {
    glBindBuffer(GL_ARRAY_BUFFER, 1);
    glBufferData(GL_ARRAY_BUFFER, 64, nullptr, GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 1);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnable(GL_PRIMITIVE_RESTART);
    glPrimitiveRestartIndex(0); // the buffer holds no other index
    for (const std::size_t offset : {std::size_t{64}, std::size_t{65}, SIZE_MAX / 2, SIZE_MAX / 2 + 1,
                                     SIZE_MAX - 63, SIZE_MAX - 7, SIZE_MAX}) {
        glVertexPointer(4, GL_FLOAT, 0, at(offset));
        glDrawArrays(GL_TRIANGLES, 0, 0);
        glDrawArrays(GL_TRIANGLES, INT_MAX, 0);
        glDrawElements(GL_TRIANGLES, 0, GL_UNSIGNED_INT, at(offset));
        glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, at(0)); // all indices are restarts
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << offset;
        if (offset > 64) {
            const gl::AddressedArrays addressed(*gl::current_context());
            EXPECT_EQ(gl::current_context()->arrays.vertex.pointer, nullptr) << offset;
        }
        glDrawArrays(GL_TRIANGLES, 0, 3);
        refused(operation, "elements beyond");
        glDrawArrays(GL_TRIANGLES, INT_MAX, 3);
        refused(operation, "elements far beyond");
        glArrayElement(0);
        refused(operation, "an element beyond");
        glArrayElement(INT_MAX);
        refused(operation, "an element far beyond");
        glVertexPointer(4, GL_FLOAT, INT_MAX, at(0));
        glDrawArrays(GL_TRIANGLES, INT_MAX, 1);
        refused(operation, "a stride that goes far beyond");
        glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, at(offset));
        refused(operation, "indices beyond");
        glInterleavedArrays(GL_T4F_C4F_N3F_V4F, 0, at(offset));
        glDrawArrays(GL_TRIANGLES, 0, 0);
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << offset;
        glDrawArrays(GL_TRIANGLES, 1, 1);
        refused(operation, "interleaved arrays beyond");
        for (const GLenum array : {GL_TEXTURE_COORD_ARRAY, GL_COLOR_ARRAY, GL_NORMAL_ARRAY})
            glDisableClientState(array);
    }
    glDisable(GL_PRIMITIVE_RESTART);
}

/// Offsets take the place of pointers, mixed with client memory. Immediate mode, lists and arrays agree.
TEST_F(Buffers, ArraysAndIndices) {
    struct Corner {
        GLubyte color[4];
        GLfloat at[2];
    };
    std::vector<Corner> mesh;
    for (int i = 0; i < 9; ++i)
        mesh.push_back(
            {{static_cast<GLubyte>(20 * i), 0, 0, 255},
             {static_cast<GLfloat>(i % 3) * 0.5f - 0.5f, static_cast<GLfloat>(i / 3) * 0.5f - 0.5f}});
    const GLushort index[8] = {0, 1, 4, 3, 4, 5, 8, 7};
    std::vector<GLubyte> padded(3, 0);
    padded.insert(padded.end(), reinterpret_cast<const GLubyte*>(index),
                  reinterpret_cast<const GLubyte*>(index + 8));
    const auto expected = drawn([&] {
        glBegin(GL_QUADS);
        for (const GLushort i : index) {
            glColor4ubv(mesh[i].color);
            glVertex2fv(mesh[i].at);
        }
        glEnd();
    });
    ASSERT_EQ(expected.size(), 4u * 9);
    glBindBuffer(GL_ARRAY_BUFFER, 1);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(9 * sizeof(Corner)), mesh.data(), GL_STATIC_DRAW);
    glVertexPointer(2, GL_FLOAT, sizeof(Corner), at(offsetof(Corner, at)));
    glInterleavedArrays(GL_C4UB_V2F, 0, at(0));
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 2);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(padded.size()), padded.data(),
                 GL_STATIC_DRAW);
    const auto draw = [] { glDrawElements(GL_QUADS, 8, GL_UNSIGNED_SHORT, at(3)); };
    EXPECT_EQ(drawn(draw), expected);
    glNewList(5, GL_COMPILE);
    draw();
    glEndList();
    EXPECT_EQ(drawn([] { glCallList(5); }), expected);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    std::array<GLubyte, 4> colors[9];
    for (std::size_t i = 0; i < 9; ++i)
        std::copy_n(mesh[i].color, 4, colors[i].begin());
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, colors); // takes colours from client memory again
    EXPECT_EQ(drawn(draw), expected);
    void* offset = nullptr;
    glGetPointerv(GL_VERTEX_ARRAY_POINTER, &offset);
    EXPECT_EQ(offset, at(4)) << "offsets stay offsets";
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    EXPECT_EQ(drawn([&] { glDrawElements(GL_QUADS, 8, GL_UNSIGNED_SHORT, index); }), expected);
    EXPECT_EQ(drawn([&] {
                  glBegin(GL_QUADS);
                  for (const GLushort i : index)
                      glArrayElement(i);
                  glEnd();
              }),
              expected);
}

/// The size of a buffer is known, and nothing beyond it is ever read.
TEST_F(Buffers, NothingBeyondABufferIsRead) {
    glBindBuffer(GL_ARRAY_BUFFER, 1);
    glBufferData(GL_ARRAY_BUFFER, 4 * 8, nullptr, GL_STATIC_DRAW); // the buffer holds four vertices
    glVertexPointer(2, GL_FLOAT, 0, at(0));
    glEnableClientState(GL_VERTEX_ARRAY);
    const GLubyte index[3] = {0, 3, 4};
    const auto is = [](GLenum code, std::size_t points, auto draw) {
        WindowRecorder recorder;
        draw();
        EXPECT_EQ(glGetError(), code);
        EXPECT_EQ(recorder.primitives.size(), points);
    };
    const GLenum none = GL_NO_ERROR;
    is(none, 4, [] { glDrawArrays(GL_POINTS, 0, 4); });
    is(operation, 0, [] { glDrawArrays(GL_POINTS, 0, 5); });
    is(operation, 0, [] { glDrawArrays(GL_POINTS, 4, 1); });
    is(none, 0, [] { glDrawArrays(GL_POINTS, 4, 0); });
    is(operation, 0, [] { glDrawArrays(GL_POINTS, INT32_MAX, INT32_MAX); });
    is(none, 2, [&] { glDrawElements(GL_POINTS, 2, GL_UNSIGNED_BYTE, index); });
    is(operation, 0, [&] { glDrawElements(GL_POINTS, 3, GL_UNSIGNED_BYTE, index); });
    is(operation, 0, [] { glArrayElement(4); });
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 2);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, 3, index, GL_STATIC_DRAW);
    is(none, 1, [] { glDrawElements(GL_POINTS, 1, GL_UNSIGNED_BYTE, at(1)); });
    is(operation, 0, [] { glDrawElements(GL_POINTS, 1, GL_UNSIGNED_BYTE, at(3)); });
    is(operation, 0, [] { glDrawElements(GL_POINTS, 2, GL_UNSIGNED_SHORT, at(0)); });
    is(operation, 0, [] { glDrawElements(GL_POINTS, 1, GL_UNSIGNED_BYTE, at(SIZE_MAX)); });
    glNewList(1, GL_COMPILE);
    glDrawArrays(GL_POINTS, 0, 5);
    glEndList();
    is(operation, 0, [] { glCallList(1); });
    glMapBuffer(GL_ARRAY_BUFFER, GL_READ_ONLY);
    is(operation, 0, [] { glDrawArrays(GL_POINTS, 0, 1); });
    glUnmapBuffer(GL_ARRAY_BUFFER);
    glVertexPointer(2, GL_FLOAT, 0, at(8));
    is(operation, 0, [] { glDrawArrays(GL_POINTS, 0, 4); });
    glVertexPointer(2, GL_FLOAT, 12, at(0));
    is(none, 3, [] { glDrawArrays(GL_POINTS, 0, 3); });
    is(operation, 0, [] { glDrawArrays(GL_POINTS, 0, 4); });
}

TEST_F(Buffers, MultiDraw) {
    std::vector<GLfloat> position;
    for (int i = 0; i < 24; ++i)
        position.push_back(static_cast<GLfloat>(i % 7) * 0.2f - 0.6f);
    glVertexPointer(2, GL_FLOAT, 0, position.data());
    glEnableClientState(GL_VERTEX_ARRAY);
    const GLint first[4] = {0, 5, 2, 8};
    const GLsizei count[4] = {4, 0, -3, 3};
    const GLubyte a[4] = {0, 3, 5, 7}, b[3] = {1, 2, 9};
    const void* indices[4] = {a, a, nullptr, b};
    const auto arrays = drawn([] {
        glDrawArrays(GL_LINE_STRIP, 0, 4);
        glDrawArrays(GL_LINE_STRIP, 8, 3);
    });
    const auto elements = drawn([&] {
        glDrawElements(GL_LINE_STRIP, 4, GL_UNSIGNED_BYTE, a);
        glDrawElements(GL_LINE_STRIP, 3, GL_UNSIGNED_BYTE, b);
    });
    EXPECT_EQ(arrays.size(), 5u * 2 * 3);
    EXPECT_EQ(drawn([&] { glMultiDrawArrays(GL_LINE_STRIP, first, count, 4); }), arrays);
    EXPECT_EQ(drawn([&] { glMultiDrawElements(GL_LINE_STRIP, count, GL_UNSIGNED_BYTE, indices, 4); }),
              elements);
    glNewList(1, GL_COMPILE);
    glMultiDrawArrays(GL_LINE_STRIP, first, count, 4);
    glMultiDrawElements(GL_LINE_STRIP, count, GL_UNSIGNED_BYTE, indices, 4);
    glEndList();
    const auto list = drawn([] { glCallList(1); });
    EXPECT_EQ(list.size(), arrays.size() + elements.size());
    glMultiDrawArrays(GL_LINE_STRIP, first, count, -1);
    refused(value, "primcount");
    glMultiDrawArrays(GL_POLYGON + 1, first, count, 1);
    refused(token, "mode");
    glMultiDrawElements(GL_POINTS, count, GL_INT, indices, 1);
    refused(token, "type");
}

} // namespace
} // namespace spangle::test
