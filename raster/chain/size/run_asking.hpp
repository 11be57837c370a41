// Runs a stage by one loop, which asks whether fragments are alive if the stage has one lane.
#pragma once

#include "raster/chain/run_stage.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

namespace inner {

/// Runs a stage. A stage with one lane always asks whether each fragment is alive. A stage with several lanes
/// works under a mask instead.
template <class M, class K, class S>
SPANGLE_INLINE void run_asking(K& k, S& s, std::int32_t from, std::int32_t to, std::int32_t x0,
                               Outcome& outcome) {
    constexpr bool asks = M::lanes == 1 && (S::kill || S::effect);
    run_stage<asks, M>(k, s, from, to, x0, outcome);
}

} // namespace inner
} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
