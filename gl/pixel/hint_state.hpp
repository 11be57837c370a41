// Hints (GL 1.3, 5.6; GL 1.4, 5.6). They choose the accuracy tier, and never change coverage or depth.
#pragma once

#include "gl/context/features.hpp"
#include "gl/context/types.hpp"

namespace spangle::gl {

/// Indices of hints. The first five are in the order of their tokens.
enum HintIndex : unsigned {
    hint_perspective_correction,
    hint_point_smooth,
    hint_line_smooth,
    hint_polygon_smooth,
    hint_fog,
    hint_texture_compression,
#if SPANGLE_FEATURE_MIPMAP_GENERATION
    hint_generate_mipmap,
#endif
    hints,
};

struct HintState {
    constexpr HintState() {
        for (GLenum& each : mode)
            each = GL_DONT_CARE;
    }

    GLenum mode[hints];
};

} // namespace spangle::gl
