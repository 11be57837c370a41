// What EGL's handles stand for, and how a handle is told from garbage: every object is on its display's list.
#pragma once

#include <cstdint>

#include <spangle/EGL/egl.h>
#include <spangle/format.hpp>
#include <spangle/hal/display.hpp>

#include "gl/context/arena.hpp"
#include "gl/context/create.hpp"

namespace spangle::egl {

struct Config {
    EGLint id = 0;
    PixelFormat format{};
    DepthFormat depth{};
    EGLint precision = EGL_PRECISION_EXACT_SPANGLE;
};

struct Surface {
    Surface* next = nullptr;
    Config config;
    std::int32_t width = 0, height = 0;
    bool window = false, destroyed = false;
    bool wants_single = false;     ///< EGL_RENDER_BUFFER was EGL_SINGLE_BUFFER
    bool back_buffered = false;    ///< SwapBuffers shows what was drawn; else Flush does
    unsigned bindings = 0;         ///< contexts it is current to
    std::uint8_t* color = nullptr; ///< a pbuffer's own; a window's belongs to the display
    std::uint8_t* depth = nullptr;
    std::int16_t* accum = nullptr;
    hal::Frame frame; ///< of a window
};

struct Context {
    Context* next = nullptr;
    Config config;
    gl::Context* gl = nullptr;
    bool current = false, destroyed = false;
};

struct Display {
    hal::Display* native = nullptr; ///< null: off-screen only
    bool used = false, initialized = false;
    Surface* surfaces = nullptr;
    Context* contexts = nullptr;
};

/// What is current on this thread.
struct Thread {
    EGLint error = EGL_SUCCESS;
    Display* display = nullptr;
    Context* context = nullptr;
    Surface* draw = nullptr;
    Surface* read = nullptr;
};
Thread& thread();

/// Records an error with a text for spangle::on_message; null for no text. Returns EGL_FALSE.
EGLBoolean fail(EGLint error, const char* text = nullptr);
EGLBoolean succeed();

/// The display behind a handle, or null with BAD_DISPLAY or NOT_INITIALIZED recorded.
Display* find_display(EGLDisplay handle);
Surface* find_surface(Display& display, EGLSurface handle);
Context* find_context(Display& display, EGLContext handle);

/// The one memory of the program.
gl::Arena& arena();

/// A surface's memory.
void free_surface(Surface* surface);

/// Frees the object when nothing holds it any more.
void release(Display& display, Surface* surface);
void release(Display& display, Context* context);

/// The pixels of a surface as the rasterizer sees them: GL's rows count from the bottom.
raster::Surface pixels_of(const Surface& surface);

/// Hands the surfaces of this thread to its context; again after a window got another buffer.
void attach_surfaces();

/// Presents what was drawn to a window of this thread and attaches the next frame's buffer.
bool present(Display& display, Surface& surface);

/// What Flush and Finish do to the window that is current on this thread, if there is one: shown when it has
/// no back buffer; with `finish`, waited for.
void show_window(bool finish);

/// Undoes MakeCurrent on this thread.
void release_current();

} // namespace spangle::egl
