// Draws a frame of a window, whether or not memory holds the whole frame.
#pragma once

#include <spangle/EGL/egl.h>

namespace spangle {

/// Draws one frame of the window that is current on this thread, and shows it. Where memory holds a whole
/// frame, `draw` is called once. Otherwise it is called once for each [band](docs/glossary.md#band)
/// (EGL_BAND_HEIGHT_SPANGLE), from the top of the window down. Each band is sent to the panel while the next
/// one is drawn.
///
/// GL sees the whole window in every call, but draws and reads only the rows of the band. All calls for one
/// frame must therefore draw the same, in the same order: `draw` clears the buffers it tests against and
/// samples, sets the state it relies on, and advances no animation. Spangle identifies each batch of
/// primitives by its number in the frame, and skips batches that lie outside the band. If the result is
/// false, eglGetError() tells why, and the next frame sends the pixels that this frame did not send.
bool frame(EGLDisplay display, void (*draw)(void* data), void* data);

/// Draws a frame with anything that can be called: `spangle::frame(display, [&] { draw_scene(time); });`
template <class Draw> bool frame(EGLDisplay display, Draw draw) {
    return frame(
        display, [](void* data) { (*static_cast<Draw*>(data))(); }, &draw);
}

} // namespace spangle
