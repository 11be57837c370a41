// From the state of texture units to what the rasterizer is told.
#pragma once

#include "gl/context/context.hpp"

namespace spangle::gl {

/// FragmentState::unit.
void fill_textures(const Context& context, raster::FragmentState& out);

} // namespace spangle::gl
