// Steps from run to run, by one form for all runs.
#pragma once

#include "raster/numeric/bits.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Makes the next run of a row, which begins at pixel `from`. Runs is CoordRuns.
template <class Runs> SPANGLE_INLINE void continue_run(Runs& runs, std::int32_t from) {
    runs.start_clipped_run(from);
}

/// Does nothing, because continue_run() needs nothing prepared where the first run of a row begins.
template <class Runs> SPANGLE_INLINE void prepare_runs(Runs&) {}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
