#include "boards/demo/demo.hpp"

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/native.hpp>

/// A scene profile may hold another tier only.
#ifndef DEMO_PRECISION
#define DEMO_PRECISION EGL_PRECISION_BALANCED_SPANGLE
#endif

namespace spangle::demo {

namespace {

/// A context on the display's window.
struct Window {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLSurface surface = EGL_NO_SURFACE;
    EGLContext context = EGL_NO_CONTEXT;

    const char* open(hal::Display& native_display) {
        static constexpr EGLint wish[] = {EGL_RENDERABLE_TYPE,   EGL_OPENGL_BIT, EGL_SURFACE_TYPE,
                                          EGL_WINDOW_BIT,        EGL_DEPTH_SIZE, 16,
                                          EGL_PRECISION_SPANGLE, DEMO_PRECISION, EGL_NONE};
        display = eglGetDisplay(native(native_display));
        if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE)
            return "eglInitialize";
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (eglChooseConfig(display, wish, &config, 1, &count) == EGL_FALSE || count == 0)
            return "eglChooseConfig";
        surface = eglCreateWindowSurface(display, config, 0, nullptr);
        if (surface == EGL_NO_SURFACE)
            return "eglCreateWindowSurface";
        context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
        if (context == EGL_NO_CONTEXT)
            return "eglCreateContext";
        if (eglMakeCurrent(display, surface, surface, context) == EGL_FALSE)
            return "eglMakeCurrent";
        return nullptr;
    }

    /// Everything GL holds goes with the context and the window.
    void close() const {
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context != EGL_NO_CONTEXT)
            eglDestroyContext(display, context);
        if (surface != EGL_NO_SURFACE)
            eglDestroySurface(display, surface);
    }
};

const char* draw(const Window& window, hal::Display& display, const scenes::Scene& scene, int frames,
                 Watcher& watcher) {
    const hal::DisplayInfo info = display.info();
    if (format_info(info.format).bits >= 16) // fewer need it
        glDisable(GL_DITHER);
    scene.setup(info.width, info.height);
    for (int frame = 0; frame < frames; ++frame) {
        watcher.begin_frame();
        scene.draw(frame);
        if (glGetError() != GL_NO_ERROR)
            return "the scene";
        watcher.drawn();
        if (eglSwapBuffers(window.display, window.surface) == EGL_FALSE)
            return "eglSwapBuffers";
        watcher.presented();
    }
    return nullptr;
}

} // namespace

const char* play(hal::Display& display, const scenes::Scene& scene, int frames, Watcher& watcher) {
    Window window;
    const char* problem = window.open(display);
    if (problem == nullptr)
        problem = draw(window, display, scene, frames, watcher);
    window.close();
    return problem;
}

std::uint32_t frame_hash(hal::Display& display) {
    const hal::DisplayInfo info = display.info();
    const hal::Result<hal::Frame> frame = display.acquire();
    std::uint32_t hash = 2166136261u;
    for (std::int32_t y = 0; frame.ok() && y < stored_rows(info.format, info.height); ++y) {
        const std::uint8_t* const row =
            frame.value().pixels + static_cast<std::ptrdiff_t>(y) * frame.value().stride;
        for (std::int32_t i = 0; i < row_bytes(info.format, info.width); ++i)
            hash = (hash ^ row[i]) * 16777619u;
    }
    return hash;
}

} // namespace spangle::demo
