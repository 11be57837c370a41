// The stencil test of front and back faces (GL 1.3, 4.1.5; two sides and wrapping: GL 2.0).
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/tokens.hpp"

namespace spangle::gl::cmd {

namespace {

bool is_face(GLenum face) {
    return face == GL_FRONT || face == GL_BACK || face == GL_FRONT_AND_BACK;
}

/// Calls change(side) for each side that `face` names. A build without two sides uses the front side for
/// both.
template <class Change> void change_sides(Context& context, GLenum face, Change change) {
    if (face != GL_BACK)
        change(context.fragment_ops.stencil[0]);
    if (SPANGLE_FEATURE_STENCIL_SIDES && face != GL_FRONT)
        change(context.fragment_ops.stencil[1]);
    context.changed(dirty_fragment);
}

} // namespace

void StencilFuncSeparate(Context& context, GLenum face, GLenum func, GLint ref, GLuint mask) {
    if (!is_face(face) || !is_compare(func))
        return error(context, GL_INVALID_ENUM);
    change_sides(context, face, [=](StencilSide& side) {
        side.func = func;
        side.ref = ref;
        side.value_mask = mask;
    });
}

void StencilOpSeparate(Context& context, GLenum face, GLenum fail, GLenum zfail, GLenum zpass) {
    if (!is_face(face) || !is_in(stencil_ops, fail) || !is_in(stencil_ops, zfail) ||
        !is_in(stencil_ops, zpass))
        return error(context, GL_INVALID_ENUM);
    change_sides(context, face, [=](StencilSide& side) {
        side.fail = fail;
        side.pass_depth_fail = zfail;
        side.pass_depth_pass = zpass;
    });
}

void StencilMaskSeparate(Context& context, GLenum face, GLuint mask) {
    if (!is_face(face))
        return error(context, GL_INVALID_ENUM);
    change_sides(context, face, [=](StencilSide& side) { side.write_mask = mask; });
}

void StencilFunc(Context& context, GLenum func, GLint ref, GLuint mask) {
    StencilFuncSeparate(context, GL_FRONT_AND_BACK, func, ref, mask);
}

void StencilOp(Context& context, GLenum fail, GLenum zfail, GLenum zpass) {
    StencilOpSeparate(context, GL_FRONT_AND_BACK, fail, zfail, zpass);
}

void StencilMask(Context& context, GLuint mask) {
    StencilMaskSeparate(context, GL_FRONT_AND_BACK, mask);
}

} // namespace spangle::gl::cmd
