#include "host_sim/trade/measure.hpp"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include <spangle/GL/gl.h>
#include <spangle/boards/boards.hpp>
#include <spangle/native.hpp>
#include <spangle/sim/board.hpp>
#include <spangle/tier.hpp>

#include "gl/pixel/fragment_setup.hpp"
#include "host_sim/trade/coverage.hpp"
#include "host_sim/trade/judge.hpp"
#include "host_sim/trade/offscreen.hpp"
#include "host_sim/trade/recording.hpp"

namespace spangle::trade {

namespace {

/// A context whose drawing is counted and watched.
struct MeasuredContext {
    Offscreen screen;
    std::optional<Coverage> coverage;
    raster::Counters counters;
    int coverage_width = 0;

    std::string open(const Program& program, const Setting& s, PixelFormat format, EGLint precision,
                     const raster::Knobs* knobs = nullptr) {
        std::string problem = screen.open(program, s.width, s.height, format, precision, s.dither, knobs);
        if (!problem.empty())
            return problem;
        coverage.emplace(s.width, s.height);
        coverage_width = s.width;
        counters.observer = &*coverage;
        gl::observe(*gl::current_context(), &counters, false);
        return "";
    }
    DrawnFrame draw(const Program& program, int frame) {
        screen.make_current();
        program.draw(frame);
        const FrameCoverage covered = coverage->end_frame();
        DrawnPicture picture = read_picture();
        coarsen(picture);
        return {std::move(picture), covered, upside_down(coverage->take_mask(), coverage_width)};
    }
};

std::string gl_problem(const Program& program) {
    const GLenum error = glGetError();
    return error == GL_NO_ERROR ? "" : fmt::format("{} raised GL error 0x{:04X}", program.name, error);
}

void measure_pictures(const Program& program, const Tier& tier, const Format& format, const Setting& s,
                      Measured& out) {
    MeasuredContext ours, twin;
    out.problem = ours.open(program, s, format.format, tier.precision, own_knobs(tier));
    if (out.problem.empty())
        out.problem = twin.open(program, s, format.format, EGL_PRECISION_DOUBLE_SPANGLE);
    for (int f = 0; f < s.frames && out.problem.empty(); ++f) {
        const DrawnFrame picture = ours.draw(program, f);
        out.problem = gl_problem(program);
        const DrawnFrame reference = twin.draw(program, f);
        judge(picture, reference, out);
        if (f + 1 == s.frames) {
            out.picture = image_of(picture.picture);
            out.reference = image_of(reference.picture);
        }
    }
    out.off_own = ours.coverage ? ours.coverage->mismatches() : 0;
}

/// Measures the whole difference, of tier and format together, against double in eight bits.
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
    judge_plain(out);
}

void measure_stages(const Program& program, const Tier& tier, const Format& format, const Setting& s,
                    Measured& out) {
    Offscreen shadow;
    out.problem =
        shadow.open(program, s.width, s.height, format.format, tier.shadow, s.dither, own_knobs(tier));
    if (!out.problem.empty())
        return;
    const StageReport report;
    for (int f = 0; f < s.frames; ++f)
        program.draw(f);
    out.stages = report.stages();
    if (image_of(read_picture()) != out.picture)
        out.problem = program.name + ": the shadow draws another picture";
}

/// Sends frames to a simulated ILI9341. Of each frame only those parts are sent that differ from what the
/// panel holds.
void measure_bus(const Program& program, const Tier& tier, const Setting& s, Measured& out) {
    sim::SimBoard board(boards::ili9341_spi);
    const EGLDisplay display = eglGetDisplay(native(board.display()));
    const EGLint wish[] = {EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_SURFACE_TYPE,
                           EGL_WINDOW_BIT,
                           EGL_DEPTH_SIZE,
                           16,
                           EGL_STENCIL_SIZE,
                           program.stencil ? 8 : 0,
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
        if (tier.knobs)
            use_tier(*tier.knobs);
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
    if (program.recording != nullptr)
        return measure_recording(program, tier, format, setting);
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
