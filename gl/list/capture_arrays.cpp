// Vertex arrays in display lists: the elements are read while the list is compiled and stored as what
// ArrayElement stands for, so that they share the runs of immediate mode (GL 1.3, 2.8 and 5.4).
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_LISTS

#include <cstring>

#include "gl/api/generated/commands.hpp"
#include "gl/list/record.hpp"
#include "gl/vertex/array_element.hpp"

namespace spangle::gl {

namespace {

using list::Word;

/// Begin of a captured draw. Between Begin and End the whole draw fails at execution: its vertices must not
/// reach the primitive that is open.
const Word* play_begin_draw(Context& context, const Word* words) {
    const Word* past;
    std::memcpy(&past, words + 1, sizeof past);
    if (!list::allowed_outside(context, SPANGLE_TEXT("a drawn array in a list between glBegin and glEnd")))
        return past;
    cmd::Begin(context, words[0]);
    return words + 1 + list::address_words;
}

const Word* play_end_draw(Context& context, const Word* words) {
    cmd::End(context);
    return words;
}

GLuint index_at(GLenum type, const void* indices, GLsizei i) {
    const auto at = static_cast<std::size_t>(i);
    if (type == GL_UNSIGNED_BYTE)
        return static_cast<const GLubyte*>(indices)[at];
    if (type == GL_UNSIGNED_SHORT) {
        GLushort value;
        std::memcpy(&value, static_cast<const unsigned char*>(indices) + at * sizeof value, sizeof value);
        return value;
    }
    GLuint value;
    std::memcpy(&value, static_cast<const unsigned char*>(indices) + at * sizeof value, sizeof value);
    return value;
}

void capture(Context& context, GLuint index) {
    const ElementValues e = fetch_element(context.arrays, index);
    if (e.has_normal)
        encode::Normal(context, e.normal[0], e.normal[1], e.normal[2]);
    if (e.has_color)
        encode::Color(context, e.color[0], e.color[1], e.color[2], e.color[3]);
    if (e.has_tex_coord)
        encode::TexCoord(context, e.tex_coord[0], e.tex_coord[1], e.tex_coord[2], e.tex_coord[3]);
    if (e.has_vertex)
        encode::Vertex(context, e.vertex[0], e.vertex[1], e.vertex[2], e.vertex[3]);
}

template <class Index> void capture_draw(Context& context, GLenum mode, GLsizei count, Index index) {
    Word* const begin = list::record(context, &play_begin_draw, 1 + list::address_words);
    for (GLsizei i = 0; i < count && !context.list.recorder.out_of_memory; ++i)
        capture(context, index(i));
    // The record of End is never the first of a chunk without a link to it, so its address is where a skip
    // goes on.
    Word* const end = list::record(context, &play_end_draw, 0);
    if (end == nullptr)
        return;
    begin[0] = mode;
    const Word* const past = end;
    std::memcpy(begin + 1, &past, sizeof past);
}

bool is_index_type(GLenum type) {
    return type == GL_UNSIGNED_BYTE || type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_INT;
}

} // namespace

namespace encode {

void ArrayElement(Context& context, GLint i) {
    if (i < 0)
        return list::record_error(context, GL_INVALID_VALUE, true);
    capture(context, static_cast<GLuint>(i));
}

void DrawArrays(Context& context, GLenum mode, GLint first, GLsizei count) {
    if (mode > GL_POLYGON)
        return list::record_error(context, GL_INVALID_ENUM, false);
    if (first < 0 || count < 0)
        return list::record_error(context, GL_INVALID_VALUE, false);
    capture_draw(context, mode, count,
                 [first](GLsizei i) { return static_cast<GLuint>(first) + static_cast<GLuint>(i); });
}

void DrawElements(Context& context, GLenum mode, GLsizei count, GLenum type, const void* indices) {
    if (mode > GL_POLYGON || !is_index_type(type))
        return list::record_error(context, GL_INVALID_ENUM, false);
    if (count < 0 || (indices == nullptr && count > 0))
        return list::record_error(context, GL_INVALID_VALUE, false);
    capture_draw(context, mode, count, [=](GLsizei i) { return index_at(type, indices, i); });
}

void DrawRangeElements(Context& context, GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type,
                       const void* indices) {
    if (end < start)
        return list::record_error(context, GL_INVALID_VALUE, false);
    DrawElements(context, mode, count, type, indices);
}

} // namespace encode

} // namespace spangle::gl

#endif
