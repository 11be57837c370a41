// Levels derived from the base level (GL 1.4, 3.8.8: GENERATE_MIPMAP).
#pragma once

#include "gl/texture/texture_object.hpp"

namespace spangle::gl {

struct Context;

/// Levels of one face behind the base level, up to `last`, each texel the mean of those it covers. Nothing
/// happens without a base level, or where its texels are compressed. OUT_OF_MEMORY leaves all levels as they
/// were.
void generate_mipmaps(Context& context, TextureObject& texture, unsigned face, GLint last);

} // namespace spangle::gl
