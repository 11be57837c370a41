// What all parts of the pipeline know of the current draw: the context, the modes, the compiled state of
// fragments, and the bands that a callback draws.
//
// The pipeline is a chain of parts, each of which derives from the part beneath:
//   DrawScope <- VertexStage <- Shading <- Clipper <- CaptureSink <- PointSink <- LineSink <- PolygonSink
//   <- PrimitiveSink <- CachedVertices <- ElementBatches <- Pipeline
// A part calls the parts beneath it only. Its using-declarations name what it takes from them.
#pragma once

#include "gl/context/context.hpp"
#include "gl/vertex/draw_modes.hpp"
#include "raster/band/batch_rows.hpp"
#include "raster/primitive/draw.hpp"

namespace spangle::gl {

class DrawScope {
  protected:
    static constexpr bool skips_batches = SPANGLE_FEATURE_BANDS != 0;

    Context* context_ = nullptr;
    /// Batches of the drawable while a callback draws its bands, else null. It is null in render modes SELECT
    /// and FEEDBACK, too.
    raster::BatchRows* batches_ = nullptr;
    const raster::DrawState* state_ = nullptr;
    DrawModes modes_;

    /// Begins a batch if a callback draws bands. True: no part of the batch reaches the current band.
    bool begins_outside_band([[maybe_unused]] const Context& context) {
        if constexpr (skips_batches) {
            batches_ = context.render.draws() ? context.drawable.batches : nullptr;
            return batches_ != nullptr && !batches_->begin_batch();
        }
        return false;
    }
    /// True from begin() to end() of a batch that is left out of the current band.
    bool is_outside_band() const { return skips_batches && batches_ != nullptr && batches_->is_skipped(); }
};

} // namespace spangle::gl
