// The reference engines: one has the pipeline in double, the other in fixed point with a double twin of each
// number.
#include <new>

#include "gl/context/features.hpp"
#include "gl/vertex/double_math.hpp"
#include "gl/vertex/draw_at_raster_position.hpp"
#include "gl/vertex/engine.hpp"
#include "gl/vertex/pipeline.hpp"
#include "gl/vertex/reference.hpp"
#include "gl/vertex/shadow_math.hpp"
#if SPANGLE_FEATURE_LIGHTING
#include "gl/vertex/double_lighting.hpp"
#include "gl/vertex/shadow_lighting.hpp"
#else
#include "gl/vertex/no_lighting.hpp"
#endif

namespace spangle::gl {

namespace {

template <class P> P& pipeline(Context& context) {
    return *static_cast<P*>(context.pipeline);
}

template <class M, class L> constexpr Engine engine_of() {
    using P = Pipeline<M, L>;
    return {
        sizeof(P), [](void* memory) { new (memory) P; },
            [](const raster::FragmentState& fragment, const raster::Surface& target, raster::DrawState& out) {
                raster::compile<typename M::Window>(fragment, target, out);
            },
            [](Context& context, GLenum mode) { pipeline<P>(context).begin(context, mode); },
            [](Context& context, Real x, Real y, Real z, Real w) {
                pipeline<P>(context).vertex(context, x, y, z, w);
            },
            [](Context& context, std::uint32_t count, const Indices& indices) {
                pipeline<P>(context).elements(context, count, indices);
            },
            [](Context& context) { pipeline<P>(context).end(); },
            [](Context& context) { pipeline<P>(context).settle_colors(); },
#if SPANGLE_FEATURE_DRAW_PIXELS || SPANGLE_FEATURE_BITMAPS
            [](Context& context, const raster::DrawState& state, const raster::Surface& target,
               raster::PixelSource& source) { draw_at_raster_position<M>(context, state, target, source); },
#endif
#if SPANGLE_FEATURE_RASTER_POS
            [](Context& context, const Real(&position)[4]) {
                pipeline<P>(context).raster_position(context, position);
            },
#endif
    };
}

} // namespace

#if SPANGLE_FEATURE_LIGHTING
const Engine double_engine = engine_of<DoubleMath, DoubleLighting>();
const Engine shadow_engine = engine_of<ShadowMath, ShadowLighting>();
#else
const Engine double_engine = engine_of<DoubleMath, NoLighting<DoubleMath>>();
const Engine shadow_engine = engine_of<ShadowMath, NoLighting<ShadowMath>>();
#endif

} // namespace spangle::gl
