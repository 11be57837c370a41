// Per-fragment operations, write masks and clear values (GL 1.3, chapter 4).
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

// Where the tokens of several values are consecutive, the members have the same order. One row of the state
// table then serves all of them.

/// The stencil test of front or back faces.
struct StencilSide {
    GLenum func = GL_ALWAYS;
    GLuint value_mask = 0xFFFFFFFF;
    GLenum fail = GL_KEEP, pass_depth_fail = GL_KEEP, pass_depth_pass = GL_KEEP;
    GLint ref = 0;
    GLuint write_mask = 0xFFFFFFFF;
    friend constexpr bool operator==(const StencilSide&, const StencilSide&) = default;
};

/// Blending of red, green and blue, or of alpha.
struct BlendPart {
    GLenum dst = GL_ZERO, src = GL_ONE, equation = GL_FUNC_ADD;
};

struct FragmentOpsState {
    bool scissor_test = false;
    GLint scissor_box[4] = {0, 0, 0, 0};
    bool alpha_test = false;
    GLenum alpha_func = GL_ALWAYS;
    Real alpha_ref = numeric::zero;
    bool stencil_test = false;
    GLint stencil_clear = 0;
    StencilSide stencil[2]; ///< front, back
    bool depth_test = false;
    GLenum depth_func = GL_LESS;
    bool depth_mask = true;
    Real depth_clear = numeric::one;
    bool blend = false;
    BlendPart blend_rgb, blend_alpha;
    Real blend_color[4] = {};
    bool color_logic_op = false, index_logic_op = false;
    GLenum logic_op = GL_COPY;
    bool dither = true;
    // The following members have no effect on surfaces without a multisample buffer (GL 1.3, 4.1.3).
    bool multisample = true, sample_alpha_to_coverage = false, sample_alpha_to_one = false,
         sample_coverage = false;
    Real sample_coverage_value = numeric::one;
    bool sample_coverage_invert = false;
    bool color_mask[4] = {true, true, true, true};
    Real color_clear[4] = {};
    Real accum_clear[4] = {};
    Real index_clear = numeric::zero;
    GLuint index_mask = 0xFFFFFFFF;
    GLenum draw_buffer = GL_FRONT, read_buffer = GL_FRONT; ///< initially GL_BACK if the first drawable has a
                                                           ///< back buffer
};

} // namespace spangle::gl
