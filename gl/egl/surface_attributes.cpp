// Queries and changes attributes of surfaces, and refuses kinds of surfaces that only other client APIs have
// (EGL 1.4, 3.5.3, 3.5.6, 3.6).
#include "gl/context/error.hpp"
#include "gl/egl/objects.hpp"

using namespace spangle::egl;

namespace {

Surface* find(EGLDisplay dpy, EGLSurface handle) {
    Display* const display = find_display(dpy);
    return display == nullptr ? nullptr : find_surface(*display, handle);
}

/// Refuses to bind a pbuffer as a texture: no config has EGL_BIND_TO_TEXTURE_RGB or RGBA (EGL 1.4, 3.6).
EGLBoolean refuse_texture(EGLDisplay dpy, EGLSurface handle, EGLint buffer) {
    const Registry registry;
    if (find(dpy, handle) == nullptr)
        return EGL_FALSE;
    if (buffer != EGL_BACK_BUFFER)
        return fail(EGL_BAD_PARAMETER, SPANGLE_TEXT("buffer is not EGL_BACK_BUFFER"));
    return fail(EGL_BAD_SURFACE, SPANGLE_TEXT("no config binds to textures; use "
                                              "glCopyTexImage2D"));
}

} // namespace

extern "C" {

EGLBoolean eglQuerySurface(EGLDisplay dpy, EGLSurface handle, EGLint attribute, EGLint* value) {
    begin_call(SPANGLE_TEXT("eglQuerySurface"));
    const Registry registry;
    Display* const display = find_display(dpy);
    if (display == nullptr)
        return EGL_FALSE;
    const Surface* const s = find_surface(*display, handle);
    if (s == nullptr)
        return EGL_FALSE;
    if (value == nullptr)
        return fail(EGL_BAD_PARAMETER, SPANGLE_TEXT("value is a null pointer"));
    switch (attribute) {
    case EGL_WIDTH:
        *value = s->width;
        break;
    case EGL_HEIGHT:
        *value = s->height;
        break;
    case EGL_CONFIG_ID:
        *value = s->config.id;
        break;
    case EGL_RENDER_BUFFER:
        *value = s->wants_single ? EGL_SINGLE_BUFFER : EGL_BACK_BUFFER;
        break;
    case EGL_ACCUM_SIZE_SPANGLE:
        *value = s->accum != nullptr ? accum_bits : 0;
        break;
    case EGL_BAND_RECORD_SPANGLE:
    case EGL_BAND_RECORD_PEAK_SPANGLE:
        *value = record_bytes(s->band, attribute == EGL_BAND_RECORD_PEAK_SPANGLE);
        break;
    case EGL_BAND_HEIGHT_SPANGLE:
        *value = s->band.height;
        break;
    case EGL_SWAP_BEHAVIOR:
        *value = EGL_BUFFER_DESTROYED;
        break; // programs ask EGL_BUFFER_AGE_EXT what a buffer still holds
    case EGL_BUFFER_AGE_EXT:
        // Only the current draw surface's buffer is known to stay the same (EGL_EXT_buffer_age).
        if (thread().draw != s)
            return fail(EGL_BAD_SURFACE, SPANGLE_TEXT("the age is known of the current draw surface alone"));
        *value = s->frame.age;
        break;
    case EGL_TEXTURE_FORMAT:
    case EGL_TEXTURE_TARGET:
        *value = EGL_NO_TEXTURE;
        break;
    case EGL_MIPMAP_TEXTURE:
    case EGL_LARGEST_PBUFFER:
        *value = EGL_FALSE;
        break;
    case EGL_MIPMAP_LEVEL:
        *value = 0;
        break;
    case EGL_MULTISAMPLE_RESOLVE:
        *value = EGL_MULTISAMPLE_RESOLVE_DEFAULT;
        break;
    case EGL_HORIZONTAL_RESOLUTION:
    case EGL_VERTICAL_RESOLUTION:
    case EGL_PIXEL_ASPECT_RATIO:
        *value = EGL_UNKNOWN;
        break;
    default:
        return fail(EGL_BAD_ATTRIBUTE, SPANGLE_TEXT("attribute is not one of surfaces"));
    }
    return end_call();
}

EGLBoolean eglSurfaceAttrib(EGLDisplay dpy, EGLSurface handle, EGLint attribute, EGLint value) {
    begin_call(SPANGLE_TEXT("eglSurfaceAttrib"));
    const Registry registry;
    if (find(dpy, handle) == nullptr)
        return EGL_FALSE;
    switch (attribute) {
    case EGL_MIPMAP_LEVEL:
        return end_call(); // the level has no effect on surfaces that are no textures (EGL 1.4, 3.5.6)
    case EGL_MULTISAMPLE_RESOLVE:
        return value == EGL_MULTISAMPLE_RESOLVE_DEFAULT ? end_call()
               : value == EGL_MULTISAMPLE_RESOLVE_BOX
                   ? fail(EGL_BAD_MATCH, SPANGLE_TEXT("the config has no EGL_MULTISAMPLE_RESOLVE_BOX_BIT"))
                   : fail(EGL_BAD_PARAMETER, SPANGLE_TEXT("value is none that the attribute takes"));
    case EGL_SWAP_BEHAVIOR:
        return value == EGL_BUFFER_DESTROYED ? end_call()
               : value == EGL_BUFFER_PRESERVED
                   ? fail(EGL_BAD_MATCH, SPANGLE_TEXT("the config has no EGL_SWAP_BEHAVIOR_PRESERVED_BIT"))
                   : fail(EGL_BAD_PARAMETER, SPANGLE_TEXT("value is none that the attribute takes"));
    default:
        return fail(EGL_BAD_ATTRIBUTE, SPANGLE_TEXT("attribute is not one of surfaces"));
    }
}

EGLBoolean eglBindTexImage(EGLDisplay dpy, EGLSurface handle, EGLint buffer) {
    begin_call(SPANGLE_TEXT("eglBindTexImage"));
    return refuse_texture(dpy, handle, buffer);
}

EGLBoolean eglReleaseTexImage(EGLDisplay dpy, EGLSurface handle, EGLint buffer) {
    begin_call(SPANGLE_TEXT("eglReleaseTexImage"));
    return refuse_texture(dpy, handle, buffer);
}

EGLSurface eglCreatePbufferFromClientBuffer(EGLDisplay dpy, EGLenum, EGLClientBuffer, EGLConfig,
                                            const EGLint*) {
    begin_call(SPANGLE_TEXT("eglCreatePbufferFromClientBuffer"));
    const Registry registry;
    if (find_display(dpy) != nullptr)
        fail(EGL_BAD_PARAMETER, SPANGLE_TEXT("only OpenVG has client "
                                             "buffers"));
    return EGL_NO_SURFACE;
}
}
