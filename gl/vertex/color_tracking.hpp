// ColorMaterial follows the current colour (GL 1.3, 2.13.3).
#pragma once

#include "gl/context/context.hpp"
#include "gl/context/features.hpp"

namespace spangle::gl {

/// Copies the current colour, which has changed, into the tracked material properties. Only for contexts in
/// which COLOR_MATERIAL is enabled.
void color_changed(Context& context);

/// Called after every change of the current colour, whether COLOR_MATERIAL is enabled or not.
inline void follow_color([[maybe_unused]] Context& context) {
#if SPANGLE_FEATURE_LIGHTING
    if (has_color_material && context.lighting.color_material)
        color_changed(context);
#endif
}

} // namespace spangle::gl
