// What caches of vertices and meshes may keep: only elements of arrays.
#pragma once

#include "gl/context/limits.hpp"

namespace spangle::gl {

/// Whether the window positions of vertices of Vertex commands may be kept.
inline constexpr bool may_cache_positions = false;
/// Whether kept vertices may keep their positions while their colours change.
inline constexpr bool may_keep_positions = false;
/// Whether the cache of elements may begin small and grow.
inline constexpr bool may_grow_cache = false;
/// Number of rows of a mesh whose vertex maps are kept.
inline constexpr int kept_mesh_rows = 0;

} // namespace spangle::gl
