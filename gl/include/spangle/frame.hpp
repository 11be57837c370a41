// A frame of a window, whether or not memory holds all of it.
#pragma once

#include <spangle/EGL/egl.h>

namespace spangle {

/// Draws one frame of the window that is current on this thread, and shows it. `draw` is called once where
/// memory holds a whole frame, and once for each band where it does not (EGL_BAND_HEIGHT_SPANGLE): from the
/// top of the window down, each band on its way to the panel while the next one is drawn. GL sees the whole
/// window every time; what lies outside of the band is not drawn, and not read. So `draw` must draw the same,
/// in the same order, whenever it is called with the same frame: it clears what it tests against (and
/// samples), sets the state it relies on, and moves nothing on. Bands know batches of primitives by their
/// number, and leave out those that lie elsewhere. False: eglGetError() tells why, and the next frame sends
/// what this one did not.
bool frame(EGLDisplay display, void (*draw)(void* data), void* data);

/// The same of anything that can be called: `spangle::frame(display, [&] { draw_scene(time); });`
template <class Draw> bool frame(EGLDisplay display, Draw draw) {
    return frame(
        display, [](void* data) { (*static_cast<Draw*>(data))(); }, &draw);
}

} // namespace spangle
