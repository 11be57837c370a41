// Commands for matrices and their stacks, the viewport and the depth range (GL 1.3, 2.10.1 and 2.10.2).
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/hooks.hpp"
#include "gl/context/limits.hpp"
#include "gl/pixel/viewport_box.hpp"
#include "gl/vertex/eye_plane.hpp"
#include "raster/numeric/matrix_build.hpp"

namespace spangle::gl {

namespace {

/// A matrix stack: its entries, its capacity and the index of its top.
struct StackRef {
    numeric::Matrix* entry;
    int depth;
    int* top;
};

StackRef modelview_stack(TransformState& t) {
    return {t.modelview.entry, modelview_stack_entries, &t.modelview.top};
}

StackRef current_stack(Context& context) {
    TransformState& t = context.transform;
    if (t.matrix_mode == GL_PROJECTION)
        return {t.projection.entry, projection_stack_entries, &t.projection.top};
    if (t.matrix_mode == GL_TEXTURE) {
        auto& stack = t.texture[context.texture.active_unit()];
        return {stack.entry, texture_stack_entries, &stack.top};
    }
    return modelview_stack(t);
}

/// Returns the message for a full stack. Profiles size each stack separately, so the message names the option
/// of the full stack.
const char* stack_is_full([[maybe_unused]] GLenum mode) {
    return mode == GL_PROJECTION ? SPANGLE_TEXT("the stack is full (SPANGLE_PROJECTION_STACK)")
           : mode == GL_TEXTURE  ? SPANGLE_TEXT("the stack is full (SPANGLE_TEXTURE_STACK)")
                                 : SPANGLE_TEXT("the stack is full (SPANGLE_MODELVIEW_STACK)");
}

/// Marks what is derived from the current matrix as changed. The Dirty bits have the order of the tokens.
void matrix_changed(Context& context) {
    static_assert(GL_PROJECTION == GL_MODELVIEW + 1 && dirty_projection == dirty_modelview << 1 &&
                  GL_TEXTURE == GL_MODELVIEW + 2 && dirty_texture_matrices == dirty_modelview << 2);
    context.changed(static_cast<Dirty>(dirty_modelview << (context.transform.matrix_mode - GL_MODELVIEW)));
}

numeric::Matrix& current_matrix(Context& context) {
    const StackRef stack = current_stack(context);
    matrix_changed(context);
    return stack.entry[*stack.top];
}

/// Multiplies the current matrix by a matrix or a rotation.
template <class R> void multiply_current(Context& context, const R& right) {
    numeric::Matrix& top = current_matrix(context);
    top = numeric::multiply(top, right);
}

bool equal(Real a, Real b) {
    return a == b;
}

} // namespace

Matrix16 top_matrix(const Context& context, GLenum pname) {
    const TransformState& t = context.transform;
    const auto& texture = t.texture[context.texture.active_unit()];
    Matrix16 out;
    numeric::to_reals(pname == GL_PROJECTION_MATRIX ? t.projection.entry[t.projection.top]
                      : pname == GL_TEXTURE_MATRIX  ? texture.entry[texture.top]
                                                    : t.modelview.entry[t.modelview.top],
                      out.m);
    return out;
}

GLint stack_depth(const Context& context, GLenum pname) {
    const TransformState& t = context.transform;
    if (pname == GL_PROJECTION_STACK_DEPTH)
        return t.projection.top + 1;
    if (pname == GL_TEXTURE_STACK_DEPTH)
        return t.texture[context.texture.active_unit()].top + 1;
    return t.modelview.top + 1;
}

#if SPANGLE_FEATURE_CLIP_PLANES || SPANGLE_FEATURE_TEXGEN
void to_eye_plane(const TransformState& transform, const Real (&plane)[4], Real (&out)[4]) {
    numeric::Matrix inverse = numeric::identity();
    numeric::inverse(transform.modelview.entry[transform.modelview.top], inverse);
    numeric::row_times(plane, inverse, out);
}
#endif

namespace cmd {

void MatrixMode(Context& context, GLenum mode) {
    if (mode != GL_MODELVIEW && mode != GL_PROJECTION && mode != GL_TEXTURE)
        return error(context, GL_INVALID_ENUM);
    context.transform.matrix_mode = mode;
}

void LoadIdentity(Context& context) {
    current_matrix(context) = numeric::identity();
}

void LoadMatrix(Context& context, const Matrix16& matrix) {
    current_matrix(context) = numeric::matrix_from_reals(matrix.m);
}

void MultMatrix(Context& context, const Matrix16& matrix) {
    multiply_current(context, numeric::matrix_from_reals(matrix.m));
}

void LoadTransposeMatrix(Context& context, const Matrix16& matrix) {
    current_matrix(context) = numeric::transpose(numeric::matrix_from_reals(matrix.m));
}

void MultTransposeMatrix(Context& context, const Matrix16& matrix) {
    multiply_current(context, numeric::transpose(numeric::matrix_from_reals(matrix.m)));
}

void PushMatrix(Context& context) {
    const StackRef stack = current_stack(context);
    if (*stack.top + 1 >= stack.depth)
        return error(context, GL_STACK_OVERFLOW, stack_is_full(context.transform.matrix_mode));
    stack.entry[*stack.top + 1] = stack.entry[*stack.top];
    ++*stack.top;
}

void PopMatrix(Context& context) {
    const StackRef stack = current_stack(context);
    if (*stack.top == 0)
        return error(context, GL_STACK_UNDERFLOW);
    --*stack.top;
    matrix_changed(context);
}

void Rotate(Context& context, Real angle, Real x, Real y, Real z) {
    multiply_current(context, numeric::rotation(angle, x, y, z));
}

void Translate(Context& context, Real x, Real y, Real z) {
    multiply_current(context, numeric::translation(x, y, z));
}

void Scale(Context& context, Real x, Real y, Real z) {
    multiply_current(context, numeric::scaling(x, y, z));
}

void Frustum(Context& context, Real left, Real right, Real bottom, Real top, Real near_val, Real far_val) {
    if (near_val <= numeric::zero || far_val <= numeric::zero || equal(left, right) || equal(bottom, top) ||
        equal(near_val, far_val))
        return error(context, GL_INVALID_VALUE,
                     SPANGLE_TEXT("near and far must be positive, and opposite planes differ"));
    multiply_current(context, numeric::frustum(left, right, bottom, top, near_val, far_val));
}

void Ortho(Context& context, Real left, Real right, Real bottom, Real top, Real near_val, Real far_val) {
    if (equal(left, right) || equal(bottom, top) || equal(near_val, far_val))
        return error(context, GL_INVALID_VALUE, SPANGLE_TEXT("opposite planes must differ"));
    multiply_current(context, numeric::ortho(left, right, bottom, top, near_val, far_val));
}

void Viewport(Context& context, GLint x, GLint y, GLsizei width, GLsizei height) {
    if (width < 0 || height < 0)
        return error(context, GL_INVALID_VALUE);
    const auto clamp = [](GLint v, GLint low, GLint high) { return v < low ? low : v > high ? high : v; };
    GLint* v = context.transform.viewport;
    const bool held_window = viewport_holds_window(context);
    v[0] = clamp(x, -max_viewport_dim, max_viewport_dim);
    v[1] = clamp(y, -max_viewport_dim, max_viewport_dim);
    v[2] = clamp(width, 0, max_viewport_dim);
    v[3] = clamp(height, 0, max_viewport_dim);
    context.changed(dirty_viewport);
    // Fragments must end at a viewport that does not hold the window; see viewport_box.hpp.
    if (!held_window || !viewport_holds_window(context))
        context.changed(dirty_fragment);
#if SPANGLE_HAS_PLATFORMS
    // Programs call glViewport when their window has changed its size.
    if (context.drawable.follow != nullptr)
        context.drawable.follow();
#endif
}

void DepthRange(Context& context, Real near_val, Real far_val) {
    context.transform.depth_range[0] = numeric::clamp01(near_val);
    context.transform.depth_range[1] = numeric::clamp01(far_val);
    context.changed(dirty_viewport);
}

} // namespace cmd

} // namespace spangle::gl
