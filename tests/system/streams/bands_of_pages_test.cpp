// Rows of mono surfaces share bytes in pages of eight, which are counted from the bottom of the picture.
// Bands are counted from its top.
#include <gtest/gtest.h>

#include <spangle/EGL/egl.h>

#include "tests/system/streams/stream_panel.hpp"

namespace spangle::test {
namespace {

/// Returns the error of a window on a mono display of this height, whose buffer holds `band` rows; 0: all.
EGLint window_error(std::int32_t height, std::int32_t band) {
    StreamPanel panel;
    panel.become(PixelFormat::mono, 12, height, band, false);
    const EGLDisplay display = eglGetDisplay(native(panel));
    EXPECT_EQ(eglInitialize(display, nullptr, nullptr), EGLBoolean{EGL_TRUE});
    const EGLint wish[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    EXPECT_EQ(eglChooseConfig(display, wish, &config, 1, &count), EGLBoolean{EGL_TRUE});
    eglCreateWindowSurface(display, config, 0, nullptr);
    const EGLint error = eglGetError();
    EXPECT_EQ(eglTerminate(display), EGLBoolean{EGL_TRUE});
    return error;
}

TEST(BandsOfPages, PicturesOfWholePagesOnly) {
    for (std::int32_t height = 8; height < 25; ++height) {
        EXPECT_EQ(window_error(height, 0), EGL_SUCCESS) << height;
        EXPECT_EQ(window_error(height, 8), height % 8 == 0 ? EGL_SUCCESS : EGL_BAD_MATCH) << height;
    }
}

} // namespace
} // namespace spangle::test
