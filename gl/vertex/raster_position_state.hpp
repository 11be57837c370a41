// The current raster position (GL 1.3, 2.12).
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

struct RasterPosition {
    /// Window x, y and z, and w of the clip coordinates.
    Real position[4] = {numeric::zero, numeric::zero, numeric::zero, numeric::one};
    Real distance = numeric::zero; ///< distance from the eye, for fog
    Real color[4] = {numeric::one, numeric::one, numeric::one, numeric::one};
    Real index = numeric::one;
    struct TexCoord {
        Real v[4] = {numeric::zero, numeric::zero, numeric::zero, numeric::one};
    } tex_coord[texture_units];
    bool valid = true;
};

} // namespace spangle::gl
