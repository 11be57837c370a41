// The compiled form of all fragment state, good while dirty_fragment is clear and no context of the share
// group changed a texture.
#pragma once

#include <type_traits>

#include "gl/context/features.hpp"
#include "gl/pixel/kept_states.hpp"
#include "raster/span/draw_state.hpp"

namespace spangle::gl {

/// What is drawn. Some modes are of one of them (GL 1.3, 3.3 to 3.5).
enum class Drawn : std::uint8_t { points, lines, polygons, pixels };

struct FragmentCache {
    bool count_passed = false;
    Drawn drawn = Drawn::pixels;       ///< what this was compiled for
    bool differs = false;              ///< for other things it would be another one
    raster::Colors colors{};           ///< of what is drawn: compiled for these alone
    std::uint32_t texture_changes = 0; ///< of the share group, when this was compiled
    raster::Counters* counters = nullptr;
    raster::PrimitiveState primitive; ///< what `state` looks at beside planes
    raster::DrawState state;
#if SPANGLE_FEATURE_STENCIL_SIDES
    raster::DrawState back; ///< of back faces, while their stencil test differs
#endif
    struct None {};
    [[no_unique_address]] std::conditional_t<kept_states != 0, KeptStates, None> kept;
};

} // namespace spangle::gl
