// What a context begins as (GL 1.3, tables 6.5 to 6.33).
#pragma once

#include "gl/context/context.hpp"

namespace spangle::gl {

/// Makes a context in memory of that size, whose bytes are 0. Entries of matrix stacks above their top are
/// written before they are read, and so is what is compiled of fragments' state and derived of textures.
Context* begin_context(void* memory);

} // namespace spangle::gl
