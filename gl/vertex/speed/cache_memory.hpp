// What caches of vertices and meshes may keep.
#pragma once

#include "gl/context/limits.hpp"
#include "raster/numeric/machine.hpp"

namespace spangle::gl {

/// Whether the window positions of vertices of Vertex commands may be kept.
inline constexpr bool may_cache_positions = true;
/// Whether kept vertices may keep their positions while their colours change. Firmware has no code for that.
inline constexpr bool may_keep_positions = numeric::wide_words;
/// Whether the cache of elements may begin small and grow.
inline constexpr bool may_grow_cache = SPANGLE_GROWS_CACHE != 0;
/// Number of rows of a mesh whose vertex maps are kept.
inline constexpr int kept_mesh_rows = 2;

} // namespace spangle::gl
