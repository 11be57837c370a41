// Matrix stacks, viewport and depth range (GL 1.3, 2.10).
#pragma once

#include "gl/context/types.hpp"
#include "raster/numeric/matrix.hpp"

namespace spangle::gl {

/// A stack of `Depth` matrices (GL 1.3, table 6.11).
template <int Depth> struct MatrixStack {
    int top = 0;
    numeric::Matrix entry[Depth];
};

struct TransformState {
    GLenum matrix_mode = GL_MODELVIEW;
    GLint viewport[4] = {0, 0, 0, 0};
    Real depth_range[2] = {numeric::zero, numeric::one};
    bool normalize = false;
    bool rescale_normal = false;
#if SPANGLE_FEATURE_CLIP_PLANES
    bool clip_plane_on[max_clip_planes] = {};
    Real clip_plane[max_clip_planes][4] = {}; ///< planes in eye space
#endif
    MatrixStack<projection_stack_entries> projection;
    MatrixStack<texture_stack_entries> texture[texture_units];
    MatrixStack<modelview_stack_entries> modelview; ///< the largest member comes last, as in Context
};

} // namespace spangle::gl
