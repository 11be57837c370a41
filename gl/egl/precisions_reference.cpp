#include <spangle/reference.hpp>

#include "gl/egl/configs.hpp"
#include "gl/vertex/reference.hpp"

namespace spangle {

void use_reference_engines() {
    egl::register_engine(EGL_PRECISION_DOUBLE_SPANGLE, &gl::double_engine);
    egl::register_engine(EGL_PRECISION_SHADOW_SPANGLE, &gl::shadow_engine);
}

} // namespace spangle
