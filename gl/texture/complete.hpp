// Which texture a unit samples (GL 1.3, 3.8.9, 3.8.10, 3.8.15).
#pragma once

#include "gl/context/context.hpp"

namespace spangle::gl {

/// A texture ready to sample, or null when it is incomplete. Valid until it changes.
const raster::Texture* complete_texture(const TextureObject& texture);

/// The texture of the target that a unit takes, its view ready to sample, or null: none is enabled, or it is
/// incomplete and the unit behaves as if none were. Valid until a texture changes.
const TextureObject* sampled_texture(const Context& context, int unit);

/// The base levels of all faces are there and alike (GL 1.3, 3.8.10).
bool is_cube_complete(const TextureObject& texture);

} // namespace spangle::gl
