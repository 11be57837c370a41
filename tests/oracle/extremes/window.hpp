// A pbuffer of Spangle with a context of one tier.
#pragma once

#include <array>

#include <gtest/gtest.h>
#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>

namespace spangle::test {

inline constexpr EGLint tiers[] = {EGL_PRECISION_EXACT_SPANGLE, EGL_PRECISION_BALANCED_SPANGLE,
                                   EGL_PRECISION_FAST_SPANGLE};

/// A context that is current while the object lives.
class Window {
  public:
    Window(EGLint tier, int size, EGLint depth, EGLint red) : display_(eglGetDisplay(EGL_DEFAULT_DISPLAY)) {
        EXPECT_TRUE(eglInitialize(display_, nullptr, nullptr));
        const EGLint wish[] = {EGL_RENDERABLE_TYPE,   EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT,
                               EGL_PRECISION_SPANGLE, tier,           EGL_NONE};
        std::array<EGLConfig, 256> configs{};
        EGLint count = 0;
        EXPECT_TRUE(eglChooseConfig(display_, wish, configs.data(), 256, &count));
        EGLConfig found = nullptr;
        for (EGLint i = count - 1; i >= 0; --i) {
            const EGLConfig config = configs[static_cast<std::size_t>(i)];
            const auto has = [&](EGLint name, EGLint value) {
                EGLint is = -1;
                return eglGetConfigAttrib(display_, config, name, &is) && is == value;
            };
            if (has(EGL_DEPTH_SIZE, depth) && has(EGL_RED_SIZE, red) && has(EGL_SAMPLES, 0) &&
                has(EGL_ALPHA_SIZE, red == 8 ? 8 : 0))
                found = config;
        }
        EXPECT_TRUE(found);
        const EGLint area[] = {EGL_WIDTH, size, EGL_HEIGHT, size, EGL_NONE};
        const EGLSurface surface = eglCreatePbufferSurface(display_, found, area);
        EXPECT_TRUE(eglMakeCurrent(display_, surface, surface,
                                   eglCreateContext(display_, found, EGL_NO_CONTEXT, nullptr)));
    }
    ~Window() {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglTerminate(display_);
    }
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

  private:
    EGLDisplay display_;
};

} // namespace spangle::test
