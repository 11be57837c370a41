// Sets the palette of a colour index window, by an extension of this library (spangle/EGL/egl.h).
#include "gl/context/error.hpp"
#include "gl/egl/objects.hpp"

using namespace spangle::egl;

extern "C" EGLBoolean eglSetPaletteSPANGLE(EGLDisplay dpy, EGLSurface handle, EGLint first, EGLint count,
                                           const std::uint8_t* rgb) {
    begin_call(SPANGLE_TEXT("eglSetPaletteSPANGLE"));
    const Registry registry;
    Display* const display = find_display(dpy);
    if (display == nullptr)
        return EGL_FALSE;
    const Surface* const surface = find_surface(*display, handle);
    if (surface == nullptr)
        return EGL_FALSE;
    if (!surface->window)
        return fail(EGL_BAD_SURFACE, SPANGLE_TEXT("only windows are shown"));
    if (!spangle::is_indexed(surface->config.format))
        return fail(EGL_BAD_MATCH, SPANGLE_TEXT("this surface holds colours; choose a config "
                                                "of EGL_COLOR_BUFFER_TYPE, EGL_INDEX_BUFFER_SPANGLE"));
    if (!spangle::hal::in_palette(first, count) || (count != 0 && rgb == nullptr))
        return fail(EGL_BAD_PARAMETER,
                    SPANGLE_TEXT("first and count leave the palette, or rgb is a null pointer"));
    const spangle::gl::LockGuard held(display->native_lock);
    const auto result = native_of(*display, *surface).set_palette(first, count, rgb);
    return result.ok() ? end_call() : fail(EGL_BAD_NATIVE_WINDOW, result.error().rule);
}
