// What GLX draws to: windows, pixmaps and pbuffers, and the EGL surface that each has once something is drawn
// there.
#pragma once

#include <memory>
#include <mutex>

#include "host_sim/dropin/glx_configs.hpp"

namespace spangle::dropin::glx {

enum class Kind { window, pixmap, pbuffer };

struct Target {
    Kind kind = Kind::window;
    XID native = 0;               ///< of the window or pixmap
    bool made = false;            ///< by glXCreateWindow and its like; else a program draws to a plain window
    GLXFBConfig config = nullptr; ///< that its surface has
    EGLSurface surface = EGL_NO_SURFACE;
    int width = 0, height = 0; ///< of a pbuffer
    unsigned long events = 0;
    bool largest = false;
};

/// One lock for what threads share of GLX.
std::recursive_mutex& lock();

/// The drawable of that XID, which is a plain window's where GLX made none of it.
std::shared_ptr<Target> drawable_of(Display* display, GLXDrawable id);
/// Whether GLX made it.
std::shared_ptr<Target> made_drawable(Display* display, GLXDrawable id);

/// A surface for a context of this configuration. EGL_NO_SURFACE, and EGL's error, where there is none.
EGLSurface surface_of(Display* display, Target& drawable, GLXFBConfig config);

/// Drops the targets of a connection that is closed, whose surfaces went with their display of EGL.
void forget_drawables(Display* display);

/// Ends the EGL display of a connection that is about to be closed, and all that GLX made over it.
void forget_connection(Display* display);

} // namespace spangle::dropin::glx
