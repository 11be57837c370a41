// The two textures of the benchmark scenes.
#pragma once

#include "boards/scenes/gl.hpp"

namespace spangle::scenes {

/// Makes and binds a 64x64 RGB texture: a checkerboard of 8-texel squares over gradients, whose first row and
/// column are white.
void make_checkerboard(GLint filter);

/// Makes and binds a 32x32 RGBA texture: a ball that fades to nothing at its rim.
void make_ball();

} // namespace spangle::scenes
