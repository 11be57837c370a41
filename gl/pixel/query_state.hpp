// Occlusion queries (GL 1.5, 4.1.7). Their objects belong to one context.
#pragma once

#include "gl/context/features.hpp"
#include "gl/context/name_table.hpp"
#include "gl/context/types.hpp"
#include "raster/span/draw_state.hpp"

namespace spangle::gl {

#if SPANGLE_FEATURE_QUERIES
struct QueryState {
    NameTable objects;         ///< to the result, a GLuint in the arena; null until the query has begun once
    GLuint active = 0;         ///< SAMPLES_PASSED: what counts now; 0: nothing
    std::uint32_t counted = 0; ///< by counters that were taken away since
    std::uint32_t start = 0;   ///< what the counters had counted before
    raster::Counters counters; ///< where no tool brought its own
};
#else
struct QueryState {};
#endif

} // namespace spangle::gl
