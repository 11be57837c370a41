// Display list state: base, the list being compiled, nesting (GL 1.3, 5.4).
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

struct ListState {
    GLuint base = 0;
};

} // namespace spangle::gl
