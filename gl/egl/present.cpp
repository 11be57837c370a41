// SwapBuffers, Flush and Finish show windows, which get new buffers from their display (EGL 1.4, 3.9).
#include "gl/context/error.hpp"
#include "gl/egl/configs.hpp"
#include "gl/egl/objects.hpp"
#include "gl/egl/platforms.hpp"
#include "gl/pixel/draw_buffer.hpp"

namespace spangle::egl {

bool fail_cut_off() {
    return fail(EGL_BAD_NATIVE_WINDOW, SPANGLE_TEXT("this window is not the display's any more")) !=
           EGL_FALSE;
}

bool take(Display& display, Surface& surface, const hal::Frame& frame) {
    surface.frame = {};
    if (!raster::has_extents && frame.extents != nullptr)
        return fail(EGL_BAD_MATCH, SPANGLE_TEXT("this build does not tell the display what was drawn "
                                                "(SPANGLE_EXTENTS)")) != EGL_FALSE;
    if (displays_change && &native_of(display, surface) == display.native) {
        const hal::DisplayInfo info = display.native->info();
        if (info.width != surface.width || info.height != surface.height ||
            info.format != surface.config.format)
            return fail(EGL_BAD_NATIVE_WINDOW, SPANGLE_TEXT("the display has another size or format now; "
                                                            "create its window again")) != EGL_FALSE;
    }
    surface.frame = frame;
    return true;
}

bool next_frame(Display& display, Surface& surface) {
    const gl::LockGuard held(display.native_lock);
    if (surface.cut_off)
        return fail_cut_off();
    surface.frame = {}; // acquire() may take the last buffer back
#if SPANGLE_HAS_PLATFORMS
    if (!follow_window(display, surface))
        return false;
    if (surface.frame.pixels != nullptr)
        return true; // the window was resized, and has its buffer already
#endif
    const hal::Result<hal::Frame> frame = native_of(display, surface).acquire();
    if (!frame.ok()) {
        fail(EGL_BAD_NATIVE_WINDOW, frame.error().rule);
        return false;
    }
    return take(display, surface, frame.value());
}

bool present(Display& display, Surface& surface) {
    const gl::LockGuard held(display.native_lock);
    const bool drawn = surface.has_pixels();
    if (drawn) {
        raster::resolve(pixels_of(surface));
        const hal::Result<void> shown = native_of(display, surface).present();
        if (!shown.ok()) // the surface keeps the buffer, and the next frame sends what this one drew
            return fail(EGL_BAD_NATIVE_WINDOW, shown.error().rule) != EGL_FALSE;
    }
    // The display has taken the last buffer back. If it gives no other, GL draws nowhere.
    const bool more = next_frame(display, surface);
    show_pixels();
    if (more && !drawn)
        return fail(EGL_BAD_NATIVE_WINDOW, SPANGLE_TEXT("this frame is lost, the display had no buffer for "
                                                        "it; it has one for the next")) != EGL_FALSE;
    return more;
}

#if SPANGLE_HAS_PLATFORMS

namespace {

/// Hands a pbuffer's picture to Platforms::planes and Platforms::swapped, one call at a time.
void show_pbuffer(Surface& surface) {
    const Registry registry;
    const raster::Surface picture = pixels_of(surface);
    raster::resolve(picture);
    if (platforms().planes != nullptr)
        platforms().planes(picture);
    hal::DisplayInfo info;
    info.width = surface.width;
    info.height = surface.height;
    info.format = surface.config.format;
    platforms().swapped(surface.frame, info);
}

} // namespace

#endif

/// Shows a window without a back buffer. A frame that the panel refuses is sent with the next one. GL has no
/// error for this, so only a message is sent.
void show_window(bool finish) {
    const Thread& t = thread();
    if (t.draw == nullptr)
        return;
#if SPANGLE_HAS_PLATFORMS
    if (platforms().swapped != nullptr && !t.draw->window && !t.draw->swapped)
        show_pbuffer(*t.draw);
#endif
    if (!t.draw->window)
        return;
    const gl::LockGuard held(t.display->native_lock);
    if (t.draw->cut_off)
        return;
    const EGLint before = thread().error;
    bool kept_back = t.draw->back_buffered;
#if SPANGLE_HAS_PLATFORMS
    kept_back = kept_back && (t.draw->system == nullptr || !gl::draws_to_front(*t.context->gl));
#endif
    if ((kept_back || present(*t.display, *t.draw)) && finish) {
        const hal::Result<void> taken = native_of(*t.display, *t.draw).finish();
        if (!taken.ok())
            fail(EGL_BAD_NATIVE_WINDOW, taken.error().rule);
    }
    thread().error = before;
}

} // namespace spangle::egl

using namespace spangle::egl;

extern "C" {

/// Sets the interval of the current draw surface, whose display need not be `dpy` (EGL 1.4, 3.9.3).
EGLBoolean eglSwapInterval(EGLDisplay dpy, EGLint interval) {
    begin_call(SPANGLE_TEXT("eglSwapInterval"));
    const Registry registry;
    if (find_display(dpy) == nullptr)
        return EGL_FALSE;
    const Thread& t = thread();
    if (t.context == nullptr)
        return fail(EGL_BAD_CONTEXT, SPANGLE_TEXT("no context is current"));
    if (!t.draw->window || t.draw->cut_off)
        return end_call(); // swaps of pbuffers and lost windows never wait
    const spangle::gl::LockGuard held(t.display->native_lock);
    native_of(*t.display, *t.draw)
        .swap_interval(interval < least_swap_interval  ? least_swap_interval
                       : interval > most_swap_interval ? most_swap_interval
                                                       : interval);
    return end_call();
}

EGLBoolean eglSwapBuffers(EGLDisplay dpy, EGLSurface handle) {
    begin_call(SPANGLE_TEXT("eglSwapBuffers"));
    Display* display = nullptr;
    Surface* surface = nullptr;
    {
        const Registry registry;
        display = find_display(dpy);
        if (display == nullptr)
            return EGL_FALSE;
        surface = find_surface(*display, handle);
        if (surface == nullptr)
            return EGL_FALSE;
#if SPANGLE_HAS_PLATFORMS
        if (platforms().swapped != nullptr && !surface->window) {
            surface->swapped = true;
            show_pbuffer(*surface);
        }
#endif
        if (!surface->window || !surface->back_buffered)
            return end_call(); // pbuffers and single-buffered windows have nothing to swap (EGL 1.4, 3.9.1)
        if (thread().draw != surface)
            return fail(EGL_BAD_SURFACE, SPANGLE_TEXT("the surface is not the current draw surface"));
    }
    if (in_primitive())
        return fail_in_primitive();
    if (surface->in_bands() && surface->band.record != nullptr)
        return present_record(*display, *surface) ? end_call() : EGL_FALSE;
    if (surface->in_bands())
        return fail(EGL_BAD_SURFACE, SPANGLE_TEXT("no memory holds a frame of this window; draw it by "
                                                  "spangle::frame"));
    return present(*display, *surface) ? end_call() : EGL_FALSE;
}
}
