// In which order should triangles come, and vertices lie, for the vertex cache of array draws?
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace spangle::bake {

using IndexList = std::vector<std::uint32_t>;

/// Vertices that are processed for these elements by a cache of that many entries. Ours keeps vertex i in
/// entry i mod entries (gl/vertex/pipeline_elements.hpp).
std::size_t cache_misses(const IndexList& indices, unsigned entries);

/// The same triangles, ordered so that their vertices come again soon: fans around a vertex, then around the
/// neighbour that will be forgotten next (Sander, Nehab, Barczak 2007, "Fast triangle reordering").
IndexList order_triangles(const IndexList& triangles, std::size_t vertices, unsigned entries);

/// Where each vertex goes when they are numbered as they are first used, which makes the cache above one that
/// forgets the oldest; `unused` for those that no index names.
inline constexpr std::uint32_t unused = 0xFFFFFFFF;
std::vector<std::uint32_t> first_use_order(const IndexList& indices, std::size_t vertices);

/// One strip of the same triangles, each with the same winding; repeated indices join its parts. A part takes
/// only triangles that come at most `reach` after its first, so that the order stays roughly what it was.
IndexList make_strip(const IndexList& triangles, std::size_t reach);

} // namespace spangle::bake
