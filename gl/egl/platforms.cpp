// Displays of platforms (EGL_EXT_platform_base), attributes of contexts (EGL_KHR_create_context), and
// surfaces for windows and pixmaps of a window system.
#include "gl/egl/platforms.hpp"

#include "gl/context/error.hpp"
#include "gl/context/gl_version.hpp"
#include "gl/egl/objects.hpp"

#if SPANGLE_HAS_PLATFORMS

namespace spangle::egl {

namespace {

constinit Platforms known;
constexpr std::size_t longest_extensions = 512;
constinit char extensions[longest_extensions] = "";

/// Appends `text`, which is cut off at the end of the buffer.
void append(char* to, const char* text) {
    std::size_t end = 0;
    while (to[end] != '\0')
        ++end;
    for (; *text != '\0' && end + 1 < longest_extensions; ++text)
        to[end++] = *text;
    to[end] = '\0';
}

/// True if this build is compatible with a version: all versions up to its own (EGL_KHR_create_context).
/// Unknown versions are refused.
bool has_version(EGLint major, EGLint minor) {
    return major == 1 && minor >= 0 && minor <= gl::gl_minor;
}

} // namespace

void use_platforms(const Platforms& platforms) {
    known = platforms;
}

const Platforms& platforms() {
    return known;
}

const char* client_extensions() {
    const Registry registry; // locks, because only one thread may write the string
    end_call();
    if (extensions[0] == '\0') {
        append(extensions, "EGL_EXT_client_extensions EGL_EXT_platform_base EGL_MESA_platform_surfaceless "
                           "EGL_KHR_client_get_all_proc_addresses");
        append(extensions, known.extensions);
    }
    return extensions;
}

EGLint context_problem(const EGLint* list) {
    EGLint major = 1, minor = 0;
    constexpr EGLint flags = EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR |
                             EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE_BIT_KHR |
                             EGL_CONTEXT_OPENGL_ROBUST_ACCESS_BIT_KHR;
    bool beyond = false;
    for (; list != nullptr && *list != EGL_NONE; list += 2) {
        const EGLint value = list[1];
        switch (list[0]) {
        case EGL_CONTEXT_MAJOR_VERSION_KHR:
            major = value;
            break;
        case EGL_CONTEXT_MINOR_VERSION_KHR:
            minor = value;
            break;
        case EGL_CONTEXT_FLAGS_KHR:
            if ((value & ~flags) != 0)
                return EGL_BAD_ATTRIBUTE;
            // Forward compatible contexts need OpenGL 3.0; robust ones need an extension of OpenGL.
            beyond = beyond || (value & ~EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR) != 0;
            break;
        case EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR:
            break; // the profile mask has no meaning below OpenGL 3.2
        case EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_KHR:
            if (value != EGL_NO_RESET_NOTIFICATION_KHR && value != EGL_LOSE_CONTEXT_ON_RESET_KHR)
                return EGL_BAD_ATTRIBUTE;
            beyond = beyond || value != EGL_NO_RESET_NOTIFICATION_KHR;
            break;
        default:
            return EGL_BAD_ATTRIBUTE;
        }
    }
    return beyond || !has_version(major, minor) ? EGL_BAD_MATCH : EGL_SUCCESS;
}

EGLDisplay platform_display(EGLenum platform, void* native) {
    if (platform == EGL_PLATFORM_SURFACELESS_MESA) {
        if (native == EGL_DEFAULT_DISPLAY)
            return display_of(nullptr, nullptr);
        fail(EGL_BAD_PARAMETER, SPANGLE_TEXT("EGL_PLATFORM_SURFACELESS_MESA has the "
                                             "display EGL_DEFAULT_DISPLAY alone"));
        return EGL_NO_DISPLAY;
    }
    const NativeDisplay found = known.find != nullptr ? known.find(platform, native) : NativeDisplay{};
    if (found.known)
        return display_of(found.panel, found.windows);
    if (platform != EGL_NONE)
        fail(EGL_BAD_PARAMETER, SPANGLE_TEXT("there is no such platform here"));
    return EGL_NO_DISPLAY;
}

namespace {

/// Copies an attribute list of EGL 1.5, whose elements are as wide as pointers. False: the list is longer
/// than that of any surface, or an element does not fit EGLint.
constexpr std::size_t most_attributes = 32;
bool narrow(const EGLAttrib* list, EGLint (&out)[2 * most_attributes + 1]) {
    std::size_t n = 0;
    for (; list != nullptr && list[n & ~std::size_t{1}] != EGL_NONE; ++n) {
        if (n == 2 * most_attributes)
            return false;
        out[n] = static_cast<EGLint>(list[n]);
        if (out[n] != list[n])
            return false;
    }
    out[n] = EGL_NONE;
    return true;
}

/// Creates a surface from a pointer to the native handle, which the X11 platforms pass
/// (EGL_EXT_platform_x11).
EGLSurface create_pointed(EGLDisplay dpy, EGLConfig config, const void* handle, bool pixmap,
                          const EGLint* list) {
    if (handle == nullptr) {
        fail(pixmap ? EGL_BAD_NATIVE_PIXMAP : EGL_BAD_NATIVE_WINDOW,
             SPANGLE_TEXT("the window or pixmap is a null pointer"));
        return EGL_NO_SURFACE;
    }
    return create_shown(dpy, config, *static_cast<const unsigned long*>(handle), pixmap, list);
}

/// Creates a surface from a pointer and an attribute list of EGL 1.5. The function has a name of its own,
/// because EGLAttrib and EGLint are one type where pointers have 32 bits.
EGLSurface create_pointed_wide(EGLDisplay dpy, EGLConfig config, const void* handle, bool pixmap,
                               const EGLAttrib* list) {
    EGLint narrowed[2 * most_attributes + 1];
    if (!narrow(list, narrowed)) {
        fail(EGL_BAD_ATTRIBUTE, SPANGLE_TEXT("attrib_list is longer than that of any surface"));
        return EGL_NO_SURFACE;
    }
    return create_pointed(dpy, config, handle, pixmap, narrowed);
}

/// Copies the pixels that both pictures have, aligned at their top left corners.
void copy_rows(const Surface& from, const hal::Frame& to, const hal::DisplayInfo& info) {
    const std::int32_t width = from.width < info.width ? from.width : info.width,
                       height = from.height < info.height ? from.height : info.height,
                       bytes = row_bytes(from.config.format, width);
    for (std::int32_t y = 0; y < height; ++y) {
        const std::uint8_t* const source = from.frame.pixels + std::ptrdiff_t{y} * from.frame.stride;
        std::uint8_t* const target = to.pixels + std::ptrdiff_t{y} * to.stride;
        for (std::int32_t i = 0; i < bytes; ++i)
            target[i] = source[i];
    }
}

} // namespace

} // namespace spangle::egl

using namespace spangle::egl;

extern "C" {

EGLDisplay eglGetPlatformDisplayEXT(EGLenum platform, void* native_display, const EGLint* attrib_list) {
    begin_call(SPANGLE_TEXT("eglGetPlatformDisplay"));
    if (attrib_list != nullptr && *attrib_list != EGL_NONE && platform != EGL_PLATFORM_X11_KHR) {
        fail(EGL_BAD_ATTRIBUTE, SPANGLE_TEXT("displays of this platform take no attributes"));
        return EGL_NO_DISPLAY;
    }
    return platform_display(platform, native_display);
}

EGLDisplay eglGetPlatformDisplay(EGLenum platform, void* native_display, const EGLAttrib* attrib_list) {
    const EGLint given[] = {attrib_list != nullptr && *attrib_list != EGL_NONE ? EGL_UNKNOWN : EGL_NONE,
                            EGL_NONE, EGL_NONE};
    return eglGetPlatformDisplayEXT(platform, native_display, given);
}

EGLSurface eglCreatePlatformWindowSurfaceEXT(EGLDisplay dpy, EGLConfig config, void* native_window,
                                             const EGLint* attrib_list) {
    begin_call(SPANGLE_TEXT("eglCreatePlatformWindowSurfaceEXT"));
    return create_pointed(dpy, config, native_window, false, attrib_list);
}

EGLSurface eglCreatePlatformWindowSurface(EGLDisplay dpy, EGLConfig config, void* native_window,
                                          const EGLAttrib* attrib_list) {
    begin_call(SPANGLE_TEXT("eglCreatePlatformWindowSurface"));
    return create_pointed_wide(dpy, config, native_window, false, attrib_list);
}

EGLSurface eglCreatePlatformPixmapSurfaceEXT(EGLDisplay dpy, EGLConfig config, void* native_pixmap,
                                             const EGLint* attrib_list) {
    begin_call(SPANGLE_TEXT("eglCreatePlatformPixmapSurfaceEXT"));
    return create_pointed(dpy, config, native_pixmap, true, attrib_list);
}

EGLSurface eglCreatePlatformPixmapSurface(EGLDisplay dpy, EGLConfig config, void* native_pixmap,
                                          const EGLAttrib* attrib_list) {
    begin_call(SPANGLE_TEXT("eglCreatePlatformPixmapSurface"));
    return create_pointed_wide(dpy, config, native_pixmap, true, attrib_list);
}

EGLSurface eglCreatePixmapSurface(EGLDisplay dpy, EGLConfig config, EGLNativePixmapType pixmap,
                                  const EGLint* attrib_list) {
    begin_call(SPANGLE_TEXT("eglCreatePixmapSurface"));
    return create_shown(dpy, config, pixmap, true, attrib_list);
}

EGLBoolean eglCopyBuffers(EGLDisplay dpy, EGLSurface handle, EGLNativePixmapType target) {
    begin_call(SPANGLE_TEXT("eglCopyBuffers"));
    const Registry registry;
    Display* const display = find_display(dpy);
    if (display == nullptr)
        return EGL_FALSE;
    Surface* const surface = find_surface(*display, handle);
    if (surface == nullptr)
        return EGL_FALSE;
    if (in_primitive())
        return fail_in_primitive(); // eglCopyBuffers flushes first (EGL 1.4, 3.9.2)
    if (display->system == nullptr)
        return fail(EGL_BAD_NATIVE_PIXMAP, SPANGLE_TEXT("this display has no pixmaps"));
    if (!display->system->shows(surface->config.format) || surface->in_bands())
        return fail(EGL_BAD_MATCH, SPANGLE_TEXT("a pixmap of this display has another format "
                                                "than the surface"));
    const spangle::gl::LockGuard held(display->native_lock);
    if (!surface->has_pixels())
        return fail(EGL_BAD_SURFACE, SPANGLE_TEXT("this surface has no buffer"));
    const auto opened = display->system->open(target, true, surface->config.format);
    if (!opened.ok())
        return fail(EGL_BAD_NATIVE_PIXMAP, opened.error().rule);
    spangle::hal::Display& pixmap = *opened.value();
    spangle::raster::resolve(pixels_of(*surface));
    const spangle::hal::DisplayInfo info = pixmap.info();
    const auto frame = pixmap.acquire();
    bool shown = frame.ok();
    if (shown) {
        copy_rows(*surface, frame.value(), info);
        shown = pixmap.present().ok();
    }
    display->system->close(pixmap);
    return shown ? end_call() : fail(EGL_BAD_NATIVE_PIXMAP, SPANGLE_TEXT("the pixmap took no picture"));
}
}

#endif
