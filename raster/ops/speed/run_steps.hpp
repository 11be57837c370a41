// Steps from run to run, with a short form for runs that the row does not cut.
#pragma once

#include "raster/numeric/bits.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Makes the next run of a row, which begins at pixel `from`. Runs is CoordRuns.
template <class Runs> SPANGLE_INLINE void continue_run(Runs& runs, std::int32_t from) {
    if (runs.is_whole_run()) [[likely]]
        runs.make_whole_run();
    else
        runs.start_clipped_run(from);
}

/// Prepares continue_run() where the first run of a row begins.
template <class Runs> SPANGLE_INLINE void prepare_runs(Runs& runs) {
    runs.set_run_steps();
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
