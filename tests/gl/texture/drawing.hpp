// An off-screen surface of 4 x 4 pixels, 8 bits a component, filled with one colour: it shows what texturing
// makes of one fragment.
#pragma once

#include <vector>

#include <gtest/gtest.h>
#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>

namespace spangle::test {

struct Drawing : testing::Test {
    EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);

    void SetUp() override {
        ASSERT_EQ(eglInitialize(display, nullptr, nullptr), EGLBoolean{EGL_TRUE});
        const EGLint wishes[] = {EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_BIT,
                                 EGL_SURFACE_TYPE,
                                 EGL_PBUFFER_BIT,
                                 EGL_ALPHA_SIZE,
                                 8,
                                 EGL_NONE};
        const EGLint size[] = {EGL_WIDTH, 4, EGL_HEIGHT, 4, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint n = 0;
        ASSERT_EQ(eglChooseConfig(display, wishes, &config, 1, &n), EGLBoolean{EGL_TRUE});
        const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
        const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
        ASSERT_EQ(eglMakeCurrent(display, surface, surface, context), EGLBoolean{EGL_TRUE});
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glEnable(GL_TEXTURE_2D);
    }
    void TearDown() override {
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglTerminate(display);
    }
    /// Draws with one texture coordinate on the whole surface, and reads a pixel.
    void draw(float s, float t, std::vector<GLubyte>& pixel) {
        glTexCoord2f(s, t);
        glBegin(GL_TRIANGLE_STRIP);
        for (float y : {-1.0f, 1.0f})
            for (float x : {-1.0f, 1.0f})
                glVertex2f(x, y);
        glEnd();
        pixel.resize(4 * 4 * 4);
        glReadPixels(0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
        for (std::size_t i = 4; i < pixel.size(); ++i)
            ASSERT_EQ(pixel[i], pixel[i - 4]);
    }
};

} // namespace spangle::test
