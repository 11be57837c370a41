// What happens to fragments: fog, tests, blending, clears, hints (GL 1.3, tables 6.8, 6.18 and 6.23).
#pragma once

#include "gl/context/state_row.hpp"

namespace spangle::gl {

inline constexpr auto fragment_rows = std::to_array<StateRow>({
    in(Group::fog),
    of_fog(linear(STORED(GL_FOG_COLOR, fog.color))),
    of_fog(STORED(GL_FOG_INDEX, fog.index)),
    of_fog(STORED(GL_FOG_COORDINATE_SOURCE, fog.source)),
    of_fog(STORED(GL_FOG_DENSITY, fog.density)),
    of_fog(STORED(GL_FOG_START, fog.start)),
    of_fog(STORED(GL_FOG_END, fog.end)),
    of_fog(STORED(GL_FOG_MODE, fog.mode)),
    of_fog(SWITCH(GL_FOG, fog.fog)),
    in(Group::scissor),
    SWITCH(GL_SCISSOR_TEST, fragment_ops.scissor_test),
    STORED(GL_SCISSOR_BOX, fragment_ops.scissor_box),
    in(Group::color_buffer),
    SWITCH(GL_ALPHA_TEST, fragment_ops.alpha_test),
    STORED(GL_ALPHA_TEST_FUNC, fragment_ops.alpha_func),
    linear(STORED(GL_ALPHA_TEST_REF, fragment_ops.alpha_ref)),
    in(Group::stencil_buffer),
    SWITCH(GL_STENCIL_TEST, fragment_ops.stencil_test),
    STORED(GL_STENCIL_FUNC, fragment_ops.stencil_func),
    STORED(GL_STENCIL_VALUE_MASK, fragment_ops.stencil_value_mask),
    STORED(GL_STENCIL_REF, fragment_ops.stencil_ref),
    STORED(GL_STENCIL_FAIL, fragment_ops.stencil_fail),
    STORED(GL_STENCIL_PASS_DEPTH_FAIL, fragment_ops.stencil_pass_depth_fail),
    STORED(GL_STENCIL_PASS_DEPTH_PASS, fragment_ops.stencil_pass_depth_pass),
    STORED(GL_STENCIL_WRITEMASK, fragment_ops.stencil_write_mask),
    STORED(GL_STENCIL_CLEAR_VALUE, fragment_ops.stencil_clear),
    in(Group::depth_buffer),
    SWITCH(GL_DEPTH_TEST, fragment_ops.depth_test),
    STORED(GL_DEPTH_FUNC, fragment_ops.depth_func),
    STORED(GL_DEPTH_WRITEMASK, fragment_ops.depth_mask),
    linear(STORED(GL_DEPTH_CLEAR_VALUE, fragment_ops.depth_clear)),
    in(Group::color_buffer),
    SWITCH(GL_BLEND, fragment_ops.blend),
    STORED(GL_BLEND_SRC, fragment_ops.blend_src),
    STORED(GL_BLEND_DST, fragment_ops.blend_dst),
    SWITCH(GL_DITHER, fragment_ops.dither),
    STORED(GL_DRAW_BUFFER, fragment_ops.draw_buffer),
    STORED(GL_COLOR_WRITEMASK, fragment_ops.color_mask),
    linear(STORED(GL_COLOR_CLEAR_VALUE, fragment_ops.color_clear)),
    in(Group::hint),
    STORED(GL_PERSPECTIVE_CORRECTION_HINT, hint.perspective_correction),
    STORED(GL_POINT_SMOOTH_HINT, hint.point_smooth),
    STORED(GL_LINE_SMOOTH_HINT, hint.line_smooth),
    STORED(GL_POLYGON_SMOOTH_HINT, hint.polygon_smooth),
    STORED(GL_FOG_HINT, hint.fog),
    STORED(GL_TEXTURE_COMPRESSION_HINT, hint.texture_compression),
});

} // namespace spangle::gl
