// What the rest of GL knows of bands that leave out batches of primitives (raster/band/batch_rows.hpp).
#pragma once

#include "gl/context/context.hpp"
#include "raster/band/batch_rows.hpp"

namespace spangle::gl {

/// Nothing comes of the vertices of the batch that has begun, because the band leaves it out.
inline bool leaves_out([[maybe_unused]] const Context& context) {
#if SPANGLE_FEATURE_BANDS
    return context.drawable.batches != nullptr && context.drawable.batches->leaves_out();
#else
    return false;
#endif
}

/// The program is told what differs from band to band, and may draw by it.
inline void distrust_batches([[maybe_unused]] Context& context) {
#if SPANGLE_FEATURE_BANDS
    if (context.drawable.batches != nullptr)
        context.drawable.batches->distrust();
#endif
}

} // namespace spangle::gl
