// Keeps the window positions of vertices that Vertex commands give, in Begin/End or in lists. Models give
// most positions several times, with another normal or for the next face. Such a position is transformed
// once. The same memory caches elements of arrays by index at other times; see VertexCache.
#pragma once

#include "gl/vertex/pipeline.hpp"

#if SPANGLE_VERTEX_CACHE != 1

namespace spangle::gl {

/// Does the work of transform_vertex(), or copies the window position that the cache keeps for an equal
/// position.
template <class M, class L> void Pipeline<M, L>::transform_with_cache(Vertex& v) {
    cache_.place(v, modes_.is_lit() ? uncolored : 0, [this](Vertex& fresh) { transform_vertex(fresh); });
}

} // namespace spangle::gl

#endif
