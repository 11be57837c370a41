// Which texture a unit samples (GL 1.3, 3.8.9, 3.8.10, 3.8.15).
#pragma once

#include "gl/context/context.hpp"

namespace spangle::gl {

/// Returns a texture's view, ready to be sampled, or null if the texture is incomplete. The view is valid
/// until the texture changes.
const raster::Texture* complete_texture(const TextureObject& texture);

/// Returns the texture that a unit samples, with its view ready to be sampled. Returns null if no target is
/// enabled or if the texture is incomplete; both disable texturing. The result is valid until a texture
/// changes.
const TextureObject* sampled_texture(const Context& context, int unit);

/// Whether the base levels of all six faces exist and are alike (GL 1.3, 3.8.10).
bool is_cube_complete(const TextureObject& texture);

} // namespace spangle::gl
