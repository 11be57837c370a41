// The engine of the product: the pipeline in fixed point.
#include <type_traits>

#include "gl/context/features.hpp"
#include "gl/vertex/draw_at_raster_position.hpp"
#include "gl/vertex/engine.hpp"
#include "gl/vertex/fixed_math.hpp"
#include "gl/vertex/pipeline.hpp"
#if SPANGLE_FEATURE_LIGHTING
#include "gl/vertex/fixed_lighting.hpp"
#else
#include "gl/vertex/no_lighting.hpp"
#endif

namespace spangle::gl {

namespace {

#if SPANGLE_FEATURE_LIGHTING
using FixedPipeline = Pipeline<FixedMath, FixedLighting>;
#else
using FixedPipeline = Pipeline<FixedMath, NoLighting<FixedMath>>;
#endif

FixedPipeline& pipeline(Context& context) {
    return *static_cast<FixedPipeline*>(context.pipeline);
}

#ifdef SPANGLE_FIRMWARE
#define OF_ENGINE Engine::
} // namespace
#else
#define OF_ENGINE
#endif

/// Does nothing, since the memory is 0 already. Each member of the pipeline begins as 0 or is derived before
/// use. A constructor would clear the pipeline member by member, which takes more code.
void OF_ENGINE construct(void*) {
    // Zero bytes are a valid pipeline.
    static_assert(std::is_trivially_copyable_v<FixedPipeline>);
}

void OF_ENGINE compile(const raster::FragmentState& fragment, const raster::Surface& target,
                       raster::DrawState& out) {
    raster::compile<raster::FixedVertex>(fragment, target, out);
}

void OF_ENGINE begin(Context& context, GLenum mode) {
    pipeline(context).begin(context, mode);
}

void OF_ENGINE vertex(Context& context, Real x, Real y, Real z, Real w) {
    pipeline(context).vertex(context, x, y, z, w);
}

void OF_ENGINE elements(Context& context, std::uint32_t count, const Indices& indices) {
    pipeline(context).elements(context, count, indices);
}

void OF_ENGINE end(Context& context) {
    pipeline(context).end();
}

void OF_ENGINE settle_colors(Context& context) {
    pipeline(context).settle_colors();
}

#if SPANGLE_FEATURE_DRAW_PIXELS || SPANGLE_FEATURE_BITMAPS
void OF_ENGINE pixels(Context& context, const raster::DrawState& state, const raster::Surface& target,
                      raster::PixelSource& source) {
    draw_at_raster_position<FixedMath>(context, state, target, source);
}
#endif

#if SPANGLE_FEATURE_RASTER_POS
void OF_ENGINE raster_position(Context& context, const Real (&position)[4]) {
    pipeline(context).raster_position(context, position);
}
#endif

#ifdef SPANGLE_FIRMWARE
const std::size_t Engine::pipeline_bytes = sizeof(FixedPipeline);
const Engine fixed_engine{};
#else
} // namespace

const Engine fixed_engine = {
    sizeof(FixedPipeline),
    construct,
    compile,
    begin,
    vertex,
    elements,
    end,
    settle_colors,
#if SPANGLE_FEATURE_DRAW_PIXELS || SPANGLE_FEATURE_BITMAPS
    pixels,
#endif
#if SPANGLE_FEATURE_RASTER_POS
    raster_position,
#endif
};
#endif

} // namespace spangle::gl
