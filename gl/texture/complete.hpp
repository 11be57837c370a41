// From a texture object to what the rasterizer samples (GL 1.3, 3.8.9).
#pragma once

#include "gl/context/context.hpp"

namespace spangle::gl {

/// The texture bound to a unit, or null when it is incomplete: the unit is then as if disabled. Valid until
/// the object changes; near-free until then.
const raster::Texture* complete_texture(const Context& context, int unit);

} // namespace spangle::gl
