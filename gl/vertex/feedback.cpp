// FeedbackBuffer, PassThrough and the values that feedback writes (GL 1.3, 5.3).
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_FEEDBACK

#include <cstring>

#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/vertex/capture.hpp"

namespace spangle::gl {

namespace {

/// Appends one value to the client's buffer, which need not be aligned. If the buffer is full, sets
/// `overflow`.
void write_feedback(FeedbackState& f, Real value) {
    if (f.written == f.size) {
        f.overflow = true;
        return;
    }
    const std::uint32_t word = f.fixed ? static_cast<std::uint32_t>(numeric::to_fixed16(value)) : value.bits;
    std::memcpy(static_cast<unsigned char*>(const_cast<void*>(f.buffer)) +
                    static_cast<std::size_t>(f.written) * sizeof word,
                &word, sizeof word);
    ++f.written;
}

void write_feedback(FeedbackState& f, const Real* values, int count) {
    for (int i = 0; i < count; ++i)
        write_feedback(f, values[i]);
}

bool is_feedback_type(GLenum type) {
    return type >= GL_2D && type <= GL_4D_COLOR_TEXTURE;
}

} // namespace

void feed_count(Context& context, GLint count) {
    write_feedback(context.render.feedback, numeric::from_i32(count));
}

void feed_token(Context& context, GLenum token) {
    feed_count(context, static_cast<GLint>(token));
}

void feed_vertex(Context& context, const FeedbackVertex& v) {
    FeedbackState& f = context.render.feedback;
    write_feedback(f, v.window, f.type == GL_2D ? 2 : f.type == GL_4D_COLOR_TEXTURE ? 4 : 3);
    if (f.type >= GL_3D_COLOR)
        write_feedback(f, v.color, v.colors);
    if (f.type >= GL_3D_COLOR_TEXTURE)
        write_feedback(f, v.texture, 4);
}

namespace cmd {

void FeedbackBuffer(Context& context, GLsizei size, GLenum type, const Values& buffer) {
    if (size < 0 || (buffer.at == nullptr && size > 0))
        return error(context, GL_INVALID_VALUE);
    if (!is_feedback_type(type))
        return error(context, GL_INVALID_ENUM);
    if (context.render.mode == GL_FEEDBACK)
        return error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("not while feedback is written"));
    FeedbackState& f = context.render.feedback;
    f = FeedbackState{};
    f.buffer = buffer.at;
    f.size = size;
    f.type = type;
    f.fixed = buffer.type == GL_FIXED;
    f.given = true;
}

void PassThrough(Context& context, Real token) {
    if (context.render.mode != GL_FEEDBACK)
        return;
    feed_token(context, GL_PASS_THROUGH_TOKEN);
    write_feedback(context.render.feedback, token);
}

} // namespace cmd

} // namespace spangle::gl

#endif
