// What EGL's handles stand for, and how a handle is told from garbage: every object is on its display's list.
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
    /// The format of a config that exists.
    PixelFormat drawn() const { return raster::drawn(format); }
};

/// Of each component of an accumulation buffer.
inline constexpr EGLint accum_bits = 16;

struct RecordedFrame; // recorded_frame.hpp
struct Display;

/// What of a window is in memory, where that is not all of it.
struct Band {
#if SPANGLE_FEATURE_BANDS
    std::int32_t height = 0;              ///< rows of depth, stencil and accumulation; 0: all
    bool colors = false;                  ///< and of colours: the display has no whole frame either
    std::int32_t first = 0, rows = 0;     ///< from the top: what is drawn to now
    RowExtents extents;                   ///< of these rows
    RecordedFrame* record = nullptr;      ///< what is drawn is kept there; null: bands are drawn by callback
    raster::BatchRows* batches = nullptr; ///< what a band may leave out then; null without memory for it
    bool cleared = false;                 ///< all bands of this frame so far, to clear_value
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
    bool destroyed = false; ///< no handle any more, and freed once nothing holds it
    bool window = false;    ///< shown somewhere: a window, or a pixmap of a window system
#if SPANGLE_HAS_PLATFORMS
    hal::WindowSystem* system = nullptr; ///< that opened `native` for this surface, and closes it
    hal::Display* native = nullptr;
    std::uintptr_t native_handle = 0; ///< of the window or pixmap there
    bool pixmap = false;
    bool swapped = false; ///< a pbuffer that SwapBuffers was called for: Flush does not show it any more
#endif
    bool wants_single = false; ///< EGL_RENDER_BUFFER was EGL_SINGLE_BUFFER
    bool back_buffered = true; ///< of windows: SwapBuffers shows what was drawn; else Flush does
    /// Its display was terminated, or shows another window: this one has no pixels, and shows nothing any
    /// more. Written with a Registry and the display's native_lock, read with either.
    bool cut_off = false;
    unsigned bindings = 0; ///< contexts it is current to
    unsigned frames = 0;   ///< calls of spangle::frame that draw it
    std::uint8_t* depth = nullptr;
    std::int16_t* accum = nullptr;
    std::uint8_t* sample_colors = nullptr; ///< a plane for each, where the config is multisampled
    RowSpan* unresolved = nullptr;         ///< of each row that is in memory
    raster::Samples samples;
    hal::Frame frame; ///< a window's belongs to the display; no pixels: the display has given none
    [[no_unique_address]] Band band;

    bool in_bands() const {
        return SPANGLE_FEATURE_BANDS && band.height != 0;
    }
    /// What is drawn goes somewhere, or will as soon as a band is opened.
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
    hal::Display* native = nullptr; ///< the panel; null: none
#if SPANGLE_HAS_PLATFORMS
    hal::WindowSystem* system = nullptr; ///< with neither there are pbuffers only
#endif
    bool used = false, initialized = false;
    /// Since it was last asked for or initialized: its entry may serve another display.
    bool terminated = false;
    /// Held by who calls `native`, or what a window system opened, which are for one thread at a time. After
    /// it none but the arena's lock is taken.
    [[no_unique_address]] gl::Lock native_lock;
    Surface* surfaces = nullptr;
    Context* contexts = nullptr;
    /// Frees what was destroyed and nothing holds any more; null while nothing was ever destroyed: a program
    /// that destroys nothing links none of it.
    void (*sweep)(Display&) = nullptr;
};

#if SPANGLE_THREADS
extern gl::Lock registry_lock;
/// Threads take turns at displays, their lists of surfaces and contexts, and what these say of who holds
/// them: who looks at any of it has a Registry. It comes before every other lock.
struct Registry : gl::Held {
    Registry() : Held(registry_lock) {}
};
#else
struct Registry {
    Registry() {}
};
#endif

/// What is current on this thread.
struct Thread {
    EGLint error = EGL_SUCCESS;
    Display* display = nullptr;
    Context* context = nullptr;
    Surface* draw = nullptr;
    Surface* read = nullptr;
};
Thread& thread();

/// Records an error. `rule` is a SPANGLE_TEXT for spangle::on_message, without the command's name; null when
/// the message has been sent. Returns EGL_FALSE.
EGLBoolean fail(EGLint error, const char* rule);

#if SPANGLE_MESSAGES
/// Names the command that this thread is in, for its messages.
void enter(const char* command);
#else
inline void enter(const char*) {}
#endif

EGLBoolean succeed();

/// The entry of a panel or of a window system, a new one where there is none; EGL_NO_DISPLAY when all are
/// used.
EGLDisplay display_of(hal::Display* native, hal::WindowSystem* system);
/// Whether a native display may be asked for: what eglGetDisplay and eglGetPlatformDisplay give.
EGLDisplay platform_display(EGLenum platform, void* native);
/// The current context is between glBegin and glEnd. Then its surfaces stay where they are, and nothing is
/// shown: what would change that fails by fail_in_primitive().
bool in_primitive();
EGLBoolean fail_in_primitive();

/// The display behind a handle, initialized or not; null with BAD_DISPLAY recorded.
Display* find_entry(EGLDisplay handle);
/// The initialized display behind a handle, or null with BAD_DISPLAY or NOT_INITIALIZED recorded.
Display* find_display(EGLDisplay handle);
Surface* find_surface(Display& display, EGLSurface handle);
Context* find_context(Display& display, EGLContext handle);

/// The one memory of the program.
gl::Arena& arena();

/// A surface's memory.
void free_surface(Surface* surface);

/// A window of a window system that changed its size since its buffer was given gets planes and a buffer of
/// its new size. False, with an error recorded, where these cannot be had: it stays as it is.
bool follow_window(Display& display, Surface& surface);

/// A window of this display, or a pixmap: what eglCreateWindowSurface and eglCreatePixmapSurface make.
EGLSurface create_shown(EGLDisplay dpy, EGLConfig config, std::uintptr_t handle, bool pixmap,
                        const EGLint* attrib_list);

/// What is marked as destroyed is freed as soon as nothing holds it.
void free_destroyed(Display& display);

constexpr std::int32_t bytes_per_depth(DepthFormat format) {
    return format == DepthFormat::none ? 0 : format == DepthFormat::z16 ? 2 : 4;
}

/// The pixels of a surface as the rasterizer sees them: GL's rows count from the bottom.
void set_pixels(Surface& surface, raster::Surface& out);
inline raster::Surface pixels_of(Surface& surface) {
    raster::Surface out;
    set_pixels(surface, out);
    return out;
}

/// Hands the pixels of this thread's surfaces to its context; again after a window got another buffer, or
/// has none any more.
void show_pixels();

/// Sizes and formats of displays may change while they are in use: another one was plugged in. Those of
/// boards do not.
#ifdef SPANGLE_FIRMWARE
inline constexpr bool displays_change = false;
#else
inline constexpr bool displays_change = true;
#endif

/// The display gave this buffer. False, and the surface has none: it is not of the surface's size, or the
/// display asks what is drawn there, which this build does not tell.
bool take(Display& display, Surface& surface, const hal::Frame& frame);

/// Where a window is shown: on the display's panel, unless it is one of a window system.
inline hal::Display& native_of(const Display& display, [[maybe_unused]] const Surface& surface) {
#if SPANGLE_HAS_PLATFORMS
    if (surface.native != nullptr)
        return *surface.native;
#endif
    return *display.native;
}

/// Asks the display for the buffer of the next frame. A window of a window system that has another size by
/// now gets planes of that size, too. False: the surface has no buffer.
bool next_frame(Display& display, Surface& surface);

/// A window that was cut off: BAD_NATIVE_WINDOW, and false.
bool fail_cut_off();

/// The rows of a window that its depth buffer shall have at once: EGL_SUCCESS, or the error of that wish.
EGLint choose_band(const hal::DisplayInfo& info, EGLint wish, Band& band);

/// A buffer for rows [first, first + rows) of a window in bands; they are in memory then.
bool open_band(Display& display, Surface& surface, std::int32_t first, std::int32_t rows);
bool send_band(Display& display, Surface& surface);
/// Calls open(first, rows) and then close() for each band from the top, while they return true.
template <class Each> bool each_band(const Surface& surface, Each each) {
    for (std::int32_t first = 0; first < surface.height; first += surface.band.height) {
        const std::int32_t left = surface.height - first;
        if (!each(first, left < surface.band.height ? left : surface.band.height))
            return false;
    }
    return true;
}

/// `out` is a view on the whole window: cuts it to the band.
void show_band(Surface& surface, raster::Surface& out);

/// The memory for a record of so many bytes, 0: none is wished. False without memory.
bool make_record(EGLint bytes, Band& band);
/// The memory for what bands of a picture of so many rows may leave out. Without it they leave out nothing.
void make_batches(std::int32_t height, Band& band);
void free_record(Band& band);
/// Of the record, or of its longest frame so far.
EGLint record_bytes(const Band& band, bool peak);

/// What was recorded is shown, or, where it is not whole, forgotten.
bool present_record(Display& display, Surface& surface);

/// This thread draws to a surface from now on, or not any more.
void attach_record(Surface& surface);
void detach_record(Surface& surface);

/// Draws and presents one frame of a window in bands.
bool draw_bands(Display& display, Surface& surface, void (*draw)(void*), void* data);
/// The same, by one call of `draw` where its record is large enough.
bool draw_recorded(Display& display, Surface& surface, void (*draw)(void*), void* data);

/// Presents what was drawn to a window of this thread and attaches the next frame's buffer. A frame that had
/// no buffer is not shown, and the next one has one again as soon as the display gives it.
bool present(Display& display, Surface& surface);

/// What Flush and Finish do to the window that is current on this thread, if there is one: shown when it has
/// no back buffer; with `finish`, waited for.
void show_window(bool finish);

/// Undoes MakeCurrent on this thread; not of context `next`, which becomes current again.
void release_current(const Context* next = nullptr);

} // namespace spangle::egl
