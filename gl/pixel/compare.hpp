// The comparisons of the alpha, stencil and depth tests (GL 1.3, 4.1.4 to 4.1.6).
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

constexpr bool is_compare(GLenum func) {
    return func >= GL_NEVER && func <= GL_ALWAYS;
}

} // namespace spangle::gl
