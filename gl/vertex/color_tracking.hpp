// ColorMaterial follows the current colour (GL 1.3, 2.13.3).
#pragma once

#include "gl/context/context.hpp"
#include "gl/context/features.hpp"

namespace spangle::gl {

/// The current colour has changed while COLOR_MATERIAL is enabled: the tracked properties follow at once.
void color_changed(Context& context);

/// The same for every change.
inline void follow_color([[maybe_unused]] Context& context) {
#if SPANGLE_FEATURE_LIGHTING
    if (has_color_material && context.lighting.color_material)
        color_changed(context);
#endif
}

} // namespace spangle::gl
