// Tests configs of colour indices and the palette of their windows (spangle/EGL/egl.h,
// EGL_SPANGLE_color_index).
#include <gtest/gtest.h>

#include <spangle/GL/gl.h>

#include "tests/system/egl/fake_display.hpp"

namespace spangle::test {
namespace {

#if SPANGLE_FEATURE_COLOR_INDEX

struct Palettes : testing::Test {
    FakeDisplay panel{PixelFormat::index8};
    EGLDisplay display = eglGetDisplay(native(panel));

    void SetUp() override { ASSERT_EQ(eglInitialize(display, nullptr, nullptr), EGLBoolean{EGL_TRUE}); }
    void TearDown() override {
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        EXPECT_EQ(eglTerminate(display), EGLBoolean{EGL_TRUE});
    }
    std::vector<EGLConfig> choose(std::vector<EGLint> wishes) const {
        wishes.insert(wishes.begin(), {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT});
        wishes.push_back(EGL_NONE);
        std::vector<EGLConfig> out(250);
        EGLint n = 0;
        EXPECT_EQ(eglChooseConfig(display, wishes.data(), out.data(), 250, &n), EGLBoolean{EGL_TRUE});
        out.resize(static_cast<std::size_t>(n));
        return out;
    }
    EGLint get(EGLConfig config, EGLint name) const {
        EGLint value = -1;
        EXPECT_EQ(eglGetConfigAttrib(display, config, name, &value), EGLBoolean{EGL_TRUE});
        return value;
    }
    EGLint refused(EGLSurface surface, EGLint first, EGLint count, const std::uint8_t* rgb) const {
        EXPECT_EQ(eglSetPaletteSPANGLE(display, surface, first, count, rgb), EGLBoolean{EGL_FALSE});
        return eglGetError();
    }
};

TEST_F(Palettes, ConfigsOfIndicesAreAskedFor) {
    for (EGLConfig c : choose({EGL_SURFACE_TYPE, EGL_PBUFFER_BIT}))
        EXPECT_EQ(get(c, EGL_COLOR_BUFFER_TYPE), EGL_RGB_BUFFER) << "what is wished where nothing is said";
    const auto indexed = choose({EGL_COLOR_BUFFER_TYPE, EGL_INDEX_BUFFER_SPANGLE});
    EXPECT_EQ(indexed.size(), 9u) << "three depth buffers, three tiers";
    for (EGLConfig c : indexed) {
        EXPECT_EQ(get(c, EGL_INDEX_SIZE_SPANGLE), 8);
        EXPECT_EQ(get(c, EGL_BUFFER_SIZE), 8);
        for (const EGLint size : {EGL_RED_SIZE, EGL_GREEN_SIZE, EGL_BLUE_SIZE, EGL_ALPHA_SIZE})
            EXPECT_EQ(get(c, size), 0);
        EXPECT_EQ(get(c, EGL_CONFIG_CAVEAT), EGL_SLOW_CONFIG);
        EXPECT_NE(get(c, EGL_SURFACE_TYPE) & EGL_WINDOW_BIT, 0);
    }
    EXPECT_TRUE(choose({EGL_COLOR_BUFFER_TYPE, EGL_INDEX_BUFFER_SPANGLE, EGL_INDEX_SIZE_SPANGLE, 9}).empty());
    EXPECT_TRUE(choose({EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_INDEX_SIZE_SPANGLE, 1}).empty());
    EXPECT_FALSE(choose({EGL_COLOR_BUFFER_TYPE, EGL_DONT_CARE, EGL_INDEX_SIZE_SPANGLE, 1}).empty());
}

TEST_F(Palettes, ContextsAreInIndexModeAndFitNoColours) {
    const EGLConfig indexed = choose({EGL_COLOR_BUFFER_TYPE, EGL_INDEX_BUFFER_SPANGLE})[0];
    const EGLConfig colored = choose({EGL_SURFACE_TYPE, EGL_PBUFFER_BIT})[0];
    const EGLint area[] = {EGL_WIDTH, 4, EGL_HEIGHT, 4, EGL_NONE};
    const EGLSurface window = eglCreateWindowSurface(display, indexed, 0, nullptr),
                     pbuffer = eglCreatePbufferSurface(display, colored, area);
    const EGLContext context = eglCreateContext(display, indexed, EGL_NO_CONTEXT, nullptr);
    EXPECT_EQ(eglMakeCurrent(display, pbuffer, pbuffer, context), EGLBoolean{EGL_FALSE});
    EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
    ASSERT_EQ(eglMakeCurrent(display, window, window, context), EGLBoolean{EGL_TRUE});
    GLint mode = 0;
    glGetIntegerv(GL_INDEX_MODE, &mode);
    EXPECT_EQ(mode, 1);
    glClearIndex(0x5A);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(eglSwapBuffers(display, window), EGLBoolean{EGL_TRUE});
    EXPECT_EQ(panel.shown, std::vector<std::uint8_t>(panel.shown.size(), 0x5A));
}

TEST_F(Palettes, OfWindowsReachTheDisplay) {
    const EGLConfig indexed = choose({EGL_COLOR_BUFFER_TYPE, EGL_INDEX_BUFFER_SPANGLE})[0];
    const EGLSurface window = eglCreateWindowSurface(display, indexed, 0, nullptr);
    const std::uint8_t rgb[6] = {1, 2, 3, 4, 5, 6};
    ASSERT_EQ(eglSetPaletteSPANGLE(display, window, 254, 2, rgb), EGLBoolean{EGL_TRUE});
    EXPECT_EQ(panel.palette, (std::vector<int>{254, 2, 1, 2, 3, 4, 5, 6}));
    ASSERT_EQ(eglSetPaletteSPANGLE(display, window, 256, 0, nullptr), EGLBoolean{EGL_TRUE});
    panel.palette.clear();
    EXPECT_EQ(refused(window, 255, 2, rgb), EGL_BAD_PARAMETER);
    EXPECT_EQ(refused(window, -1, 1, rgb), EGL_BAD_PARAMETER);
    EXPECT_EQ(refused(window, 0, -1, rgb), EGL_BAD_PARAMETER);
    EXPECT_EQ(refused(window, 257, 0, rgb), EGL_BAD_PARAMETER);
    EXPECT_EQ(refused(window, INT32_MAX, INT32_MAX, rgb), EGL_BAD_PARAMETER);
    EXPECT_EQ(refused(window, 0, 1, nullptr), EGL_BAD_PARAMETER);
    const EGLint area[] = {EGL_WIDTH, 4, EGL_HEIGHT, 4, EGL_NONE};
    EXPECT_EQ(refused(eglCreatePbufferSurface(display, indexed, area), 0, 1, rgb), EGL_BAD_SURFACE);
    EXPECT_EQ(refused(nullptr, 0, 1, rgb), EGL_BAD_SURFACE);
    EXPECT_EQ(eglSetPaletteSPANGLE(nullptr, window, 0, 1, rgb), EGLBoolean{EGL_FALSE});
    EXPECT_EQ(eglGetError(), EGL_BAD_DISPLAY);
    EXPECT_TRUE(panel.palette.empty());
}

/// Windows of colours have no palette, and a display without a palette reports an error.
TEST(PalettesOfColours, DoNotExist) {
    FakeDisplay panel;
    const EGLDisplay display = eglGetDisplay(native(panel));
    ASSERT_EQ(eglInitialize(display, nullptr, nullptr), EGLBoolean{EGL_TRUE});
    const EGLint wishes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint n = 0;
    ASSERT_EQ(eglChooseConfig(display, wishes, &config, 1, &n), EGLBoolean{EGL_TRUE});
    const EGLSurface window = eglCreateWindowSurface(display, config, 0, nullptr);
    const std::uint8_t rgb[3] = {};
    EXPECT_EQ(eglSetPaletteSPANGLE(display, window, 0, 1, rgb), EGLBoolean{EGL_FALSE});
    EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
    EXPECT_EQ(panel.hal::Display::set_palette(0, 1, rgb).error().fault, hal::Fault::unsupported);
    EXPECT_EQ(eglTerminate(display), EGLBoolean{EGL_TRUE});
}

#endif

} // namespace
} // namespace spangle::test
