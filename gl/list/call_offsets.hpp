// The arrays of list names that CallLists takes (GL 1.3, 5.4).
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl::list {

bool is_name_type(GLenum type);

/// Element i of an array of `type`, as an offset to LIST_BASE modulo 2^32: floats truncated, n_BYTES most
/// significant byte first.
GLuint name_offset(GLenum type, const void* lists, GLsizei i);

} // namespace spangle::gl::list
