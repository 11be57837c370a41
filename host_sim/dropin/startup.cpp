// Tells EGL what it needs when the pair is loaded: memory, platforms, and where pictures go.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <sys/mman.h>

#include <spangle/message.hpp>
#include <spangle/native.hpp>
#include <spangle/reference.hpp>

#include "gl/egl/platforms.hpp"
#include "gl/pixel/fragment_setup.hpp"
#include "host_sim/dropin/capture.hpp"
#include "host_sim/dropin/glx_drawables.hpp"
#include "host_sim/dropin/options.hpp"
#include "host_sim/dropin/recording.hpp"
#include "host_sim/dropin/stage.hpp"
#include "host_sim/dropin/x_windows.hpp"

namespace spangle::dropin {

namespace {

/// Gives EGL its memory, whose pages are taken from the machine only when something is stored there.
void give_memory() {
    void* const begin = mmap(nullptr, options().memory, PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (begin != MAP_FAILED)
        memory(begin, options().memory);
}

/// Whether EGL_DEFAULT_DISPLAY means X. EGL_PLATFORM says so, as with Mesa; without it X is meant if DISPLAY
/// names a server.
bool default_is_x11() {
    const char* const platform = std::getenv("EGL_PLATFORM");
    if (platform != nullptr && *platform != '\0')
        return std::strcmp(platform, "x11") == 0;
    return std::getenv("DISPLAY") != nullptr;
}

egl::NativeDisplay find(EGLenum platform, void* native) {
    const bool x11 = platform == EGL_PLATFORM_X11_KHR || native != EGL_DEFAULT_DISPLAY || default_is_x11();
    if (platform != EGL_PLATFORM_X11_KHR && platform != EGL_NONE)
        return {};
    if (!x11)
        return {true, nullptr, nullptr};
    hal::WindowSystem* const windows = XWindows::of(static_cast<_XDisplay*>(native));
    return {windows != nullptr, nullptr, windows};
}

void swapped(const hal::Frame& picture, const hal::DisplayInfo& info) {
    if (Capture::get() == nullptr) // a capture counts frames in another way
        Stage::get().show(picture, info);
}

void created(gl::Context& context) {
    if (!options().report.empty())
        gl::observe(context, Stage::get().counters(), false);
    record(context);
    if (Capture* const capture = Capture::get())
        capture->watch(context);
}

void planes(const raster::Surface& picture) {
    if (Capture* const capture = Capture::get())
        capture->take(picture);
}

void say(unsigned code, const char* text) {
    std::fprintf(stderr, "spangle: 0x%04X %s\n", code, text);
}

[[gnu::constructor]] void start() {
    give_memory();
    if (options().messages)
        on_message(say);
    if (options().precision >= EGL_PRECISION_DOUBLE_SPANGLE)
        use_reference_engines();
    egl::Platforms platforms;
    platforms.extensions = " EGL_EXT_platform_x11 EGL_KHR_platform_x11";
    platforms.find = find;
    platforms.renderable = EGL_OPENGL_ES_BIT;
    platforms.precision = options().precision;
    platforms.swapped = swapped;
    platforms.created = created;
    if (!options().capture.empty())
        platforms.planes = planes;
    static egl::DrawnFormat drawn;
    if (options().capture_format) {
        drawn = {*options().capture_format, options().precision};
        platforms.drawn = &drawn;
    }
    egl::use_platforms(platforms);
    XWindows::on_close(glx::forget_connection);
}

[[gnu::destructor]] void end() {
    Stage::finish_if_any();
    Capture::finish_if_any();
}

} // namespace

} // namespace spangle::dropin
