// How the rest of GL asks about bands that leave out batches of primitives (raster/band/batch_rows.hpp).
#pragma once

#include "gl/context/context.hpp"
#include "raster/band/batch_rows.hpp"

namespace spangle::gl {

/// Whether the band leaves out the batch that has begun, so that its vertices need no work.
inline bool is_skipped([[maybe_unused]] const Context& context) {
#if SPANGLE_FEATURE_BANDS
    return context.drawable.batches != nullptr && context.drawable.batches->is_skipped();
#else
    return false;
#endif
}

/// Called when the program reads what differs from band to band, because it may then draw other batches.
inline void distrust_batches([[maybe_unused]] Context& context) {
#if SPANGLE_FEATURE_BANDS
    if (context.drawable.batches != nullptr)
        context.drawable.batches->invalidate();
#endif
}

} // namespace spangle::gl
