// The initial state of a context (GL 1.3, tables 6.5 to 6.33).
#pragma once

#include "gl/context/context.hpp"

namespace spangle::gl {

/// Makes a context in zeroed memory of its size. Members that are written before they are read have no
/// initial value: matrix stack entries above the top, compiled fragment state, and state derived from
/// textures.
Context* begin_context(void* memory);

} // namespace spangle::gl
