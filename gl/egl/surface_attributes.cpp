// Attributes that surfaces are given later, and kinds of surfaces that only other client APIs have
// (EGL 1.4, 3.5.3, 3.5.6, 3.6).
#include "gl/context/error.hpp"
#include "gl/egl/objects.hpp"

using namespace spangle::egl;

namespace {

Surface* find(EGLDisplay dpy, EGLSurface handle) {
    Display* const display = find_display(dpy);
    return display == nullptr ? nullptr : find_surface(*display, handle);
}

/// No config has EGL_BIND_TO_TEXTURE_RGB or RGBA: pbuffers of this EGL are no textures (EGL 1.4, 3.6).
EGLBoolean refuse_texture(EGLDisplay dpy, EGLSurface handle, EGLint buffer) {
    if (find(dpy, handle) == nullptr)
        return EGL_FALSE;
    if (buffer != EGL_BACK_BUFFER)
        return fail(EGL_BAD_PARAMETER);
    return fail(EGL_BAD_SURFACE, SPANGLE_TEXT("eglBindTexImage: no config binds to textures; use "
                                              "glCopyTexImage2D"));
}

} // namespace

extern "C" {

EGLBoolean eglSurfaceAttrib(EGLDisplay dpy, EGLSurface handle, EGLint attribute, EGLint value) {
    if (find(dpy, handle) == nullptr)
        return EGL_FALSE;
    switch (attribute) {
    case EGL_MIPMAP_LEVEL:
        return succeed(); // of surfaces that are textures; of others it has no effect (EGL 1.4, 3.5.6)
    case EGL_MULTISAMPLE_RESOLVE:
        return value == EGL_MULTISAMPLE_RESOLVE_DEFAULT ? succeed()
               : value == EGL_MULTISAMPLE_RESOLVE_BOX   ? fail(EGL_BAD_MATCH)
                                                        : fail(EGL_BAD_PARAMETER);
    case EGL_SWAP_BEHAVIOR:
        return value == EGL_BUFFER_DESTROYED   ? succeed()
               : value == EGL_BUFFER_PRESERVED ? fail(EGL_BAD_MATCH)
                                               : fail(EGL_BAD_PARAMETER);
    default:
        return fail(EGL_BAD_ATTRIBUTE);
    }
}

EGLBoolean eglBindTexImage(EGLDisplay dpy, EGLSurface handle, EGLint buffer) {
    return refuse_texture(dpy, handle, buffer);
}

EGLBoolean eglReleaseTexImage(EGLDisplay dpy, EGLSurface handle, EGLint buffer) {
    return refuse_texture(dpy, handle, buffer);
}

EGLSurface eglCreatePbufferFromClientBuffer(EGLDisplay dpy, EGLenum, EGLClientBuffer, EGLConfig,
                                            const EGLint*) {
    if (find_display(dpy) != nullptr)
        fail(EGL_BAD_PARAMETER, SPANGLE_TEXT("eglCreatePbufferFromClientBuffer: only OpenVG has client "
                                             "buffers"));
    return EGL_NO_SURFACE;
}
}
