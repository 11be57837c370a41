// An EGL session of the command line: one context on a display's window or on an off-screen picture.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include <spangle/EGL/egl.h>
#include <spangle/hal/display.hpp>
#include <spangle/sim/image.hpp>

#include "host_sim/cli/options.hpp"
#include "raster/span/draw_state.hpp"

namespace spangle::cli {

class Session {
  public:
    Session() = default;
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// Opens a session. Returns why that failed, or an empty string.
    std::string open_display(hal::Display& display, Precision precision, const BandOptions& bands = {});
    std::string open_picture(int width, int height, Precision precision);

    bool make_current() const;
    /// Draws a frame and presents it, calling draw() once for each band. Returns false when that failed;
    /// error() says why.
    bool frame(const std::function<void()>& draw);
    const std::string& error() const { return error_; }
    /// The first message of the library since a session was opened; empty if there is none.
    static const std::string& last_error_text();
    int width() const { return width_; }
    int height() const { return height_; }
    /// Bytes of Spangle's memory (spangle::memory) that the surface and the context took.
    std::size_t surface_bytes() const { return surface_bytes_; }
    std::size_t context_bytes() const { return context_bytes_; }

    /// Reads the drawing buffer. When frames are drawn in bands, other rows of `image` stay as they are.
    void read(sim::Image& image) const;
    sim::Image read() const;
    /// The most bytes of the record that a frame took.
    std::size_t record_peak() const;
    /// Makes the counters count what is drawn from here on.
    void observe(raster::Counters* counters);

  private:
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLSurface surface_ = EGL_NO_SURFACE;
    EGLContext context_ = EGL_NO_CONTEXT;
    bool has_board_ = false; ///< the display is that of a board
    int width_ = 0, height_ = 0;
    std::size_t surface_bytes_ = 0, context_bytes_ = 0;
    std::string error_;

    std::string open(EGLConfig config, const EGLint* window, const EGLint* picture);
    EGLConfig choose_config(Precision precision, bool window) const;
};

} // namespace spangle::cli
