// The part of EGL beyond 1.4 that programs for PCs need: platforms with windows of their own
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

/// The meaning of a program's native display: a window system, one panel or, if both are null, pbuffers only.
struct NativeDisplay {
    bool known = false;
    hal::Display* panel = nullptr;
    hal::WindowSystem* windows = nullptr;
};

/// A pixel format and a precision in which programs are drawn.
struct DrawnFormat {
    PixelFormat format;
    EGLint precision;
};

/// Describes the platforms of a host program to EGL, and receives pictures from EGL.
struct Platforms {
    /// Client extensions of the platforms that `find` knows, each with a blank before it.
    const char* extensions = "";
    /// Finds the native display for eglGetPlatformDisplay, or for eglGetDisplay when `platform` is EGL_NONE.
    NativeDisplay (*find)(EGLenum platform, void* native) = nullptr;
    /// eglChooseConfig puts configs of this precision before configs that differ in precision only.
    EGLint precision = EGL_PRECISION_EXACT_SPANGLE;
    /// Bits of EGL_RENDERABLE_TYPE beside EGL_OPENGL_BIT. An attribute list that names no type asks for
    /// EGL_OPENGL_ES_BIT (EGL 1.4, table 3.4). Programs that bind OpenGL expect a config even then.
    EGLint renderable = 0;
    /// Receives the picture of a pbuffer at eglSwapBuffers, which shows nothing itself (EGL 1.4, 3.9.1).
    /// Flush and Finish call it, too, for a pbuffer that is never swapped, because programs for single
    /// buffers end frames with them.
    void (*swapped)(const hal::Frame& picture, const hal::DisplayInfo& info) = nullptr;
    /// Receives a picture with its depth buffer, before `swapped` receives it.
    void (*planes)(const raster::Surface& picture) = nullptr;
    /// If not null, pbuffers and contexts have this format and precision and no samples, whatever their
    /// config says. A program can thus be drawn in formats that it would not choose.
    const DrawnFormat* drawn = nullptr;
    /// Called with each new context.
    void (*created)(gl::Context& context) = nullptr;
};
/// Sets the platforms. It must be called before the first EGL command.
void use_platforms(const Platforms& platforms);
const Platforms& platforms();

/// Returns the string of eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS).
const char* client_extensions();

/// Returns EGL_SUCCESS, or the error that eglCreateContext raises for these attributes
/// (EGL_KHR_create_context).
EGLint context_problem(const EGLint* attrib_list);

/// Gives this thread's draw surface the present size of its window. glViewport calls this, because programs
/// call glViewport when their window was resized.
void follow_current_window();

} // namespace spangle::egl
