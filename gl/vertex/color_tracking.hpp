// Updates the material properties that follow the current colour (ColorMaterial; GL 1.3, 2.13.3).
#pragma once

#include "gl/context/context.hpp"
#include "gl/context/features.hpp"

namespace spangle::gl {

/// Copies the current colour, which has changed, to the tracked material properties. COLOR_MATERIAL must be
/// enabled.
void color_changed(Context& context);

/// Updates tracked material properties after a change of the current colour. It does nothing unless
/// COLOR_MATERIAL is enabled.
inline void follow_color([[maybe_unused]] Context& context) {
#if SPANGLE_FEATURE_LIGHTING
    if (has_color_material && context.lighting.color_material)
        color_changed(context);
#endif
}

} // namespace spangle::gl
