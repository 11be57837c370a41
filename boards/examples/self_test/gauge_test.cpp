// Tests the gauge on a simulated ST7789: the picture that a person would see, and the bytes that it costs on
// the wires.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <spangle/EGL/egl.h>
#include <spangle/boards/boards.hpp>
#include <spangle/native.hpp>
#include <spangle/sim/matchers.hpp>

#include "gauge.hpp"

namespace {

using namespace spangle::sim;

class Gauge : public testing::Test {
  protected:
    SimBoard board{spangle::boards::st7789_240};

    void SetUp() override {
        display_ = eglGetDisplay(spangle::native(board.display()));
        const EGLint wish[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        ASSERT_TRUE(eglInitialize(display_, nullptr, nullptr));
        ASSERT_TRUE(eglChooseConfig(display_, wish, &config, 1, &count));
        surface_ = eglCreateWindowSurface(display_, config, 0, nullptr);
        context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, nullptr);
        ASSERT_TRUE(eglMakeCurrent(display_, surface_, surface_, context_));
    }
    void TearDown() override {
        EXPECT_EQ(board.violations_text(), "");
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
        eglDestroySurface(display_, surface_);
        eglTerminate(display_);
    }
    void show(int charge) {
        draw_gauge(charge);
        ASSERT_TRUE(eglSwapBuffers(display_, surface_));
    }

  private:
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLSurface surface_ = EGL_NO_SURFACE;
    EGLContext context_ = EGL_NO_CONTEXT;
};

TEST_F(Gauge, SeventyPercent) {
    show(70);
    EXPECT_THAT(board, EqualsPicture("goldens/gauge_70.png"));
}

TEST_F(Gauge, NearlyEmptyIsRed) {
    show(1);
    EXPECT_THAT(crop(board.glass(), 14, 78, 14, 5), LooksLike(R"(
  ####        
  ####        
  ####    r   
  ####    r   
  ####    r   
)"));
}

TEST_F(Gauge, IsTheSameAfterADetour) {
    show(70);
    const std::string before = hash(board.glass());
    show(15);
    EXPECT_THAT(board, testing::Not(HasPictureHash(before)));
    show(70);
    EXPECT_THAT(board, HasPictureHash(before));
}

TEST_F(Gauge, SendsOnlyTheRowsItTouches) {
    show(70);
    show(70);
    const std::uint64_t before = board.counters().pixel_bytes;
    show(71);
    EXPECT_LE(board.counters().pixel_bytes - before, 96u * 208u * 2u);
}

} // namespace
