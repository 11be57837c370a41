// Vertex arrays in display lists. Their elements are read while the list is compiled (GL 1.3, 2.8 and 5.4).
// ArrayElement is stored as the equivalent commands, and shares the runs of immediate mode. Draws are stored
// as meshes.
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_LISTS

#include "gl/api/command.hpp"
#include "gl/api/generated/commands.hpp"
#include "gl/list/mesh.hpp"
#include "gl/vertex/array_source.hpp"
#include "gl/vertex/begin_batch.hpp"
#include "gl/vertex/current_element.hpp"

namespace spangle::gl {

namespace {

using list::Word;

/// The family whose name a draw has in messages. Without messages, all draws share one player.
template <class F> using Named = std::conditional_t<SPANGLE_MESSAGES != 0, F, family::DrawArrays>;

template <class F> const Word* play_draw(Context& context, const Word* words) {
    return list::play_mesh(context, words, F::text);
}

void capture_seldom([[maybe_unused]] Context& context, const ArraysState& arrays, GLuint index) {
    CurrentState now;
    set_seldom(now, arrays, index);
#if SPANGLE_FEATURE_COLOR_INDEX
    if (arrays.index.on())
        list::record_words<family::Index>(context, now.index);
#endif
#if SPANGLE_FEATURE_FOG
    if (arrays.fog_coord.on())
        list::record_words<family::FogCoord>(context, now.fog_coord);
#endif
#if SPANGLE_FEATURE_SECONDARY_COLOR
    if (arrays.secondary_color.on())
        list::record_words<family::SecondaryColor>(context, now.secondary_color[0], now.secondary_color[1],
                                                   now.secondary_color[2]);
#endif
#if SPANGLE_FEATURE_POLYGON_MODE
    if (arrays.edge_flag.on())
        list::record_words<family::EdgeFlag>(context, now.edge_flag);
#endif
}

void capture(Context& context, const ElementReader& reader, GLuint index) {
    if (reader.seldom != nullptr)
        capture_seldom(context, *reader.seldom, index);
    Real v[4];
    const auto has = [&v, index](const ArrayReader& array) {
        if (!array.on())
            return false;
        v[0] = v[1] = v[2] = numeric::zero;
        v[3] = numeric::one;
        array.read(index, v);
        return true;
    };
    if (has(reader.normal))
        encode::Normal(context, v[0], v[1], v[2]);
    if (has(reader.color))
        encode::Color(context, v[0], v[1], v[2], v[3]);
    if (has(reader.tex_coord[0]))
        encode::TexCoord(context, v[0], v[1], v[2], v[3]);
    for (GLuint u = 1; u < texture_units; ++u)
        if (has(reader.tex_coord[u]))
            list::record_words<family::MultiTexCoord>(context, GL_TEXTURE0 + u, v[0], v[1], v[2], v[3]);
    if (has(reader.vertex))
        encode::Vertex(context, v[0], v[1], v[2], v[3]);
}

template <class F> void capture_draw(Context& context, GLenum mode, GLsizei count, const Indices& indices) {
    const AddressedArrays addressed(context);
    using Name = Named<F>;
    for_each_run(context.array_bindings, static_cast<GLuint>(count), indices,
                 [&](GLuint n, const Indices& run) {
                     list::record_mesh(context, &list::player<&play_draw<Name>, Name>, mode, n, run);
                 });
}

[[maybe_unused]] const Word* play_restart(Context& context, const Word* words) {
    if (context.inside_begin_end())
        restart_primitive(context);
    return words;
}

bool is_index_type(GLenum type) {
    return type == GL_UNSIGNED_BYTE || type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_INT;
}

} // namespace

namespace encode {

void ArrayElement(Context& context, GLint i) {
    if (i < 0)
        return list::record_error(context, GL_INVALID_VALUE, true);
    if (is_restart_index(context.array_bindings, static_cast<GLuint>(i)))
        return static_cast<void>(list::record(context, &list::player<&play_restart>, 0));
    if (!arrays_reach(context, static_cast<GLuint>(i)))
        return list::record_error(context, GL_INVALID_OPERATION, true,
                                  SPANGLE_TEXT("an element beyond its buffer"));
    const AddressedArrays addressed(context);
    capture(context, ElementReader(context.arrays), static_cast<GLuint>(i));
}

void DrawArrays(Context& context, GLenum mode, GLint first, GLsizei count) {
    if (mode > GL_POLYGON)
        return list::record_error(context, GL_INVALID_ENUM, false);
    if (first < 0 || count < 0)
        return list::record_error(context, GL_INVALID_VALUE, false,
                                  SPANGLE_TEXT("first or count is negative"));
    Indices found{.first = static_cast<GLuint>(first)};
    if (!find_indices(context, static_cast<GLuint>(count), found))
        return list::record_error(context, GL_INVALID_OPERATION, false,
                                  SPANGLE_TEXT("an element beyond its buffer"));
    capture_draw<family::DrawArrays>(context, mode, count, found);
}

void DrawElements(Context& context, GLenum mode, GLsizei count, GLenum type, const void* indices) {
    if (mode > GL_POLYGON || !is_index_type(type))
        return list::record_error(context, GL_INVALID_ENUM, false);
    if (count < 0 || (indices == nullptr && count > 0 && context.arrays.element_buffer == nullptr))
        return list::record_error(context, GL_INVALID_VALUE, false);
    Indices found{.type = type, .data = indices};
    if (!find_indices(context, static_cast<GLuint>(count), found))
        return list::record_error(context, GL_INVALID_OPERATION, false,
                                  SPANGLE_TEXT("an index or an element beyond its buffer"));
    capture_draw<family::DrawElements>(context, mode, count, found);
}

void DrawRangeElements(Context& context, GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type,
                       const void* indices) {
    if (end < start)
        return list::record_error(context, GL_INVALID_VALUE, false, SPANGLE_TEXT("end is less than start"));
    DrawElements(context, mode, count, type, indices);
}

void MultiDrawArrays(Context& context, GLenum mode, const GLint* first, const GLsizei* count,
                     GLsizei primcount) {
    if (mode > GL_POLYGON)
        return list::record_error(context, GL_INVALID_ENUM, false);
    if (primcount < 0 || (primcount > 0 && (first == nullptr || count == nullptr)))
        return list::record_error(context, GL_INVALID_VALUE, false);
    for (GLsizei i = 0; i < primcount; ++i)
        if (count[i] > 0)
            DrawArrays(context, mode, first[i], count[i]);
}

void MultiDrawElements(Context& context, GLenum mode, const GLsizei* count, GLenum type, const void** indices,
                       GLsizei primcount) {
    if (mode > GL_POLYGON || !is_index_type(type))
        return list::record_error(context, GL_INVALID_ENUM, false);
    if (primcount < 0 || (primcount > 0 && (count == nullptr || indices == nullptr)))
        return list::record_error(context, GL_INVALID_VALUE, false);
    for (GLsizei i = 0; i < primcount; ++i)
        if (count[i] > 0)
            DrawElements(context, mode, count[i], type, indices[i]);
}

} // namespace encode

} // namespace spangle::gl

#endif
