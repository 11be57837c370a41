// The compiled form of all fragment state. Every command that changes such state sets `dirty`.
#pragma once

#include "raster/span/draw_state.hpp"

namespace spangle::gl {

struct FragmentCache {
    bool dirty = true;
    bool count_passed = false;
    raster::Counters* counters = nullptr;
    raster::DrawState state;
};

} // namespace spangle::gl
