// What is wrong with the arguments of PixelMap, for the command and for its record in a display list.
#pragma once

#include "gl/pixel/pixel_mode_state.hpp"

namespace spangle::gl {

/// NO_ERROR, or what the command raises.
GLenum pixel_map_error(GLenum map, GLsizei size, const Values& values);

} // namespace spangle::gl
