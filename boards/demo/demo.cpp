#include "boards/demo/demo.hpp"

#include <initializer_list>

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/frame.hpp>
#include <spangle/native.hpp>

/// A build with a scene profile may hold one tier only; it defines DEMO_PRECISION as that tier.
#ifndef DEMO_PRECISION
#define DEMO_PRECISION EGL_PRECISION_BALANCED_SPANGLE
#endif

namespace spangle::demo {

namespace {

/// A GL context that is current on a window of the display.
struct Window {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLSurface surface = EGL_NO_SURFACE;
    EGLContext context = EGL_NO_CONTEXT;

    /// Returns the first config that meets one of three wishes. Narrow formats are drawn in exact numbers in
    /// every tier, and small builds may have no other precision, or no depth buffer.
    EGLConfig choose_config(bool narrow) const {
        struct ConfigRequest {
            EGLint depth, precision;
        };
        const EGLint usual = narrow ? EGL_PRECISION_EXACT_SPANGLE : DEMO_PRECISION;
        for (const ConfigRequest wish :
             {ConfigRequest{16, usual}, ConfigRequest{16, EGL_PRECISION_EXACT_SPANGLE},
              ConfigRequest{0, EGL_PRECISION_EXACT_SPANGLE}}) {
            const EGLint list[] = {EGL_RENDERABLE_TYPE,   EGL_OPENGL_BIT, EGL_SURFACE_TYPE,
                                   EGL_WINDOW_BIT,        EGL_DEPTH_SIZE, wish.depth,
                                   EGL_PRECISION_SPANGLE, wish.precision, EGL_NONE};
            EGLConfig config = nullptr;
            EGLint count = 0;
            if (eglChooseConfig(display, list, &config, 1, &count) != EGL_FALSE && count != 0)
                return config;
        }
        return nullptr;
    }

    const char* open(hal::Display& native_display) {
        display = eglGetDisplay(native(native_display));
        if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE)
            return "eglInitialize";
        const EGLConfig config = choose_config(is_narrow(native_display.info().format));
        if (config == nullptr)
            return "eglChooseConfig";
        surface = eglCreateWindowSurface(display, config, 0, nullptr);
        if (surface == EGL_NO_SURFACE)
            return "eglCreateWindowSurface";
        context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
        if (context == EGL_NO_CONTEXT)
            return "eglCreateContext";
        if (eglMakeCurrent(display, surface, surface, context) == EGL_FALSE)
            return "eglMakeCurrent";
        return nullptr;
    }

    /// Destroys the context and the window, and with them everything that GL holds.
    void close() const {
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context != EGL_NO_CONTEXT)
            eglDestroyContext(display, context);
        if (surface != EGL_NO_SURFACE)
            eglDestroySurface(display, surface);
    }
};

/// A display that passes every call on, and keeps the address of the buffer that is drawn into.
class FrameTap final : public hal::Display {
  public:
    explicit FrameTap(hal::Display& display) : display_(display), info_(display.info()) {}

    hal::DisplayInfo info() const override { return info_; }
    hal::Result<void> init() override { return display_.init(); }
    hal::Result<hal::Frame> acquire() override { return remember_rows(display_.acquire(), info_.height); }
    hal::Result<void> present() override { return display_.present(); }
    hal::Result<void> finish() override { return display_.finish(); }
    void swap_interval(std::int32_t interval) override { display_.swap_interval(interval); }
    hal::Result<hal::Frame> acquire_band(std::int32_t first, std::int32_t rows) override {
        return remember_rows(display_.acquire_band(first, rows), rows);
    }
    hal::Result<void> present_band() override { return display_.present_band(); }

    const Rows& rows() const { return rows_; }

  private:
    hal::Result<hal::Frame> remember_rows(hal::Result<hal::Frame> frame, std::int32_t height) {
        rows_ = {};
        if (frame.ok())
            rows_ = {frame.value().pixels, frame.value().stride, row_bytes(info_.format, info_.width),
                     stored_rows(info_.format, height)};
        return frame;
    }

    hal::Display& display_;
    hal::DisplayInfo info_;
    Rows rows_;
};

const char* draw(const Window& window, const FrameTap& tap, const scenes::Scene& scene, int frames,
                 Watcher& watcher) {
    const hal::DisplayInfo info = tap.info();
    if (format_info(info.format).bits >= 16) // formats of fewer bits need dithering
        glDisable(GL_DITHER);
    scene.setup(info.width, info.height);
    for (int frame = 0; frame < frames; ++frame) {
        watcher.begin_frame();
        const bool shown = spangle::frame(window.display, [&] {
            watcher.draws();
            scene.draw(frame);
            watcher.drawn(tap.rows());
        });
        if (glGetError() != GL_NO_ERROR)
            return "the scene";
        if (!shown)
            return "spangle::frame";
        watcher.presented();
    }
    return nullptr;
}

} // namespace

const char* play(hal::Display& display, const scenes::Scene& scene, int frames, Watcher& watcher) {
    FrameTap tap(display);
    Window window;
    const char* problem = window.open(tap);
    if (problem == nullptr)
        problem = draw(window, tap, scene, frames, watcher);
    window.close();
    return problem;
}

void PictureHash::add(const Rows& rows) {
    for (std::int32_t y = 0; y < rows.count; ++y) {
        const std::uint8_t* const row = rows.pixels + static_cast<std::ptrdiff_t>(y) * rows.stride;
        for (std::int32_t i = 0; i < rows.row_bytes; ++i)
            value_ = (value_ ^ row[i]) * 16777619u;
    }
}

} // namespace spangle::demo
