// Which texture a unit samples (GL 1.3, 3.8.9, 3.8.13).
#pragma once

#include "gl/context/context.hpp"

namespace spangle::gl {

/// The texture bound to the 2D target of a unit, ready to sample, or null when it is incomplete: the unit
/// then behaves as if it were disabled. Valid until a texture changes.
const raster::Texture* complete_texture(const Context& context, int unit);

} // namespace spangle::gl
