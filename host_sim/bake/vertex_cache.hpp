// Orders triangles and vertices for the vertex cache of array draws.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace spangle::bake {

using IndexList = std::vector<std::uint32_t>;

/// The number of vertices that a cache of that many entries processes for these elements. Spangle keeps
/// vertex i in entry i mod entries (gl/vertex/vertex_cache.hpp).
std::size_t cache_misses(const IndexList& indices, unsigned entries);

/// Orders triangles so that their vertices are used again soon. Triangles form fans around a vertex,
/// then around the neighbour that will be forgotten next (Sander, Nehab, Barczak 2007, "Fast triangle
/// reordering").
IndexList order_triangles(const IndexList& triangles, std::size_t vertices, unsigned entries);

/// The new number of each vertex, in the order of first use, or `unused` where no index names it. With these
/// numbers the cache of cache_misses() forgets the oldest vertex first.
inline constexpr std::uint32_t unused = 0xFFFFFFFF;
std::vector<std::uint32_t> first_use_order(const IndexList& indices, std::size_t vertices);

/// One strip of the same triangles, each with the same winding; repeated indices join its parts. A part takes
/// only triangles that come at most `reach` after its first, so that the order stays roughly the same.
IndexList make_strip(const IndexList& triangles, std::size_t reach);

} // namespace spangle::bake
