// The compiled form of all fragment state. It is valid while dirty_fragment is clear and no context of the
// share group has changed a texture.
#pragma once

#include <type_traits>

#include "gl/context/features.hpp"
#include "gl/pixel/compiled_state_cache.hpp"
#include "raster/span/draw_state.hpp"

namespace spangle::gl {

/// The kind of primitive, because some state applies to one kind only (GL 1.3, 3.3 to 3.5).
enum class PrimitiveKind : std::uint8_t { points, lines, polygons, pixels };

struct FragmentCache {
    bool count_passed = false;
    PrimitiveKind drawn = PrimitiveKind::pixels; ///< kind of primitive that `state` was compiled for
    bool differs = false;                        ///< the compiled form depends on the kind of primitive
    raster::Colors colors{};                     ///< source of colours that `state` was compiled for
    std::uint32_t texture_changes = 0;           ///< ShareGroup::texture_changes when `state` was compiled
    raster::Counters* counters = nullptr;
    raster::PrimitiveState primitive; ///< per-primitive state that `state` and `back` refer to
    raster::DrawState state;
#if SPANGLE_FEATURE_STENCIL_SIDES
    raster::DrawState back; ///< the compiled state for back faces; used only while stencil_sides()
#endif
    struct None {};
    [[no_unique_address]] std::conditional_t<compiled_state_count != 0, CompiledStateCache, None> kept;
};

} // namespace spangle::gl
