// A context on a picture for the benchmarks: RGB565 with 16-bit depth, or with the wished buffers.
#pragma once

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/native.hpp>

namespace spangle::bench {

/// Least bits of a pixel's alpha, depth and stencil, and samples.
struct Buffers {
    EGLint alpha = 0, depth = 16, stencil = 0, samples = 0;
};

struct Headless {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLSurface surface = EGL_NO_SURFACE;
    EGLContext context = EGL_NO_CONTEXT;
    std::size_t surface_bytes = 0, context_bytes = 0; ///< bytes of Spangle's memory

    /// Opens a context of `precision`, an EGL_PRECISION_..._SPANGLE token. Returns false if anything fails.
    bool open(int width, int height, EGLint precision, const Buffers& buffers = {}) {
        display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
        if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE)
            return false;
        const EGLint wish[] = {EGL_RENDERABLE_TYPE,   EGL_OPENGL_BIT,  EGL_SURFACE_TYPE, EGL_PBUFFER_BIT,
                               EGL_ALPHA_SIZE,        buffers.alpha,   EGL_DEPTH_SIZE,   buffers.depth,
                               EGL_STENCIL_SIZE,      buffers.stencil, EGL_SAMPLES,      buffers.samples,
                               EGL_PRECISION_SPANGLE, precision,       EGL_NONE};
        const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (eglChooseConfig(display, wish, &config, 1, &count) == EGL_FALSE || count == 0)
            return false;
        const std::size_t before = memory_use().used;
        surface = eglCreatePbufferSurface(display, config, size);
        surface_bytes = memory_use().used - before;
        context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
        context_bytes = memory_use().used - before - surface_bytes;
        return eglMakeCurrent(display, surface, surface, context) != EGL_FALSE;
    }

    /// Makes this context current, if several are open.
    bool make_current() const { return eglMakeCurrent(display, surface, surface, context) != EGL_FALSE; }

    void close() {
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglTerminate(display);
    }
};

} // namespace spangle::bench
