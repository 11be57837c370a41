// How a fragment's colour is combined with the stored one: blending and logical operations (GL 1.3, 4.1.7,
// 4.1.9; factors and equations: GL 1.4; separate functions: GL 1.4, equations: GL 2.0).
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/tokens.hpp"

namespace spangle::gl::cmd {

void BlendFuncSeparate(Context& context, GLenum src_rgb, GLenum dst_rgb, GLenum src_alpha, GLenum dst_alpha) {
    if (!is_source_factor(src_rgb) || !is_source_factor(src_alpha) || !is_blend_factor(dst_rgb) ||
        !is_blend_factor(dst_alpha))
        return error(context, GL_INVALID_ENUM);
    FragmentOpsState& ops = context.fragment_ops;
    ops.blend_rgb.src = src_rgb;
    ops.blend_rgb.dst = dst_rgb;
    ops.blend_alpha.src = src_alpha;
    ops.blend_alpha.dst = dst_alpha;
    context.changed(dirty_fragment);
}

void BlendFunc(Context& context, GLenum sfactor, GLenum dfactor) {
    BlendFuncSeparate(context, sfactor, dfactor, sfactor, dfactor);
}

void BlendEquationSeparate(Context& context, GLenum rgb, GLenum alpha) {
    if (!is_in(blend_equations, rgb) || !is_in(blend_equations, alpha))
        return error(context, GL_INVALID_ENUM);
    context.fragment_ops.blend_rgb.equation = rgb;
    context.fragment_ops.blend_alpha.equation = alpha;
    context.changed(dirty_fragment);
}

void BlendEquation(Context& context, GLenum mode) {
    BlendEquationSeparate(context, mode, mode);
}

void BlendColor(Context& context, Real red, Real green, Real blue, Real alpha) {
    const Real given[4] = {red, green, blue, alpha};
    for (int c = 0; c < 4; ++c)
        context.fragment_ops.blend_color[c] = numeric::clamp01(given[c]);
    context.changed(dirty_fragment);
}

void LogicOp(Context& context, GLenum opcode) {
    if (!is_logic_op(opcode))
        return error(context, GL_INVALID_ENUM);
    context.fragment_ops.logic_op = opcode;
    context.changed(dirty_fragment);
}

} // namespace spangle::gl::cmd
