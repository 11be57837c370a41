// The two textures of the benchmark scenes.
#pragma once

#include "boards/scenes/gl.hpp"

namespace spangle::scenes {

/// 64x64 RGB checkerboard of 8-texel squares over gradients, first row and column white. Binds a new texture
/// object.
void make_checkerboard(GLint filter);

/// 32x32 RGBA ball that fades to nothing at its rim. Binds a new texture object.
void make_ball();

} // namespace spangle::scenes
