// Derives the rasterizer's texture state from the state of texture units.
#pragma once

#include "gl/context/context.hpp"

namespace spangle::gl {

/// Fills in FragmentState::unit.
void fill_textures(const Context& context, raster::FragmentState& out);

} // namespace spangle::gl
