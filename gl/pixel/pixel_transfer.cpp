// PixelTransfer (GL 1.3, 3.6.3).
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_PIXEL_TRANSFER

#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"

namespace spangle::gl::cmd {

namespace {

/// The scale or bias that a name of table 3.2 (GL 1.3) refers to, or null. The tokens of scale and bias
/// alternate.
Real* number_of(PixelModeState& mode, GLenum pname) {
    if (pname < GL_RED_SCALE || pname > GL_DEPTH_BIAS || pname == GL_ZOOM_X || pname == GL_ZOOM_Y)
        return nullptr;
    const unsigned n = pname < GL_ZOOM_X ? pname - GL_RED_SCALE : pname - GL_GREEN_SCALE + 2;
    Linear& linear = mode.linear[n / 2];
    return n % 2 == 0 ? &linear.scale : &linear.bias;
}

} // namespace

void PixelTransfer(Context& context, GLenum pname, const Params& params) {
    if (params.count == 0)
        return error(context, GL_INVALID_ENUM);
    PixelModeState& mode = context.pixel_mode;
    const Param value = params.v[0];
    switch (pname) {
    case GL_MAP_COLOR:
        mode.map_color = numeric::to_bool(value.real());
        break;
    case GL_MAP_STENCIL:
        mode.map_stencil = numeric::to_bool(value.real());
        break;
    case GL_INDEX_SHIFT:
        mode.index_shift = value.integer();
        break;
    case GL_INDEX_OFFSET:
        mode.index_offset = value.integer();
        break;
    default:
        if (Real* const number = number_of(mode, pname); number != nullptr)
            *number = value.real();
        else
            error(context, GL_INVALID_ENUM);
    }
}

} // namespace spangle::gl::cmd

#endif
