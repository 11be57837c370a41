// Draws elements of arrays from the cache of vertices, all elements of a draw at once.
#pragma once

#include "gl/vertex/current_element.hpp"

namespace spangle::gl {

/// Draws elements through the cache of vertices. Returns false where their state does not allow that.
template <class Pipeline>
SPANGLE_INLINE bool draw_cached(Pipeline& to, Context& context, const ElementReader& reader,
                                std::uint32_t count, const Indices& indices) {
    if (to.modes_.needs_vertex_state() || reader.seldom != nullptr || !reader.vertex.on())
        return false;
    to.draw_cached_elements(context, reader, count, indices);
    return true;
}

/// Takes one element from the cache, among those that are drawn one by one. Returns false: draw_cached() has
/// drawn all elements that the cache may hold.
template <class Pipeline>
SPANGLE_INLINE bool take_cached(Pipeline&, const CurrentState&, std::uint32_t, const Real (&)[4]) {
    return false;
}

} // namespace spangle::gl
