// Makes and destroys contexts, surfaces and objects of GL ten thousand times. The memory in use must not
// grow.
#include <gtest/gtest.h>

#include <vector>

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/native.hpp>

#include "gl/egl/objects.hpp"
#include "tests/system/egl/fake_display.hpp"

namespace spangle::test {
namespace {

constexpr EGLBoolean yes = EGL_TRUE;
constexpr int cycles = 10000, settled = 120; ///< what a cycle makes repeats every 60 cycles

/// What one cycle leaves in use, and the most that it needs, must be the same in every later cycle.
class Growth {
  public:
    void after(int cycle) {
        const MemoryUse use = memory_use();
        if (cycle < settled) {
            used_ = use.used;
            peak_ = use.peak;
            return;
        }
        ASSERT_EQ(use.used, used_) << cycle;
        ASSERT_EQ(use.peak, peak_) << cycle;
    }

  private:
    std::size_t used_ = 0, peak_ = 0;
};

EGLConfig config_of(EGLDisplay display, EGLint surface_type) {
    const EGLint wish[] = {
        EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, surface_type, EGL_DEPTH_SIZE, 16, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    EXPECT_EQ(eglChooseConfig(display, wish, &config, 1, &count), yes);
    return config;
}

/// Makes objects of every kind with contents. Objects that are not deleted are freed with the last context.
void make_objects(int cycle) {
    const auto name = static_cast<GLuint>(cycle % 12 + 1);
    const GLsizei side = 1 << cycle % 5;
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glBindTexture(GL_TEXTURE_2D, name + 20);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, side, side, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, nullptr);
    glDeleteTextures(1, &name);
    glBindBuffer(GL_ARRAY_BUFFER, name);
    glBufferData(GL_ARRAY_BUFFER, 16 + 8 * (cycle % 6), nullptr, GL_STATIC_DRAW);
    glVertexPointer(2, GL_FLOAT, 0, nullptr);
    glEnableClientState(GL_VERTEX_ARRAY);
    glNewList(name, GL_COMPILE_AND_EXECUTE);
    for (int i = 0; i < cycle % 20; ++i)
        glVertex3f(0, static_cast<GLfloat>(i), 1);
    glDrawArrays(GL_POINTS, 0, 2);
    glEndList();
    glCallList(name);
    if (cycle % 2 == 0)
        glDeleteLists(name, 1);
    glPushAttrib(GL_ALL_ATTRIB_BITS); // never popped
    GLuint query = 0;
    glGenQueries(1, &query);
    glBeginQuery(GL_SAMPLES_PASSED, query);
    glRectf(-1, -1, 1, 1);
    glEndQuery(GL_SAMPLES_PASSED);
    const GLfloat points[] = {0, 0, 0, 1, 1, 1};
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, points);
    if (cycle % 3 == 0)
        glNewList(99, GL_COMPILE); // a list that never ends
}

TEST(Churn, ContextsAndSurfaces) {
    const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    ASSERT_EQ(eglInitialize(display, nullptr, nullptr), yes);
    const EGLConfig config = config_of(display, EGL_PBUFFER_BIT);
    const std::size_t before = memory_use().used;
    Growth growth;
    // Each context shares with the one before, so the group outlives its contexts.
    EGLContext kept = EGL_NO_CONTEXT;
    for (int cycle = 0; cycle < cycles && !HasFatalFailure(); ++cycle) {
        const EGLint size[] = {EGL_WIDTH, 1 + cycle % 6 * 9, EGL_HEIGHT, 1 + cycle % 5 * 7, EGL_NONE};
        const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
        const EGLContext context = eglCreateContext(display, config, kept, nullptr);
        ASSERT_EQ(eglMakeCurrent(display, surface, surface, context), yes) << cycle;
        if (kept != EGL_NO_CONTEXT) {
            ASSERT_EQ(eglDestroyContext(display, kept), yes);
        }
        kept = cycle % 10 == 9 ? EGL_NO_CONTEXT : context;
        make_objects(cycle);
        ASSERT_EQ(eglDestroySurface(display, surface), yes); // destroys the surface while it is current
        if (kept == EGL_NO_CONTEXT) {
            ASSERT_EQ(eglDestroyContext(display, context), yes);
        }
        ASSERT_EQ(eglReleaseThread(), yes);
        if (kept != EGL_NO_CONTEXT)
            continue;
        ASSERT_EQ(memory_use().used, before) << cycle;
        growth.after(cycle);
    }
    EXPECT_TRUE(egl::arena().consistent());
    EXPECT_EQ(eglTerminate(display), yes);
}

TEST(Churn, ObjectsOfOneContext) {
    const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    ASSERT_EQ(eglInitialize(display, nullptr, nullptr), yes);
    const EGLConfig config = config_of(display, EGL_PBUFFER_BIT);
    const EGLint size[] = {EGL_WIDTH, 8, EGL_HEIGHT, 8, EGL_NONE};
    const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    ASSERT_EQ(eglMakeCurrent(display, surface, surface, context), yes);
    Growth growth;
    for (int cycle = 0; cycle < cycles && !HasFatalFailure(); ++cycle) {
        GLuint textures[3], buffer = 0, array = 0, query = 0;
        glGenTextures(3, textures);
        for (const GLuint texture : textures) {
            glBindTexture(GL_TEXTURE_2D, texture);
            const GLsizei side = 1 << cycle % 4;
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, side, side, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
        }
        glGenBuffers(1, &buffer);
        glGenVertexArrays(1, &array);
        glBindVertexArray(array);
        glBindBuffer(GL_ARRAY_BUFFER, buffer);
        glBufferData(GL_ARRAY_BUFFER, 100 + cycle % 30, nullptr, GL_STATIC_DRAW);
        glVertexPointer(2, GL_FLOAT, 0, nullptr);
        const GLuint list = glGenLists(3);
        glNewList(list + 1, GL_COMPILE);
        for (int i = 0; i < cycle % 30; ++i)
            glRectf(-1, -1, 1, 1);
        glEndList();
        glCallList(list + 1);
        glGenQueries(1, &query);
        glPushAttrib(GL_TEXTURE_BIT | GL_ENABLE_BIT);
        glBindTexture(GL_TEXTURE_2D, textures[0]);
        glPopAttrib();
        glDeleteTextures(3, textures);
        glDeleteVertexArrays(1, &array);
        glDeleteBuffers(1, &buffer);
        glDeleteLists(list, 3);
        glDeleteQueries(1, &query);
        glBindTexture(GL_TEXTURE_2D, 0);
        ASSERT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << cycle;
        growth.after(cycle);
    }
    EXPECT_EQ(eglReleaseThread(), yes);
    EXPECT_EQ(eglTerminate(display), yes);
    EXPECT_TRUE(egl::arena().consistent());
}

TEST(Churn, DisplaysAndWindows) {
    const std::size_t before = memory_use().used;
    Growth growth;
    for (int cycle = 0; cycle < cycles && !HasFatalFailure(); ++cycle) {
        FakeDisplay panel(PixelFormat::rgb565_be, 8 + cycle % 3, 4 + cycle % 2);
        const EGLDisplay display = eglGetDisplay(native(panel));
        ASSERT_EQ(eglInitialize(display, nullptr, nullptr), yes) << cycle;
        const EGLConfig config = config_of(display, EGL_WINDOW_BIT);
        const EGLSurface window = eglCreateWindowSurface(display, config, 0, nullptr);
        const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
        ASSERT_EQ(eglMakeCurrent(display, window, window, context), yes) << cycle;
        glClear(GL_COLOR_BUFFER_BIT);
        ASSERT_EQ(eglSwapBuffers(display, window), yes);
        if (cycle % 2 == 0) { // contexts and surfaces are destroyed in either order
            ASSERT_EQ(eglReleaseThread(), yes);
        }
        ASSERT_EQ(eglTerminate(display), yes);
        ASSERT_EQ(eglReleaseThread(), yes);
        ASSERT_EQ(memory_use().used, before) << cycle;
        growth.after(cycle);
    }
}

} // namespace
} // namespace spangle::test
