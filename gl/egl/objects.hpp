// The objects behind EGL's handles. A handle is checked by looking it up on its display's list.
#pragma once

#include <cstdint>

#include <spangle/EGL/egl.h>
#include <spangle/format.hpp>
#include <spangle/hal/display.hpp>
#include <spangle/hal/window_system.hpp>

#include "gl/context/arena.hpp"
#include "gl/context/create.hpp"
#include "gl/context/features.hpp"
#include "gl/context/threads.hpp"
#include "raster/surface/samples.hpp"

namespace spangle::egl {

struct Config {
    EGLint id = 0;
    PixelFormat format{};
    DepthFormat depth{};
    bool multisampled = false;
    EGLint precision = EGL_PRECISION_EXACT_SPANGLE;

    bool has_samples() const { return raster::has_samples && multisampled; }
    /// The colour format of a surface of this config, which must exist. It is a constant in builds with one
    /// format.
    PixelFormat drawn() const { return raster::drawn(format); }
};

/// Bits of each component of an accumulation buffer.
inline constexpr EGLint accum_bits = 16;

struct RecordedFrame; // recorded_frame.cpp defines it
struct Display;

/// The rows of a window in bands that are in memory.
struct Band {
#if SPANGLE_FEATURE_BANDS
    /// Height of a band: the number of rows of depth, stencil and accumulation in memory. 0: the whole
    /// window.
    std::int32_t height = 0;
    /// True if the colour buffer holds one band only, as the display's buffers do.
    bool colors = false;
    std::int32_t first = 0, rows = 0; ///< rows of the open band, counted from the top
    RowExtents extents;               ///< columns touched in each row of the open band
    /// Record of drawing commands. Null: a callback draws each band.
    RecordedFrame* record = nullptr;
    /// Rows that each batch reaches. Null: every band draws all batches.
    raster::BatchRows* batches = nullptr;
    /// True if every band of this frame so far was cleared to clear_value.
    bool cleared = false;
    std::uint32_t clear_value = 0;
#else
    static constexpr std::int32_t height = 0, first = 0;
    static constexpr bool colors = false;
    static constexpr RecordedFrame* record = nullptr;
#endif
};

struct Surface {
    Surface* next = nullptr;
    Config config;
    std::int32_t width = 0, height = 0;
    /// True if the handle is invalid. The memory is freed when nothing holds the surface.
    bool destroyed = false;
    bool window = false; ///< true for windows, and pixmaps of a window system; false for pbuffers
#if SPANGLE_HAS_PLATFORMS
    /// The window system that opened `native` and closes it. Null: `native` is unused.
    hal::WindowSystem* system = nullptr;
    hal::Display* native = nullptr;
    std::uintptr_t native_handle = 0; ///< the window system's handle of the window or pixmap
    bool pixmap = false;
    /// True if SwapBuffers was called for this pbuffer, so that Flush does not show it any more.
    bool swapped = false;
#endif
    bool wants_single = false; ///< true if EGL_RENDER_BUFFER was EGL_SINGLE_BUFFER
    /// True if SwapBuffers shows a window's picture, and false if Flush shows it.
    bool back_buffered = true;
    /// True if the window has lost its pixels and is never shown again, because its display was terminated or
    /// shows another window. Writers hold a Registry and the display's native_lock; readers hold either.
    bool cut_off = false;
    /// Counts how often a context has the surface as its draw or read surface.
    unsigned bindings = 0;
    unsigned frames = 0; ///< number of calls of spangle::frame that draw the surface
    std::uint8_t* depth = nullptr;
    std::int16_t* accum = nullptr;
    std::uint8_t* sample_colors = nullptr; ///< one colour plane per sample; null: not multisampled
    RowSpan* unresolved = nullptr;         ///< columns of each row in memory that wait for resolve()
    raster::Samples samples;
    /// The colour buffer, which a window gets from its display. No pixels: there is no buffer.
    hal::Frame frame;
    [[no_unique_address]] Band band;

    bool in_bands() const {
        return SPANGLE_FEATURE_BANDS && band.height != 0;
    }
    /// True if there is a buffer to draw to, or if opening a band will give one.
    bool has_pixels() const {
        return !cut_off && (frame.pixels != nullptr || in_bands());
    }
};

struct Context {
    Context* next = nullptr;
    Config config;
    gl::Context* gl = nullptr;
    bool destroyed = false;
    bool current = false;
};

struct Display {
    hal::Display* native = nullptr; ///< the panel, or null for a window system or for pbuffers only
#if SPANGLE_HAS_PLATFORMS
    hal::WindowSystem* system = nullptr; ///< the window system, or null for a panel or for pbuffers only
#endif
    bool used = false, initialized = false;
    /// True if eglTerminate came after the last eglGetDisplay or eglInitialize. The entry may then be reused.
    bool terminated = false;
    /// Lock for calls of `native` and of displays that a window system opened, which serve one thread at a
    /// time. While a thread holds it, it may take no other lock but the arena's.
    [[no_unique_address]] gl::Lock native_lock;
    Surface* surfaces = nullptr;
    Context* contexts = nullptr;
    /// Frees destroyed objects that nothing holds any more. It is null until an object is first destroyed, so
    /// that a program that destroys nothing does not link that code.
    void (*free_unused_objects)(Display&) = nullptr;
};

#if SPANGLE_THREADS
extern gl::Lock registry_lock;
/// Excludes other threads while it lives. A thread must have one to read or write displays, their lists of
/// objects, or the counts of holders of an object. Its lock is taken before every other lock.
struct Registry : gl::LockGuard {
    Registry() : LockGuard(registry_lock) {}
};
#else
struct Registry {
    Registry() {}
};
#endif

/// The error and the current objects of this thread.
struct Thread {
    EGLint error = EGL_SUCCESS;
    Display* display = nullptr;
    Context* context = nullptr;
    Surface* draw = nullptr;
    Surface* read = nullptr;
};
Thread& thread();

/// Records an error and returns EGL_FALSE. `rule` is a SPANGLE_TEXT for spangle::on_message, without the
/// command's name. Null: the message has been sent.
EGLBoolean fail(EGLint error, const char* rule);

#if SPANGLE_MESSAGES
/// Sets the name of the command that this thread runs, which begins its messages.
void begin_call(const char* command);
#else
inline void begin_call(const char*) {}
#endif

EGLBoolean end_call();

/// Returns the entry of a panel or of a window system, and makes one if needed. EGL_NO_DISPLAY: all entries
/// are used.
EGLDisplay display_of(hal::Display* native, hal::WindowSystem* system);
/// Returns the display of a native one, for eglGetDisplay and eglGetPlatformDisplay.
EGLDisplay platform_display(EGLenum platform, void* native);
/// True if the current context is between glBegin and glEnd. Its surfaces then stay current, and nothing is
/// shown. Commands that would change this fail with fail_in_primitive().
bool in_primitive();
EGLBoolean fail_in_primitive();

/// Returns the display of a handle, initialized or not. Null: BAD_DISPLAY is recorded.
Display* find_entry(EGLDisplay handle);
/// Returns the initialized display of a handle. Null: BAD_DISPLAY or NOT_INITIALIZED is recorded.
Display* find_display(EGLDisplay handle);
Surface* find_surface(Display& display, EGLSurface handle);
Context* find_context(Display& display, EGLContext handle);

/// The arena that all memory of the library comes from.
gl::Arena& arena();

/// Frees a surface with its planes, and closes the native window that was opened for it.
void free_surface(Surface* surface);

/// Makes planes and a buffer of the new size for a window that its window system has resized. False: there is
/// no memory or the window is gone, the error is recorded, and the surface keeps its size.
bool follow_window(Display& display, Surface& surface);

/// Creates a window or pixmap surface, for eglCreateWindowSurface and eglCreatePixmapSurface.
EGLSurface create_shown(EGLDisplay dpy, EGLConfig config, std::uintptr_t handle, bool pixmap,
                        const EGLint* attrib_list);

/// Frees objects that are marked as destroyed, at once or as soon as nothing holds them.
void free_destroyed(Display& display);

constexpr std::int32_t bytes_per_depth(DepthFormat format) {
    return format == DepthFormat::none ? 0 : format == DepthFormat::z16 ? 2 : 4;
}

/// Sets `out` to the pixels of a surface as the rasterizer sees them, with rows counted from the bottom.
void set_pixels(Surface& surface, raster::Surface& out);
inline raster::Surface pixels_of(Surface& surface) {
    raster::Surface out;
    set_pixels(surface, out);
    return out;
}

/// Hands the pixels of this thread's surfaces to its context. It is called again whenever a window gets
/// another buffer, or loses it.
void show_pixels();

/// True if a display may change its size or format while it is in use, as when another one is plugged in.
/// Displays of boards never change.
#ifdef SPANGLE_FIRMWARE
inline constexpr bool displays_change = false;
#else
inline constexpr bool displays_change = true;
#endif

/// Makes a buffer of the display the surface's buffer. False: the size or format differs, or the display
/// wants extents that this build does not have. The surface then has no buffer.
bool take(Display& display, Surface& surface, const hal::Frame& frame);

/// Returns the display that shows a window: its own one in a window system, else the panel.
inline hal::Display& native_of(const Display& display, [[maybe_unused]] const Surface& surface) {
#if SPANGLE_HAS_PLATFORMS
    if (surface.native != nullptr)
        return *surface.native;
#endif
    return *display.native;
}

/// Asks the display for the buffer of the next frame. A window that its window system has resized gets planes
/// of the new size, too. False: the surface has no buffer.
bool next_frame(Display& display, Surface& surface);

/// Records BAD_NATIVE_WINDOW for a window that was cut off, and returns false.
bool fail_cut_off();

/// Chooses the band height of a window, in rows. If `wish` is 0, the display chooses. Returns EGL_SUCCESS, or
/// the error of the requested height.
EGLint choose_band(const hal::DisplayInfo& info, EGLint wish, Band& band);

/// Brings rows [first, first + rows), counted from the top, of a window in bands into memory.
bool open_band(Display& display, Surface& surface, std::int32_t first, std::int32_t rows);
bool send_band(Display& display, Surface& surface);
/// Calls each(first, rows) for every band from the top down. If a call returns false, it stops and returns
/// false.
template <class Each> bool each_band(const Surface& surface, Each each) {
    for (std::int32_t first = 0; first < surface.height; first += surface.band.height) {
        const std::int32_t left = surface.height - first;
        if (!each(first, left < surface.band.height ? left : surface.band.height))
            return false;
    }
    return true;
}

/// Cuts `out`, a view of the whole window, to the open band.
void show_band(Surface& surface, raster::Surface& out);

/// Allocates a record of `bytes` bytes, or none for 0. False: there is no memory.
bool make_record(EGLint bytes, Band& band);
/// Allocates the table of rows that batches reach, for a picture `height` rows high. Without memory every
/// band draws all batches.
void make_batches(std::int32_t height, Band& band);
void free_record(Band& band);
/// Returns the size of the record in bytes or, with `peak`, the bytes that its longest frame so far has used.
EGLint record_bytes(const Band& band, bool peak);

/// Shows the recorded frame and begins the next one. A frame whose record is incomplete is not shown.
bool present_record(Display& display, Surface& surface);

/// attach_record() is called when a surface becomes this thread's draw surface, and detach_record() when it
/// is no longer that surface.
void attach_record(Surface& surface);
void detach_record(Surface& surface);

/// Draws and presents one frame of a window in bands: calls `draw` once for every band.
bool draw_bands(Display& display, Surface& surface, void (*draw)(void*), void* data);
/// Draws and presents one frame of a window in bands by one call of `draw`, if its record is large enough.
/// Otherwise draw_bands() draws it.
bool draw_recorded(Display& display, Surface& surface, void (*draw)(void*), void* data);

/// Presents what was drawn to a window of this thread and attaches the next frame's buffer. A frame without a
/// buffer is not shown. The next frame has a buffer as soon as the display gives one.
bool present(Display& display, Surface& surface);

/// Shows the current window of this thread if it has no back buffer, for Flush and Finish. With `finish`,
/// also waits until the last frame is shown.
void show_window(bool finish);

/// Ends the current context of this thread. Context `next` stays marked as current, because it becomes
/// current again.
void release_current(const Context* next = nullptr);

} // namespace spangle::egl
