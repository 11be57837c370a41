// The surface that a context draws to follows MakeCurrent, and does not change between Begin and End (EGL
// 1.4, 3.7.3).
#include <gtest/gtest.h>

#include <spangle/GL/gl.h>

#include <vector>

#include <spangle/frame.hpp>

#include "gl/egl/objects.hpp"
#include "tests/system/egl/fake_display.hpp"

namespace spangle::test {
namespace {

constexpr EGLBoolean yes = EGL_TRUE, no = EGL_FALSE;

struct Drawables : testing::Test {
    FakeDisplay panel;
    EGLDisplay display = eglGetDisplay(native(panel));
    std::size_t memory_before = memory_use().used;

    void SetUp() override { ASSERT_EQ(eglInitialize(display, nullptr, nullptr), yes); }
    void TearDown() override {
        EXPECT_EQ(eglReleaseThread(), yes);
        EXPECT_EQ(eglTerminate(display), yes);
        EXPECT_EQ(memory_use().used, memory_before);
    }
    std::vector<EGLConfig> configs(std::vector<EGLint> wish, EGLint most = 1000) const {
        wish.insert(wish.end(), {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE});
        std::vector<EGLConfig> found(static_cast<std::size_t>(most));
        EGLint count = 0;
        EXPECT_EQ(eglChooseConfig(display, wish.data(), found.data(), most, &count), yes);
        found.resize(static_cast<std::size_t>(count));
        return found;
    }
    EGLSurface pbuffer(EGLConfig config, EGLint width, EGLint height) const {
        const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
        return eglCreatePbufferSurface(display, config, size);
    }
    EGLContext context(EGLConfig config) const {
        return eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    }
    EGLint attribute(EGLConfig config, EGLint name) const {
        EGLint value = -1;
        EXPECT_EQ(eglGetConfigAttrib(display, config, name, &value), yes);
        return value;
    }
};

std::vector<GLubyte> pixels(GLint width, GLint height) {
    // There is one byte more, so that the vector is never empty.
    std::vector<GLubyte> all(static_cast<std::size_t>(width * height * 4 + 1));
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, all.data());
    return all;
}

/// Draws four textured, blended, depth-tested triangles. `between` is called between Begin and End.
template <class Between> void draw_strip(Between between) {
    glClearColor(0, 0, 0.5f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 6; ++i) {
        between();
        glColor4f(1, static_cast<float>(i) / 5, 0, 0.75f);
        glVertex3f(i % 2 == 0 ? -1.0f : 1.0f, -1 + static_cast<float>(i) * 0.4f, 0.25f);
    }
    glEnd();
}

/// Between Begin and End every call for another drawable is refused, from a large surface to smaller ones of
/// every format. The primitive goes on as if there had been no call.
TEST_F(Drawables, BetweenBeginAndEndTheyStay) {
    for (const EGLint samples : {0, 4}) {
        const std::vector<EGLConfig> all =
            configs({EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_DEPTH_SIZE, 16, EGL_SAMPLES, samples});
        if (all.empty())
            continue; // this build has no samples
        const EGLConfig config = all.front();
        const EGLSurface large = pbuffer(config, 64, 48), small = pbuffer(config, 3, 2);
        const EGLContext mine = context(config), other = context(config);
        ASSERT_EQ(eglMakeCurrent(display, large, large, mine), yes);
        draw_strip([] {});
        const std::vector<GLubyte> undisturbed = pixels(64, 48);
        draw_strip([&] {
            const auto refused = [&](EGLBoolean result, const char* what) {
                EXPECT_EQ(result, no) << what;
                EXPECT_EQ(eglGetError(), EGL_BAD_ACCESS) << what;
                EXPECT_EQ(eglGetCurrentContext(), mine) << what;
                EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), large) << what;
                EXPECT_EQ(eglGetCurrentSurface(EGL_READ), large) << what;
            };
            refused(eglMakeCurrent(display, small, small, mine), "smaller");
            refused(eglMakeCurrent(display, large, small, mine), "another to read");
            refused(eglMakeCurrent(display, large, large, mine), "the same");
            refused(eglMakeCurrent(display, small, small, other), "another context");
            refused(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT), "none");
            refused(eglReleaseThread(), "the thread");
            refused(eglWaitClient(), "wait");
            refused(eglWaitGL(), "wait for GL");
            refused(eglTerminate(display), "terminate");
        });
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        EXPECT_EQ(pixels(64, 48), undisturbed);
        // The refused surfaces and contexts were not kept current.
        EXPECT_EQ(eglMakeCurrent(display, small, small, other), yes);
        EXPECT_EQ(eglMakeCurrent(display, large, small, mine), yes);
        EXPECT_EQ(eglReleaseThread(), yes);
    }
}

/// A window's buffer is not exchanged between Begin and End either, whether SwapBuffers or Flush would show
/// it.
TEST_F(Drawables, BetweenBeginAndEndNothingIsShown) {
    panel.two_buffers = true;
    for (const bool single : {false, true}) {
        panel.two_buffers = !single;
        const EGLConfig config = configs({EGL_SURFACE_TYPE, EGL_WINDOW_BIT, EGL_DEPTH_SIZE, 16}, 1).front();
        const EGLint list[] = {EGL_RENDER_BUFFER, single ? EGL_SINGLE_BUFFER : EGL_BACK_BUFFER, EGL_NONE};
        const EGLSurface window = eglCreateWindowSurface(display, config, 0, list);
        ASSERT_EQ(eglMakeCurrent(display, window, window, context(config)), yes);
        const int presents = panel.presents, acquires = panel.acquires;
        draw_strip([&] {
            if (!single) {
                EXPECT_EQ(eglSwapBuffers(display, window), no);
                EXPECT_EQ(eglGetError(), EGL_BAD_ACCESS);
            }
            glFlush(); // the error is reported after End
            EXPECT_EQ(eglWaitClient(), no);
            EXPECT_EQ(eglGetError(), EGL_BAD_ACCESS);
            EXPECT_FALSE(frame(display, [] { FAIL() << "not inside of Begin and End"; }));
            EXPECT_EQ(eglGetError(), EGL_BAD_ACCESS);
        });
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
        EXPECT_EQ(panel.presents, presents);
        EXPECT_EQ(panel.acquires, acquires);
        EXPECT_EQ(frame(display, [] { glBegin(GL_TRIANGLES); }), single) << "an open primitive is no frame";
        EXPECT_EQ(panel.presents, presents);
        glEnd();
        EXPECT_TRUE(frame(display, [] { draw_strip([] {}); }));
        EXPECT_EQ(eglReleaseThread(), yes);
        EXPECT_EQ(eglDestroySurface(display, window), yes);
    }
}

/// A context draws on surfaces of its own format, depth buffer and number of samples, whatever their
/// precision (EGL 1.4, 2.2). The test tries every pair of configs, for drawing and for reading.
TEST_F(Drawables, EveryOtherFormatIsRefused) {
    struct Kind {
        EGLConfig config;
        EGLint visual, depth, stencil, samples;
        EGLSurface surface;
        bool operator==(const Kind& o) const {
            return visual == o.visual && depth == o.depth && stencil == o.stencil && samples == o.samples;
        }
    };
    std::vector<Kind> kinds;
    EGLint visuals[2] = {-1, -1}; // visuals of two pixel formats, which stand for all
    for (const EGLConfig config : configs({EGL_SURFACE_TYPE, EGL_PBUFFER_BIT})) {
        const EGLint visual = attribute(config, EGL_NATIVE_VISUAL_ID);
        EGLint* const known = visuals[0] == -1 || visuals[0] == visual ? &visuals[0] : &visuals[1];
        if (*known == -1)
            *known = visual;
        if (*known == visual)
            kinds.push_back({config, visual, attribute(config, EGL_DEPTH_SIZE),
                             attribute(config, EGL_STENCIL_SIZE), attribute(config, EGL_SAMPLES),
                             pbuffer(config, 2, 2)});
    }
    ASSERT_GE(kinds.size(), 6u);
    for (const Kind& one : kinds) {
        const EGLContext c = context(one.config);
        for (const Kind& two : kinds) {
            const bool fits = one == two;
            EXPECT_EQ(eglMakeCurrent(display, two.surface, two.surface, c), fits ? yes : no);
            EXPECT_EQ(eglGetError(), fits ? EGL_SUCCESS : EGL_BAD_MATCH)
                << one.depth << ' ' << two.depth << ' ' << one.stencil << ' ' << two.stencil;
            EXPECT_EQ(eglMakeCurrent(display, one.surface, two.surface, c), fits ? yes : no);
            EXPECT_EQ(eglMakeCurrent(display, two.surface, one.surface, c), fits ? yes : no);
        }
        EXPECT_EQ(eglReleaseThread(), yes);
        EXPECT_EQ(eglDestroyContext(display, c), yes);
    }
}

/// Surfaces of many sizes follow each other. State that was derived from the last size is derived again, so
/// every picture equals that of a new context.
TEST_F(Drawables, WhatIsDerivedFollowsTheSize) {
    for (const EGLint samples : {0, 4}) {
        const std::vector<EGLConfig> all = configs({EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_DEPTH_SIZE, 24,
                                                    EGL_STENCIL_SIZE, 8, EGL_SAMPLES, samples});
        if (all.empty())
            continue;
        const EGLConfig config = all.front();
        const EGLContext old = context(config);
        for (const auto& [w, h] :
             {std::pair{40, 30}, {1, 1}, {3, 30}, {200, 2}, {2, 200}, {0, 0}, {64, 64}, {7, 5}, {65, 63}}) {
            const EGLSurface surface = pbuffer(config, w, h);
            const EGLContext fresh = context(config);
            std::vector<GLubyte> drawn[2];
            for (const EGLContext c : {old, fresh}) {
                ASSERT_EQ(eglMakeCurrent(display, surface, surface, c), yes);
                glViewport(0, 0, w, h);
                draw_strip([] {});
                glScissor(0, 0, w, h);
                drawn[c == fresh] = pixels(w, h);
                EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
            }
            EXPECT_EQ(drawn[0], drawn[1]) << w << 'x' << h;
            EXPECT_EQ(eglReleaseThread(), yes);
            EXPECT_EQ(eglDestroyContext(display, fresh), yes);
            EXPECT_EQ(eglDestroySurface(display, surface), yes);
        }
        EXPECT_EQ(eglDestroyContext(display, old), yes);
    }
}

/// The buffer of a pbuffer is a back buffer (EGL 1.4, 3.5.6). FRONT names the same buffer.
TEST_F(Drawables, APbufferIsABackBuffer) {
    const EGLConfig config = configs({EGL_SURFACE_TYPE, EGL_PBUFFER_BIT}, 1).front();
    const EGLSurface surface = pbuffer(config, 4, 4);
    const EGLContext c = context(config);
    ASSERT_EQ(eglMakeCurrent(display, surface, surface, c), yes);
    EGLint buffer = 0;
    EXPECT_EQ(eglQuerySurface(display, surface, EGL_RENDER_BUFFER, &buffer), yes);
    EXPECT_EQ(buffer, EGL_BACK_BUFFER);
    EXPECT_EQ(eglQueryContext(display, c, EGL_RENDER_BUFFER, &buffer), yes);
    EXPECT_EQ(buffer, EGL_BACK_BUFFER);
    GLint named[2] = {}, doubled = 0;
    glGetIntegerv(GL_DRAW_BUFFER, &named[0]);
    glGetIntegerv(GL_READ_BUFFER, &named[1]);
    glGetIntegerv(GL_DOUBLEBUFFER, &doubled);
    EXPECT_EQ(named[0], GL_BACK);
    EXPECT_EQ(named[1], GL_BACK);
    EXPECT_EQ(doubled, 1);
    for (const GLenum name : {GL_BACK, GL_BACK_LEFT, GL_FRONT, GL_FRONT_LEFT, GL_LEFT}) {
        glDrawBuffer(name);
        glReadBuffer(name);
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << name;
        glClearColor(name == GL_FRONT ? 1.0f : 0.0f, 1, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        EXPECT_EQ(pixels(1, 1)[0], name == GL_FRONT ? 255 : 0);
        EXPECT_EQ(pixels(1, 1)[1], 255);
    }
    for (const GLenum name : {GL_BACK_RIGHT, GL_FRONT_RIGHT, GL_RIGHT, GL_AUX0}) {
        glDrawBuffer(name);
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION}) << name;
        glReadBuffer(name);
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION}) << name;
    }
}

} // namespace
} // namespace spangle::test
