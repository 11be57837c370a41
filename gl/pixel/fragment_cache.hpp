// The compiled form of all fragment state, good while dirty_fragment is clear.
#pragma once

#include "raster/span/draw_state.hpp"

namespace spangle::gl {

struct FragmentCache {
    bool count_passed = false;
    raster::Counters* counters = nullptr;
    raster::DrawState state;
};

} // namespace spangle::gl
