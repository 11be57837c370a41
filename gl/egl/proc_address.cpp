// eglGetProcAddress (EGL 1.4, 3.10) finds entry points of EGL and GL by name. It is optional, because its
// table links every entry point into the program.
#include "gl/api/names.hpp"
#include "gl/context/features.hpp"
#include "gl/egl/objects.hpp"

namespace {

#if SPANGLE_FEATURE_GET_PROC_ADDRESS
struct Entry {
    const char* name;
    __eglMustCastToProperFunctionPointerType function;
};

template <class F> __eglMustCastToProperFunctionPointerType erase_type(F* function) {
    return reinterpret_cast<__eglMustCastToProperFunctionPointerType>(function);
}

bool are_equal_names(const char* a, const char* b) {
    for (; *a != '\0' && *a == *b; ++a)
        ++b;
    return *a == *b;
}

__eglMustCastToProperFunctionPointerType find_egl(const char* name) {
#define ENTRY(function)                                                                                      \
    { #function, erase_type(function) }
    const Entry table[] = {
        ENTRY(eglGetError),
        ENTRY(eglGetDisplay),
        ENTRY(eglInitialize),
        ENTRY(eglTerminate),
        ENTRY(eglQueryString),
        ENTRY(eglGetConfigs),
        ENTRY(eglChooseConfig),
        ENTRY(eglGetConfigAttrib),
        ENTRY(eglDestroySurface),
        ENTRY(eglQuerySurface),
        ENTRY(eglCreateWindowSurface),
        ENTRY(eglCreatePbufferSurface),
        ENTRY(eglBindAPI),
        ENTRY(eglQueryAPI),
        ENTRY(eglSwapInterval),
        ENTRY(eglCreateContext),
        ENTRY(eglDestroyContext),
        ENTRY(eglMakeCurrent),
        ENTRY(eglGetCurrentContext),
        ENTRY(eglGetCurrentSurface),
        ENTRY(eglQueryContext),
        ENTRY(eglGetCurrentDisplay),
        ENTRY(eglWaitGL),
        ENTRY(eglWaitClient),
        ENTRY(eglWaitNative),
        ENTRY(eglReleaseThread),
        ENTRY(eglSetPaletteSPANGLE),
        ENTRY(eglSwapBuffers),
        ENTRY(eglGetProcAddress),
        ENTRY(eglSurfaceAttrib),
        ENTRY(eglBindTexImage),
        ENTRY(eglReleaseTexImage),
        ENTRY(eglCreatePbufferFromClientBuffer),
#if SPANGLE_HAS_PLATFORMS
        ENTRY(eglCreatePixmapSurface),
        ENTRY(eglCopyBuffers),
        ENTRY(eglGetPlatformDisplay),
        ENTRY(eglGetPlatformDisplayEXT),
        ENTRY(eglCreatePlatformWindowSurface),
        ENTRY(eglCreatePlatformWindowSurfaceEXT),
        ENTRY(eglCreatePlatformPixmapSurface),
        ENTRY(eglCreatePlatformPixmapSurfaceEXT),
#endif
    };
#undef ENTRY
    for (const Entry& entry : table)
        if (are_equal_names(entry.name, name))
            return entry.function;
    return nullptr;
}
#endif

} // namespace

extern "C" __eglMustCastToProperFunctionPointerType eglGetProcAddress(const char* procname) {
#if SPANGLE_FEATURE_GET_PROC_ADDRESS
    if (procname == nullptr)
        return nullptr;
    const auto egl = find_egl(procname);
    return egl != nullptr ? egl : spangle::gl::find_entry_point(procname);
#else
    static_cast<void>(procname);
    return nullptr;
#endif
}
