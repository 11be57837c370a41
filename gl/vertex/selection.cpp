// SelectBuffer, the name stack and hit records (GL 1.3, 5.2).
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_SELECTION

#include <cstring>

#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/vertex/capture.hpp"
#include "gl/vertex/render_mode.hpp"

namespace spangle::gl {

namespace {

/// Appends one word to the client's buffer, which need not be aligned. If the buffer is full, sets
/// `overflow`.
void put(SelectState& s, GLuint word) {
    if (s.written == s.size) {
        s.overflow = true;
        return;
    }
    std::memcpy(static_cast<unsigned char*>(const_cast<void*>(s.buffer)) +
                    static_cast<std::size_t>(s.written) * sizeof word,
                &word, sizeof word);
    ++s.written;
}

/// Returns the state with the name stack, or null in render modes other than SELECT, in which names have no
/// effect.
SelectState* names(Context& context) {
    return context.render.mode == GL_SELECT ? &context.render.select : nullptr;
}

} // namespace

void record_hit(Context& context, std::uint32_t depth) {
    SelectState& s = context.render.select;
    s.hit = true;
    s.nearest = depth < s.nearest ? depth : s.nearest;
    s.farthest = depth > s.farthest ? depth : s.farthest;
}

void end_hit_record(SelectState& s) {
    if (!s.hit)
        return;
    put(s, static_cast<GLuint>(s.depth));
    put(s, s.nearest);
    put(s, s.farthest);
    for (GLint i = 0; i < s.depth; ++i)
        put(s, s.name[i]);
    ++s.hits;
    s.hit = false;
    s.nearest = 0xFFFFFFFF;
    s.farthest = 0;
}

namespace cmd {

void SelectBuffer(Context& context, GLsizei size, GLuint* buffer) {
    if (size < 0 || (buffer == nullptr && size > 0))
        return error(context, GL_INVALID_VALUE);
    if (context.render.mode == GL_SELECT)
        return error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("not while hits are recorded"));
    SelectState& s = context.render.select;
    s.buffer = buffer;
    s.size = size;
    s.given = true;
}

// Each command that changes the name stack ends the record of earlier hits (GL 1.3, 5.2).

void InitNames(Context& context) {
    SelectState* const s = names(context);
    if (s == nullptr)
        return;
    end_hit_record(*s);
    s->depth = 0;
}

void PushName(Context& context, GLuint name) {
    SelectState* const s = names(context);
    if (s == nullptr)
        return;
    if (s->depth == name_stack_entries)
        return error(context, GL_STACK_OVERFLOW, SPANGLE_TEXT("the stack is full (SPANGLE_NAME_STACK)"));
    end_hit_record(*s);
    s->name[s->depth++] = name;
}

void PopName(Context& context) {
    SelectState* const s = names(context);
    if (s == nullptr)
        return;
    if (s->depth == 0)
        return error(context, GL_STACK_UNDERFLOW);
    end_hit_record(*s);
    --s->depth;
}

void LoadName(Context& context, GLuint name) {
    SelectState* const s = names(context);
    if (s == nullptr)
        return;
    if (s->depth == 0)
        return error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("the name stack is empty"));
    end_hit_record(*s);
    s->name[s->depth - 1] = name;
}

} // namespace cmd

} // namespace spangle::gl

#endif
