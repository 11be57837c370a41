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

/// What a program's native display stands for: a window system, one panel or, if both are null, pbuffers
/// only.
struct NativeDisplay {
    bool known = false;
    hal::Display* panel = nullptr;
    hal::WindowSystem* windows = nullptr;
};

/// The pixel format and the precision that programs are drawn in.
struct DrawnFormat {
    PixelFormat format;
    EGLint precision;
};

/// What a host program tells EGL about its platforms, and what EGL hands to it.
struct Platforms {
    /// Client extensions of the platforms that `find` knows, each with a blank before it.
    const char* extensions = "";
    /// Finds the native display for eglGetPlatformDisplay, or for eglGetDisplay when `platform` is EGL_NONE.
    NativeDisplay (*find)(EGLenum platform, void* native) = nullptr;
    /// eglChooseConfig puts configs of this precision before configs that differ in precision only.
    EGLint precision = EGL_PRECISION_EXACT_SPANGLE;
    /// Bits of EGL_RENDERABLE_TYPE beside EGL_OPENGL_BIT. An attribute list that names no type asks for
    /// EGL_OPENGL_ES_BIT (EGL 1.4, table 3.4), and programs that bind OpenGL then expect a config.
    EGLint renderable = 0;
    /// Receives the picture of a pbuffer at eglSwapBuffers, which shows nothing itself (EGL 1.4, 3.9.1).
    /// Flush and Finish call it, too, for a pbuffer that is never swapped: programs for single buffers end
    /// frames so.
    void (*swapped)(const hal::Frame& picture, const hal::DisplayInfo& info) = nullptr;
    /// Receives a picture with its depth buffer, before `swapped` receives it.
    void (*planes)(const raster::Surface& picture) = nullptr;
    /// If not null, pbuffers and contexts have this format and precision and no samples, whatever their
    /// config says. So a program can be drawn in formats that it would not choose.
    const DrawnFormat* drawn = nullptr;
    /// Called with each new context.
    void (*created)(gl::Context& context) = nullptr;
};
/// Must be called before the first EGL command.
void use_platforms(const Platforms& platforms);
const Platforms& platforms();

/// What eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS) gives.
const char* client_extensions();

/// Returns EGL_SUCCESS, or the error that eglCreateContext raises for these attributes
/// (EGL_KHR_create_context).
EGLint context_problem(const EGLint* attrib_list);

/// Gives this thread's draw surface the present size of its window. glViewport calls it, because programs
/// call that when their window was resized.
void follow_current_window();

} // namespace spangle::egl
