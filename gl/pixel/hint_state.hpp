// Hints (GL 1.3, 5.6). They choose the accuracy tier, never coverage or depth.
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

/// In the order of their tokens; that of texture compression has another place among those.
enum HintIndex : unsigned {
    hint_perspective_correction,
    hint_point_smooth,
    hint_line_smooth,
    hint_polygon_smooth,
    hint_fog,
    hint_texture_compression,
    hints,
};

struct HintState {
    GLenum mode[hints] = {GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE};
};

} // namespace spangle::gl
