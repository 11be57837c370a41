#include "gl/egl/configs.hpp"
#include "gl/egl/reference.hpp"
#include "gl/vertex/reference.hpp"

namespace spangle::egl {

void use_reference_engines() {
    register_engine(EGL_PRECISION_DOUBLE_SPANGLE, &gl::double_engine);
    register_engine(EGL_PRECISION_SHADOW_SPANGLE, &gl::shadow_engine);
}

} // namespace spangle::egl
