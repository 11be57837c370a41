#include "host_sim/trade/offscreen.hpp"

#include <fmt/format.h>

#include <spangle/GL/gl.h>
#include <spangle/tier.hpp>

namespace spangle::trade {

namespace {

/// Returns the first config of that kind with a depth buffer, or null. The low byte of a pbuffer's visual
/// tells the layout of its pixels.
EGLConfig choose(EGLDisplay display, PixelFormat format, EGLint precision, bool stencil) {
    const EGLint wish[] = {EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_SURFACE_TYPE,
                           EGL_PBUFFER_BIT,
                           EGL_DEPTH_SIZE,
                           16,
                           EGL_STENCIL_SIZE,
                           stencil ? 8 : 0,
                           EGL_SAMPLES,
                           0,
                           EGL_PRECISION_SPANGLE,
                           precision,
                           EGL_NONE};
    constexpr EGLint most = 256;
    EGLConfig configs[most];
    EGLint count = 0;
    eglChooseConfig(display, wish, configs, most, &count);
    for (EGLint i = 0; i < count; ++i) {
        EGLint visual = -1, samples = 0;
        eglGetConfigAttrib(display, configs[i], EGL_NATIVE_VISUAL_ID, &visual);
        eglGetConfigAttrib(display, configs[i], EGL_SAMPLES, &samples);
        if ((visual & 0xFF) == static_cast<EGLint>(format) && samples == 0)
            return configs[i];
    }
    return nullptr;
}

} // namespace

Offscreen::~Offscreen() {
    if (display_ == EGL_NO_DISPLAY)
        return;
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT)
        eglDestroyContext(display_, context_);
    if (surface_ != EGL_NO_SURFACE)
        eglDestroySurface(display_, surface_);
}

std::string Offscreen::open(const Program& program, int width, int height, PixelFormat format,
                            EGLint precision, bool dither, const raster::Knobs* knobs) {
    display_ = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr))
        return "this build has no display of its own";
    const EGLConfig config = choose(display_, format, precision, program.stencil);
    if (config == nullptr)
        return "this build has no such format, or no such precision";
    const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    surface_ = eglCreatePbufferSurface(display_, config, size);
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, nullptr);
    if (!eglMakeCurrent(display_, surface_, surface_, context_))
        return fmt::format("EGL refuses a picture of {}x{} (error 0x{:04X})", width, height,
                           static_cast<unsigned>(eglGetError()));
    if (knobs != nullptr && !use_tier(*knobs))
        return "this build has no tiers of your own: it lacks one of the three";
    // A program that draws without these buffers, or without clearing them, would leave what was there
    // before.
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    program.setup(width, height);
    (dither ? glEnable : glDisable)(GL_DITHER);
    return "";
}

void Offscreen::make_current() const {
    eglMakeCurrent(display_, surface_, surface_, context_);
}

} // namespace spangle::trade
