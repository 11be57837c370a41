// What programs written for PCs ask of EGL beyond 1.4: platforms with windows of their own
// (EGL_EXT_platform_base). Boards have one display and leave this out.
#pragma once

#include <spangle/EGL/egl.h>
#include <spangle/hal/display.hpp>
#include <spangle/hal/window_system.hpp>

namespace spangle::gl {
struct Context;
}
namespace spangle::raster {
struct Surface;
}

namespace spangle::egl {

/// What a program's native display is: a window system, or one panel, or, with neither, a place for pbuffers.
struct NativeDisplay {
    bool known = false;
    hal::Display* panel = nullptr;
    hal::WindowSystem* windows = nullptr;
};

/// What pixels are and in which numbers they are made.
struct Drawn {
    PixelFormat format;
    EGLint precision;
};

/// What a host that is more than a board's display tells EGL.
struct Platforms {
    /// Client extensions of the platforms that `find` knows, each with a blank before it.
    const char* extensions = "";
    /// Resolves eglGetPlatformDisplay; with platform EGL_NONE eglGetDisplay.
    NativeDisplay (*find)(EGLenum platform, void* native) = nullptr;
    /// Of configs that differ in nothing else, the one that eglChooseConfig gives first has this precision.
    EGLint precision = EGL_PRECISION_EXACT_SPANGLE;
    /// Bits of EGL_RENDERABLE_TYPE beside EGL_OPENGL_BIT. A wish that names no type asks for
    /// EGL_OPENGL_ES_BIT (EGL 1.4, table 3.4), and programs that bind OpenGL then expect a config.
    EGLint renderable = 0;
    /// eglSwapBuffers of a pbuffer, which shows nothing (EGL 1.4, 3.9.1), hands its picture here; so do Flush
    /// and Finish of one that is never swapped: programs for single buffers end frames like that.
    void (*swapped)(const hal::Frame& picture, const hal::DisplayInfo& info) = nullptr;
    /// Sees a picture before `swapped` does, with its depth buffer.
    void (*planes)(const raster::Surface& picture) = nullptr;
    /// Not null: pbuffers and contexts have this format and precision and no samples, whatever their config
    /// says. So a program is drawn in formats that it would not choose.
    const Drawn* drawn = nullptr;
    /// Sees each new context.
    void (*created)(gl::Context& context) = nullptr;
};
/// Must come before the first EGL call.
void use_platforms(const Platforms& platforms);
const Platforms& platforms();

/// What eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS) gives.
const char* client_extensions();

/// EGL_SUCCESS, or what eglCreateContext says to these attributes (EGL_KHR_create_context).
EGLint context_problem(const EGLint* attrib_list);

/// glViewport is what programs say when their window has another size: the surface this thread draws to
/// follows.
void follow_current_window();

} // namespace spangle::egl
