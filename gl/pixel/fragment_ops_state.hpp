// Per-fragment operations, write masks and clear values (GL 1.3, chapter 4).
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

struct FragmentOpsState {
    bool scissor_test = false;
    GLint scissor_box[4] = {0, 0, 0, 0};
    bool alpha_test = false;
    GLenum alpha_func = GL_ALWAYS;
    Real alpha_ref = numeric::zero;
    bool stencil_test = false;
    GLenum stencil_func = GL_ALWAYS;
    GLint stencil_ref = 0;
    GLuint stencil_value_mask = 0xFFFFFFFF;
    GLenum stencil_fail = GL_KEEP, stencil_pass_depth_fail = GL_KEEP, stencil_pass_depth_pass = GL_KEEP;
    GLuint stencil_write_mask = 0xFFFFFFFF;
    GLint stencil_clear = 0;
    bool depth_test = false;
    GLenum depth_func = GL_LESS;
    bool depth_mask = true;
    Real depth_clear = numeric::one;
    bool blend = false;
    GLenum blend_src = GL_ONE, blend_dst = GL_ZERO;
    bool dither = true;
    bool color_mask[4] = {true, true, true, true};
    Real color_clear[4] = {};
    GLenum draw_buffer = GL_FRONT, read_buffer = GL_FRONT; ///< BACK when the first drawable has one
};

} // namespace spangle::gl
