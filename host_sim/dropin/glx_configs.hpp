// The framebuffer configurations of GLX: what EGL's configs say, times what GLX counts in: one or two
// buffers, accumulation.
#pragma once

#include <vector>

#include <spangle/EGL/egl.h>

#include "host_sim/dropin/glx.hpp"

struct SpangleFbConfig {
    int id;
    EGLConfig egl;
    int red, green, blue, alpha, depth, stencil, accum, samples;
    bool double_buffered;
    int screen;
    Visual* visual;
    VisualID visual_id;
    int visual_depth;
};

namespace spangle::dropin::glx {

/// EGL's display of this connection, initialised; EGL_NO_DISPLAY where that is not possible.
EGLDisplay egl_display(Display* display);

/// All configurations of a screen, in the order in which GLX prefers them; none: no such screen.
const std::vector<SpangleFbConfig>& configs(Display* display, int screen);

/// The value of an attribute; false where there is no such attribute.
bool attribute(const SpangleFbConfig& config, int name, int& value);

/// The configuration that windows of this visual have: the one that was last chosen for it, where several
/// share it.
GLXFBConfig of_visual(Display* display, int screen, VisualID visual);
void remember_choice(const SpangleFbConfig& config);

/// Drops the configurations of a connection that is closed.
void forget_configs(Display* display);

/// A handle that a program gave; null where it is none of ours.
GLXFBConfig checked(Display* display, GLXFBConfig config);

} // namespace spangle::dropin::glx
