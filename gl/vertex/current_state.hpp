// Current vertex attributes (GL 1.3, 2.7; GL 1.4, 2.7).
#pragma once

#include "gl/context/types.hpp"
#include "gl/vertex/raster_position_state.hpp"

namespace spangle::gl {

struct CurrentState {
    Real color[4] = {numeric::one, numeric::one, numeric::one, numeric::one};
    /// No command changes the alpha of the secondary colour.
    Real secondary_color[4] = {numeric::zero, numeric::zero, numeric::zero, numeric::one};
    Real normal[3] = {numeric::zero, numeric::zero, numeric::one};
    Real index = numeric::one; ///< the index as set, without the mask of the framebuffer's bits
    Real fog_coord = numeric::zero;
    bool edge_flag = true;
    struct TexCoord {
        Real v[4] = {numeric::zero, numeric::zero, numeric::zero, numeric::one};
    } tex_coord[texture_units];
    RasterPosition raster;
};

} // namespace spangle::gl
