// Levels derived from the base level (GL 1.4, 3.8.8: GENERATE_MIPMAP).
#pragma once

#include "gl/texture/texture_object.hpp"

namespace spangle::gl {

struct Context;

/// Generates the levels of one face after the base level, up to `last`. Each texel is the mean of the texels
/// that it covers. The function does nothing if there is no base level, or if its texels are compressed.
/// After OUT_OF_MEMORY all levels are unchanged.
void generate_mipmaps(Context& context, TextureObject& texture, unsigned face, GLint last);

} // namespace spangle::gl
