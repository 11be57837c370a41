#include "host_sim/trade/measure.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include <spangle/GL/gl.h>
#include <spangle/boards/boards.hpp>
#include <spangle/native.hpp>
#include <spangle/sim/board.hpp>

#include "gl/pixel/fragment_setup.hpp"
#include "host_sim/trade/coverage.hpp"
#include "host_sim/trade/offscreen.hpp"
#include "host_sim/trade/perceived.hpp"

namespace spangle::trade {

namespace {

sim::Image image_of(const DrawnPicture& drawn) {
    sim::Image out(drawn.width, drawn.height);
    const std::size_t row = 4 * static_cast<std::size_t>(drawn.width);
    for (int y = 0; y < drawn.height; ++y)
        std::copy_n(drawn.rgba.begin() + static_cast<std::ptrdiff_t>(row) * (drawn.height - 1 - y), row,
                    out.rgba.begin() + static_cast<std::ptrdiff_t>(row) * y);
    for (std::size_t i = 3; i < out.rgba.size(); i += 4)
        out.rgba[i] = 255; // alpha is no part of what is seen
    return out;
}

/// A mask from the bottom row on.
std::vector<bool> upside_down(const std::vector<bool>& mask, int width) {
    std::vector<bool> out;
    out.reserve(mask.size());
    for (std::size_t row = mask.size(); row != 0; row -= static_cast<std::size_t>(width))
        for (std::size_t x = row - static_cast<std::size_t>(width); x < row; ++x)
            out.push_back(mask[x]);
    return out;
}

/// A context that is drawn with and watched.
struct Watched {
    Offscreen screen;
    std::optional<Coverage> coverage;
    raster::Counters counters;

    std::string open(const Program& program, const Setting& s, PixelFormat format, EGLint precision) {
        std::string problem = screen.open(program, s.width, s.height, format, precision, s.dither);
        if (!problem.empty())
            return problem;
        coverage.emplace(s.width, s.height);
        counters.observer = &*coverage;
        gl::observe(*gl::current_context(), &counters, false);
        return "";
    }
    DrawnPicture draw(const Program& program, int frame) const {
        screen.make_current();
        program.draw(frame);
        return read_picture();
    }
};

std::string gl_problem(const Program& program) {
    const GLenum error = glGetError();
    return error == GL_NO_ERROR ? "" : fmt::format("{} raised GL error 0x{:04X}", program.name, error);
}

void measure_pictures(const Program& program, const Tier& tier, const Format& format, const Setting& s,
                      Measured& out) {
    Watched ours, twin;
    out.problem = ours.open(program, s, format.format, tier.precision);
    if (out.problem.empty())
        out.problem = twin.open(program, s, format.format, EGL_PRECISION_DOUBLE_SPANGLE);
    for (int f = 0; f < s.frames && out.problem.empty(); ++f) {
        const DrawnPicture picture = ours.draw(program, f);
        const FrameCoverage covered = ours.coverage->end_frame();
        out.problem = gl_problem(program);
        const DrawnPicture reference = twin.draw(program, f);
        const FrameCoverage ideal = twin.coverage->end_frame();
        out.off_unsnapped += differences(covered.snapped, ideal.exact);
        out.off_ideal += differences(ideal.snapped, ideal.exact);
        const std::vector<bool> mask = upside_down(twin.coverage->take_mask(), s.width);
        out.error.add(compare(picture, reference, &mask));
        if (f + 1 == s.frames) {
            out.picture = image_of(picture);
            out.reference = image_of(reference);
        }
    }
    out.off_own = ours.coverage ? ours.coverage->mismatches() : 0;
}

/// What the format costs, too: against double in eight bits, which nothing rounds further.
void measure_against_plain(const Program& program, const Setting& s, Measured& out) {
    Offscreen plain;
    Setting undithered = s;
    undithered.dither = false;
    out.problem = plain.open(program, s.width, s.height, PixelFormat::rgba8888, EGL_PRECISION_DOUBLE_SPANGLE,
                             undithered.dither);
    if (!out.problem.empty())
        return;
    program.draw(s.frames - 1);
    out.plain = image_of(read_picture());
    double squares = 0;
    for (std::size_t i = 0; i < out.plain.rgba.size(); ++i) {
        const double d = out.plain.rgba[i] - out.picture.rgba[i];
        squares += d * d;
    }
    const double values = 3.0 * static_cast<double>(out.plain.rgba.size()) / 4;
    out.psnr_to_888 = squares > 0 ? 10 * std::log10(255.0 * 255.0 * values / squares) : PictureError::alike;
    out.perceived = perceived_difference(out.picture, out.plain);
}

void measure_stages(const Program& program, const Tier& tier, const Format& format, const Setting& s,
                    Measured& out) {
    Offscreen shadow;
    out.problem = shadow.open(program, s.width, s.height, format.format, tier.shadow, s.dither);
    if (!out.problem.empty())
        return;
    const StageReport report;
    for (int f = 0; f < s.frames; ++f)
        program.draw(f);
    out.stages = report.stages();
    if (image_of(read_picture()) != out.picture)
        out.problem = program.name + ": the shadow draws another picture";
}

/// Frames on a simulated ILI9341, each sent as far as it differs from what the panel holds.
void measure_bus(const Program& program, const Tier& tier, const Setting& s, Measured& out) {
    sim::SimBoard board(boards::ili9341_spi);
    const EGLDisplay display = eglGetDisplay(native(board.display()));
    const EGLint wish[] = {EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_SURFACE_TYPE,
                           EGL_WINDOW_BIT,
                           EGL_DEPTH_SIZE,
                           16,
                           EGL_SAMPLES,
                           0,
                           EGL_PRECISION_SPANGLE,
                           tier.precision,
                           EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglInitialize(display, nullptr, nullptr) || !eglChooseConfig(display, wish, &config, 1, &count) ||
        count == 0)
        return;
    const EGLSurface window = eglCreateWindowSurface(display, config, 0, nullptr);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    if (eglMakeCurrent(display, window, window, context)) {
        program.setup(s.width, s.height);
        (s.dither ? glEnable : glDisable)(GL_DITHER);
        std::uint64_t first = 0;
        for (int f = 0; f < s.frames; ++f) {
            program.draw(f);
            eglSwapBuffers(display, window);
            if (f == 0)
                first = board.counters().bytes;
        }
        if (s.frames > 1)
            out.bus_bytes = (board.counters().bytes - first) / static_cast<std::uint64_t>(s.frames - 1);
    }
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglTerminate(display);
}

} // namespace

Measured measure(const Program& program, const Tier& tier, const Format& format, const Setting& setting) {
    use_reference_engines();
    Measured out;
    measure_pictures(program, tier, format, setting, out);
    if (out.problem.empty())
        measure_against_plain(program, setting, out);
    if (out.problem.empty())
        measure_stages(program, tier, format, setting, out);
    out.frame_bytes = static_cast<std::uint64_t>(row_bytes(format.format, setting.width)) *
                      static_cast<std::uint64_t>(stored_rows(format.format, setting.height));
    if (out.problem.empty() && format.format == PixelFormat::rgb565_be && setting.width == 320 &&
        setting.height == 240)
        measure_bus(program, tier, setting, out);
    return out;
}

} // namespace spangle::trade
