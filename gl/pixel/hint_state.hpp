// Hints (GL 1.3, 5.6). They choose the accuracy tier, never coverage or depth.
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

struct HintState {
    GLenum perspective_correction = GL_DONT_CARE;
    GLenum point_smooth = GL_DONT_CARE;
    GLenum line_smooth = GL_DONT_CARE;
    GLenum polygon_smooth = GL_DONT_CARE;
    GLenum fog = GL_DONT_CARE;
    GLenum texture_compression = GL_DONT_CARE;
};

} // namespace spangle::gl
