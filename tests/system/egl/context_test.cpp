// Tests contexts: creation, sharing, MakeCurrent, lifetime, entry points by name (EGL 1.4, 3.7, 3.10).
#include <gtest/gtest.h>

#include <spangle/GL/gl.h>

#include <cstring>
#include <thread>

#include "gl/context/features.hpp"
#include "gl/egl/objects.hpp"
#include "tests/system/egl/fake_display.hpp"

namespace spangle::test {
namespace {

constexpr EGLBoolean yes = EGL_TRUE, no = EGL_FALSE;

struct Contexts : testing::Test {
    EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    std::size_t memory_before = memory_use().used;
    EGLConfig config = nullptr, sixteen = nullptr;

    void SetUp() override {
        ASSERT_EQ(eglInitialize(display, nullptr, nullptr), yes);
        const EGLint wishes[] = {EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_BIT,
                                 EGL_SURFACE_TYPE,
                                 EGL_PBUFFER_BIT,
                                 EGL_ALPHA_SIZE,
                                 8,
                                 EGL_DEPTH_SIZE,
                                 24,
                                 EGL_STENCIL_SIZE,
                                 8,
                                 EGL_NONE};
        const EGLint small[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT,
                                EGL_NONE};
        EGLint n = 0;
        ASSERT_EQ(eglChooseConfig(display, wishes, &config, 1, &n), yes);
        ASSERT_EQ(eglChooseConfig(display, small, &sixteen, 1, &n), yes);
    }
    void TearDown() override {
        EXPECT_EQ(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT), yes);
        eglTerminate(display);
        EXPECT_EQ(memory_use().used, memory_before);
        EXPECT_TRUE(egl::arena().consistent());
    }
    EGLSurface pbuffer(EGLint width = 8, EGLint height = 8, EGLConfig of = nullptr) {
        const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
        return eglCreatePbufferSurface(display, of == nullptr ? config : of, size);
    }
    EGLContext context(EGLContext share = EGL_NO_CONTEXT) {
        return eglCreateContext(display, config, share, nullptr);
    }
    EGLint query(EGLContext c, EGLint name) {
        EGLint value = -7;
        EXPECT_EQ(eglQueryContext(display, c, name, &value), yes);
        return value;
    }
};

TEST_F(Contexts, CreationErrors) {
    int local = 0;
    EXPECT_EQ(eglCreateContext(nullptr, config, EGL_NO_CONTEXT, nullptr), EGL_NO_CONTEXT);
    EXPECT_EQ(eglGetError(), EGL_BAD_DISPLAY);
    EXPECT_EQ(eglCreateContext(display, &local, EGL_NO_CONTEXT, nullptr), EGL_NO_CONTEXT);
    EXPECT_EQ(eglGetError(), EGL_BAD_CONFIG);
    EXPECT_EQ(eglCreateContext(display, config, &local, nullptr), EGL_NO_CONTEXT);
    EXPECT_EQ(eglGetError(), EGL_BAD_CONTEXT);
    const EGLint list[] = {EGL_WIDTH, 1, EGL_NONE}; // an attribute of surfaces only
    EXPECT_EQ(eglCreateContext(display, config, EGL_NO_CONTEXT, list), EGL_NO_CONTEXT);
    EXPECT_EQ(eglGetError(), EGL_BAD_ATTRIBUTE);
}

TEST_F(Contexts, WhatIsCurrent) {
    EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
    EXPECT_EQ(eglGetCurrentDisplay(), EGL_NO_DISPLAY);
    EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), EGL_NO_SURFACE);
    const EGLSurface surface = pbuffer();
    const EGLContext c = context();
    EXPECT_EQ(query(c, EGL_RENDER_BUFFER), EGL_NONE);
    ASSERT_EQ(eglMakeCurrent(display, surface, surface, c), yes);
    EXPECT_EQ(eglGetCurrentContext(), c);
    EXPECT_EQ(eglGetCurrentDisplay(), display);
    EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), surface);
    EXPECT_EQ(eglGetCurrentSurface(EGL_READ), surface);
    EXPECT_EQ(eglGetCurrentSurface(EGL_WIDTH), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
    EXPECT_EQ(query(c, EGL_RENDER_BUFFER), EGL_BACK_BUFFER); // the surface is a pbuffer (EGL 1.4, 3.5.6)
    EXPECT_EQ(query(c, EGL_CONTEXT_CLIENT_TYPE), EGL_OPENGL_API);
    EGLint id = 0, value = 0;
    EXPECT_EQ(eglGetConfigAttrib(display, config, EGL_CONFIG_ID, &id), yes);
    EXPECT_EQ(query(c, EGL_CONFIG_ID), id);
    EXPECT_EQ(eglQueryContext(display, c, EGL_WIDTH, &value), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_ATTRIBUTE);
    EXPECT_EQ(eglQueryContext(display, c, EGL_CONFIG_ID, nullptr), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
    EXPECT_EQ(eglSwapInterval(display, 5), yes); // the interval is clamped
    EXPECT_EQ(eglReleaseThread(), yes);
    EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
    glClear(GL_COLOR_BUFFER_BIT); // without a context this has no effect
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(Contexts, MakeCurrentErrors) {
    const EGLSurface surface = pbuffer(), second = pbuffer(), flat = pbuffer(8, 8, sixteen);
    const EGLContext c = context(), d = context();
    ASSERT_EQ(eglMakeCurrent(display, surface, surface, c), yes);
    const struct {
        EGLSurface draw, read;
        EGLContext context;
        EGLint error;
    } cases[] = {
        {surface, EGL_NO_SURFACE, EGL_NO_CONTEXT, EGL_BAD_MATCH},
        {EGL_NO_SURFACE, surface, EGL_NO_CONTEXT, EGL_BAD_MATCH},
        {EGL_NO_SURFACE, EGL_NO_SURFACE, c, EGL_BAD_MATCH},
        {surface, EGL_NO_SURFACE, c, EGL_BAD_MATCH},
        {flat, flat, c, EGL_BAD_MATCH},
        {c, c, c, EGL_BAD_SURFACE},
        {surface, surface, surface, EGL_BAD_CONTEXT},
        {surface, flat, c, EGL_BAD_MATCH}, // the surface to read must fit the context, too
        {flat, surface, c, EGL_BAD_MATCH},
    };
    for (const auto& bad : cases) {
        EXPECT_EQ(eglMakeCurrent(display, bad.draw, bad.read, bad.context), no) << &bad - cases;
        EXPECT_EQ(eglGetError(), bad.error) << &bad - cases;
        EXPECT_EQ(eglGetCurrentContext(), c); // the current context stays
        EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), surface);
    }
    EXPECT_EQ(eglMakeCurrent(nullptr, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_DISPLAY);
    EXPECT_EQ(eglGetCurrentContext(), c);
    std::thread([&] {
        EXPECT_EQ(eglMakeCurrent(display, second, second, c), no); // the context is current on another thread
        EXPECT_EQ(eglGetError(), EGL_BAD_ACCESS);
        EXPECT_EQ(eglMakeCurrent(display, surface, surface, d), no);
        EXPECT_EQ(eglGetError(), EGL_BAD_ACCESS);
        EXPECT_EQ(eglMakeCurrent(display, second, surface, d), no);
        EXPECT_EQ(eglGetError(), EGL_BAD_ACCESS);
        EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
    }).join();
    EXPECT_EQ(eglMakeCurrent(display, surface, surface, c), yes); // they are current already
    EXPECT_EQ(eglMakeCurrent(display, surface, surface, d), yes); // the surface gets another context
    EXPECT_EQ(eglMakeCurrent(display, second, second, d), yes);
}

/// Draws a texture of one colour over the whole surface, and returns the word of the surface's first pixel.
std::uint32_t pixel_of_texture() {
    std::uint32_t pixel = 0;
    glRectf(-1, -1, 1, 1);
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
    return pixel;
}
void store_texture(std::uint32_t color, GLsizei side) {
    std::uint32_t texels[64];
    for (std::uint32_t& texel : texels)
        texel = color;
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
}

TEST_F(Contexts, ATextureReplacedByAnotherContextIsSeenWithoutBindingItAgain) {
    const EGLSurface surface = pbuffer(), second = pbuffer();
    const EGLContext c = context(), d = context(c);
    ASSERT_EQ(eglMakeCurrent(display, surface, surface, c), yes);
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    store_texture(0x55555555, 8);
    EXPECT_EQ(pixel_of_texture(), 0x55555555u);
    std::thread([&] { // c stays current here, and its compiled state has the address of the old texels
        ASSERT_EQ(eglMakeCurrent(display, second, second, d), yes);
        glBindTexture(GL_TEXTURE_2D, name);
        store_texture(0xEEEEEEEE, 4);
        GLuint other = 0;
        glGenTextures(1, &other);
        glBindTexture(GL_TEXTURE_2D, other);
        store_texture(0x11111111, 8); // memory where the old texels were
        EXPECT_EQ(eglReleaseThread(), yes);
    })
        .join();
    EXPECT_EQ(pixel_of_texture(), 0xEEEEEEEEu);
    std::thread([&] { // makes the texture incomplete: drawn as if texturing were off (GL 1.3, 3.8.15)
        ASSERT_EQ(eglMakeCurrent(display, second, second, d), yes);
        glBindTexture(GL_TEXTURE_2D, name);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
        EXPECT_EQ(eglReleaseThread(), yes);
    })
        .join();
    EXPECT_EQ(pixel_of_texture(), 0xFFFFFFFFu);
}

TEST_F(Contexts, ObjectsLiveWhileTheyAreCurrent) {
    const EGLSurface surface = pbuffer();
    const EGLContext c = context();
    ASSERT_EQ(eglMakeCurrent(display, surface, surface, c), yes);
    EXPECT_EQ(eglDestroySurface(display, surface), yes);
    EXPECT_EQ(eglDestroyContext(display, c), yes);
    EGLint value = 0;
    EXPECT_EQ(eglQuerySurface(display, surface, EGL_WIDTH, &value), no); // the handles are no longer valid
    EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
    EXPECT_EQ(eglDestroyContext(display, c), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_CONTEXT);
    glClearColor(0, 1, 0, 1); // drawing to destroyed current objects goes on
    glClear(GL_COLOR_BUFFER_BIT);
    GLubyte pixel[4] = {};
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    EXPECT_EQ(pixel[1], 255);
    EXPECT_GT(memory_use().used, memory_before);
    EXPECT_EQ(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT), yes);
    EXPECT_EQ(memory_use().used, memory_before); // the released objects are freed here
}

TEST_F(Contexts, TerminateEndsEverythingThatIsNotCurrent) {
    const EGLSurface surface = pbuffer(), idle = pbuffer();
    const EGLContext c = context();
    context();
    ASSERT_EQ(eglMakeCurrent(display, surface, surface, c), yes);
    EXPECT_EQ(eglTerminate(display), yes);
    EXPECT_EQ(eglDestroySurface(display, idle), no);
    EXPECT_EQ(eglGetError(), EGL_NOT_INITIALIZED);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    EXPECT_EQ(eglReleaseThread(), yes);
    EXPECT_EQ(memory_use().used, memory_before);
    ASSERT_EQ(eglInitialize(display, nullptr, nullptr), yes); // the display can be initialized again
}

TEST_F(Contexts, SharedTexturesAndTheirMemory) {
    const EGLSurface surface = pbuffer();
    const EGLContext a = context(), b = context(a), alone = context();
    ASSERT_EQ(eglMakeCurrent(display, surface, surface, a), yes);
    glBindTexture(GL_TEXTURE_2D, 3);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 32, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    ASSERT_EQ(eglMakeCurrent(display, surface, surface, b), yes);
    EXPECT_EQ(glIsTexture(3), GLboolean{GL_TRUE});
    GLint bound = -1, width = -1;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    EXPECT_EQ(bound, 0); // bindings are not shared
    glBindTexture(GL_TEXTURE_2D, 3);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    EXPECT_EQ(width, 32);
    EXPECT_EQ(eglDestroyContext(display, a), yes); // b keeps the share group
    EXPECT_EQ(glIsTexture(3), GLboolean{GL_TRUE});
    ASSERT_EQ(eglMakeCurrent(display, surface, surface, alone), yes);
    EXPECT_EQ(glIsTexture(3), GLboolean{GL_FALSE});
}

TEST_F(Contexts, TheFirstSurfaceGivesViewportAndScissor) {
    const EGLSurface first = pbuffer(10, 20), second = pbuffer(30, 40);
    const EGLContext c = context();
    for (EGLSurface surface : {first, second}) {
        ASSERT_EQ(eglMakeCurrent(display, surface, surface, c), yes);
        GLint viewport[4] = {}, box[4] = {};
        glGetIntegerv(GL_VIEWPORT, viewport);
        glGetIntegerv(GL_SCISSOR_BOX, box);
        for (const GLint* v : {viewport, box}) {
            EXPECT_EQ(v[0], 0);
            EXPECT_EQ(v[2], 10);
            EXPECT_EQ(v[3], 20);
        }
    }
    GLint buffer = 0;
    glGetIntegerv(GL_DRAW_BUFFER, &buffer);
    EXPECT_EQ(buffer, GL_BACK);
}

TEST_F(Contexts, PixelsStayInTheirSurface) {
    const EGLSurface one = pbuffer(), two = pbuffer();
    const EGLContext c = context();
    GLubyte pixel[4];
    int shade = 0;
    for (EGLSurface surface : {one, two}) {
        ASSERT_EQ(eglMakeCurrent(display, surface, surface, c), yes);
        glClearColor(static_cast<float>(shade++), 0, 1, 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    shade = 0;
    for (EGLSurface surface : {one, two}) {
        ASSERT_EQ(eglMakeCurrent(display, surface, surface, c), yes);
        glReadPixels(7, 7, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
        EXPECT_EQ(pixel[0], 255 * shade++);
        EXPECT_EQ(pixel[2], 255);
    }
}

/// Drawing goes to `draw`, and ReadPixels returns pixels of `read` (EGL 1.4, 3.7.3).
TEST_F(Contexts, TwoSurfacesOneDrawnToOneReadFrom) {
    const EGLSurface from = pbuffer(8, 8), to = pbuffer(4, 4);
    const EGLContext c = context(), d = context();
    GLubyte pixel[4];
    const auto fill = [](float red) {
        glClearColor(red, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
    };
    const auto red_at = [&](GLint at) {
        glReadPixels(at, at, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
        return int{pixel[0]};
    };
    ASSERT_EQ(eglMakeCurrent(display, from, from, c), yes);
    fill(1);
    ASSERT_EQ(eglMakeCurrent(display, to, from, c), yes);
    EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), to);
    EXPECT_EQ(eglGetCurrentSurface(EGL_READ), from);
    fill(0.2f);
    EXPECT_EQ(red_at(7), 255); // the surface that is read has this pixel, though the drawn one is smaller
    // Both surfaces are current, so they last until they are released, although they are destroyed.
    EXPECT_EQ(eglDestroySurface(display, from), yes);
    EXPECT_EQ(red_at(0), 255);
    const std::size_t before = memory_use().used;
    ASSERT_EQ(eglMakeCurrent(display, to, to, c), yes);
    EXPECT_LT(memory_use().used, before);
    EXPECT_EQ(red_at(3), 51);
    EXPECT_EQ(eglMakeCurrent(display, to, to, d), yes); // nothing of the old pair is left
    EXPECT_EQ(red_at(3), 51);
    std::thread([&] { EXPECT_EQ(eglMakeCurrent(display, to, to, c), no); }).join();
}

/// Drawing reaches the edges of the surface that is current now, not of the one before.
TEST_F(Contexts, EachSurfaceIsDrawnToItsEdges) {
    const EGLSurface small = pbuffer(4, 5), large = pbuffer(30, 20);
    const EGLContext c = context();
    for (const EGLSurface surface : {small, large, small}) {
        ASSERT_EQ(eglMakeCurrent(display, surface, surface, c), yes);
        const bool is_large = surface == large;
        const GLint width = is_large ? 30 : 4, height = is_large ? 20 : 5;
        glViewport(0, 0, width, height);
        glClear(GL_COLOR_BUFFER_BIT);
        glRectf(-1, -1, 1, 1);
        for (const GLint x : {0, width - 1})
            for (const GLint y : {0, height - 1}) {
                GLubyte pixel[4] = {};
                glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
                EXPECT_EQ(pixel[0], 255) << x << ' ' << y;
            }
    }
}

TEST_F(Contexts, EntryPointsByName) {
    const char* const names[] = {"eglGetError", "eglSwapBuffers", "eglGetProcAddress", "eglMakeCurrent",
                                 "glClear",     "glVertex3f",     "glTexImage2D",      "glReadPixels"};
    for (const char* name : names)
        EXPECT_EQ(eglGetProcAddress(name) != nullptr, SPANGLE_FEATURE_GET_PROC_ADDRESS != 0) << name;
    for (const char* name : {"", "egl", "eglGetErro", "eglGetErrorX", "glNoSuchThing", "clear"})
        EXPECT_EQ(eglGetProcAddress(name), nullptr) << name;
    EXPECT_EQ(eglGetProcAddress(nullptr), nullptr);
#if SPANGLE_FEATURE_GET_PROC_ADDRESS
    EXPECT_EQ(reinterpret_cast<EGLint (*)()>(eglGetProcAddress("eglGetError"))(), EGL_SUCCESS);
#endif
}

} // namespace
} // namespace spangle::test
