// RasterPos and WindowPos (GL 1.3, 2.12; GL 1.4, 2.13).
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_RASTER_POS

#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/vertex/capture.hpp"
#include "gl/vertex/engine.hpp"

namespace spangle::gl::cmd {

void RasterPos(Context& context, Real x, Real y, Real z, Real w) {
    context.engine->raster_position(context, {x, y, z, w});
}

/// Sets the raster position from window coordinates. Only z is transformed, by the depth range; there is no
/// lighting and no clipping (GL 1.4, 2.13).
void WindowPos(Context& context, Real x, Real y, Real z) {
    const CurrentState& current = context.current;
    const Real near = context.transform.depth_range[0], far = context.transform.depth_range[1];
    RasterPosition& raster = context.current.raster;
    raster.position[0] = x;
    raster.position[1] = y;
    raster.position[2] = numeric::add(near, numeric::mul(numeric::clamp01(z), numeric::sub(far, near)));
    raster.position[3] = numeric::one;
    raster.distance = context.fog.source == GL_FOG_COORDINATE ? current.fog_coord : numeric::zero;
    if (is_indexed(context.drawable))
        raster.index = current.index;
    else
        for (int c = 0; c < 4; ++c)
            raster.color[c] = numeric::clamp01(current.color[c]);
    for (int u = 0; u < texture_units; ++u)
        for (int c = 0; c < 4; ++c)
            raster.tex_coord[u].v[c] = current.tex_coord[u].v[c];
    raster.valid = true;
#if SPANGLE_FEATURE_SELECTION
    if (context.render.mode == GL_SELECT) {
        const std::uint32_t depth = numeric::to_unit(raster.position[2], 32);
        record_hit(context, depth);
    }
#endif
}

} // namespace spangle::gl::cmd

#endif
