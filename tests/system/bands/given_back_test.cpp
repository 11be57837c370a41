// Buffers of bands and frames belong to the display again after a present (spangle/hal/display.hpp). This
// display protects the memory then, so any access would end the program.
#include <gtest/gtest.h>

#include <sys/mman.h>

#include <new>

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/frame.hpp>
#include <spangle/native.hpp>

namespace spangle::test {
namespace {

constexpr std::int32_t width = 16, height = 12;
constexpr EGLBoolean yes = EGL_TRUE;

class PagedDisplay final : public hal::Display {
  public:
    explicit PagedDisplay(std::int32_t band)
        : memory_(static_cast<std::uint8_t*>(
              mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0))),
          band_(band) {}
    ~PagedDisplay() { munmap(memory_, bytes); }
    PagedDisplay(const PagedDisplay&) = delete;
    PagedDisplay& operator=(const PagedDisplay&) = delete;

    hal::DisplayInfo info() const override {
        return {"paged", width, height, PixelFormat::rgb565_be, false, hal::WireFormat::none, band_, 1};
    }
    hal::Result<void> init() override { return {}; }
    hal::Result<hal::Frame> acquire() override { return open(height); }
    hal::Result<void> present() override { return take_back(); }
    hal::Result<hal::Frame> acquire_band(std::int32_t, std::int32_t rows) override {
        (void)take_back();
        if (bands_left == 0)
            return hal::Error{hal::Fault::gone, "paged: no buffer"};
        --bands_left;
        return open(rows);
    }
    hal::Result<void> present_band() override { return take_back(); }

    int bands_left = 1000; ///< number of bands that the display still gives

  private:
    static constexpr std::size_t bytes = 8192;
    struct Inside {
        RowExtents extents;
        RowSpan rows[height];
        std::uint8_t pixels[width * height * 2];
    };

    hal::Result<hal::Frame> open(std::int32_t rows) {
        EXPECT_EQ(mprotect(memory_, bytes, PROT_READ | PROT_WRITE), 0);
        auto* const inside = new (memory_) Inside();
        inside->extents = {inside->rows, rows, false, 0};
        return hal::Frame{inside->pixels, width * 2, 0, &inside->extents};
    }
    hal::Result<void> take_back() {
        EXPECT_EQ(mprotect(memory_, bytes, PROT_NONE), 0);
        return {};
    }

    std::uint8_t* memory_;
    std::int32_t band_;
};

struct Window {
    EGLDisplay display;

    Window(PagedDisplay& panel, EGLint name, EGLint value) : display(eglGetDisplay(native(panel))) {
        EXPECT_EQ(eglInitialize(display, nullptr, nullptr), yes);
        const EGLint wish[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_DEPTH_SIZE, 16, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        EXPECT_EQ(eglChooseConfig(display, wish, &config, 1, &count), yes);
        const EGLint list[] = {name, value, EGL_NONE};
        const EGLSurface window = eglCreateWindowSurface(display, config, 0, list);
        EXPECT_EQ(eglMakeCurrent(display, window, window,
                                 eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr)),
                  yes);
    }
    ~Window() {
        eglReleaseThread();
        eglTerminate(display);
    }
};

/// Reads pixels of the frame or band in memory. If the display has taken all memory back, GL must read none:
/// any access would end the program.
void draw_and_read() {
    GLubyte pixels[width * height * 4];
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glRectf(-1, -1, 1, 1);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
}

TEST(GivenBack, FramesWhoseDepthIsInBands) {
    PagedDisplay panel(0);
    Window window(panel, EGL_BAND_HEIGHT_SPANGLE, 5);
    for (int i = 0; i < 2; ++i) {
        EXPECT_TRUE(frame(window.display, draw_and_read));
        draw_and_read();
    }
}

TEST(GivenBack, Bands) {
    PagedDisplay panel(5);
    Window window(panel, EGL_BAND_HEIGHT_SPANGLE, 5);
    for (int i = 0; i < 2; ++i) {
        EXPECT_TRUE(frame(window.display, draw_and_read));
        draw_and_read();
    }
    panel.bands_left = 1; // the first of three bands
    EXPECT_FALSE(frame(window.display, draw_and_read));
    draw_and_read();
}

TEST(GivenBack, RecordedBands) {
    PagedDisplay panel(5);
    Window window(panel, EGL_BAND_RECORD_SPANGLE, 1 << 16);
    draw_and_read();
    EXPECT_EQ(eglSwapBuffers(window.display, eglGetCurrentSurface(EGL_DRAW)), yes);
    draw_and_read();
    const auto read = [&](int bands) { // the display gives so many bands and refuses the next
        panel.bands_left = bands;
        GLubyte pixel[4];
        for (const GLint y : {0, height - 1, 0})
            glReadPixels(0, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    };
    read(1);
    read(0);
    EXPECT_EQ(eglSwapBuffers(window.display, eglGetCurrentSurface(EGL_DRAW)), EGLBoolean{EGL_FALSE});
    draw_and_read();
    read(1000);
    EXPECT_EQ(eglSwapBuffers(window.display, eglGetCurrentSurface(EGL_DRAW)), yes);
}

} // namespace
} // namespace spangle::test
