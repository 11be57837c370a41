// Tests displays that give no buffer, change, or are terminated while their window is current (EGL 1.4, 3.2,
// 3.9).
#include <gtest/gtest.h>

#include <spangle/GL/gl.h>

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <spangle/message.hpp>

#include "gl/egl/objects.hpp"
#include "tests/system/egl/fake_display.hpp"

namespace spangle::test {
namespace {

constexpr EGLBoolean yes = EGL_TRUE, no = EGL_FALSE;

std::string last_message;
void remember(unsigned, const char* text) {
    last_message = text;
}

EGLConfig config_of(EGLDisplay display, EGLint surface_type, EGLint samples = 0) {
    const EGLint wish[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE,
                           surface_type,        EGL_DEPTH_SIZE, 16,
                           EGL_SAMPLES,         samples,        EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    EXPECT_EQ(eglChooseConfig(display, wish, &config, 1, &count), yes);
    return count == 1 ? config : nullptr;
}

EGLSurface pbuffer_of(EGLDisplay display, EGLint width, EGLint height) {
    const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    return eglCreatePbufferSurface(display, config_of(display, EGL_PBUFFER_BIT), size);
}

/// Draws and reads in every way. None of the calls may touch memory outside of a surface.
void draw_and_read() {
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_ACCUM_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glRectf(-1, -1, 1, 1);
    glBegin(GL_LINE_LOOP);
    glVertex2f(-1, -1), glVertex2f(1, 0.5f), glVertex2f(0, 1);
    glEnd();
    glBegin(GL_POINTS);
    glVertex2f(0, 0);
    glEnd();
    GLubyte texels[16 * 4] = {};
    glRasterPos2f(0, 0);
    glDrawPixels(4, 4, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glBitmap(8, 2, 0, 0, 0, 0, texels);
    glCopyPixels(0, 0, 8, 8, GL_COLOR);
    glReadPixels(0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, 4, 0);
    while (glGetError() != GL_NO_ERROR)
        ;
}

struct LostDisplays : testing::Test {
    std::unique_ptr<FakeDisplay> panel = std::make_unique<FakeDisplay>();
    EGLDisplay display = eglGetDisplay(native(*panel));
    std::size_t memory_before = memory_use().used;
    EGLSurface window = EGL_NO_SURFACE;
    EGLContext context = EGL_NO_CONTEXT;

    void SetUp() override { ASSERT_EQ(eglInitialize(display, nullptr, nullptr), yes); }
    void TearDown() override {
        on_message(nullptr);
        EXPECT_EQ(eglReleaseThread(), yes);
        EXPECT_EQ(eglTerminate(display), yes);
        EXPECT_EQ(memory_use().used, memory_before);
        EXPECT_TRUE(egl::arena().consistent());
    }
    void make_window(bool single = false, EGLint samples = 0) {
        const EGLConfig config = config_of(display, EGL_WINDOW_BIT, samples);
        const EGLint list[] = {EGL_RENDER_BUFFER, single ? EGL_SINGLE_BUFFER : EGL_BACK_BUFFER, EGL_NONE};
        window = eglCreateWindowSurface(display, config, 0, list);
        ASSERT_NE(window, EGL_NO_SURFACE);
        context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
        ASSERT_EQ(eglMakeCurrent(display, window, window, context), yes);
    }
};

/// The frame was shown, but there is no next buffer. Later drawing must not reach the frame that was given
/// back; it goes nowhere, is not shown, and the next present reports an error.
TEST_F(LostDisplays, WithoutANextBufferGlDrawsNowhere) {
    for (const EGLint samples : {0, 4}) {
        if (config_of(display, EGL_WINDOW_BIT, samples) == nullptr)
            continue; // this build has no samples
        panel->two_buffers = true;
        make_window(false, samples);
        glClearColor(1, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        panel->fail_acquire = true;
        on_message(&remember);
        const int presents = panel->presents;
        EXPECT_EQ(eglSwapBuffers(display, window), no);
        EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
        EXPECT_EQ(last_message, "eglSwapBuffers: fake: no buffer");
        EXPECT_EQ(panel->presents, presents + 1);
        const std::vector<std::uint8_t> one = panel->pixels, other = panel->front;
        const std::vector<RowSpan> rows = panel->rows;
        draw_and_read();
        EXPECT_EQ(eglSwapBuffers(display, window), no) << "there still is none";
        draw_and_read();
        EXPECT_EQ(panel->pixels, one);
        EXPECT_EQ(panel->front, other);
        EXPECT_EQ(panel->rows, rows);
        panel->fail_acquire = false;
        EXPECT_EQ(eglSwapBuffers(display, window), no) << "this frame is lost";
        EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
        EXPECT_NE(last_message.find("this frame is lost"), std::string::npos);
        EXPECT_EQ(panel->presents, presents + 1) << "nothing was drawn that could be shown";
        glClearColor(0, 1, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        EXPECT_EQ(eglSwapBuffers(display, window), yes);
        EXPECT_EQ(panel->presents, presents + 2);
        EXPECT_EQ(panel->shown[0], 0x07);
        EXPECT_EQ(eglReleaseThread(), yes);
        EXPECT_EQ(eglDestroySurface(display, window), yes);
    }
}

/// MakeCurrent asks for a buffer again, and fails as long as there is none (EGL 1.4, 3.7.3).
TEST_F(LostDisplays, MakeCurrentAsksForABufferAgain) {
    make_window();
    panel->fail_acquire = true;
    EXPECT_EQ(eglSwapBuffers(display, window), no);
    EXPECT_EQ(eglReleaseThread(), yes);
    EXPECT_EQ(eglMakeCurrent(display, window, window, context), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
    EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
    panel->fail_acquire = false;
    EXPECT_EQ(eglMakeCurrent(display, window, window, context), yes);
    draw_and_read();
    EXPECT_EQ(eglSwapBuffers(display, window), yes);
    EXPECT_EQ(panel->shown[0], 0xFF);
}

/// A single-buffered window loses its buffer in the same way when Flush shows the frame.
TEST_F(LostDisplays, FlushOfASingleBufferedWindowLosesItsBuffer) {
    make_window(true);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    panel->fail_acquire = true;
    glFlush();
    const std::vector<std::uint8_t> before = panel->pixels;
    const int presents = panel->presents;
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glFinish();
    EXPECT_EQ(panel->pixels, before);
    EXPECT_EQ(panel->presents, presents);
    panel->fail_acquire = false;
    glFlush(); // that frame is lost
    glClear(GL_COLOR_BUFFER_BIT);
    glFlush();
    EXPECT_EQ(panel->presents, presents + 1);
    EXPECT_EQ(panel->shown[0], 0);
}

/// Another display was plugged in. The window has the size of the old display, and must never draw into the
/// new one.
TEST_F(LostDisplays, ADisplayOfAnotherSizeIsNotDrawnTo) {
    for (const auto& [width, height] : {std::pair{6, 4}, {12, 8}, {11, 9}, {40, 30}}) {
        panel->become(12, 9);
        make_window();
        draw_and_read();
        EXPECT_EQ(eglSwapBuffers(display, window), yes);
        glFinish();
        // HALs notice a new display at a present. Until the present returns, the buffer that is drawn to
        // stays valid.
        const FakeDisplay before = *panel;
        panel->become(width, height);
        EXPECT_EQ(eglSwapBuffers(display, window), no);
        EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
        const std::vector<std::uint8_t> pixels = panel->pixels;
        draw_and_read();
        EXPECT_EQ(panel->pixels, pixels);
        EXPECT_EQ(eglSwapBuffers(display, window), no) << "it never fits again";
        EXPECT_EQ(eglReleaseThread(), yes);
        EXPECT_EQ(eglMakeCurrent(display, window, window, context), no);
        EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
        EXPECT_EQ(eglDestroySurface(display, window), yes);
        make_window(); // a window of the new size
        EGLint found = 0;
        EXPECT_EQ(eglQuerySurface(display, window, EGL_WIDTH, &found), yes);
        EXPECT_EQ(found, width);
        EXPECT_EQ(eglReleaseThread(), yes);
        EXPECT_EQ(eglDestroySurface(display, window), yes);
    }
}

/// GL does not draw surfaces of such sizes, so there is no window. A device may report any size.
TEST_F(LostDisplays, AbsurdSizesAreNoWindows) {
    const EGLConfig config = config_of(display, EGL_WINDOW_BIT);
    for (const auto& [width, height] :
         {std::pair{0, 9}, {12, 0}, {-1, 9}, {12, -5}, {2049, 9}, {12, 2049}, {32767, 4096}}) {
        class Absurd final : public hal::Display {
          public:
            Absurd(std::int32_t w, std::int32_t h) : w_(w), h_(h) {}
            hal::DisplayInfo info() const override {
                return {"absurd", w_, h_, PixelFormat::rgb565_be, true};
            }
            hal::Result<void> init() override { return {}; }
            hal::Result<hal::Frame> acquire() override { return hal::Frame{}; }
            hal::Result<void> present() override { return {}; }

          private:
            std::int32_t w_, h_;
        } absurd(width, height);
        const EGLDisplay other = eglGetDisplay(native(absurd));
        ASSERT_EQ(eglInitialize(other, nullptr, nullptr), yes);
        EXPECT_EQ(eglCreateWindowSurface(other, config, 0, nullptr), EGL_NO_SURFACE)
            << width << 'x' << height;
        EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
        EXPECT_EQ(eglTerminate(other), yes);
    }
}

/// Current objects survive eglTerminate, but the pixels of a window belong to its display, which may then go.
/// Rendering must not end the program (EGL 1.4, 3.2).
TEST_F(LostDisplays, ATerminatedDisplayMayGoWhileItsWindowIsCurrent) {
    for (const bool single : {false, true}) {
        panel = std::make_unique<FakeDisplay>();
        display = eglGetDisplay(native(*panel));
        ASSERT_EQ(eglInitialize(display, nullptr, nullptr), yes);
        make_window(single);
        EXPECT_EQ(eglTerminate(display), yes);
        EXPECT_EQ(eglTerminate(display), yes) << "again: no effect";
        const int presents = panel->presents;
        const std::vector<std::uint8_t> pixels = panel->pixels;
        draw_and_read();
        glFinish();
        EXPECT_EQ(panel->presents, presents);
        EXPECT_EQ(panel->pixels, pixels);
        panel.reset();
        draw_and_read();
        glFlush();
        glFinish();
        EXPECT_EQ(eglWaitClient(), yes);
        EXPECT_EQ(eglSwapBuffers(display, window), no);
        EXPECT_EQ(eglGetError(), EGL_NOT_INITIALIZED);
        EXPECT_EQ(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT), yes);
        EXPECT_EQ(memory_use().used, memory_before);
    }
    panel = std::make_unique<FakeDisplay>();
    display = eglGetDisplay(native(*panel));
}

/// The display's handle stays valid when it is terminated twice and initialized again. Old objects stay
/// marked for deletion (EGL 1.4, 3.2).
TEST_F(LostDisplays, TerminatedTwiceAndInitializedAgain) {
    FakeDisplay fresh;
    const EGLDisplay never = eglGetDisplay(native(fresh));
    EXPECT_EQ(eglTerminate(never), yes) << "one that was never initialized";
    EXPECT_EQ(eglTerminate(never), yes);
    EXPECT_EQ(fresh.inits, 0);
    make_window();
    const EGLSurface idle = pbuffer_of(display, 4, 4);
    for (int round = 0; round < 3; ++round) {
        EXPECT_EQ(eglTerminate(display), yes);
        EXPECT_EQ(eglTerminate(display), yes);
        EXPECT_EQ(eglGetDisplay(native(*panel)), display);
        EGLint value = 0;
        EXPECT_EQ(eglQuerySurface(display, window, EGL_WIDTH, &value), no);
        EXPECT_EQ(eglGetError(), EGL_NOT_INITIALIZED);
        const int inits = panel->inits;
        EXPECT_EQ(eglInitialize(display, nullptr, nullptr), yes);
        EXPECT_EQ(panel->inits, inits + 1);
        EXPECT_EQ(eglQuerySurface(display, window, EGL_WIDTH, &value), no) << "still marked";
        EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
        EXPECT_EQ(eglDestroySurface(display, idle), no);
        EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
        EXPECT_EQ(eglMakeCurrent(display, window, window, context), no);
        EXPECT_NE(eglGetCurrentContext(), EGL_NO_CONTEXT) << "current until it is released";
        const int presents = panel->presents;
        draw_and_read();
        glFinish(); // the old window shows nothing on the new display
        EXPECT_EQ(panel->presents, presents);
        EXPECT_EQ(panel->finishes, 0);
    }
    const EGLConfig config = config_of(display, EGL_WINDOW_BIT);
    const EGLSurface next = eglCreateWindowSurface(display, config, 0, nullptr);
    ASSERT_NE(next, EGL_NO_SURFACE) << "the glass is free again";
    const EGLContext drawn = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    EXPECT_EQ(eglMakeCurrent(display, next, next, drawn), yes);
    draw_and_read();
    EXPECT_EQ(eglSwapBuffers(display, next), yes);
    EXPECT_EQ(panel->shown[0], 0xFF);
}

/// However many displays there are, a display's entry is reused only when nothing of that display is current.
TEST_F(LostDisplays, TheEntryOfACurrentSurfaceIsNotGivenAway) {
    const auto stays = [&](EGLSurface surface, EGLContext its_context) {
        ASSERT_EQ(eglMakeCurrent(display, surface, surface, its_context), yes);
        EXPECT_EQ(eglTerminate(display), yes);
        std::vector<std::unique_ptr<FakeDisplay>> others;
        for (int i = 0; i < 3 * gl::most_displays; ++i) {
            others.push_back(std::make_unique<FakeDisplay>());
            const EGLDisplay other = eglGetDisplay(native(*others.back()));
            if (other == EGL_NO_DISPLAY)
                continue; // all entries are taken
            EXPECT_NE(other, display);
            EXPECT_EQ(eglInitialize(other, nullptr, nullptr), yes);
            EXPECT_EQ(eglTerminate(other), yes);
        }
        // Other displays take the remaining entries, so that a new display can only get the entry that was
        // given back.
        std::vector<EGLDisplay> open;
        for (const auto& one : others)
            if (const EGLDisplay other = eglGetDisplay(native(*one)); other != EGL_NO_DISPLAY) {
                EXPECT_NE(other, display);
                EXPECT_EQ(eglInitialize(other, nullptr, nullptr), yes);
                open.push_back(other);
            }
        EXPECT_EQ(open.size(), gl::most_displays - 1u);
        for (const EGLDisplay other : open)
            EXPECT_EQ(eglTerminate(other), yes);
        EXPECT_EQ(eglGetCurrentDisplay(), display);
        draw_and_read();
        EXPECT_EQ(eglReleaseThread(), yes);
        EXPECT_EQ(memory_use().used, memory_before);
        EXPECT_EQ(eglInitialize(display, nullptr, nullptr), yes) << "and the handle is good";
    };
    const EGLConfig config = config_of(display, EGL_PBUFFER_BIT);
    stays(pbuffer_of(display, 8, 8), eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr));
    make_window();
    stays(window, context);
}

/// More displays than entries come one after the other. Displays that were terminated make room for new ones,
/// the others do not.
TEST(DisplayEntries, ServeTheDisplaysOfALongLife) {
    std::vector<std::unique_ptr<FakeDisplay>> panels;
    std::vector<EGLDisplay> open;
    for (int i = 0; i < 10 * gl::most_displays; ++i) {
        panels.push_back(std::make_unique<FakeDisplay>());
        const EGLDisplay display = eglGetDisplay(native(*panels.back()));
        ASSERT_NE(display, EGL_NO_DISPLAY) << i;
        ASSERT_EQ(eglInitialize(display, nullptr, nullptr), yes);
        EXPECT_EQ(panels.back()->inits, 1);
        EXPECT_EQ(eglTerminate(display), yes);
    }
    for (std::size_t i = 0; i < gl::most_displays; ++i) {
        open.push_back(eglGetDisplay(native(*panels[i])));
        ASSERT_NE(open.back(), EGL_NO_DISPLAY) << i;
        ASSERT_EQ(eglInitialize(open.back(), nullptr, nullptr), yes);
    }
    FakeDisplay one_more;
    EXPECT_EQ(eglGetDisplay(native(one_more)), EGL_NO_DISPLAY);
    for (const EGLDisplay display : open)
        EXPECT_EQ(eglTerminate(display), yes);
    EXPECT_NE(eglGetDisplay(native(one_more)), EGL_NO_DISPLAY);
    eglTerminate(eglGetDisplay(native(one_more)));
}

/// An entry is given to one display. The next display does not get the same entry, though neither is
/// initialized yet.
TEST(DisplayEntries, AreGivenOutOnce) {
    std::vector<std::unique_ptr<FakeDisplay>> panels;
    std::vector<EGLDisplay> handles;
    for (int i = 0; i < 2 * gl::most_displays; ++i) { // from here on every entry was used before
        panels.push_back(std::make_unique<FakeDisplay>());
        eglTerminate(eglGetDisplay(native(*panels.back())));
    }
    for (std::size_t i = 0; i < gl::most_displays; ++i) {
        handles.push_back(eglGetDisplay(native(*panels[i])));
        ASSERT_NE(handles.back(), EGL_NO_DISPLAY) << i;
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_NE(handles[i], handles[j]) << i << ' ' << j;
    }
    FakeDisplay one_more;
    EXPECT_EQ(eglGetDisplay(native(one_more)), EGL_NO_DISPLAY);
    for (std::size_t i = 0; i < gl::most_displays; ++i) {
        EXPECT_EQ(eglGetDisplay(native(*panels[i])), handles[i]);
        EXPECT_EQ(eglTerminate(handles[i]), yes);
    }
}

/// Whatever of a terminated display is current keeps the display's entry: a surface that is only read, or a
/// context without a handle, also on another thread.
TEST_F(LostDisplays, TheEntryStaysWhateverIsCurrentWherever) {
    const EGLConfig config = config_of(display, EGL_PBUFFER_BIT);
    const EGLSurface drawn = pbuffer_of(display, 8, 8), read = pbuffer_of(display, 8, 8);
    const EGLContext its_context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    std::thread([&] {
        ASSERT_EQ(eglMakeCurrent(display, drawn, read, its_context), yes);
        EXPECT_EQ(eglDestroySurface(display, drawn), yes);
        EXPECT_EQ(eglDestroyContext(display, its_context), yes);
        const std::size_t held = memory_use().used;
        std::thread([&] {
            EXPECT_EQ(eglTerminate(display), yes);
            EXPECT_EQ(memory_use().used, held) << "all of it is current";
            std::vector<std::unique_ptr<FakeDisplay>> others;
            for (int i = 0; i < 2 * gl::most_displays; ++i) {
                others.push_back(std::make_unique<FakeDisplay>());
                EXPECT_NE(eglGetDisplay(native(*others.back())), display);
            }
            for (const auto& one : others)
                eglTerminate(eglGetDisplay(native(*one))); // the displays that got an entry
        }).join();
        draw_and_read();
        EXPECT_EQ(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT), yes);
        EXPECT_EQ(memory_use().used, memory_before) << "nothing holds them any more";
    }).join();
    std::vector<std::unique_ptr<FakeDisplay>> others;
    std::vector<EGLDisplay> taken;
    for (int i = 0; i < gl::most_displays; ++i) {
        others.push_back(std::make_unique<FakeDisplay>());
        taken.push_back(eglGetDisplay(native(*others.back())));
        EXPECT_NE(taken.back(), EGL_NO_DISPLAY) << "the entry serves again";
    }
    for (const EGLDisplay other : taken)
        EXPECT_EQ(eglTerminate(other), yes);
    display = eglGetDisplay(native(*panel));
}

/// A new window gets the display as soon as the old window has no handle. A context that still draws to the
/// old window then draws nowhere.
TEST_F(LostDisplays, ANewWindowTakesTheGlassOfADestroyedOne) {
    for (const bool single : {false, true}) {
        panel->two_buffers = !single;
        make_window(single);
        EXPECT_EQ(eglDestroySurface(display, window), yes);
        draw_and_read(); // draws into the window's own buffer, which stays
        const EGLConfig config = config_of(display, EGL_WINDOW_BIT);
        std::thread([&] { // the surface is current here, while another thread makes the new window
            EXPECT_EQ(eglCreateWindowSurface(display, config, 0, nullptr), EGL_NO_SURFACE);
            EXPECT_EQ(eglGetError(), EGL_BAD_ALLOC);
        })
            .join();
        glBegin(GL_POINTS);
        EXPECT_EQ(eglCreateWindowSurface(display, config, 0, nullptr), EGL_NO_SURFACE);
        EXPECT_EQ(eglGetError(), EGL_BAD_ALLOC);
        glEnd();
        const EGLSurface next = eglCreateWindowSurface(display, config, 0, nullptr);
        ASSERT_NE(next, EGL_NO_SURFACE);
        const std::vector<std::uint8_t> pixels = panel->pixels;
        const int presents = panel->presents;
        draw_and_read();
        glFinish();
        EXPECT_EQ(panel->pixels, pixels);
        EXPECT_EQ(panel->presents, presents);
        EXPECT_EQ(eglSwapInterval(display, 0), yes);
        EXPECT_TRUE(panel->intervals.empty()) << "of a window that shows nothing";
        EXPECT_EQ(eglMakeCurrent(display, next, next, context), yes);
        draw_and_read();
        EXPECT_EQ(eglSwapBuffers(display, next), yes);
        EXPECT_EQ(panel->presents, presents + 1);
        EXPECT_EQ(eglReleaseThread(), yes);
        EXPECT_EQ(eglDestroySurface(display, next), yes);
    }
}

/// A display can be initialized again only when no other thread draws to a window from before its
/// termination.
TEST_F(LostDisplays, InitWaitsForTheWindowsOfOtherThreads) {
    std::thread([&] {
        make_window();
        std::thread([&] {
            EXPECT_EQ(eglTerminate(display), yes);
            const int inits = panel->inits;
            EXPECT_EQ(eglInitialize(display, nullptr, nullptr), no);
            EXPECT_EQ(eglGetError(), EGL_NOT_INITIALIZED);
            EXPECT_EQ(panel->inits, inits) << "init() may take the memory that is drawn into";
        }).join();
        const int presents = panel->presents;
        draw_and_read();
        glFinish();
        EXPECT_EQ(panel->presents, presents) << "nothing is shown after eglTerminate";
        EXPECT_EQ(eglReleaseThread(), yes);
    }).join();
    EXPECT_EQ(eglInitialize(display, nullptr, nullptr), yes);
}

/// The interval is set for the current window, whatever display is named (EGL 1.4, 3.9.3).
TEST_F(LostDisplays, SwapIntervalAsksTheCurrentSurface) {
    const EGLDisplay headless = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    ASSERT_EQ(eglInitialize(headless, nullptr, nullptr), yes);
    FakeDisplay second;
    const EGLDisplay other = eglGetDisplay(native(second));
    ASSERT_EQ(eglInitialize(other, nullptr, nullptr), yes);
    make_window();
    EXPECT_EQ(eglSwapInterval(headless, 0), yes);
    EXPECT_EQ(eglSwapInterval(other, 7), yes);
    EXPECT_EQ(eglSwapInterval(display, -1), yes);
    EXPECT_EQ(panel->intervals, (std::vector<std::int32_t>{0, 1, 0}));
    EXPECT_TRUE(second.intervals.empty());
    EXPECT_EQ(eglSwapInterval(nullptr, 1), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_DISPLAY);
    EXPECT_EQ(eglReleaseThread(), yes);
    EXPECT_EQ(eglSwapInterval(display, 1), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_CONTEXT);
    const EGLSurface surface = pbuffer_of(headless, 4, 4);
    ASSERT_EQ(eglMakeCurrent(
                  headless, surface, surface,
                  eglCreateContext(headless, config_of(headless, EGL_PBUFFER_BIT), EGL_NO_CONTEXT, nullptr)),
              yes);
    for (const EGLDisplay named : {headless, display, other})
        EXPECT_EQ(eglSwapInterval(named, 1), yes) << "a pbuffer has none";
    EXPECT_EQ(panel->intervals.size(), 3u);
    EXPECT_EQ(eglReleaseThread(), yes);
    EXPECT_EQ(eglTerminate(headless), yes);
    EXPECT_EQ(eglTerminate(other), yes);
}

} // namespace
} // namespace spangle::test
