// Checks the arguments of PixelMap, for the command and for its record in a display list.
#pragma once

#include "gl/context/error.hpp"
#include "gl/pixel/pixel_mode_state.hpp"

namespace spangle::gl {

/// Returns NO_ERROR, or the error that the command raises.
GLenum pixel_map_error(GLenum map, GLsizei size, const Values& values);

/// The rule that an INVALID_VALUE of pixel_map_error() breaks, for messages; null when a pointer is null.
inline const char* pixel_map_rule([[maybe_unused]] const Values& values) {
    return values.at == nullptr
               ? nullptr
               : SPANGLE_TEXT("a map has 1 to 256 entries, a power of two where indices address them");
}

} // namespace spangle::gl
