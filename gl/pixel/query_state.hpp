// Occlusion queries (GL 1.5, 4.1.7). Their objects belong to one context.
#pragma once

#include "gl/context/features.hpp"
#include "gl/context/name_table.hpp"
#include "gl/context/types.hpp"
#include "raster/span/draw_state.hpp"

namespace spangle::gl {

#if SPANGLE_FEATURE_QUERIES
struct QueryState {
    NameTable objects; ///< each object is a result, a GLuint in the arena; null: the query has never begun
    GLuint active = 0; ///< name of the active SAMPLES_PASSED query, or 0
    std::uint32_t counted = 0; ///< samples counted by counters that were replaced since the query began
    std::uint32_t start = 0;   ///< value of the present counters when this query began to use them
    raster::Counters counters; ///< used unless a tool has set its own counters
};
#else
struct QueryState {};
#endif

} // namespace spangle::gl
