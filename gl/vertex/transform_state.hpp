// Matrix stacks, viewport and depth range (GL 1.3, 2.10).
#pragma once

#include "gl/context/types.hpp"
#include "raster/numeric/matrix.hpp"

namespace spangle::gl {

/// A stack of matrices; the minimum depths of GL 1.3, table 6.11.
template <int Depth> struct MatrixStack {
    static constexpr int depth = Depth;
    numeric::Matrix entry[Depth];
    int top = 0;
};

inline constexpr int max_clip_planes = 6;

struct TransformState {
    GLenum matrix_mode = GL_MODELVIEW;
    MatrixStack<32> modelview;
    MatrixStack<2> projection;
    MatrixStack<2> texture[texture_units];
    GLint viewport[4] = {0, 0, 0, 0};
    Real depth_range[2] = {numeric::zero, numeric::one};
    bool normalize = false;
    bool rescale_normal = false;
    bool clip_plane_on[max_clip_planes] = {};
    Real clip_plane[max_clip_planes][4] = {}; ///< in eye space
};

} // namespace spangle::gl
