// The framebuffer configurations of GLX: each config of EGL, with each combination of what only GLX counts:
// one or two buffers, and accumulation.
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

/// The initialised EGL display of this connection; EGL_NO_DISPLAY where that is not possible.
EGLDisplay egl_display(Display* display);

/// All configurations of a screen, in the order in which GLX prefers them. The list is empty for no such
/// screen.
const std::vector<SpangleFbConfig>& configs(Display* display, int screen);

/// Reads the value of an attribute. Returns false where there is no such attribute.
bool attribute(const SpangleFbConfig& config, int name, int& value);

/// The configuration of windows with this visual. Where several configurations share the visual, it is the
/// one last chosen.
GLXFBConfig of_visual(Display* display, int screen, VisualID visual);
void remember_choice(const SpangleFbConfig& config);

/// Drops the configurations of a connection that is closed.
void forget_configs(Display* display);

/// The configuration that a program's handle stands for; null where the handle is not from this library.
GLXFBConfig checked(Display* display, GLXFBConfig config);

} // namespace spangle::dropin::glx
