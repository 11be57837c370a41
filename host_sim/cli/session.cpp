#include "host_sim/cli/session.hpp"

#include <algorithm>
#include <cstdio>

#include <spangle/GL/gl.h>
#include <spangle/frame.hpp>
#include <spangle/message.hpp>
#include <spangle/native.hpp>

#include "gl/pixel/fragment_setup.hpp"

namespace spangle::cli {

namespace {

/// The first and the last message of the library, for the messages about errors.
std::string& first_message() {
    static std::string text;
    return text;
}
std::string& last_message() {
    static std::string text;
    return text;
}

void listen() {
    first_message().clear();
    on_message([](unsigned, const char* text) {
        last_message() = text;
        if (first_message().empty())
            first_message() = text;
    });
}

std::string egl_problem(const char* call) {
    char code[16];
    std::snprintf(code, sizeof code, "0x%04X", static_cast<unsigned>(eglGetError()));
    // The message begins with the command, which need not be named twice.
    const std::string named = std::string(call) + ": ", &told = last_message();
    const std::string rule = told.starts_with(named) ? told.substr(named.size()) : told;
    return std::string(call) + " failed (" + code + ")" + (rule.empty() ? "" : ": " + rule);
}

} // namespace

Session::~Session() {
    if (display_ == EGL_NO_DISPLAY)
        return;
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT)
        eglDestroyContext(display_, context_);
    if (surface_ != EGL_NO_SURFACE)
        eglDestroySurface(display_, surface_);
    // The display of a board ends with its board, and another board may come to lie at its address. Sessions
    // without a board share the default display.
    if (has_board_)
        eglTerminate(display_);
}

EGLConfig Session::choose_config(Precision precision, bool window) const {
    const EGLint wish[] = {EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_SURFACE_TYPE,
                           window ? EGL_WINDOW_BIT : EGL_PBUFFER_BIT,
                           EGL_DEPTH_SIZE,
                           16,
                           EGL_PRECISION_SPANGLE,
                           static_cast<EGLint>(precision),
                           EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglChooseConfig(display_, wish, &config, 1, &count);
    return count > 0 ? config : nullptr;
}

std::string Session::open(EGLConfig config, const EGLint* window, const EGLint* picture) {
    if (config == nullptr)
        return "this build has no such precision";
    const std::size_t before = memory_use().used;
    surface_ = picture == nullptr ? eglCreateWindowSurface(display_, config, 0, window)
                                  : eglCreatePbufferSurface(display_, config, picture);
    if (surface_ == EGL_NO_SURFACE)
        return egl_problem(picture == nullptr ? "eglCreateWindowSurface" : "eglCreatePbufferSurface");
    surface_bytes_ = memory_use().used - before;
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, nullptr);
    if (context_ == EGL_NO_CONTEXT)
        return egl_problem("eglCreateContext");
    context_bytes_ = memory_use().used - before - surface_bytes_;
    if (!make_current())
        return egl_problem("eglMakeCurrent");
    eglQuerySurface(display_, surface_, EGL_WIDTH, &width_);
    eglQuerySurface(display_, surface_, EGL_HEIGHT, &height_);
    return "";
}

std::string Session::open_display(hal::Display& display, Precision precision, const BandOptions& bands) {
    listen();
    display_ = eglGetDisplay(native(display));
    has_board_ = true;
    if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr))
        return egl_problem("eglInitialize");
    const EGLint window[] = {EGL_BAND_HEIGHT_SPANGLE, bands.height, EGL_BAND_RECORD_SPANGLE,
                             bands.record ? bands.record_bytes : 0, EGL_NONE};
    return open(choose_config(precision, true), bands.height != 0 ? window : nullptr, nullptr);
}

std::string Session::open_picture(int width, int height, Precision precision) {
    listen();
    display_ = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (display_ == EGL_NO_DISPLAY)
        return "this build has no display beside the board's (SPANGLE_DISPLAYS); --size draws without a "
               "board";
    if (!eglInitialize(display_, nullptr, nullptr))
        return egl_problem("eglInitialize");
    const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    return open(choose_config(precision, false), nullptr, size);
}

const std::string& Session::last_error_text() {
    return first_message();
}

bool Session::make_current() const {
    return eglMakeCurrent(display_, surface_, surface_, context_) != EGL_FALSE;
}

bool Session::frame(const std::function<void()>& draw) {
    if (spangle::frame(display_, draw))
        return true;
    error_ = egl_problem("spangle::frame");
    return false;
}

void Session::read(sim::Image& image) const {
    if (image.width != width_ || image.height != height_)
        image = sim::Image(width_, height_);
    const std::size_t row = static_cast<std::size_t>(width_) * 4;
    for (int y = 0; y < height_; ++y)
        glReadPixels(0, height_ - 1 - y, width_, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                     image.rgba.data() + row * static_cast<std::size_t>(y));
}

sim::Image Session::read() const {
    sim::Image image(width_, height_);
    read(image);
    return image;
}

std::size_t Session::record_peak() const {
    EGLint bytes = 0;
    eglQuerySurface(display_, surface_, EGL_BAND_RECORD_PEAK_SPANGLE, &bytes);
    return static_cast<std::size_t>(bytes);
}

void Session::observe(raster::Counters* counters) {
    gl::observe(*gl::current_context(), counters, false);
}

} // namespace spangle::cli
