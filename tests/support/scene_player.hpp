// Plays a scene on a display, through EGL as a program would draw it.
#pragma once

#include <functional>

#include <spangle/EGL/egl.h>
#include <spangle/native.hpp>

#include "boards/scenes/scene.hpp"

namespace spangle::test {

/// Plays frames 0 to frames - 1, and calls `drawn` before each frame is presented. Returns false if EGL
/// refused anything. All frames but the first are sent as damage.
inline bool play(
    hal::Display& target, const scenes::Scene& scene, int frames,
    const std::function<void()>& drawn = [] {}) {
    const EGLDisplay display = eglGetDisplay(native(target));
    const EGLint wish[] = {EGL_SURFACE_TYPE,
                           EGL_WINDOW_BIT,
                           EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_DEPTH_SIZE,
                           16,
                           EGL_STENCIL_SIZE,
                           0,
                           EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    bool good = eglInitialize(display, nullptr, nullptr) != EGL_FALSE &&
                eglBindAPI(EGL_OPENGL_API) != EGL_FALSE &&
                eglChooseConfig(display, wish, &config, 1, &count) != EGL_FALSE && count == 1;
    const EGLSurface window = eglCreateWindowSurface(display, config, 0, nullptr);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    good = good && eglMakeCurrent(display, window, window, context) != EGL_FALSE;
    const hal::DisplayInfo info = target.info();
    if (good)
        scene.setup(info.width, info.height);
    for (int frame = 0; good && frame < frames; ++frame) {
        scene.draw(frame);
        drawn();
        good = eglSwapBuffers(display, window) != EGL_FALSE;
    }
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglTerminate(display);
    return good;
}

} // namespace spangle::test
