// Stands in for functions of later versions of OpenGL. A program that is linked to be bound at once starts
// only where all functions it names exist, called or not. A call raises INVALID_OPERATION; eglGetProcAddress
// and glXGetProcAddress do not find these functions.
#include <cstdint>

#include <spangle/GL/gl.h>

#include "gl/api/issue.hpp"
#include "gl/context/error.hpp"
#include "host_sim/dropin/capture.hpp"

extern "C" {

__attribute__((used)) std::intptr_t spangle_dropin_later();

std::intptr_t spangle_dropin_later() {
    if (spangle::dropin::Capture* const capture = spangle::dropin::Capture::get())
        capture->note_missing_function();
    spangle::gl::refuse_feature(SPANGLE_TEXT("a function of OpenGL 2.0 or later; GL_VERSION is 1.x"));
    return 0;
}

#define LATER(name) GLAPI std::intptr_t name() __attribute__((alias("spangle_dropin_later")));
#include "host_sim/dropin/later_functions.inc"
#undef LATER
}
