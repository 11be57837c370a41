// A context on a picture of a chosen format and precision.
#pragma once

#include <string>

#include <spangle/EGL/egl.h>
#include <spangle/format.hpp>
#include <spangle/raster/tier.hpp>
#include <spangle/sim/image.hpp>

#include "host_sim/trade/program.hpp"

namespace spangle::trade {

class Offscreen {
  public:
    Offscreen() = default;
    ~Offscreen();
    Offscreen(const Offscreen&) = delete;
    Offscreen& operator=(const Offscreen&) = delete;

    /// Makes the context, makes it current, and sets the program up. `knobs` are those of a tier that the
    /// user composed, or null. Returns why it cannot be drawn, or an empty string.
    std::string open(const Program& program, int width, int height, PixelFormat format, EGLint precision,
                     bool dither, const raster::Knobs* knobs = nullptr);
    void make_current() const;

  private:
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLSurface surface_ = EGL_NO_SURFACE;
    EGLContext context_ = EGL_NO_CONTEXT;
};

} // namespace spangle::trade
