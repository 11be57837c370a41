// glXGetProcAddress: finds every function of GLX and of GL (GLX 1.4, 3.3.12).
#include <cstring>

#include <spangle/EGL/egl.h>

#include "host_sim/dropin/glx.hpp"

namespace {

struct Entry {
    const char* name;
    GLXProc function;
};

const Entry table[] = {
#define F(returns, name, parameters) {#name, reinterpret_cast<GLXProc>(&name)},
#include "host_sim/dropin/glx_functions.inc"
#undef F
};

} // namespace

extern "C" {

GLXProc glXGetProcAddress(const GLubyte* name) {
    const char* const text = reinterpret_cast<const char*>(name);
    if (text == nullptr)
        return nullptr;
    for (const Entry& entry : table)
        if (std::strcmp(entry.name, text) == 0)
            return entry.function;
    return std::strncmp(text, "gl", 2) == 0 ? eglGetProcAddress(text) : nullptr;
}

GLXProc glXGetProcAddressARB(const GLubyte* name) {
    return glXGetProcAddress(name);
}
}
