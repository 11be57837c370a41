// Tells all parts of GL whether a band leaves out a batch of primitives (raster/band/batch_rows.hpp).
#pragma once

#include "gl/context/context.hpp"
#include "raster/band/batch_rows.hpp"

namespace spangle::gl {

/// True if the band leaves out the batch that has begun, so that its vertices need no work.
inline bool is_skipped([[maybe_unused]] const Context& context) {
#if SPANGLE_FEATURE_BANDS
    return context.drawable.batches != nullptr && context.drawable.batches->is_skipped();
#else
    return false;
#endif
}

/// Makes the table of batches invalid when the program reads something that differs from band to band. The
/// program may then draw other batches.
inline void distrust_batches([[maybe_unused]] Context& context) {
#if SPANGLE_FEATURE_BANDS
    if (context.drawable.batches != nullptr)
        context.drawable.batches->invalidate();
#endif
}

} // namespace spangle::gl
