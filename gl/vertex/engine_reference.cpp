// The reference engine: the same pipeline over double.
#include <new>

#include "gl/vertex/double_lighting.hpp"
#include "gl/vertex/double_math.hpp"
#include "gl/vertex/engine.hpp"
#include "gl/vertex/pipeline.hpp"
#include "gl/vertex/reference.hpp"

namespace spangle::gl {

namespace {

using DoublePipeline = Pipeline<DoubleMath, DoubleLighting>;

DoublePipeline& pipeline(Context& context) {
    return *static_cast<DoublePipeline*>(context.pipeline);
}

} // namespace

const Engine double_engine = {
    sizeof(DoublePipeline),
    [](void* memory) { new (memory) DoublePipeline; },
    [](const raster::FragmentState& fragment, const raster::Surface& target, raster::DrawState& out) {
        out = raster::compile<raster::DoubleVertex>(fragment, target);
    },
    [](Context& context, GLenum mode) { pipeline(context).begin(context, mode); },
    [](Context& context, Real x, Real y, Real z, Real w) {
        pipeline(context).vertex(context, {x, y, z, w});
    },
    [](Context& context) { pipeline(context).end(); },
    [](Context& context) { pipeline(context).settle_colors(); },
};

} // namespace spangle::gl
