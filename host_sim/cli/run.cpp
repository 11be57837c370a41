#include "host_sim/cli/run.hpp"

#include <algorithm>
#include <unistd.h>

#include <memory>

#include <fmt/format.h>

#include <spangle/GL/gl.h>
#include <spangle/native.hpp>
#include <spangle/reference.hpp>
#include <spangle/sim/board.hpp>
#include <spangle/tier.hpp>

#include "boards/scenes/scene.hpp"
#include "host_sim/capture/names.hpp"
#include "host_sim/cli/process_memory.hpp"
#include "host_sim/cli/program.hpp"
#include "host_sim/cli/say.hpp"
#include "host_sim/cli/screen.hpp"
#include "host_sim/cli/session.hpp"
#include "host_sim/cli/window.hpp"
#include "host_sim/trade/coverage.hpp"
#include "raster/reference/shadow.hpp"

namespace spangle::cli {

using trade::count_differences;
using trade::Coverage;
using trade::FrameCoverage;

namespace {

bool is_shadow(Precision p) {
    return p >= Precision::shadow;
}

/// Draws the same frames in double, and compares them with those of the run.
class Comparison {
  public:
    std::string open(const Session& ours, const Program& program, bool dither) {
        use_reference_engines();
        const std::string problem =
            reference_.open_picture(ours.width(), ours.height(), Precision::reference);
        if (!problem.empty())
            return "--compare: " + problem;
        coverage_ = std::make_unique<Coverage>(ours.width(), ours.height());
        start(program, reference_, dither);
        counters_.observer = coverage_.get();
        reference_.observe(&counters_);
        return "";
    }

    void frame(const Program& program, int f, const sim::Image& ours, const FrameCoverage& covered) {
        reference_.make_current();
        program.draw(f);
        const FrameCoverage ideal = coverage_->end_frame();
        unsnapped_pixels_ += count_differences(covered.snapped, ideal.exact);
        snapping_pixels_ += count_differences(ideal.snapped, ideal.exact);
        const sim::Image theirs = reference_.read();
        const std::vector<bool> mask = coverage_->take_mask();
        const sim::Difference d = sim::compare_565(ours, theirs, &mask);
        difference_.pixels += d.pixels;
        difference_.identical += d.identical;
        difference_.max_lsb = std::max(difference_.max_lsb, d.max_lsb);
        worst_psnr_ = std::min(worst_psnr_, d.psnr_db);
        picture_ = sim::difference_picture(ours, theirs);
    }

    void finish(Report& report, const Coverage& ours) const {
        report.compared = true;
        report.identical_565_percent = difference_.identical_percent();
        report.max_lsb = difference_.max_lsb;
        report.psnr_565_db = worst_psnr_;
        report.coverage_mismatches = ours.mismatches();
        report.coverage_unsnapped = unsnapped_pixels_;
        report.coverage_snapping = snapping_pixels_;
        report.covered = difference_.pixels;
    }
    const sim::Image& picture() const { return picture_; }

  private:
    Session reference_;
    std::unique_ptr<Coverage> coverage_;
    raster::Counters counters_;
    sim::Difference difference_;
    double worst_psnr_ = 99.0;
    std::uint64_t unsnapped_pixels_ = 0, snapping_pixels_ = 0;
    sim::Image picture_;
};

/// Collects the reports of draws in shadow precision, while this object exists.
class ShadowSession {
  public:
    explicit ShadowSession(bool wanted)
        : is_wanted_(wanted), previous_report_(raster::report_shadow(wanted ? &report_ : nullptr)) {}
    ~ShadowSession() { raster::report_shadow(previous_report_); }
    ShadowSession(const ShadowSession&) = delete;
    ShadowSession& operator=(const ShadowSession&) = delete;

    void finish(Report& report) const {
        for (int i = 0; is_wanted_ && i < raster::shadow_stages; ++i) {
            const raster::ShadowRecord& r = report_.stage[i];
            const auto stage = static_cast<raster::ShadowStage>(i);
            if (r.count != 0)
                report.stages.push_back({raster::name_of(stage), raster::unit_of(stage), r.count, r.worst,
                                         r.rms(), r.least, r.greatest, r.saturated});
        }
    }

  private:
    bool is_wanted_;
    raster::ShadowReport report_;
    raster::ShadowReport* previous_report_;
};

/// Shows progress in a line that is rewritten, on terminals and for long runs only.
void print_progress(int frame, int frames) {
    if (frames < 30 || isatty(STDERR_FILENO) == 0)
        return;
    tell(fmt::format("\rframe {} of {}{}", frame + 1, frames, frame + 1 == frames ? "\r\033[K" : ""));
}

/// Counts the triangles that reach a pixel, over frames that were drawn in bands. Each band counts the
/// triangles that reach the band, so that a triangle counts several times in a frame. The frames are
/// therefore drawn once more as wholes.
std::string count_whole(const RunOptions& options, const Program& program, int width, int height,
                        Report& report) {
    Session session;
    if (std::string problem = session.open_picture(width, height, options.precision); !problem.empty())
        return "to count triangles: " + problem;
    start(program, session, options.dither);
    raster::Counters counters;
    session.observe(&counters);
    report.triangles = 0;
    for (int f = 0; f < report.frames; ++f) {
        counters.triangles = 0;
        program.draw(f);
        report.triangles += counters.triangles;
    }
    return "";
}

/// Ends the dump of the wires, if there is one, and notes what became of it.
void end_vcd(const RunOptions& options, sim::SimBoard& board, RunResult& result) {
    const sim::SimBoard::Recorded dump = board.end_vcd();
    result.unwritten = dump.error;
    if (dump.full && dump.error.empty())
        result.notes +=
            fmt::format("{}: stopped at {:.6f} ms, for the file has reached its limit; --vcd-limit "
                        "sets another\n",
                        options.vcd, static_cast<double>(dump.end) * 1e-6);
}

} // namespace

RunResult run(const RunOptions& options) {
    RunResult result;
    Model model;
    Program program;
    result.error = make_program(options, model, program);
    if (!result.error.empty())
        return result;
    for (const std::string& note : model.notes)
        result.notes += note + "\n";

    if (options.precision == Precision::reference || is_shadow(options.precision))
        use_reference_engines();
    Screen screen;
    Session session;
    result.error = screen.open(options, session);
    if (!result.error.empty())
        return result;
    if (options.knobs && !use_tier(*options.knobs))
        result.error = "this build has no tiers of your own: it lacks one of the three";
    if (!result.error.empty())
        return result;
    sim::SimBoard* const board = screen.simulated();
    if (!options.vcd.empty())
        result.error = board == nullptr ? "--vcd records a simulated board's wires; leave out " +
                                              std::string(screen.presents() ? "the real bus" : "--size")
                                        : board->record_vcd(options.vcd, options.vcd_limit);
    if (!result.error.empty())
        return result;
    start(program, session, options.dither);

    raster::Counters counters;
    Coverage coverage(session.width(), session.height());
    if (options.compare)
        counters.observer = &coverage;
    session.observe(&counters);
    const ShadowSession shadow(is_shadow(options.precision));
    Comparison comparison;
    if (options.compare) {
        result.error = comparison.open(session, program, options.dither);
        if (!result.error.empty())
            return result;
        session.make_current();
    }
    Window window;
    if (options.window)
        window.open(program.name, session.width(), session.height());

    const auto show = [&] {
        window.show(board != nullptr ? board->glass() : session.read(),
                    board != nullptr ? board->memory() : sim::Image(),
                    board != nullptr ? board->counters() : sim::BoardCounters{});
    };

    screen.start();
    Report& report = result.report;
    for (int f = 0; f < options.frames && !window.is_closed(); ++f) {
        counters.triangles = counters.fragments = 0;
        const bool read = f + 1 == options.frames || options.compare;
        int calls = 0;
        const auto draw = [&] {
            program.draw(f);
            if (read)
                session.read(result.picture);
            if (board != nullptr && calls++ == 0)
                board->pass(static_cast<sim::Time>(options.present.draw_ms) * 1'000'000);
        };
        if (!screen.presents())
            draw();
        else if (!session.frame(draw)) {
            result.error = session.error();
            return result;
        }
        const FrameCoverage covered = coverage.end_frame();
        report.triangles += counters.triangles;
        report.fragments += counters.fragments;
        if (options.compare) {
            comparison.frame(program, f, result.picture, covered);
            session.make_current();
        }
        if (window.is_open())
            show();
        print_progress(f, options.frames);
        ++report.frames;
    }
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
        result.error =
            fmt::format("{} raised GL error 0x{:04X}{}{}", program.name, error,
                        Session::last_error_text().empty() ? "" : ": ", Session::last_error_text());
        return result;
    }

    report.scene = program.name;
    report.precision = names::name_of(names::precisions, static_cast<EGLint>(options.precision));
    report.picture_hash = sim::hash(result.picture);
    result.error = screen.finish();
    screen.describe(options, session, report);
    if (board != nullptr) {
        result.picture = board->glass();
        result.violations = board->violations_text();
        end_vcd(options, *board, result);
    }
    shadow.finish(report);
    if (options.stats)
        report.memory = {session.context_bytes(), session.surface_bytes(), memory_use().peak, process_peak()};
    if (options.compare) {
        comparison.finish(report, coverage);
        result.difference = comparison.picture();
    }
    if (options.bands.height != 0 && result.error.empty())
        result.error = count_whole(options, program, session.width(), session.height(), report);

    // The requested frames are reported. The scene now goes on while the window is open.
    session.make_current();
    session.observe(nullptr);
    for (int f = report.frames; result.error.empty() && window.can_be_closed() && !window.is_closed(); ++f) {
        if (!screen.presents())
            program.draw(f);
        else if (!session.frame([&] { program.draw(f); }))
            result.error = session.error();
        show();
    }
    return result;
}

} // namespace spangle::cli
