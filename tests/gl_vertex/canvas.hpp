// A context with a pbuffer to draw vertices into.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>

namespace spangle::test {

class Canvas : public testing::Test {
  protected:
    explicit Canvas(int side = size) : side_(side) {}
    static constexpr int size = 64; ///< of most

    void SetUp() override {
        display_ = eglGetDisplay(EGL_DEFAULT_DISPLAY);
        ASSERT_TRUE(eglInitialize(display_, nullptr, nullptr));
        const EGLint wish[] = {EGL_RENDERABLE_TYPE,
                               EGL_OPENGL_BIT,
                               EGL_SURFACE_TYPE,
                               EGL_PBUFFER_BIT,
                               EGL_ALPHA_SIZE,
                               8,
                               EGL_DEPTH_SIZE,
                               24,
                               EGL_NONE};
        const EGLint area[] = {EGL_WIDTH, side_, EGL_HEIGHT, side_, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        ASSERT_TRUE(eglChooseConfig(display_, wish, &config, 1, &count) && count == 1);
        const EGLSurface surface = eglCreatePbufferSurface(display_, config, area);
        ASSERT_TRUE(
            eglMakeCurrent(display_, surface, surface, eglCreateContext(display_, config, nullptr, nullptr)));
    }
    void TearDown() override {
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        eglMakeCurrent(display_, nullptr, nullptr, nullptr);
        eglTerminate(display_);
    }

    EGLDisplay display_ = nullptr;

  private:
    int side_;
};

} // namespace spangle::test
