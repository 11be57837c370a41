// Keeps the window positions of vertices that Vertex commands give, in Begin/End or in lists. Models give
// most positions several times, with another normal or for the next face. Such a position is transformed
// once. The same memory caches elements of arrays by index at other times; see VertexCache.
#pragma once

#include "gl/vertex/pipeline.hpp"

#if SPANGLE_VERTEX_CACHE != 1

namespace spangle::gl {

/// Empties the cache and switches it to positions of Vertex commands.
template <class M, class L> void Pipeline<M, L>::cache_positions() {
    for (CachedPosition& p : vertex_cache_.cached_position)
        new (&p) CachedPosition;
    caches_positions_ = true;
}

/// Switches the cache to elements of arrays. Only the part that held positions is emptied.
template <class M, class L> void Pipeline<M, L>::cache_elements() {
    const std::size_t lost =
        caches_window_positions && caches_positions_ ? cached_position_overlap : first_vertices;
    for (std::size_t i = 0; i < lost; ++i)
        new (&vertex_cache_.vertex[i]) Vertex;
    caches_positions_ = false;
}

/// Empties the cache when cache_epoch_ wraps around to 0. Otherwise, old vertices would look valid.
template <class M, class L> void Pipeline<M, L>::clear_cache() {
    if (caches_window_positions && caches_positions_)
        cache_positions();
    else
        cache_elements();
    if constexpr (grows_cache)
        for (std::size_t i = 0; grown_cache_.elements != nullptr && i < vertex_cache; ++i)
            new (&grown_cache_.elements[i]) Vertex;
}

/// Returns the index of a position in the cache. The hash separates positions that are much alike: short
/// fractions, a constant z, points and their mirror images.
template <class M, class L> inline std::uint32_t Pipeline<M, L>::cached_position_index(const Real* position) {
    const std::uint32_t y = position[1].bits;
    const std::uint32_t mixed = position[0].bits + (y << 3) + (y >> 7) + (position[2].bits >> 1);
    return mixed * 0x9E3779B1u >> (32 - std::countr_zero(cached_position_count));
}

/// Does the work of transform_vertex(), or copies the window position that the cache keeps for an equal
/// position. A few vertices between draws of elements do not empty the cache of elements.
template <class M, class L> void Pipeline<M, L>::transform_with_cache(Vertex& v) {
    if (!caches_positions_) {
        if (++immediate_count_ < cached_position_count) [[unlikely]]
            return transform_vertex(v);
        cache_positions();
    }
    CachedPosition& kept = vertex_cache_.cached_position[cached_position_index(v.position)];
    const bool plain = v.position[3] == numeric::one;
    if (plain && kept.cache_epoch == cache_epoch_ && equal_words<3>(kept.position, v.position)) {
        M::take_place(kept.window_position, v.window);
        v.flags = modes_.is_lit() ? uncolored : 0;
        return;
    }
    transform_vertex(v);
    if (!plain || (v.flags & ~uncolored) != 0)
        return;
    for (int i = 0; i < 3; ++i)
        kept.position[i] = v.position[i];
    kept.cache_epoch = cache_epoch_;
    M::keep_place(v.window, kept.window_position);
}

} // namespace spangle::gl

#endif
