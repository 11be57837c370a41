// The compiled form of all fragment state, good while dirty_fragment is clear and no context of the share
// group changed a texture.
#pragma once

#include "gl/context/features.hpp"
#include "raster/span/draw_state.hpp"

namespace spangle::gl {

struct FragmentCache {
    bool count_passed = false;
    std::uint32_t texture_changes = 0; ///< of the share group, when this was compiled
    raster::Counters* counters = nullptr;
    raster::DrawState state;
#if SPANGLE_FEATURE_STENCIL_SIDES
    raster::DrawState back; ///< of back faces, while their stencil test differs
#endif
};

} // namespace spangle::gl
