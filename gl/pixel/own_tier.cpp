#include <spangle/tier.hpp>

#include "gl/context/context.hpp"

namespace spangle {

bool use_tier([[maybe_unused]] const raster::Knobs& knobs) {
#if SPANGLE_OWN_TIERS
    gl::Context* const context = gl::current_context();
    if (context == nullptr || context->inside_begin_end() || !raster::are_valid(knobs))
        return false;
    context->own_tier = true;
    context->knobs = knobs;
    context->changed(gl::dirty_fragment);
    return true;
#else
    return false;
#endif
}

} // namespace spangle
