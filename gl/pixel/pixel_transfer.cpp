// PixelTransfer (GL 1.3, 3.6.3).
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_PIXEL_TRANSFER

#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"

namespace spangle::gl::cmd {

namespace {

/// Returns twice the index of a component for its scale, and 1 more for its bias. In GL, the tokens of scale
/// and bias alternate.
constexpr unsigned place_of(GLenum pname) {
    return pname < GL_ZOOM_X ? pname - GL_RED_SCALE : pname - GL_GREEN_SCALE + 2;
}
static_assert(place_of(GL_RED_SCALE) == 0 && place_of(GL_RED_BIAS) == 1 && place_of(GL_GREEN_SCALE) == 2 &&
              place_of(GL_GREEN_BIAS) == 3 && place_of(GL_BLUE_SCALE) == 4 && place_of(GL_BLUE_BIAS) == 5 &&
              place_of(GL_ALPHA_SCALE) == 6 && place_of(GL_ALPHA_BIAS) == 7 &&
              place_of(GL_DEPTH_SCALE) == 8 && place_of(GL_DEPTH_BIAS) == 9);

/// The scale or bias that a name of table 3.2 (GL 1.3) refers to, or null.
Real* number_of(PixelModeState& mode, GLenum pname) {
    if (pname < GL_RED_SCALE || pname > GL_DEPTH_BIAS || pname == GL_ZOOM_X || pname == GL_ZOOM_Y)
        return nullptr;
    const unsigned n = place_of(pname);
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
