// Keeps vertices given by themselves, in Begin/End or lists. Models give most positions several times, with
// another normal or for the next face, and the window position is not computed again. The cache finds
// elements by index and these vertices by position, in the same memory.
#pragma once

#include "gl/vertex/pipeline.hpp"

#if SPANGLE_VERTEX_CACHE != 1

namespace spangle::gl {

/// Empties the cache; from now on it keeps vertices given by themselves.
template <class M, class L> void Pipeline<M, L>::keep_placed() {
    for (Placed& p : kept_.placed)
        new (&p) Placed;
    keeps_placed_ = true;
}

/// From now on the cache keeps elements. Only the part that held vertices given by themselves is emptied.
template <class M, class L> void Pipeline<M, L>::keep_elements() {
    const std::size_t lost = keeps_places && keeps_placed_ ? placed_overlap : first_vertices;
    for (std::size_t i = 0; i < lost; ++i)
        new (&kept_.vertex[i]) Vertex;
    keeps_placed_ = false;
}

/// Empties the cache, since now_ starts again and old vertices would look valid.
template <class M, class L> void Pipeline<M, L>::forget_all() {
    if (keeps_places && keeps_placed_)
        keep_placed();
    else
        keep_elements();
    if constexpr (grows_cache)
        for (std::size_t i = 0; grown_.elements != nullptr && i < vertex_cache; ++i)
            new (&grown_.elements[i]) Vertex;
}

/// A place in the cache for a position. Positions are much alike: short fractions, a constant z, points and
/// their mirror images.
template <class M, class L> inline std::uint32_t Pipeline<M, L>::placed_index(const Real* position) {
    const std::uint32_t y = position[1].bits;
    const std::uint32_t mixed = position[0].bits + (y << 3) + (y >> 7) + (position[2].bits >> 1);
    return mixed * 0x9E3779B1u >> (32 - std::countr_zero(placed_count));
}

/// Does the work of process(); a position that was given before gets the window position kept for it. A few
/// vertices between draws of elements do not empty the cache of elements.
template <class M, class L> void Pipeline<M, L>::place(Vertex& v) {
    if (!keeps_placed_) {
        if (++in_turn_ < placed_count) [[unlikely]]
            return process(v);
        keep_placed();
    }
    Placed& kept = kept_.placed[placed_index(v.position)];
    const bool plain = v.position[3] == numeric::one;
    if (plain && kept.time == now_ && same<3>(kept.position, v.position)) {
        M::take_place(kept.place, v.window);
        v.flags = lit_ ? uncolored : 0;
        return;
    }
    process(v);
    if (!plain || (v.flags & ~uncolored) != 0)
        return;
    for (int i = 0; i < 3; ++i)
        kept.position[i] = v.position[i];
    kept.time = now_;
    M::keep_place(v.window, kept.place);
}

} // namespace spangle::gl

#endif
