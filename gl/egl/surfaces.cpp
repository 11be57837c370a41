// Windows and pbuffers: their creation and destruction (EGL 1.4, 3.5).
#include "gl/context/error.hpp"
#include "gl/context/features.hpp"
#include "gl/context/limits.hpp"
#include "gl/egl/configs.hpp"
#include "gl/egl/objects.hpp"
#include "gl/egl/platforms.hpp"

#include <initializer_list>
#include <new>
#include <utility>

namespace spangle::egl {

namespace {

constexpr std::int32_t largest_pbuffer = gl::max_viewport_dim;

/// Properties of a surface beyond its config.
struct SurfaceOptions {
    bool color = false; ///< true to allocate a colour buffer; a window has its display's
    bool accum = false;
    Band band = {};
    EGLint record = 0; ///< bytes of the record; 0: none
};

/// Bytes of one sample's colour plane for `rows` rows. If a byte holds pixels of several rows, a band that
/// begins anywhere may need one row of bytes more.
std::size_t bytes_of_sample(PixelFormat format, std::int32_t width, std::int32_t rows) {
    const std::int32_t shared = raster::drawn_info(format).rows, most = (rows + 2 * shared - 2) / shared;
    return static_cast<std::size_t>(row_bytes(format, width)) * static_cast<std::size_t>(most);
}

/// Makes a surface with its buffers. Null: memory ran out, and everything was freed.
Surface* create_surface(const Config& config, std::int32_t width, std::int32_t height,
                        const SurfaceOptions& extras) {
    gl::Arena& a = arena();
    const std::int32_t rows = extras.band.height != 0 ? extras.band.height : height;
    const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(rows);
    void* const memory = a.allocate(sizeof(Surface));
    if (memory == nullptr)
        return nullptr;
    auto* const surface = new (memory) Surface();
    surface->config = config;
    surface->width = width;
    surface->height = height;
    if constexpr (SPANGLE_FEATURE_BANDS)
        surface->band = extras.band;
    bool whole = true;
    const auto plane = [&](std::size_t bytes) -> void* {
        void* const memory_of = a.allocate(bytes);
        whole = whole && memory_of != nullptr;
        return memory_of;
    };
    const PixelFormat format = config.drawn();
    if (extras.color) {
        surface->frame.stride = row_bytes(format, width);
        surface->frame.pixels =
            static_cast<std::uint8_t*>(plane(static_cast<std::size_t>(surface->frame.stride) *
                                             static_cast<std::size_t>(stored_rows(format, height))));
    }
    const std::size_t samples = config.has_samples() ? raster::sample_count : 1;
    const std::size_t depth_bytes = pixels * static_cast<std::size_t>(bytes_per_depth(config.depth));
    if (config.depth != DepthFormat::none)
        surface->depth = static_cast<std::uint8_t*>(plane(depth_bytes * samples));
    if (config.has_samples()) {
        const std::size_t sample_bytes = bytes_of_sample(format, width, rows);
        surface->sample_colors = static_cast<std::uint8_t*>(plane(sample_bytes * samples));
        surface->samples.next_color = static_cast<std::ptrdiff_t>(sample_bytes);
        surface->samples.next_depth = static_cast<std::ptrdiff_t>(depth_bytes);
        surface->unresolved = static_cast<RowSpan*>(plane(static_cast<std::size_t>(rows) * sizeof(RowSpan)));
    }
    if (SPANGLE_FEATURE_ACCUM && extras.accum)
        surface->accum = static_cast<std::int16_t*>(plane(pixels * (4 * accum_bits / 8)));
    if (!whole || !make_record(extras.record, surface->band)) {
        free_surface(surface);
        return nullptr;
    }
    make_batches(height, surface->band);
    for (std::int32_t y = 0; config.has_samples() && y < rows; ++y)
        new (surface->unresolved + y) RowSpan;
    return surface;
}

/// Reads EGL_ACCUM_SIZE_SPANGLE. False: this is another attribute. More bits than this build has are an
/// error.
bool read_accum(const EGLint* at, bool& accum, EGLint& problem) {
    if (at[0] != EGL_ACCUM_SIZE_SPANGLE)
        return false;
    if (at[1] < 0 || at[1] > accum_bits || !SPANGLE_FEATURE_ACCUM)
        problem = EGL_BAD_MATCH;
    accum = at[1] > 0;
    return true;
}

EGLSurface keep(Display& display, Surface* surface) {
    surface->next = display.surfaces;
    display.surfaces = surface;
    end_call();
    return surface;
}

struct WindowAttributes {
    bool single = false; ///< true for a window without a back buffer
    bool accum = false;
    EGLint band_height = 0, record = 0;
};

/// Reads the attributes of a window. Returns EGL_SUCCESS, or the error in the list.
EGLint read_window(const EGLint* list, WindowAttributes& out) {
    EGLint problem = EGL_SUCCESS;
    for (; list != nullptr && *list != EGL_NONE; list += 2) {
        if (read_accum(list, out.accum, problem))
            continue;
        if (SPANGLE_FEATURE_BANDS && list[0] == EGL_BAND_HEIGHT_SPANGLE) {
            out.band_height = list[1];
            continue;
        }
        if (SPANGLE_HAS_RECORDS && list[0] == EGL_BAND_RECORD_SPANGLE) {
            out.record = list[1];
            continue;
        }
        if (list[0] != EGL_RENDER_BUFFER)
            return EGL_BAD_ATTRIBUTE;
        if (list[1] != EGL_SINGLE_BUFFER && list[1] != EGL_BACK_BUFFER)
            return EGL_BAD_PARAMETER;
        out.single = list[1] == EGL_SINGLE_BUFFER;
    }
    return problem;
}

struct PbufferAttributes {
    EGLint width = 0, height = 0;
    bool largest = false, accum = false;
};

/// Reads the attributes of a pbuffer. Returns 0, or the error in the list.
EGLint read_pbuffer(const EGLint* list, PbufferAttributes& out) {
    EGLint problem = 0;
    for (; list != nullptr && *list != EGL_NONE; list += 2) {
        if (read_accum(list, out.accum, problem))
            continue;
        switch (list[0]) {
        case EGL_WIDTH:
            out.width = list[1];
            break;
        case EGL_HEIGHT:
            out.height = list[1];
            break;
        case EGL_LARGEST_PBUFFER:
            out.largest = list[1] != EGL_FALSE;
            break;
        case EGL_TEXTURE_FORMAT:
        case EGL_TEXTURE_TARGET:
            if (list[1] != EGL_NO_TEXTURE)
                return EGL_BAD_MATCH;
            break;
        case EGL_MIPMAP_TEXTURE:
            break;
        default:
            return EGL_BAD_ATTRIBUTE;
        }
    }
    return out.width < 0 || out.height < 0 ? EGL_BAD_PARAMETER : problem;
}

/// True if GL can draw on a surface of this size. A display may report any size.
bool is_drawable_size(const hal::DisplayInfo& info) {
    return info.width > 0 && info.height > 0 && info.width <= gl::max_viewport_dim &&
           info.height <= gl::max_viewport_dim;
}

/// Returns the window that the display's panel shows, or null. In window systems, every window has its own
/// place on the screen.
Surface* window_of(const Display& display) {
    Surface* s = display.native != nullptr ? display.surfaces : nullptr;
    while (s != nullptr && (!s->window || s->cut_off))
        s = s->next;
    return s;
}

/// True if a new window may replace `window` on the panel. The old window must be null, or destroyed and
/// current on this thread only. GL can then be told that its pixels are gone.
bool may_leave(const Surface* window) {
    const Thread& t = thread();
    return window == nullptr ||
           (window->destroyed && (t.draw == window || t.read == window) && !in_primitive());
}

/// Takes the pixels from `window`, because the panel will show another one.
void cut_off(Display& display, Surface* window) {
    if (window == nullptr)
        return;
    {
        const gl::LockGuard held(display.native_lock);
        window->cut_off = true;
    }
    show_pixels();
}

EGLSurface refuse_window(EGLint problem) {
    fail(problem, SPANGLE_TEXT("needs a config of the panel's format, window 0, "
                               "no other window, and bands no higher than the display's, and a record "
                               "only where the display has bands"));
    return EGL_NO_SURFACE;
}

/// Where a new surface is shown.
struct WindowTarget {
    hal::Display* native;

#if SPANGLE_HAS_PLATFORMS
    hal::WindowSystem* system = nullptr;

    /// Opens the window or pixmap `handle`. Returns EGL_SUCCESS, or the error of that handle.
    EGLint open(const Display& display, const Config& config, std::uintptr_t handle, bool pixmap) {
        const EGLint wrong = pixmap ? EGL_BAD_NATIVE_PIXMAP : EGL_BAD_NATIVE_WINDOW;
        for (const Surface* s = display.surfaces; s != nullptr; s = s->next)
            if (s->window && !s->destroyed && s->native_handle == handle && s->pixmap == pixmap)
                return EGL_BAD_ALLOC; // a panel shows one window, and a native window has one surface
        if (display.system == nullptr)
            return handle != 0 || pixmap           ? wrong
                   : may_leave(window_of(display)) ? EGL_SUCCESS
                                                   : EGL_BAD_ALLOC;
        const hal::Result<hal::Display*> opened = display.system->open(handle, pixmap, config.format);
        if (!opened.ok())
            return wrong;
        system = display.system;
        native = opened.value();
        return EGL_SUCCESS;
    }
    void close() const {
        if (system != nullptr)
            system->close(*native);
    }
    void give(Surface& surface, std::uintptr_t handle, bool pixmap) const {
        surface.system = system;
        surface.native = system != nullptr ? native : nullptr;
        surface.native_handle = handle;
        surface.pixmap = pixmap;
    }
#else
    static EGLint open(const Display& display, const Config&, std::uintptr_t handle, bool) {
        return handle != 0                     ? EGL_BAD_NATIVE_WINDOW
               : may_leave(window_of(display)) ? EGL_SUCCESS
                                               : EGL_BAD_ALLOC; // a panel shows one window
    }
    static void close() {}
    static void give(const Surface&, std::uintptr_t, bool) {}
#endif
};

} // namespace

#if SPANGLE_HAS_PLATFORMS

bool follow_window(Display& display, Surface& surface) {
    if (surface.system == nullptr || surface.in_bands())
        return true;
    const hal::DisplayInfo info = surface.native->info();
    if (info.width == surface.width && info.height == surface.height)
        return true;
    if (info.width == 0)
        return fail(EGL_BAD_NATIVE_WINDOW, SPANGLE_TEXT("the window is destroyed")) != EGL_FALSE;
    if (!is_drawable_size(info))
        return fail(EGL_BAD_NATIVE_WINDOW, SPANGLE_TEXT("the window is larger than what GL draws")) !=
               EGL_FALSE;
    Surface* const other =
        create_surface(surface.config, info.width, info.height, {false, surface.accum != nullptr, {}, 0});
    if (other == nullptr)
        return fail(EGL_BAD_ALLOC, SPANGLE_TEXT("no memory for the planes of a window that became larger; "
                                                "see spangle::memory")) != EGL_FALSE;
    surface.frame = {}; // acquire() may take this buffer back
    const hal::Result<hal::Frame> frame = surface.native->acquire();
    if (frame.ok()) {
        std::swap(surface.depth, other->depth);
        std::swap(surface.accum, other->accum);
        std::swap(surface.sample_colors, other->sample_colors);
        std::swap(surface.unresolved, other->unresolved);
        surface.samples = other->samples;
        surface.width = info.width;
        surface.height = info.height;
    }
    free_surface(other);
    return frame.ok() ? take(display, surface, frame.value())
                      : fail(EGL_BAD_NATIVE_WINDOW, frame.error().rule) != EGL_FALSE;
}

#endif

void free_surface(Surface* surface) {
    free_record(surface->band);
#if SPANGLE_FEATURE_BANDS
    arena().free(surface->band.batches);
#endif
#if SPANGLE_HAS_PLATFORMS
    if (surface->system != nullptr)
        surface->system->close(*surface->native);
#endif
    std::uint8_t* const own = surface->window ? nullptr : surface->frame.pixels;
    for (void* const plane : {static_cast<void*>(own), static_cast<void*>(surface->depth),
                              static_cast<void*>(surface->accum), static_cast<void*>(surface->sample_colors),
                              static_cast<void*>(surface->unresolved), static_cast<void*>(surface)})
        arena().free(plane);
}

} // namespace spangle::egl

using namespace spangle::egl;

EGLSurface spangle::egl::create_shown(EGLDisplay dpy, EGLConfig config, std::uintptr_t handle, bool pixmap,
                                      const EGLint* attrib_list) {
    const Registry registry;
    Display* const display = find_display(dpy);
    if (display == nullptr)
        return EGL_NO_SURFACE;
    const Config found = find_config(*display, config);
    if (found.id == 0)
        return refuse_window(EGL_BAD_CONFIG);
    WindowAttributes wish;
    Band band;
    WindowTarget shown = {display->native};
    EGLint problem = !fits_window(*display, found) ? EGL_BAD_MATCH : read_window(attrib_list, wish);
    if (problem == EGL_SUCCESS)
        problem = shown.open(*display, found, handle, pixmap);
    if (problem != EGL_SUCCESS)
        return refuse_window(problem);
    const spangle::hal::DisplayInfo info = shown.native->info();
    problem = is_drawable_size(info) ? choose_band(info, wish.band_height, band) : EGL_BAD_NATIVE_WINDOW;
    if (problem == EGL_SUCCESS && wish.record != 0)
        problem = wish.record < 0 ? EGL_BAD_PARAMETER : band.colors ? EGL_SUCCESS : EGL_BAD_MATCH;
    if (problem != EGL_SUCCESS) {
        shown.close();
        return refuse_window(problem);
    }
    Surface* const surface =
        create_surface(found, info.width, info.height, {false, wish.accum, band, wish.record});
    if (surface == nullptr) {
        shown.close();
        fail(EGL_BAD_ALLOC, SPANGLE_TEXT("no memory for depth, samples and the record; see spangle::memory"));
        return EGL_NO_SURFACE;
    }
    surface->window = true;
    shown.give(*surface, handle, pixmap);
    surface->wants_single = wish.single || pixmap;
    // A display that flips buffers cannot grant EGL_SINGLE_BUFFER, which is a wish only (EGL 1.4, 3.5.1).
    surface->back_buffered = !surface->wants_single || !info.keeps_buffer || surface->in_bands();
    cut_off(*display, window_of(*display));
    if (!surface->in_bands() && !next_frame(*display, *surface)) {
        const EGLint error = thread().error;
        free_surface(surface);
        fail(error, nullptr);
        return EGL_NO_SURFACE;
    }
    return keep(*display, surface);
}

extern "C" {

EGLSurface eglCreateWindowSurface(EGLDisplay dpy, EGLConfig config, EGLNativeWindowType win,
                                  const EGLint* attrib_list) {
    begin_call(SPANGLE_TEXT("eglCreateWindowSurface"));
    return create_shown(dpy, config, win, false, attrib_list);
}

EGLSurface eglCreatePbufferSurface(EGLDisplay dpy, EGLConfig config, const EGLint* attrib_list) {
    begin_call(SPANGLE_TEXT("eglCreatePbufferSurface"));
    const Registry registry;
    Display* const display = find_display(dpy);
    if (display == nullptr)
        return EGL_NO_SURFACE;
    const Config found = made_of(find_config(*display, config));
    PbufferAttributes wish;
    EGLint problem = found.id == 0 ? EGL_BAD_CONFIG : read_pbuffer(attrib_list, wish);
    if (problem == 0 && (wish.width > largest_pbuffer || wish.height > largest_pbuffer) && !wish.largest)
        problem = EGL_BAD_ALLOC;
    if (problem != 0) {
        fail(problem, SPANGLE_TEXT("config is not one of this display, or attrib_list does not fit pbuffers "
                                   "and their largest size"));
        return EGL_NO_SURFACE;
    }
    const auto cut = [](EGLint v) { return v > largest_pbuffer ? largest_pbuffer : v; };
    Surface* const surface =
        create_surface(found, cut(wish.width), cut(wish.height), {true, wish.accum, {}, 0});
    if (surface == nullptr) {
        fail(EGL_BAD_ALLOC, SPANGLE_TEXT("not enough memory; see spangle::memory"));
        return EGL_NO_SURFACE;
    }
    return keep(*display, surface);
}

EGLBoolean eglDestroySurface(EGLDisplay dpy, EGLSurface handle) {
    begin_call(SPANGLE_TEXT("eglDestroySurface"));
    const Registry registry;
    Display* const display = find_display(dpy);
    if (display == nullptr)
        return EGL_FALSE;
    Surface* const surface = find_surface(*display, handle);
    if (surface == nullptr)
        return EGL_FALSE;
    surface->destroyed = true;
    free_destroyed(*display);
    return end_call();
}
}
