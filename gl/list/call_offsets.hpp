// Arrays of list names, which CallLists takes (GL 1.3, 5.4).
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl::list {

bool is_name_type(GLenum type);

/// Returns element i of an array of `type`, as an offset to LIST_BASE modulo 2^32. Floats are truncated, and
/// n_BYTES have the most significant byte first.
GLuint name_offset(GLenum type, const void* lists, GLsizei i);

} // namespace spangle::gl::list
