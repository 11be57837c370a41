// Tests displays, windows, pbuffers and SwapBuffers (EGL 1.4, 3.2, 3.5, 3.9).
#include <gtest/gtest.h>

#include <spangle/GL/gl.h>
#include <spangle/message.hpp>

#include <climits>
#include <cstring>
#include <string>

#include "gl/context/features.hpp"
#include "gl/egl/objects.hpp"
#include "tests/system/egl/fake_display.hpp"

namespace spangle::test {
namespace {

std::string last_message;
unsigned last_code = 0;
void remember(unsigned code, const char* text) {
    last_code = code;
    last_message = text;
}

constexpr EGLBoolean yes = EGL_TRUE, no = EGL_FALSE;

EGLConfig choose(EGLDisplay display, std::vector<EGLint> wishes) {
    wishes.insert(wishes.end(), {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE});
    EGLConfig config = nullptr;
    EGLint n = 0;
    EXPECT_EQ(eglChooseConfig(display, wishes.data(), &config, 1, &n), yes);
    EXPECT_EQ(n, 1);
    return config;
}

struct Surfaces : testing::Test {
    FakeDisplay panel;
    EGLDisplay display = eglGetDisplay(native(panel));
    std::size_t memory_before = memory_use().used;

    void SetUp() override { ASSERT_EQ(eglInitialize(display, nullptr, nullptr), yes); }
    void TearDown() override {
        EXPECT_EQ(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT), yes);
        eglTerminate(display);
        EXPECT_EQ(memory_use().used, memory_before); // all memory was given back
        EXPECT_TRUE(egl::arena().consistent());
        on_message(nullptr);
    }
    EGLConfig window_config(EGLint depth = 0) {
        return choose(display, {EGL_SURFACE_TYPE, EGL_WINDOW_BIT, EGL_DEPTH_SIZE, depth});
    }
    EGLConfig pbuffer_config() {
        return choose(display, {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_ALPHA_SIZE, 8, EGL_DEPTH_SIZE, 24});
    }
    EGLint query(EGLSurface surface, EGLint name) {
        EGLint value = -7;
        EXPECT_EQ(eglQuerySurface(display, surface, name, &value), yes);
        return value;
    }
    EGLContext current_window(EGLSurface& surface, EGLint depth = 16) {
        const EGLConfig config = window_config(depth);
        surface = eglCreateWindowSurface(display, config, 0, nullptr);
        const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
        EXPECT_EQ(eglMakeCurrent(display, surface, surface, context), yes);
        return context;
    }
};

TEST(Displays, HandlesAndInitialisation) {
    FakeDisplay panel, other;
    const EGLDisplay display = eglGetDisplay(native(panel));
    ASSERT_NE(display, EGL_NO_DISPLAY);
    EXPECT_EQ(eglGetDisplay(native(panel)), display);
    EXPECT_NE(eglGetDisplay(native(other)), display);
    EGLint n = 0;
    EXPECT_EQ(eglGetConfigs(display, nullptr, 0, &n), no);
    EXPECT_EQ(eglGetError(), EGL_NOT_INITIALIZED);
    EXPECT_EQ(eglQueryString(display, EGL_VERSION), nullptr);
    EXPECT_EQ(eglGetError(), EGL_NOT_INITIALIZED);

    panel.fail_init = true;
    on_message(&remember);
    EXPECT_EQ(eglInitialize(display, nullptr, nullptr), no);
    EXPECT_EQ(eglGetError(), EGL_NOT_INITIALIZED);
    EXPECT_EQ(last_message, "eglInitialize: fake: the panel does not answer");
    on_message(nullptr);
    EXPECT_EQ(eglGetConfigs(display, nullptr, 0, &n), no);
    panel.fail_init = false;
    EGLint major = 0, minor = 0;
    EXPECT_EQ(eglInitialize(display, &major, &minor), yes);
    EXPECT_EQ(major, 1);
    EXPECT_EQ(minor, 4);
    EXPECT_EQ(panel.inits, 2);
    EXPECT_EQ(eglInitialize(display, nullptr, nullptr), yes); // the second call has no effect (EGL 1.4, 3.2)
    EXPECT_EQ(panel.inits, 2);

    EXPECT_EQ(std::strncmp(eglQueryString(display, EGL_VERSION), "1.4 ", 4), 0);
    EXPECT_NE(std::strstr(eglQueryString(display, EGL_CLIENT_APIS), "OpenGL"), nullptr);
    EXPECT_NE(std::strstr(eglQueryString(display, EGL_EXTENSIONS), "EGL_EXT_buffer_age"), nullptr);
    EXPECT_EQ(std::strstr(eglQueryString(display, EGL_EXTENSIONS), "EGL_SPANGLE_accum") != nullptr,
              SPANGLE_FEATURE_ACCUM != 0);
    EXPECT_NE(eglQueryString(display, EGL_VENDOR), nullptr);
    EXPECT_EQ(eglQueryString(display, EGL_WIDTH), nullptr);
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);

    EXPECT_EQ(eglQueryAPI(), EGLenum{EGL_OPENGL_API}); // OpenGL is the only API
    EXPECT_EQ(eglBindAPI(EGL_OPENGL_API), yes);
    EXPECT_EQ(eglQueryAPI(), EGLenum{EGL_OPENGL_API});
    EXPECT_EQ(eglBindAPI(EGL_OPENVG_API), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
    EXPECT_EQ(eglWaitNative(EGL_CORE_NATIVE_ENGINE), yes);
    EXPECT_EQ(eglWaitNative(1), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);

    EXPECT_EQ(eglTerminate(display), yes);
    EXPECT_EQ(eglTerminate(eglGetDisplay(native(other))), yes);
    int local = 0;
    for (EGLDisplay garbage : {EGLDisplay{nullptr}, EGLDisplay{&local}}) {
        EXPECT_EQ(eglInitialize(garbage, nullptr, nullptr), no);
        EXPECT_EQ(eglGetError(), EGL_BAD_DISPLAY);
        EXPECT_EQ(eglTerminate(garbage), no);
        EXPECT_EQ(eglGetError(), EGL_BAD_DISPLAY);
    }
}

TEST(Displays, OffScreenWithoutAPanel) {
    const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    ASSERT_EQ(eglInitialize(display, nullptr, nullptr), yes);
    const EGLint wishes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_WINDOW_BIT, EGL_NONE};
    EGLint n = -1;
    EXPECT_EQ(eglChooseConfig(display, wishes, nullptr, 0, &n), yes);
    EXPECT_EQ(n, 0);
    const EGLConfig config = choose(display, {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT});
    EXPECT_EQ(eglCreateWindowSurface(display, config, 0, nullptr), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
    const EGLint size[] = {EGL_WIDTH, 4, EGL_HEIGHT, 4, EGL_NONE};
    EXPECT_NE(eglCreatePbufferSurface(display, config, size), EGL_NO_SURFACE);
    EXPECT_EQ(eglTerminate(display), yes);
}

TEST_F(Surfaces, PbufferSizesAndErrors) {
    const EGLConfig config = pbuffer_config();
    const struct {
        std::vector<EGLint> list;
        EGLint error, width, height;
    } cases[] = {
        {{EGL_WIDTH, 10, EGL_HEIGHT, 20, EGL_NONE}, EGL_SUCCESS, 10, 20},
        {{EGL_WIDTH, 160, EGL_HEIGHT, 160, EGL_TEXTURE_FORMAT, EGL_NO_TEXTURE, EGL_NONE},
         EGL_SUCCESS,
         160,
         160},
        {{EGL_NONE}, EGL_SUCCESS, 0, 0},
        {{EGL_WIDTH, -1, EGL_HEIGHT, 20, EGL_NONE}, EGL_BAD_PARAMETER, 0, 0},
        {{EGL_WIDTH, 1, EGL_HEIGHT, INT_MIN, EGL_NONE}, EGL_BAD_PARAMETER, 0, 0},
        {{EGL_WIDTH, 4096, EGL_HEIGHT, 1, EGL_NONE}, EGL_BAD_ALLOC, 0, 0},
        {{EGL_WIDTH, INT_MAX, EGL_HEIGHT, INT_MAX, EGL_NONE}, EGL_BAD_ALLOC, 0, 0},
        {{EGL_WIDTH, 4096, EGL_HEIGHT, 1, EGL_LARGEST_PBUFFER, EGL_TRUE, EGL_NONE}, EGL_SUCCESS, 2048, 1},
        {{EGL_TEXTURE_FORMAT, 0x305D, EGL_NONE}, EGL_BAD_MATCH, 0, 0},
        {{0x1234, 1, EGL_NONE}, EGL_BAD_ATTRIBUTE, 0, 0},
    };
    for (const auto& c : cases) {
        const EGLSurface surface = eglCreatePbufferSurface(display, config, c.list.data());
        EXPECT_EQ(eglGetError(), c.error) << &c - cases;
        EXPECT_EQ(surface != EGL_NO_SURFACE, c.error == EGL_SUCCESS);
        if (surface == EGL_NO_SURFACE)
            continue;
        EXPECT_EQ(query(surface, EGL_WIDTH), c.width);
        EXPECT_EQ(query(surface, EGL_HEIGHT), c.height);
        EXPECT_EQ(query(surface, EGL_RENDER_BUFFER), EGL_BACK_BUFFER); // EGL 1.4, 3.5.6
        EGLint id = 0;
        EXPECT_EQ(eglGetConfigAttrib(display, config, EGL_CONFIG_ID, &id), yes);
        EXPECT_EQ(query(surface, EGL_CONFIG_ID), id);
        EXPECT_EQ(eglSwapBuffers(display, surface), yes); // swapping a pbuffer has no effect
        EXPECT_EQ(eglDestroySurface(display, surface), yes);
    }
    EXPECT_EQ(eglCreatePbufferSurface(display, nullptr, nullptr), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_CONFIG);
}

TEST_F(Surfaces, DeadAndForeignHandles) {
    const EGLint size[] = {EGL_WIDTH, 4, EGL_HEIGHT, 4, EGL_NONE};
    const EGLSurface surface = eglCreatePbufferSurface(display, pbuffer_config(), size);
    const EGLContext context = eglCreateContext(display, pbuffer_config(), EGL_NO_CONTEXT, nullptr);
    FakeDisplay second;
    const EGLDisplay other = eglGetDisplay(native(second));
    ASSERT_EQ(eglInitialize(other, nullptr, nullptr), yes);
    EGLint value = 0;
    // The surface belongs to another display.
    EXPECT_EQ(eglQuerySurface(other, surface, EGL_WIDTH, &value), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
    EXPECT_EQ(eglQueryContext(other, context, EGL_CONFIG_ID, &value), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_CONTEXT);
    EXPECT_EQ(eglTerminate(other), yes);
    EXPECT_EQ(eglQuerySurface(display, surface, 0x1234, &value), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_ATTRIBUTE);
    EXPECT_EQ(eglQuerySurface(display, surface, EGL_WIDTH, nullptr), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
    EXPECT_EQ(eglDestroySurface(display, surface), yes);
    EXPECT_EQ(eglDestroyContext(display, context), yes);
    for (void* dead : {surface, context, static_cast<void*>(nullptr), static_cast<void*>(&value)}) {
        EXPECT_EQ(eglDestroySurface(display, dead), no);
        EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
        EXPECT_EQ(eglSwapBuffers(display, dead), no);
        EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
        EXPECT_EQ(eglDestroyContext(display, dead), no);
        EXPECT_EQ(eglGetError(), EGL_BAD_CONTEXT);
    }
}

TEST_F(Surfaces, TheWindowIsTheGlass) {
    const EGLConfig config = window_config();
    const EGLSurface surface = eglCreateWindowSurface(display, config, 0, nullptr);
    ASSERT_NE(surface, EGL_NO_SURFACE);
    EXPECT_EQ(query(surface, EGL_WIDTH), 12);
    EXPECT_EQ(query(surface, EGL_HEIGHT), 9);
    EXPECT_EQ(query(surface, EGL_RENDER_BUFFER), EGL_BACK_BUFFER);
    EXPECT_EQ(query(surface, EGL_SWAP_BEHAVIOR), EGL_BUFFER_DESTROYED);
    // A display has one window only.
    EXPECT_EQ(eglCreateWindowSurface(display, config, 0, nullptr), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_ALLOC);
    EXPECT_EQ(eglDestroySurface(display, surface), yes);
    EXPECT_EQ(eglCreateWindowSurface(display, config, 1, nullptr), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
    EXPECT_EQ(eglCreateWindowSurface(display, nullptr, 0, nullptr), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_CONFIG);
    EXPECT_EQ(eglCreateWindowSurface(display, pbuffer_config(), 0, nullptr),
              EGL_NO_SURFACE); // the config does not have the panel's format
    EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
    const EGLint unknown[] = {EGL_WIDTH, 3, EGL_NONE};
    EXPECT_EQ(eglCreateWindowSurface(display, config, 0, unknown), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_ATTRIBUTE);
    panel.fail_acquire = true;
    EXPECT_EQ(eglCreateWindowSurface(display, config, 0, nullptr), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
    panel.fail_acquire = false;
    const EGLint back[] = {EGL_RENDER_BUFFER, EGL_BACK_BUFFER, EGL_NONE};
    EXPECT_NE(eglCreateWindowSurface(display, config, 0, back), EGL_NO_SURFACE);
}

#if SPANGLE_FEATURE_MULTISAMPLE

/// A window whose config has samples presents resolved pixels, and sends no more of them than was drawn.
TEST_F(Surfaces, SamplesAreResolvedWhenTheWindowIsShown) {
    const EGLConfig config =
        choose(display, {EGL_SURFACE_TYPE, EGL_WINDOW_BIT, EGL_DEPTH_SIZE, 16, EGL_SAMPLE_BUFFERS, 1});
    const EGLSurface surface = eglCreateWindowSurface(display, config, 0, nullptr);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    ASSERT_EQ(eglMakeCurrent(display, surface, surface, context), yes);
    glDisable(GL_DITHER);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    EXPECT_TRUE(panel.extents.cleared);
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, 12, 0, 9, -1, 1);
    glColor3f(1, 1, 1);
    glRectf(2, 1, 4.5f, 2); // covers two samples of column 4
    for (const std::uint8_t byte : panel.pixels)
        ASSERT_EQ(byte, 0) << "not resolved yet";
    EXPECT_EQ(eglSwapBuffers(display, surface), yes);
    for (std::size_t y = 0; y < 9; ++y)
        for (std::size_t x = 0; x < 12; ++x) {
            const unsigned word = panel.shown[(y * 12 + x) * 2] * 256u + panel.shown[(y * 12 + x) * 2 + 1];
            const bool row = y == 7; // memory row 7 is GL's row 1
            EXPECT_EQ(word, row && (x == 2 || x == 3) ? 0xFFFFu
                            : row && x == 4           ? 16u << 11 | 32u << 5 | 16u
                                                      : 0u)
                << x << ' ' << y;
            EXPECT_EQ(panel.shown_extents[y], (row ? RowSpan{2, 5} : RowSpan{}));
        }
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

/// A window without a back buffer is resolved by Flush.
TEST_F(Surfaces, FlushResolvesSamplesOfASingleBuffer) {
    const EGLConfig config =
        choose(display, {EGL_SURFACE_TYPE, EGL_WINDOW_BIT, EGL_DEPTH_SIZE, 16, EGL_SAMPLE_BUFFERS, 1});
    const EGLint single[] = {EGL_RENDER_BUFFER, EGL_SINGLE_BUFFER, EGL_NONE};
    const EGLSurface surface = eglCreateWindowSurface(display, config, 0, single);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    ASSERT_EQ(eglMakeCurrent(display, surface, surface, context), yes);
    glClear(GL_COLOR_BUFFER_BIT);
    glBegin(GL_TRIANGLES);
    glVertex2f(-1, -1), glVertex2f(3, -1), glVertex2f(-1, 3);
    glEnd();
    glFlush();
    for (const std::uint8_t byte : panel.shown)
        ASSERT_EQ(byte, 0xFF);
}

TEST_F(Surfaces, SamplesBelongToConfigsThatHaveThem) {
    const std::vector<EGLint> wish = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_DEPTH_SIZE, 24};
    std::vector<EGLint> sampled = wish;
    sampled.insert(sampled.end(), {EGL_SAMPLES, 2});
    const EGLint size[] = {EGL_WIDTH, 64, EGL_HEIGHT, 32, EGL_NONE};
    const EGLConfig configs[] = {choose(display, wish), choose(display, sampled)};
    EGLSurface surface[2];
    EGLContext context[2];
    std::size_t bytes[2];
    for (int i = 0; i < 2; ++i) {
        const std::size_t before = memory_use().used;
        surface[i] = eglCreatePbufferSurface(display, configs[i], size);
        bytes[i] = memory_use().used - before;
        context[i] = eglCreateContext(display, configs[i], EGL_NO_CONTEXT, nullptr);
    }
    constexpr std::size_t pixels = 64 * 32; // beside it samples have four colours, and three further depths
    EXPECT_GE(bytes[1] - bytes[0], pixels * (4 * 2 + 3 * 4) + 32 * sizeof(RowSpan));
    EXPECT_LE(bytes[1] - bytes[0], pixels * (4 * 2 + 3 * 4) + 32 * sizeof(RowSpan) + 128);
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(eglMakeCurrent(display, surface[i], surface[i], context[1 - i]), no);
        EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
        EXPECT_EQ(eglMakeCurrent(display, surface[i], surface[i], context[i]), yes);
    }
}

#endif

TEST_F(Surfaces, DrawingGoesStraightIntoTheFrameTopRowFirst) {
    EGLSurface surface;
    current_window(surface);
    glDisable(GL_DITHER);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST);
    glScissor(2, 0, 3, 1); // the bottom row of GL
    glClearColor(1, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ASSERT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    for (std::size_t y = 0; y < 9; ++y)
        for (std::size_t x = 0; x < 12; ++x) {
            const bool red = y == 8 && x >= 2 && x < 5; // the last row of memory
            EXPECT_EQ(panel.pixels[(y * 12 + x) * 2], red ? 0xF8 : 0) << x << " " << y;
            EXPECT_EQ(panel.pixels[(y * 12 + x) * 2 + 1], 0);
        }
    EXPECT_TRUE(panel.extents.cleared);
    EXPECT_EQ(panel.rows[8], (RowSpan{2, 5}));
    EXPECT_EQ(panel.rows[0], RowSpan{});
    EXPECT_EQ(eglSwapBuffers(display, surface), yes);
    EXPECT_EQ(panel.presents, 1);
    EXPECT_EQ(panel.shown, panel.pixels);
    EXPECT_EQ(panel.shown_extents[8], (RowSpan{2, 5}));
    EXPECT_EQ(query(surface, EGL_BUFFER_AGE_EXT), 1); // the age of the next frame's buffer
    glScissor(0, 8, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(panel.pixels[0], 0xF8);
    EXPECT_EQ(panel.rows[0], (RowSpan{0, 1}));
    EXPECT_FALSE(panel.extents.cleared);
}

TEST_F(Surfaces, EachFrameIsDrawnIntoItsOwnBuffer) {
    panel.two_buffers = true;
    EGLSurface surface;
    current_window(surface);
    for (int frame = 0; frame < 4; ++frame) {
        constexpr std::uint8_t first_byte[] = {0xF8, 0x07, 0x00}; // of red, green, blue in RGB565
        const int shade = frame % 3;
        glClearColor(shade == 0 ? 1.0f : 0.0f, shade == 1 ? 1.0f : 0.0f, shade == 2 ? 1.0f : 0.0f, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        EXPECT_EQ(panel.pixels[0], first_byte[shade]);
        ASSERT_EQ(eglSwapBuffers(display, surface), yes);
        EXPECT_EQ(panel.shown[0], first_byte[shade]);
    }
}

TEST_F(Surfaces, ASingleBufferedWindowIsShownByFlush) {
    const EGLint single[] = {EGL_RENDER_BUFFER, EGL_SINGLE_BUFFER, EGL_NONE};
    const EGLConfig config = window_config();
    const EGLSurface surface = eglCreateWindowSurface(display, config, 0, single);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    ASSERT_EQ(eglMakeCurrent(display, surface, surface, context), yes);
    EGLint granted = 0;
    EXPECT_EQ(eglQueryContext(display, context, EGL_RENDER_BUFFER, &granted), yes);
    EXPECT_EQ(granted, EGL_SINGLE_BUFFER);
    EXPECT_EQ(query(surface, EGL_RENDER_BUFFER), EGL_SINGLE_BUFFER);
    GLboolean doubled = GL_TRUE;
    glGetBooleanv(GL_DOUBLEBUFFER, &doubled);
    EXPECT_EQ(doubled, GL_FALSE);
    GLint drawn = 0;
    glGetIntegerv(GL_DRAW_BUFFER, &drawn);
    EXPECT_EQ(drawn, GL_FRONT);

    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(panel.presents, 0);
    EXPECT_EQ(eglSwapBuffers(display, surface), yes); // no effect (EGL 1.4, 3.9.1)
    EXPECT_EQ(panel.presents, 0);
    glFlush();
    EXPECT_EQ(panel.presents, 1);
    EXPECT_EQ(panel.shown[0], 0xFF);
    EXPECT_EQ(panel.finishes, 0);
    glFinish();
    EXPECT_EQ(panel.presents, 2);
    EXPECT_EQ(panel.finishes, 1);
    EXPECT_EQ(eglWaitClient(), yes);
    EXPECT_EQ(panel.presents, 3);
    EXPECT_EQ(eglWaitGL(), yes);
    EXPECT_EQ(panel.presents, 4);
    EXPECT_EQ(panel.finishes, 3);

    glEnable(GL_SCISSOR_TEST); // draws on the pixels that are there
    glScissor(0, 8, 2, 1);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    panel.fail_present = true; // a failed transfer is reported in a message, and GL goes on
    on_message(&remember);
    last_code = 0;
    glFlush();
    EXPECT_EQ(last_code, static_cast<unsigned>(EGL_BAD_NATIVE_WINDOW));
    EXPECT_EQ(eglGetError(), EGL_SUCCESS);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    panel.fail_present = false;
    // Releasing the context flushes it.
    EXPECT_EQ(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT), yes);
    EXPECT_EQ(panel.presents, 5);
    EXPECT_EQ(panel.shown_extents[0], (RowSpan{0, 2}));
    EXPECT_EQ(panel.shown[0], 0);
    EXPECT_EQ(panel.shown[2 * 2], 0xFF);
}

TEST_F(Surfaces, FinishWaitsForWhatWasPresented) {
    EGLSurface surface;
    current_window(surface);
    glFlush();
    EXPECT_EQ(panel.finishes, 0);
    glFinish();
    EXPECT_EQ(panel.finishes, 1);
    EXPECT_EQ(panel.presents, 0) << "the back buffer is not shown by it";
    EXPECT_EQ(eglWaitClient(), yes);
    EXPECT_EQ(panel.finishes, 2);
    panel.fail_present = true;
    on_message(&remember);
    last_message.clear();
    glFinish();
    EXPECT_EQ(last_message, "glFinish: fake: the transfer does not end");
    EXPECT_EQ(eglGetError(), EGL_SUCCESS);
}

TEST_F(Surfaces, SwapIntervalsAreClampedAndReachTheDisplay) {
    EGLSurface surface;
    current_window(surface);
    EGLint least = -1, most = -1;
    EXPECT_EQ(eglGetConfigAttrib(display, window_config(), EGL_MIN_SWAP_INTERVAL, &least), yes);
    EXPECT_EQ(eglGetConfigAttrib(display, window_config(), EGL_MAX_SWAP_INTERVAL, &most), yes);
    EXPECT_EQ(least, 0);
    EXPECT_EQ(most, 1);
    for (const EGLint interval : {0, 1, -5, 60})
        EXPECT_EQ(eglSwapInterval(display, interval), yes);
    EXPECT_EQ(panel.intervals, (std::vector<std::int32_t>{0, 1, 0, 1}));
}

TEST_F(Surfaces, ADisplayThatFlipsGrantsNoSingleBuffer) {
    panel.two_buffers = true;
    const EGLint single[] = {EGL_RENDER_BUFFER, EGL_SINGLE_BUFFER, EGL_NONE};
    const EGLConfig config = window_config();
    const EGLSurface surface = eglCreateWindowSurface(display, config, 0, single);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    ASSERT_EQ(eglMakeCurrent(display, surface, surface, context), yes);
    EGLint granted = 0;
    EXPECT_EQ(eglQueryContext(display, context, EGL_RENDER_BUFFER, &granted), yes);
    EXPECT_EQ(granted, EGL_BACK_BUFFER);
    // RENDER_BUFFER returns the buffer that was asked for (EGL 1.4, 3.5.6).
    EXPECT_EQ(query(surface, EGL_RENDER_BUFFER), EGL_SINGLE_BUFFER);
    glFlush();
    EXPECT_EQ(panel.presents, 0);
    EXPECT_EQ(eglSwapBuffers(display, surface), yes);
    EXPECT_EQ(panel.presents, 1);
    const EGLint nonsense[] = {EGL_RENDER_BUFFER, 7, EGL_NONE};
    EXPECT_EQ(eglDestroySurface(display, surface), yes);
    EXPECT_EQ(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT), yes);
    EXPECT_EQ(eglCreateWindowSurface(display, config, 0, nonsense), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
}

TEST_F(Surfaces, AFailedTransferIsReportedAndNothingIsLost) {
    EGLSurface surface;
    current_window(surface);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    panel.fail_present = true;
    on_message(&remember);
    EXPECT_EQ(eglSwapBuffers(display, surface), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
    EXPECT_EQ(last_message, "eglSwapBuffers: fake: 3 of 7 bytes went out");
    EXPECT_EQ(last_code, static_cast<unsigned>(EGL_BAD_NATIVE_WINDOW));
    EXPECT_EQ(panel.presents, 0);
    glEnable(GL_SCISSOR_TEST); // the frame's buffer can still be drawn into
    glScissor(0, 0, 1, 1);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    panel.fail_present = false;
    EXPECT_EQ(eglSwapBuffers(display, surface), yes);
    EXPECT_EQ(panel.presents, 1);
    EXPECT_EQ(panel.shown[0], 0xFF);
    EXPECT_EQ(panel.shown[8 * 12 * 2], 0);
    panel.fail_acquire = true; // the frame is shown, but there is no next buffer
    EXPECT_EQ(eglSwapBuffers(display, surface), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
    EXPECT_EQ(last_message, "eglSwapBuffers: fake: no buffer");
    panel.fail_acquire = false;
}

TEST_F(Surfaces, SwapWantsTheCurrentWindow) {
    const EGLConfig config = window_config();
    const EGLSurface surface = eglCreateWindowSurface(display, config, 0, nullptr);
    EXPECT_EQ(eglSwapBuffers(display, surface), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
    EXPECT_EQ(panel.presents, 0);
    EGLint age = 0;
    EXPECT_EQ(eglQuerySurface(display, surface, EGL_BUFFER_AGE_EXT, &age), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
    EXPECT_EQ(eglSwapInterval(display, 1), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_CONTEXT);
}

/// Whichever allocation fails, the error is BAD_ALLOC and no memory is kept.
TEST_F(Surfaces, ExhaustionAtEveryPoint) {
    gl::Arena& arena = egl::arena();
    const EGLConfig config = pbuffer_config();
    const EGLint size[] = {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
    const std::size_t start = arena.used();
    // Leaves `room` bytes free in an arena that is otherwise full.
    std::vector<void*> hoard;
    for (std::size_t block = std::size_t{1} << 40; block >= 32; block /= 2)
        while (void* p = arena.allocate(block))
            hoard.push_back(p);
    unsigned surfaces = 0, contexts = 0, failures = 0;
    for (std::size_t freed = 0; freed < hoard.size() && (surfaces == 0 || contexts == 0); ++freed) {
        const std::size_t used = arena.used();
        const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
        if (surface == EGL_NO_SURFACE) {
            EXPECT_EQ(eglGetError(), EGL_BAD_ALLOC);
            EXPECT_EQ(arena.used(), used);
            ++failures;
        } else {
            ++surfaces;
            EXPECT_EQ(eglDestroySurface(display, surface), yes);
        }
        const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
        if (context == EGL_NO_CONTEXT) {
            EXPECT_EQ(eglGetError(), EGL_BAD_ALLOC);
            EXPECT_EQ(arena.used(), used);
            ++failures;
        } else {
            ++contexts;
            EXPECT_EQ(eglDestroyContext(display, context), yes);
        }
        EXPECT_EQ(arena.used(), used);
        ASSERT_TRUE(arena.consistent());
        arena.free(hoard[hoard.size() - 1 - freed]);
        hoard[hoard.size() - 1 - freed] = nullptr;
    }
    for (void* p : hoard)
        arena.free(p);
    EXPECT_EQ(arena.used(), start);
    EXPECT_GT(failures, 5u);
    EXPECT_GT(surfaces, 0u);
    EXPECT_GT(contexts, 0u);
}

/// An accumulation buffer is there beside the config's buffers, on windows and pbuffers alike.
TEST_F(Surfaces, AccumulationBuffers) {
    const EGLConfig config = window_config(16);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    const std::size_t before = egl::arena().used();
    for (const bool window : {false, true})
        for (const EGLint bits : {0, 1, 16}) {
            const EGLint window_list[] = {EGL_ACCUM_SIZE_SPANGLE, bits, EGL_NONE};
            const EGLint list[] = {EGL_WIDTH, 12, EGL_ACCUM_SIZE_SPANGLE, bits, EGL_HEIGHT, 9, EGL_NONE};
            const EGLSurface surface = window ? eglCreateWindowSurface(display, config, 0, window_list)
                                              : eglCreatePbufferSurface(display, config, list);
            ASSERT_NE(surface, EGL_NO_SURFACE);
            EGLint size = -1;
            EXPECT_EQ(eglQuerySurface(display, surface, EGL_ACCUM_SIZE_SPANGLE, &size), yes);
            EXPECT_EQ(size, bits == 0 ? 0 : 16);
            ASSERT_EQ(eglMakeCurrent(display, surface, surface, context), yes);
            GLint of_gl[4] = {-1, -1, -1, -1};
            for (const GLenum name :
                 {GL_ACCUM_RED_BITS, GL_ACCUM_GREEN_BITS, GL_ACCUM_BLUE_BITS, GL_ACCUM_ALPHA_BITS}) {
                glGetIntegerv(name, of_gl);
                EXPECT_EQ(of_gl[0], size);
            }
            glClearAccum(0, 1, 0, 1);
            glClear(GL_ACCUM_BUFFER_BIT);
            glClear(GL_COLOR_BUFFER_BIT);
            glAccum(GL_RETURN, 1);
            EXPECT_EQ(glGetError(), bits == 0 ? GLenum{GL_INVALID_OPERATION} : GLenum{GL_NO_ERROR});
            GLubyte pixel[4] = {};
            glReadPixels(11, 8, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
            EXPECT_EQ(pixel[0], 0);
            EXPECT_EQ(pixel[1], bits == 0 ? 0 : 255);
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
            EXPECT_EQ(eglDestroySurface(display, surface), yes);
            EXPECT_EQ(egl::arena().used(), before);
        }
    for (const EGLint bits : {-1, 17}) {
        const EGLint window_list[] = {EGL_ACCUM_SIZE_SPANGLE, bits, EGL_NONE};
        EXPECT_EQ(eglCreateWindowSurface(display, config, 0, window_list), EGL_NO_SURFACE);
        EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
        const EGLint list[] = {EGL_WIDTH, 12, EGL_HEIGHT, 9, EGL_ACCUM_SIZE_SPANGLE, bits, EGL_NONE};
        EXPECT_EQ(eglCreatePbufferSurface(display, config, list), EGL_NO_SURFACE);
        EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
    }
}

/// A window is drawn to while a pbuffer is read, and the other way about. SwapBuffers exchanges the buffers
/// of the drawn surface, and ReadBuffer names a buffer of the read surface.
TEST_F(Surfaces, WindowAndPbufferAsDrawAndRead) {
    const EGLConfig config = window_config(16);
    const EGLSurface window = eglCreateWindowSurface(display, config, 0, nullptr);
    const EGLint size[] = {EGL_WIDTH, 12, EGL_HEIGHT, 9, EGL_NONE};
    const EGLSurface pbuffer = eglCreatePbufferSurface(display, config, size);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    GLubyte pixel[4] = {};
    ASSERT_EQ(eglMakeCurrent(display, pbuffer, pbuffer, context), yes);
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ASSERT_EQ(eglMakeCurrent(display, window, pbuffer, context), yes);
    for (int frame = 0; frame < 2; ++frame) {
        glClearColor(1, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
        EXPECT_EQ(pixel[0], 0);
        EXPECT_EQ(pixel[1], 255);
        EXPECT_EQ(eglSwapBuffers(display, window), yes);
        EXPECT_EQ(panel.shown[0], 0xF8); // the high byte of red, in big-endian order
    }
    glReadBuffer(GL_FRONT);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    glReadBuffer(GL_BACK); // of a pbuffer, FRONT and BACK name the same buffer
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    glDrawBuffer(GL_FRONT);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION}); // a window has no front buffer to draw to
    // FRONT_AND_BACK names all buffers that exist: the back buffer (GL 1.3, 4.2.1).
    glDrawBuffer(GL_NONE);
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(eglSwapBuffers(display, window), yes);
    EXPECT_EQ(panel.shown[0], 0xF8);
    glDrawBuffer(GL_FRONT_AND_BACK);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(eglSwapBuffers(display, window), yes);
    EXPECT_EQ(panel.shown[0], 0x07); // the high byte of green
    glClearColor(1, 0, 0, 1);
    glDrawBuffer(GL_BACK);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    ASSERT_EQ(eglMakeCurrent(display, pbuffer, window, context), yes);
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    EXPECT_EQ(pixel[0], 255);
    EXPECT_EQ(eglSwapBuffers(display, window), no); // the window is read, not drawn to
    EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
}

} // namespace
} // namespace spangle::test
