// Threads of a host, each with a context of its own: on one display, in one share group, on windows (EGL 1.4:
// EGL and client APIs are safe to call from several threads). The same program runs under ThreadSanitizer.
#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/message.hpp>
#include <spangle/native.hpp>

#include "tests/system/egl/fake_display.hpp"

namespace spangle::test {
namespace {

constexpr EGLBoolean yes = EGL_TRUE;

/// The number of rounds of each thread.
#ifndef SPANGLE_ROUNDS
#define SPANGLE_ROUNDS 200
#endif
constexpr int rounds = SPANGLE_ROUNDS;

/// Runs the same in two threads, with a number each, which begin at once.
void twice(const std::function<void(int)>& what) {
    std::atomic<int> waiting = 2;
    const auto begin = [&](int number) {
        --waiting;
        while (waiting != 0)
            std::this_thread::yield();
        what(number);
    };
    std::thread other(begin, 1);
    begin(0);
    other.join();
}

EGLConfig config_of(EGLDisplay display, EGLint surface_type) {
    const EGLint wish[] = {
        EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, surface_type, EGL_DEPTH_SIZE, 16, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    EXPECT_EQ(eglChooseConfig(display, wish, &config, 1, &count), yes);
    EXPECT_EQ(count, 1);
    return config;
}

EGLSurface pbuffer_of(EGLDisplay display, EGLConfig config) {
    const EGLint size[] = {EGL_WIDTH, 24, EGL_HEIGHT, 16, EGL_NONE};
    return eglCreatePbufferSurface(display, config, size);
}

void store_texture(std::uint32_t color, GLsizei side) {
    const std::vector<std::uint32_t> texels(static_cast<std::size_t>(side * side), color);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
}

/// Draws a triangle over the whole surface.
void draw_textured() {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBegin(GL_TRIANGLES);
    const GLfloat corner[3][2] = {{-1, -1}, {3, -1}, {-1, 3}};
    for (const auto& c : corner) {
        glTexCoord2fv(c);
        glVertex2fv(c);
    }
    glEnd();
}

struct Threads : testing::Test {
    EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    std::size_t memory_before = memory_use().used;

    void SetUp() override { ASSERT_EQ(eglInitialize(display, nullptr, nullptr), yes); }
    void TearDown() override {
        EXPECT_EQ(eglReleaseThread(), yes);
        EXPECT_EQ(eglTerminate(display), yes);
        EXPECT_EQ(memory_use().used, memory_before) << "everything was given back";
    }
};

/// Each thread makes a pbuffer and a context, draws, reads its own picture back, and destroys them.
TEST_F(Threads, OneDisplayAndObjectsOfTheirOwn) {
    const EGLConfig config = config_of(display, EGL_PBUFFER_BIT);
    twice([&](int number) {
        for (int round = 0; round < rounds; ++round) {
            const EGLSurface surface = pbuffer_of(display, config);
            const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
            ASSERT_EQ(eglMakeCurrent(display, surface, surface, context), yes);
            const bool white = (round + number) % 2 == 0;
            glBindTexture(GL_TEXTURE_2D, 5);
            store_texture(white ? 0xFFFFFFFF : 0xFF000000, round % 3 == 0 ? 16 : 4);
            glNewList(7, GL_COMPILE);
            draw_textured();
            glEndList();
            glCallList(7);
            GLubyte pixel[4] = {};
            glReadPixels(23, 15, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
            ASSERT_EQ(pixel[0], white ? 255 : 0) << number << ' ' << round;
            ASSERT_EQ(glGetError(), GLenum{GL_NO_ERROR});
            ASSERT_EQ(eglDestroySurface(display, surface), yes);
            ASSERT_EQ(eglReleaseThread(), yes);
            ASSERT_EQ(eglDestroyContext(display, context), yes);
            ASSERT_EQ(eglGetError(), EGL_SUCCESS);
        }
    });
}

/// One thread replaces, deletes and makes textures, lists and buffers that the other draws with, also within
/// primitives. Each draw uses one of the objects, or draws nothing.
TEST_F(Threads, ObjectsOfOneShareGroup) {
    const EGLConfig config = config_of(display, EGL_PBUFFER_BIT);
    EGLContext contexts[2];
    contexts[0] = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    contexts[1] = eglCreateContext(display, config, contexts[0], nullptr);
    twice([&](int number) {
        const EGLSurface surface = pbuffer_of(display, config);
        ASSERT_EQ(eglMakeCurrent(display, surface, surface, contexts[number]), yes);
        glEnableClientState(GL_VERTEX_ARRAY);
        for (int round = 0; round < rounds; ++round) {
            const auto name = static_cast<GLuint>(round % 4 + 1);
            glBindTexture(GL_TEXTURE_2D, name);
            glBindBuffer(GL_ARRAY_BUFFER, name);
            if (number == 0) {
                store_texture(0xFFFFFFFF, round % 5 == 0 ? 32 : 8);
                const GLfloat corners[] = {-1, -1, 3, -1, -1, 3};
                glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_DYNAMIC_DRAW);
                const std::uint32_t texel = 0xFFFFFFFF;
                glTexSubImage2D(GL_TEXTURE_2D, 0, 1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &texel);
                glNewList(name, GL_COMPILE);
                for (int i = 0; i < 1 + round % 3; ++i)
                    draw_textured();
                glEndList();
                const GLuint gone[] = {name % 4 + 1, 40 + name};
                if (round % 3 == 0) {
                    glDeleteTextures(2, gone);
                    glDeleteBuffers(2, gone);
                    glDeleteLists(gone[0], 1);
                }
            } else {
                draw_textured();
                glCallList(name % 3 + 1);
                glVertexPointer(2, GL_FLOAT, 0, nullptr);
                glDrawArrays(GL_TRIANGLES, 0, 3);
                GLint width = 0;
                glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
                GLuint made = 0;
                glGenTextures(1, &made);
                (void)glIsTexture(name);
                (void)glIsList(name);
                glPushAttrib(GL_TEXTURE_BIT);
                glBindTexture(GL_TEXTURE_2D, made);
                glPopAttrib();
                glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
                glBindBuffer(GL_ARRAY_BUFFER, name % 4 + 1);
                glPopClientAttrib();
                glDeleteTextures(1, &made);
                while (glGetError() != GL_NO_ERROR) // elements beyond a new buffer
                    ;
            }
        }
        ASSERT_EQ(eglReleaseThread(), yes);
    });
}

/// The first thread gets the context and the surface, and no other thread does until they are released.
TEST_F(Threads, OneContextThatBothWant) {
    const EGLConfig config = config_of(display, EGL_PBUFFER_BIT);
    const EGLSurface surface = pbuffer_of(display, config);
    const EGLContext contexts[2] = {eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr),
                                    eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr)};
    std::atomic<int> inside = 0;
    twice([&](int number) {
        for (int round = 0; round < rounds; ++round) {
            const EGLContext context = contexts[round % 2 == 0 ? 0 : number];
            if (eglMakeCurrent(display, surface, surface, context) == yes) {
                EXPECT_EQ(++inside, 1);
                glClear(GL_COLOR_BUFFER_BIT);
                --inside;
                EXPECT_EQ(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT), yes);
            } else {
                EXPECT_EQ(eglGetError(), EGL_BAD_ACCESS);
            }
        }
    });
}

/// A window is shown while the other thread makes and destroys pbuffers of the same display, queries it, and
/// terminates it. This is done several times, because the moment differs each time.
TEST_F(Threads, AWindowAndAnotherThreadOfItsDisplay) {
    constexpr int times = 20, frames = rounds / times;
    FakeDisplay panel;
    for (int n = 0; n < times; ++n) {
        const bool single = n % 2 != 0;
        panel.two_buffers = !single;
        const EGLDisplay shown = eglGetDisplay(native(panel));
        ASSERT_EQ(eglInitialize(shown, nullptr, nullptr), yes);
        const EGLConfig of_window = config_of(shown, EGL_WINDOW_BIT);
        const EGLint list[] = {EGL_RENDER_BUFFER, single ? EGL_SINGLE_BUFFER : EGL_BACK_BUFFER, EGL_NONE};
        const EGLSurface window = eglCreateWindowSurface(shown, of_window, 0, list);
        const EGLContext context = eglCreateContext(shown, of_window, EGL_NO_CONTEXT, nullptr);
        std::atomic<bool> drawn = false, terminated = false;
        twice([&](int number) {
            if (number == 0) {
                ASSERT_EQ(eglMakeCurrent(shown, window, window, context), yes);
                for (int round = 0; round < frames || !terminated; ++round) {
                    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
                    glRectf(-1, -1, 1, 1);
                    (void)eglSwapInterval(shown, round % 2);
                    (void)eglSwapBuffers(shown, window); // refused once the display is terminated
                    glFinish();
                    // The flag is stored once, because a store after each frame would order this thread's
                    // frames before eglTerminate.
                    if (round == frames / 2)
                        drawn = true;
                }
                ASSERT_EQ(eglReleaseThread(), yes);
            } else {
                const EGLConfig config = config_of(shown, EGL_PBUFFER_BIT);
                while (!drawn) {
                    const EGLSurface surface = pbuffer_of(shown, config);
                    EXPECT_EQ(eglCreateWindowSurface(shown, config, 0, nullptr), EGL_NO_SURFACE);
                    EGLint value = 0;
                    EXPECT_EQ(eglQuerySurface(shown, surface, EGL_WIDTH, &value), yes);
                    EXPECT_EQ(eglDestroySurface(shown, surface), yes);
                    EXPECT_NE(eglQueryString(shown, EGL_VERSION), nullptr);
                    EXPECT_EQ(eglInitialize(shown, nullptr, nullptr), yes);
                }
                EXPECT_EQ(eglTerminate(shown), yes);
                const int presents = panel.presents;
                EXPECT_EQ(eglInitialize(shown, nullptr, nullptr), EGLBoolean{EGL_FALSE})
                    << "it is still drawn to";
                EXPECT_EQ(panel.presents, presents) << "nothing is shown after eglTerminate";
                terminated = true;
            }
        });
        EXPECT_EQ(eglInitialize(shown, nullptr, nullptr), yes);
        EXPECT_EQ(eglTerminate(shown), yes);
    }
}

/// Two panels have a thread each, as in an instrument with two displays, and other displays come and go.
TEST_F(Threads, ADisplayForEachThread) {
    twice([&](int number) {
        for (int round = 0; round < rounds / 10; ++round) {
            FakeDisplay panel;
            const EGLDisplay mine = eglGetDisplay(native(panel));
            ASSERT_NE(mine, EGL_NO_DISPLAY);
            ASSERT_EQ(eglInitialize(mine, nullptr, nullptr), yes);
            const EGLConfig config = config_of(mine, EGL_WINDOW_BIT);
            const EGLSurface window = eglCreateWindowSurface(mine, config, 0, nullptr);
            ASSERT_EQ(
                eglMakeCurrent(mine, window, window, eglCreateContext(mine, config, EGL_NO_CONTEXT, nullptr)),
                yes);
            for (int frame = 0; frame < 5; ++frame) {
                glClearColor(number == 0 ? 1.0f : 0.0f, 0, 1, 1);
                glClear(GL_COLOR_BUFFER_BIT);
                ASSERT_EQ(eglSwapBuffers(mine, window), yes);
            }
            EXPECT_EQ(panel.presents, 5);
            EXPECT_EQ(panel.shown[0], number == 0 ? 0xF8 : 0x00);
            ASSERT_EQ(eglReleaseThread(), yes);
            ASSERT_EQ(eglTerminate(mine), yes);
        }
    });
}

std::atomic<int> messages[2];
template <int number> void count(unsigned, const char*) {
    ++messages[number];
}

/// Both threads raise messages while the sink is set.
TEST_F(Threads, MessagesOfAllThreads) {
    const MessageSink before = on_message(count<0>);
    twice([&](int number) {
        for (int round = 0; round < rounds; ++round) {
            EXPECT_EQ(eglCreateContext(display, nullptr, EGL_NO_CONTEXT, nullptr), EGL_NO_CONTEXT);
            EXPECT_EQ(eglGetError(), EGL_BAD_CONFIG) << "errors are each thread's own";
            const EGLint wish[] = {EGL_NONE}; // a wish for OpenGL ES, which raises a message
            EGLint found = 0;
            EXPECT_EQ(eglChooseConfig(display, wish, nullptr, 0, &found), yes);
            EXPECT_EQ(eglGetError(), EGL_SUCCESS);
            if (number == 0)
                on_message(round % 2 == 0 ? count<1> : count<0>);
        }
    });
    on_message(before);
    EXPECT_EQ(messages[0] + messages[1], 4 * rounds) << "the wrong config and the remark are told each time";
}

} // namespace
} // namespace spangle::test
