// A GL context to draw into without a display: a pbuffer of RGBA8888 with 24 bits of depth.
#pragma once

#include <vector>

#include <gtest/gtest.h>
#include <spangle/EGL/egl.h>

namespace spangle::test {

/// A context that is current on this thread as long as the object lives.
class HeadlessGl {
  public:
    /// `more` holds further attributes of the config, `of_surface` further attributes of the surface.
    HeadlessGl(int width, int height, const std::vector<EGLint>& more = {},
               const std::vector<EGLint>& of_surface = {})
        : display_(eglGetDisplay(EGL_DEFAULT_DISPLAY)) {
        EXPECT_TRUE(eglInitialize(display_, nullptr, nullptr));
        std::vector<EGLint> wish = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                    EGL_SURFACE_TYPE,    EGL_PBUFFER_BIT,
                                    EGL_ALPHA_SIZE,      8,
                                    EGL_DEPTH_SIZE,      24};
        wish.insert(wish.end(), more.begin(), more.end());
        wish.push_back(EGL_NONE);
        std::vector<EGLint> area = {EGL_WIDTH, width, EGL_HEIGHT, height};
        area.insert(area.end(), of_surface.begin(), of_surface.end());
        area.push_back(EGL_NONE);
        EGLConfig config = nullptr;
        EGLint count = 0;
        EXPECT_TRUE(eglChooseConfig(display_, wish.data(), &config, 1, &count) && count == 1);
        const EGLSurface surface = eglCreatePbufferSurface(display_, config, area.data());
        EXPECT_TRUE(eglMakeCurrent(display_, surface, surface,
                                   eglCreateContext(display_, config, EGL_NO_CONTEXT, nullptr)));
    }
    ~HeadlessGl() {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglTerminate(display_);
    }
    HeadlessGl(const HeadlessGl&) = delete;
    HeadlessGl& operator=(const HeadlessGl&) = delete;

  private:
    EGLDisplay display_;
};

} // namespace spangle::test
