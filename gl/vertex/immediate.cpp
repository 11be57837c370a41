// Begin, End, Vertex, current attributes, and commands that draw arrays (GL 1.3, 2.6 to 2.9).
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/share_group.hpp"
#include "gl/vertex/array_source.hpp"
#include "gl/vertex/begin_batch.hpp"
#include "gl/vertex/current_element.hpp"

namespace spangle::gl {

namespace {

void set_gate(Context& context, bool inside) {
    context.gate = static_cast<std::uint8_t>(inside ? context.gate | gate_inside
                                                    : context.gate & ~(gate_inside | gate_left_out));
}

void color(Context& context, const Real (&rgba)[4]) {
    for (int c = 0; c < 4; ++c)
        context.current.color[c] = rgba[c];
    follow_color(context);
}

void set_tex_coord(Context& context, std::uint32_t unit, Real s, Real t, Real r, Real q) {
    Real(&v)[4] = context.current.tex_coord[unit].v;
    v[0] = s;
    v[1] = t;
    v[2] = r;
    v[3] = q;
}

/// Performs ArrayElement: sets the attributes of enabled arrays, then gives the vertex (GL 1.3, 2.8).
void element(Context& context, std::uint32_t index) {
    if (context.inside_begin_end() && is_restart_index(context.array_bindings, index))
        return restart_primitive(context);
    if (!arrays_reach(context, index))
        return error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("an array element beyond its buffer"));
    const AddressedArrays addressed(context);
    const ElementReader reader(context.arrays);
    set_attributes(context, reader, index);
    if (!reader.vertex.on() || !context.inside_begin_end())
        return;
    Real v[4] = {numeric::zero, numeric::zero, numeric::zero, numeric::one};
    reader.vertex.read(index, v);
    context.engine->vertex(context, v[0], v[1], v[2], v[3]);
}

/// True if this build draws primitives of the mode. Otherwise the error is set.
bool takes(Context& context, GLenum mode) {
    const bool known = mode <= GL_POLYGON;
    if (known && (mode == GL_POINTS       ? has_points
                  : mode <= GL_LINE_STRIP ? has_lines
                                          : mode < GL_QUADS || has_polygons))
        return true;
    error(context, known ? GL_INVALID_OPERATION : GL_INVALID_ENUM,
          known ? SPANGLE_TEXT("this build draws no such primitives (SPANGLE_PRIMITIVES)") : nullptr);
    return false;
}

/// Draws `count` elements as one primitive, or as several primitives that restart indices separate.
void draw(Context& context, GLenum mode, GLsizei count, const Indices& indices) {
    const CurrentStateGuard kept(context);
    const AddressedArrays addressed(context);
    for_each_run(context.array_bindings, static_cast<std::uint32_t>(count), indices,
                 [&](std::uint32_t n, const Indices& run) {
                     cmd::Begin(context, mode);
                     context.engine->elements(context, n, run);
                     cmd::End(context);
                 });
}

} // namespace

namespace cmd {

void Begin(Context& context, GLenum mode) {
    if (!takes(context, mode))
        return;
    // Until End, no other thread may change textures that this primitive uses.
    context.share->lock.take();
    set_gate(context, true);
    context.primitive = mode;
    begin_batch(context);
}

void End(Context& context) {
    if (!context.inside_begin_end())
        return error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("no glBegin came before"));
    context.engine->end(context);
    set_gate(context, false);
    context.share->lock.give();
}

void Vertex(Context& context, Real x, Real y, Real z, Real w) {
    // Outside of Begin/End, a vertex has no effect and is no error (GL 1.3, 2.6.3).
    if (context.inside_begin_end())
        context.engine->vertex(context, x, y, z, w);
}

void TexCoord(Context& context, Real s, Real t, Real r, Real q) {
    set_tex_coord(context, 0, s, t, r, q);
}

void MultiTexCoord(Context& context, GLenum target, Real s, Real t, Real r, Real q) {
    if (unit_of(target) >= texture_units)
        return error(context, GL_INVALID_ENUM,
                     SPANGLE_TEXT("target is beyond the units of this build (SPANGLE_TEXTURE_UNITS)"));
    set_tex_coord(context, unit_of(target), s, t, r, q);
}

void Normal(Context& context, Real x, Real y, Real z) {
    context.current.normal[0] = x;
    context.current.normal[1] = y;
    context.current.normal[2] = z;
}

void Color(Context& context, Real red, Real green, Real blue, Real alpha) {
    color(context, {red, green, blue, alpha});
}

#if SPANGLE_FEATURE_SECONDARY_COLOR
void SecondaryColor(Context& context, Real red, Real green, Real blue) {
    Real(&color)[4] = context.current.secondary_color;
    color[0] = red;
    color[1] = green;
    color[2] = blue;
}
#endif

#if SPANGLE_FEATURE_COLOR_INDEX
void Index(Context& context, Real index) {
    context.current.index = index;
}
#endif

#if SPANGLE_FEATURE_FOG
void FogCoord(Context& context, Real coord) {
    context.current.fog_coord = coord;
}
#endif

#if SPANGLE_FEATURE_POLYGON_MODE
void EdgeFlag(Context& context, bool flag) {
    context.current.edge_flag = flag;
}
#endif

void Rect(Context& context, Real x1, Real y1, Real x2, Real y2) {
    Begin(context, GL_POLYGON);
    const Real corner[4][2] = {{x1, y1}, {x2, y1}, {x2, y2}, {x1, y2}};
    for (const Real(&c)[2] : corner)
        context.engine->vertex(context, c[0], c[1], numeric::zero, numeric::one);
    End(context);
}

void ArrayElement(Context& context, GLint i) {
    if (i < 0)
        return error(context, GL_INVALID_VALUE);
    element(context, static_cast<std::uint32_t>(i));
}

void DrawArrays(Context& context, GLenum mode, GLint first, GLsizei count) {
    if (!takes(context, mode))
        return;
    if (first < 0 || count < 0)
        return error(context, GL_INVALID_VALUE, SPANGLE_TEXT("first or count is negative"));
    Indices found{.first = static_cast<std::uint32_t>(first)};
    if (!find_indices(context, static_cast<std::uint32_t>(count), found))
        return error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("an element beyond its buffer"));
    draw(context, mode, count, found);
}

void DrawElements(Context& context, GLenum mode, GLsizei count, GLenum type, const void* indices) {
    if (!takes(context, mode))
        return;
    if (count < 0)
        return error(context, GL_INVALID_VALUE);
    if (type != GL_UNSIGNED_BYTE && type != GL_UNSIGNED_SHORT && type != GL_UNSIGNED_INT)
        return error(context, GL_INVALID_ENUM);
    if (indices == nullptr && count > 0 && context.arrays.element_buffer == nullptr)
        return error(context, GL_INVALID_VALUE);
    Indices found{.type = type, .data = indices};
    if (!find_indices(context, static_cast<std::uint32_t>(count), found))
        return error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("an index or an element beyond its buffer"));
    draw(context, mode, count, found);
}

void DrawRangeElements(Context& context, GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type,
                       const void* indices) {
    if (!takes(context, mode))
        return;
    if (end < start)
        return error(context, GL_INVALID_VALUE, SPANGLE_TEXT("end is less than start"));
    // This implementation does not need the promise that indices are within the range.
    DrawElements(context, mode, count, type, indices);
}

/// Draws several arrays one after the other, and skips those without vertices (GL 1.4, 2.8).
void MultiDrawArrays(Context& context, GLenum mode, const GLint* first, const GLsizei* count,
                     GLsizei primcount) {
    if (!takes(context, mode))
        return;
    if (primcount < 0 || (primcount > 0 && (first == nullptr || count == nullptr)))
        return error(context, GL_INVALID_VALUE);
    for (GLsizei i = 0; i < primcount; ++i)
        if (count[i] > 0)
            DrawArrays(context, mode, first[i], count[i]);
}

void MultiDrawElements(Context& context, GLenum mode, const GLsizei* count, GLenum type, const void** indices,
                       GLsizei primcount) {
    if (!takes(context, mode))
        return;
    if (type != GL_UNSIGNED_BYTE && type != GL_UNSIGNED_SHORT && type != GL_UNSIGNED_INT)
        return error(context, GL_INVALID_ENUM);
    if (primcount < 0 || (primcount > 0 && (count == nullptr || indices == nullptr)))
        return error(context, GL_INVALID_VALUE);
    for (GLsizei i = 0; i < primcount; ++i)
        if (count[i] > 0)
            DrawElements(context, mode, count[i], type, indices[i]);
}

} // namespace cmd

} // namespace spangle::gl
