// Every error of EGL is reported in one sentence, which begins with the command's name (spangle/message.hpp).
#include <gtest/gtest.h>

#include <spangle/GL/gl.h>
#include <spangle/frame.hpp>
#include <spangle/message.hpp>

#include <string>
#include <vector>

#include "gl/context/features.hpp"
#include "gl/egl/objects.hpp"
#include "tests/system/egl/fake_display.hpp"

#if SPANGLE_MESSAGES

namespace spangle::test {
namespace {

struct Said {
    unsigned code;
    std::string text;
};
std::vector<Said>& said() {
    static std::vector<Said> all;
    return all;
}

/// An initialized display with a window and a pbuffer, neither of them current; and a display that is not
/// initialized.
struct EglSentences : testing::Test {
    FakeDisplay panel, other;
    EGLDisplay display = eglGetDisplay(native(panel)), sleeping = eglGetDisplay(native(other));
    EGLConfig config = nullptr, of_pbuffers = nullptr;
    EGLSurface window = EGL_NO_SURFACE, pbuffer = EGL_NO_SURFACE;
    EGLContext context = EGL_NO_CONTEXT;

    void SetUp() override {
        eglInitialize(display, nullptr, nullptr);
        config = choose(EGL_WINDOW_BIT);
        of_pbuffers = choose(EGL_PBUFFER_BIT);
        const EGLint size[] = {EGL_WIDTH, 8, EGL_HEIGHT, 8, EGL_NONE};
        window = eglCreateWindowSurface(display, config, 0, nullptr);
        pbuffer = eglCreatePbufferSurface(display, of_pbuffers, size);
        context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
        ASSERT_TRUE(window != EGL_NO_SURFACE && pbuffer != EGL_NO_SURFACE && context != EGL_NO_CONTEXT);
        on_message([](unsigned code, const char* text) { said().push_back({code, text}); });
        said().clear();
    }
    void TearDown() override {
        on_message(nullptr);
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglTerminate(display);
    }
    EGLConfig choose(EGLint kind) const {
        const EGLint wishes[] = {EGL_SURFACE_TYPE, kind, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        EGLConfig found = nullptr;
        EGLint n = 0;
        eglChooseConfig(display, wishes, &found, 1, &n);
        return found;
    }

    /// Checks that the last call raised `error`, and that one sentence reports it.
    void told(EGLint error, const std::string& command, const char* rule = "") {
        EXPECT_EQ(eglGetError(), error) << command;
        ASSERT_EQ(said().size(), 1u) << command;
        EXPECT_EQ(said()[0].code, static_cast<unsigned>(error));
        EXPECT_EQ(said()[0].text.find(command + ": "), 0u) << said()[0].text;
        EXPECT_GT(said()[0].text.size(), command.size() + 10) << said()[0].text;
        EXPECT_NE(said()[0].text.find(rule), std::string::npos) << said()[0].text;
        said().clear();
    }
};

using Call = void (*)(EGLDisplay display, EGLSurface surface, EGLContext context, EGLConfig config);
struct Named {
    const char* name;
    Call call;
};

constexpr EGLenum vg_image = 0x3096; // EGL_OPENVG_IMAGE, which this header does not define
constexpr EGLint end[] = {EGL_NONE};
EGLint value;

/// Commands that check their display first.
constexpr Named of_displays[] = {
    {"eglQueryString",
     [](EGLDisplay d, EGLSurface, EGLContext, EGLConfig) { eglQueryString(d, EGL_VENDOR); }},
    {"eglGetConfigs",
     [](EGLDisplay d, EGLSurface, EGLContext, EGLConfig) { eglGetConfigs(d, nullptr, 0, &value); }},
    {"eglChooseConfig",
     [](EGLDisplay d, EGLSurface, EGLContext, EGLConfig) { eglChooseConfig(d, end, nullptr, 0, &value); }},
    {"eglGetConfigAttrib", [](EGLDisplay d, EGLSurface, EGLContext,
                              EGLConfig c) { eglGetConfigAttrib(d, c, EGL_RED_SIZE, &value); }},
    {"eglCreateWindowSurface",
     [](EGLDisplay d, EGLSurface, EGLContext, EGLConfig c) { eglCreateWindowSurface(d, c, 0, nullptr); }},
    {"eglCreatePbufferSurface",
     [](EGLDisplay d, EGLSurface, EGLContext, EGLConfig c) { eglCreatePbufferSurface(d, c, nullptr); }},
    {"eglCreatePbufferFromClientBuffer",
     [](EGLDisplay d, EGLSurface, EGLContext, EGLConfig c) {
         eglCreatePbufferFromClientBuffer(d, vg_image, nullptr, c, nullptr);
     }},
    {"eglDestroySurface", [](EGLDisplay d, EGLSurface s, EGLContext, EGLConfig) { eglDestroySurface(d, s); }},
    {"eglQuerySurface",
     [](EGLDisplay d, EGLSurface s, EGLContext, EGLConfig) { eglQuerySurface(d, s, EGL_WIDTH, &value); }},
    {"eglSurfaceAttrib",
     [](EGLDisplay d, EGLSurface s, EGLContext, EGLConfig) { eglSurfaceAttrib(d, s, EGL_MIPMAP_LEVEL, 0); }},
    {"eglBindTexImage",
     [](EGLDisplay d, EGLSurface s, EGLContext, EGLConfig) { eglBindTexImage(d, s, EGL_BACK_BUFFER); }},
    {"eglReleaseTexImage",
     [](EGLDisplay d, EGLSurface s, EGLContext, EGLConfig) { eglReleaseTexImage(d, s, EGL_BACK_BUFFER); }},
    {"eglCreateContext", [](EGLDisplay d, EGLSurface, EGLContext,
                            EGLConfig c) { eglCreateContext(d, c, EGL_NO_CONTEXT, nullptr); }},
    {"eglDestroyContext", [](EGLDisplay d, EGLSurface, EGLContext c, EGLConfig) { eglDestroyContext(d, c); }},
    {"eglMakeCurrent",
     [](EGLDisplay d, EGLSurface s, EGLContext c, EGLConfig) { eglMakeCurrent(d, s, s, c); }},
    {"eglQueryContext",
     [](EGLDisplay d, EGLSurface, EGLContext c, EGLConfig) { eglQueryContext(d, c, EGL_CONFIG_ID, &value); }},
    {"eglSwapInterval", [](EGLDisplay d, EGLSurface, EGLContext, EGLConfig) { eglSwapInterval(d, 1); }},
    {"eglSwapBuffers", [](EGLDisplay d, EGLSurface s, EGLContext, EGLConfig) { eglSwapBuffers(d, s); }},
#if SPANGLE_HAS_PLATFORMS
    {"eglCopyBuffers",
     [](EGLDisplay d, EGLSurface s, EGLContext, EGLConfig) { eglCopyBuffers(d, s, EGLNativePixmapType{}); }},
    {"eglCreatePixmapSurface",
     [](EGLDisplay d, EGLSurface, EGLContext, EGLConfig c) {
         eglCreatePixmapSurface(d, c, EGLNativePixmapType{}, nullptr);
     }},
#endif
};

TEST_F(EglSentences, DisplaysThatAreNone) {
    int nothing = 0;
    for (const Named& command : of_displays) {
        command.call(&nothing, window, context, config);
        told(EGL_BAD_DISPLAY, command.name, "dpy");
        command.call(sleeping, window, context, config);
        told(EGL_NOT_INITIALIZED, command.name, "eglInitialize");
    }
    eglInitialize(&nothing, nullptr, nullptr);
    told(EGL_BAD_DISPLAY, "eglInitialize", "dpy");
    eglTerminate(&nothing);
    told(EGL_BAD_DISPLAY, "eglTerminate", "dpy");
    eglMakeCurrent(&nothing, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    told(EGL_BAD_DISPLAY, "eglMakeCurrent", "dpy");
    // A display that is not initialized is no error of eglMakeCurrent without objects (EGL 1.4, 3.7.3).
    eglMakeCurrent(sleeping, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    EXPECT_EQ(eglGetError(), EGL_SUCCESS);
    EXPECT_TRUE(said().empty());
}

TEST_F(EglSentences, ObjectsThatAreNone) {
    int nothing = 0;
    eglDestroySurface(display, &nothing);
    told(EGL_BAD_SURFACE, "eglDestroySurface", "surface");
    eglQuerySurface(display, &nothing, EGL_WIDTH, &value);
    told(EGL_BAD_SURFACE, "eglQuerySurface", "surface");
    eglSwapBuffers(display, &nothing);
    told(EGL_BAD_SURFACE, "eglSwapBuffers", "surface");
    eglDestroyContext(display, &nothing);
    told(EGL_BAD_CONTEXT, "eglDestroyContext", "context");
    eglQueryContext(display, &nothing, EGL_CONFIG_ID, &value);
    told(EGL_BAD_CONTEXT, "eglQueryContext", "context");
    eglMakeCurrent(display, window, window, &nothing);
    told(EGL_BAD_CONTEXT, "eglMakeCurrent", "context");
    eglGetConfigAttrib(display, &nothing, EGL_RED_SIZE, &value);
    told(EGL_BAD_CONFIG, "eglGetConfigAttrib", "config");
    eglCreateContext(display, &nothing, EGL_NO_CONTEXT, nullptr);
    told(EGL_BAD_CONFIG, "eglCreateContext", "config");
    eglCreateWindowSurface(display, &nothing, 0, nullptr);
    told(EGL_BAD_CONFIG, "eglCreateWindowSurface", "config");
    eglCreatePbufferSurface(display, &nothing, nullptr);
    told(EGL_BAD_CONFIG, "eglCreatePbufferSurface", "config");
}

TEST_F(EglSentences, ArgumentsThatAreNone) {
    const EGLint wrong[] = {0x7777, 0, EGL_NONE};
    eglQueryString(display, EGL_WIDTH);
    told(EGL_BAD_PARAMETER, "eglQueryString", "name");
    eglBindAPI(EGL_OPENVG_API);
    told(EGL_BAD_PARAMETER, "eglBindAPI", "api");
    eglWaitNative(1);
    told(EGL_BAD_PARAMETER, "eglWaitNative", "engine");
    eglGetConfigs(display, nullptr, 0, nullptr);
    told(EGL_BAD_PARAMETER, "eglGetConfigs", "num_config");
    eglChooseConfig(display, nullptr, nullptr, 0, nullptr);
    told(EGL_BAD_PARAMETER, "eglChooseConfig", "num_config");
    eglChooseConfig(display, wrong, nullptr, 0, &value);
    told(EGL_BAD_ATTRIBUTE, "eglChooseConfig", "attrib_list");
    eglGetConfigAttrib(display, config, 0x7777, &value);
    told(EGL_BAD_ATTRIBUTE, "eglGetConfigAttrib", "attribute");
    eglGetConfigAttrib(display, config, EGL_RED_SIZE, nullptr);
    told(EGL_BAD_PARAMETER, "eglGetConfigAttrib", "value");
    eglCreateContext(display, config, EGL_NO_CONTEXT, wrong);
    told(EGL_BAD_ATTRIBUTE, "eglCreateContext", "attrib_list");
    eglCreatePbufferSurface(display, of_pbuffers, wrong);
    told(EGL_BAD_ATTRIBUTE, "eglCreatePbufferSurface", "attrib_list");
    eglCreateWindowSurface(display, config, 0, wrong);
    told(EGL_BAD_ATTRIBUTE, "eglCreateWindowSurface");
    eglQuerySurface(display, window, 0x7777, &value);
    told(EGL_BAD_ATTRIBUTE, "eglQuerySurface", "attribute");
    eglQuerySurface(display, window, EGL_WIDTH, nullptr);
    told(EGL_BAD_PARAMETER, "eglQuerySurface", "value");
    eglQuerySurface(display, window, EGL_BUFFER_AGE_EXT, &value);
    told(EGL_BAD_SURFACE, "eglQuerySurface", "current");
    eglSurfaceAttrib(display, window, 0x7777, 0);
    told(EGL_BAD_ATTRIBUTE, "eglSurfaceAttrib", "attribute");
    eglSurfaceAttrib(display, window, EGL_SWAP_BEHAVIOR, 1);
    told(EGL_BAD_PARAMETER, "eglSurfaceAttrib", "value");
    eglSurfaceAttrib(display, window, EGL_SWAP_BEHAVIOR, EGL_BUFFER_PRESERVED);
    told(EGL_BAD_MATCH, "eglSurfaceAttrib", "EGL_SWAP_BEHAVIOR_PRESERVED_BIT");
    eglSurfaceAttrib(display, window, EGL_MULTISAMPLE_RESOLVE, 1);
    told(EGL_BAD_PARAMETER, "eglSurfaceAttrib", "value");
    eglSurfaceAttrib(display, window, EGL_MULTISAMPLE_RESOLVE, EGL_MULTISAMPLE_RESOLVE_BOX);
    told(EGL_BAD_MATCH, "eglSurfaceAttrib", "EGL_MULTISAMPLE_RESOLVE_BOX_BIT");
    eglBindTexImage(display, pbuffer, 0);
    told(EGL_BAD_PARAMETER, "eglBindTexImage", "buffer");
    eglReleaseTexImage(display, pbuffer, EGL_BACK_BUFFER);
    told(EGL_BAD_SURFACE, "eglReleaseTexImage", "config");
    eglCreatePbufferFromClientBuffer(display, vg_image, nullptr, config, nullptr);
    told(EGL_BAD_PARAMETER, "eglCreatePbufferFromClientBuffer", "OpenVG");
    eglQueryContext(display, context, 0x7777, &value);
    told(EGL_BAD_ATTRIBUTE, "eglQueryContext", "attribute");
    eglQueryContext(display, context, EGL_CONFIG_ID, nullptr);
    told(EGL_BAD_PARAMETER, "eglQueryContext", "value");
    eglGetCurrentSurface(0);
    told(EGL_BAD_PARAMETER, "eglGetCurrentSurface", "readdraw");
}

TEST_F(EglSentences, WhatIsCurrent) {
    eglSwapInterval(display, 1);
    told(EGL_BAD_CONTEXT, "eglSwapInterval", "current");
    eglSwapBuffers(display, window);
    told(EGL_BAD_SURFACE, "eglSwapBuffers", "current");
    eglMakeCurrent(display, window, EGL_NO_SURFACE, context);
    told(EGL_BAD_MATCH, "eglMakeCurrent", "both");
    eglMakeCurrent(display, window, window, EGL_NO_CONTEXT);
    told(EGL_BAD_MATCH, "eglMakeCurrent", "no context");
    frame(
        display, [](void*) {}, nullptr);
    told(EGL_BAD_SURFACE, "spangle::frame", "current");
    ASSERT_EQ(eglMakeCurrent(display, window, window, context), EGLBoolean{EGL_TRUE});
    EXPECT_TRUE(said().empty());
    glBegin(GL_LINES);
    eglSwapBuffers(display, window);
    told(EGL_BAD_ACCESS, "eglSwapBuffers", "glEnd");
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    told(EGL_BAD_ACCESS, "eglMakeCurrent", "glEnd");
    eglTerminate(display);
    told(EGL_BAD_ACCESS, "eglTerminate", "glEnd");
    eglWaitClient();
    told(EGL_BAD_ACCESS, "eglWaitClient", "glEnd");
    eglReleaseThread();
    told(EGL_BAD_ACCESS, "eglReleaseThread", "glEnd");
    glEnd();
    EXPECT_EQ(eglSwapBuffers(display, window), EGLBoolean{EGL_TRUE});
    EXPECT_TRUE(said().empty());
}

} // namespace
} // namespace spangle::test

#endif
