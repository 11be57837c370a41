// Commands for the shading model, facing, culling, point size and line width (GL 1.3, 2.13.7, 3.3, 3.4 and
// 3.5.1).
#include "gl/api/generated/commands.hpp"
#include "gl/pixel/viewport_box.hpp"

namespace spangle::gl::cmd {

void ShadeModel(Context& context, GLenum mode) {
    if (mode != GL_FLAT && mode != GL_SMOOTH)
        return error(context, GL_INVALID_ENUM);
    context.polygon.shade_model = mode;
    context.changed(dirty_fragment);
}

void FrontFace(Context& context, GLenum mode) {
    if (mode != GL_CW && mode != GL_CCW)
        return error(context, GL_INVALID_ENUM);
    context.polygon.front_face = mode;
}

void CullFace(Context& context, GLenum mode) {
    if (mode != GL_FRONT && mode != GL_BACK && mode != GL_FRONT_AND_BACK)
        return error(context, GL_INVALID_ENUM);
    context.polygon.cull_face_mode = mode;
}

#if SPANGLE_FEATURE_POLYGON_MODE
void PolygonMode(Context& context, GLenum face, GLenum mode) {
    if ((face != GL_FRONT && face != GL_BACK && face != GL_FRONT_AND_BACK) ||
        (mode != GL_POINT && mode != GL_LINE && mode != GL_FILL))
        return error(context, GL_INVALID_ENUM);
    if (face != GL_BACK)
        context.polygon.mode[0] = mode;
    if (face != GL_FRONT)
        context.polygon.mode[1] = mode;
    // Whether the fragments of polygons have coverage depends on the polygon mode.
    context.changed(dirty_fragment);
}
#endif

void PointSize(Context& context, Real size) {
    if (size <= numeric::zero)
        return error(context, GL_INVALID_VALUE, SPANGLE_TEXT("size is not positive"));
    context.polygon.point_size = size;
}

#if SPANGLE_FEATURE_POINT_PARAMETERS
void PointParameter(Context& context, GLenum pname, const Params& params) {
    if (params.count == 0)
        return error(context, GL_INVALID_ENUM);
    PolygonState& polygon = context.polygon;
    const auto set_size = [&](Real& size) {
        if (params.v[0].real() < numeric::zero)
            return error(context, GL_INVALID_VALUE);
        size = params.v[0].real();
    };
    switch (pname) {
    case GL_POINT_SIZE_MIN:
        return set_size(polygon.point_size_min);
    case GL_POINT_SIZE_MAX:
        return set_size(polygon.point_size_max);
    case GL_POINT_FADE_THRESHOLD_SIZE:
        return set_size(polygon.point_fade_threshold);
    case GL_POINT_DISTANCE_ATTENUATION:
        for (int i = 0; i < 3; ++i)
            polygon.point_attenuation[i] = params.v[i].real();
        return;
    case GL_POINT_SPRITE_COORD_ORIGIN:
        if (params.v[0].token() != GL_LOWER_LEFT && params.v[0].token() != GL_UPPER_LEFT)
            return error(context, GL_INVALID_ENUM);
        polygon.sprite_origin = params.v[0].token();
        return;
    default:
        return error(context, GL_INVALID_ENUM);
    }
}
#endif

void LineWidth(Context& context, Real width) {
    if (width <= numeric::zero)
        return error(context, GL_INVALID_VALUE, SPANGLE_TEXT("width is not positive"));
    context.polygon.line_width = width;
    if (!viewport_holds_window(context))
        // Fragments of wide lines must end at a viewport that does not hold the window; see viewport_box.hpp.
        context.changed(dirty_fragment);
}

#if SPANGLE_FEATURE_POLYGON_OFFSET
void PolygonOffset(Context& context, Real factor, Real units) {
    // No derived state is marked as changed: each polygon reads the offset when it is drawn.
    context.polygon.offset_factor = factor;
    context.polygon.offset_units = units;
}
#endif

#if SPANGLE_FEATURE_STIPPLE
void LineStipple(Context& context, GLint factor, GLushort pattern) {
    context.polygon.stipple_factor = numeric::clamp<GLint>(factor, 1, 256);
    context.polygon.stipple_pattern = pattern;
}
#endif

} // namespace spangle::gl::cmd
