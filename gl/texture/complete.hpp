// Which texture a unit samples (GL 1.3, 3.8.9, 3.8.10, 3.8.15).
#pragma once

#include "gl/context/context.hpp"

namespace spangle::gl {

/// A texture's view, ready to sample; null when the texture is incomplete. Valid until the texture changes.
const raster::Texture* complete_texture(const TextureObject& texture);

/// The texture that a unit samples, with its view ready. Null when no target is enabled or the texture is
/// incomplete, which act alike. Valid until a texture changes.
const TextureObject* sampled_texture(const Context& context, int unit);

/// Whether the base levels of all six faces exist and are alike (GL 1.3, 3.8.10).
bool is_cube_complete(const TextureObject& texture);

} // namespace spangle::gl
