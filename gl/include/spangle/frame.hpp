// Draws a frame of a window, whether or not memory holds the whole frame.
#pragma once

#include <spangle/EGL/egl.h>

namespace spangle {

/// Draws one frame of the window that is current on this thread, and shows it. Where memory holds a whole
/// frame, `draw` is called once. Else it is called once for each [band](docs/glossary.md#band)
/// (EGL_BAND_HEIGHT_SPANGLE), from the top of the window down; each band is sent to the panel while the next
/// one is drawn.
///
/// GL sees the whole window in every call, but draws and reads only the rows of the band. So all calls for
/// one frame must draw the same, in the same order: `draw` clears the buffers it tests against and samples,
/// sets the state it relies on, and advances no animation. A band knows a batch of primitives by its number,
/// and leaves out batches that lie elsewhere. False: eglGetError() tells why, and the next frame sends what
/// this frame did not.
bool frame(EGLDisplay display, void (*draw)(void* data), void* data);

/// Draws a frame with anything that can be called: `spangle::frame(display, [&] { draw_scene(time); });`
template <class Draw> bool frame(EGLDisplay display, Draw draw) {
    return frame(
        display, [](void* data) { (*static_cast<Draw*>(data))(); }, &draw);
}

} // namespace spangle
