// Per-fragment state: scissor, alpha and depth test, masks, clear values, buffer selection
// (GL 1.3, 4.1, 4.2).
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/tokens.hpp"
#include "gl/pixel/draw_buffer.hpp"

namespace spangle::gl::cmd {

namespace {

/// The colour buffers that a token names, as bits.
enum : unsigned { front_buffer = 1, back_buffer = 2, missing_buffer = 4, unknown_buffer = 8 };

unsigned buffers_of(GLenum mode) {
    switch (mode) {
    case GL_NONE:
        return 0;
    case GL_FRONT:
    case GL_FRONT_LEFT:
        return front_buffer;
    case GL_BACK:
    case GL_BACK_LEFT:
        return back_buffer;
    case GL_LEFT:
    case GL_FRONT_AND_BACK:
        return front_buffer | back_buffer;
    case GL_FRONT_RIGHT:
    case GL_BACK_RIGHT:
    case GL_RIGHT:
    case GL_AUX0:
        return missing_buffer;
    default:
        return unknown_buffer;
    }
}

/// The names of a surface's only colour buffer: BACK for a window, FRONT for a window without a back buffer,
/// both for a pbuffer.
unsigned existing_buffer(bool double_buffered, bool front_buffered) {
    return (double_buffered ? back_buffer : 0u) | (front_buffered ? front_buffer : 0u);
}

/// Shows what was drawn to the front before drawing to the back begins, because both are one buffer.
void leave_front(const Context& context, unsigned next) {
    const Drawable& drawable = context.drawable;
    if (SPANGLE_HAS_PLATFORMS && drawable.double_buffered && drawable.show != nullptr &&
        (next & front_buffer) == 0 && draws_to_front(context))
        drawable.show(false);
}

} // namespace

void Scissor(Context& context, GLint x, GLint y, GLsizei width, GLsizei height) {
    if (width < 0 || height < 0)
        return error(context, GL_INVALID_VALUE);
    GLint* box = context.fragment_ops.scissor_box;
    box[0] = x;
    box[1] = y;
    box[2] = width;
    box[3] = height;
    context.changed(dirty_fragment);
}

void AlphaFunc(Context& context, GLenum func, Real ref) {
    if (!is_compare(func))
        return error(context, GL_INVALID_ENUM);
    context.fragment_ops.alpha_func = func;
    context.fragment_ops.alpha_ref = numeric::clamp01(ref);
    context.changed(dirty_fragment);
}

void SampleCoverage(Context& context, Real value, bool invert) {
    context.fragment_ops.sample_coverage_value = numeric::clamp01(value);
    context.fragment_ops.sample_coverage_invert = invert;
    context.changed(dirty_fragment);
}

void DepthFunc(Context& context, GLenum func) {
    if (!is_compare(func))
        return error(context, GL_INVALID_ENUM);
    context.fragment_ops.depth_func = func;
    context.changed(dirty_fragment);
}

void DepthMask(Context& context, bool flag) {
    context.fragment_ops.depth_mask = flag;
    context.changed(dirty_fragment);
}

void ColorMask(Context& context, bool red, bool green, bool blue, bool alpha) {
    bool* mask = context.fragment_ops.color_mask;
    mask[0] = red;
    mask[1] = green;
    mask[2] = blue;
    mask[3] = alpha;
    context.changed(dirty_fragment);
}

void ClearColor(Context& context, Real red, Real green, Real blue, Real alpha) {
    const Real given[4] = {red, green, blue, alpha};
    for (int c = 0; c < 4; ++c)
        context.fragment_ops.color_clear[c] = numeric::clamp01(given[c]);
}

void ClearIndex(Context& context, Real index) {
    context.fragment_ops.index_clear = index;
}

void IndexMask(Context& context, GLuint mask) {
    context.fragment_ops.index_mask = mask;
    context.changed(dirty_fragment);
}

void ClearDepth(Context& context, Real depth) {
    context.fragment_ops.depth_clear = numeric::clamp01(depth);
}

void ClearStencil(Context& context, GLint s) {
    context.fragment_ops.stencil_clear = s & 0xFF;
}

void DrawBuffer(Context& context, GLenum mode) {
    const unsigned asked = buffers_of(mode);
    if (asked == unknown_buffer)
        return error(context, GL_INVALID_ENUM);
    const Drawable& drawable = context.drawable;
    const unsigned exists = existing_buffer(drawable.double_buffered, drawable.front_buffered);
    if (mode != GL_NONE && (asked & exists) == 0)
        return error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("this surface has no such buffer"));
    leave_front(context, asked);
    context.fragment_ops.draw_buffer = mode;
    context.changed(dirty_fragment);
}

void ReadBuffer(Context& context, GLenum mode) {
    const unsigned asked = buffers_of(mode);
    if (asked == unknown_buffer || mode == GL_NONE || mode == GL_FRONT_AND_BACK)
        return error(context, GL_INVALID_ENUM);
    const Drawable& drawable = context.drawable;
    const unsigned exists = existing_buffer(drawable.read_double_buffered, drawable.read_front_buffered);
    if ((asked & exists) == 0)
        return error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("this surface has no such buffer"));
    context.fragment_ops.read_buffer = mode;
}

} // namespace spangle::gl::cmd

namespace spangle::gl {

bool draws_to_front(const Context& context) {
    return (cmd::buffers_of(context.fragment_ops.draw_buffer) & cmd::front_buffer) != 0;
}

} // namespace spangle::gl
