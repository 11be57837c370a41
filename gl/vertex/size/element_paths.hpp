// Draws elements of arrays from the cache of vertices, one by one.
#pragma once

#include "gl/vertex/current_element.hpp"

namespace spangle::gl {

/// Draws elements through the cache of vertices. Returns false: take_cached() takes them one by one.
template <class Pipeline>
SPANGLE_INLINE bool draw_cached(Pipeline&, Context&, const ElementReader&, std::uint32_t, const Indices&) {
    return false;
}

/// Takes one element from the cache, among those that are drawn one by one. Returns false where its state
/// does not allow that.
template <class Pipeline>
SPANGLE_INLINE bool take_cached(Pipeline& to, const CurrentState& current, std::uint32_t index,
                                const Real (&position)[4]) {
    if (to.modes_.needs_vertex_state())
        return false;
    to.next_element(current, to.cache_.element(index), position);
    return true;
}

} // namespace spangle::gl
