// What GLX draws to: windows, pixmaps and pbuffers, and the EGL surface that each has from its first drawing
// on.
#pragma once

#include <memory>
#include <mutex>

#include "host_sim/dropin/glx_configs.hpp"

namespace spangle::dropin::glx {

enum class Kind { window, pixmap, pbuffer };

struct Target {
    Kind kind = Kind::window;
    XID native = 0;    ///< id of the window or pixmap in X
    bool made = false; ///< made by glXCreateWindow or its like; false: a plain window of the program
    GLXFBConfig config = nullptr; ///< configuration of the drawable's surface
    EGLSurface surface = EGL_NO_SURFACE;
    int width = 0, height = 0; ///< size of a pbuffer, in pixels
    unsigned long events = 0;
    bool largest = false;
};

/// The lock of everything that threads share of GLX.
std::recursive_mutex& lock();

/// The drawable of that XID. An XID that GLX does not know stands for a plain window, which is added.
std::shared_ptr<Target> drawable_of(Display* display, GLXDrawable id);
/// The drawable of that XID if GLX knows it; else null.
std::shared_ptr<Target> made_drawable(Display* display, GLXDrawable id);

/// The surface of the drawable for a context of this configuration. Where there is none, returns
/// EGL_NO_SURFACE, and EGL has the error.
EGLSurface surface_of(Display* display, Target& drawable, GLXFBConfig config);

/// Drops the drawables of a connection that is closed, whose surfaces ended with their EGL display.
void forget_drawables(Display* display);

/// Ends the EGL display of a connection that is about to be closed, and all that GLX made on it.
void forget_connection(Display* display);

} // namespace spangle::dropin::glx
