#include "host_sim/cli/run.hpp"

#include <algorithm>
#include <unistd.h>

#include <memory>

#include <fmt/format.h>

#include <spangle/GL/gl.h>
#include <spangle/native.hpp>
#include <spangle/sim/board.hpp>

#include "boards/scenes/scene.hpp"
#include "gl/egl/reference.hpp"
#include "host_sim/bringup/attach.hpp"
#include "host_sim/cli/coverage.hpp"
#include "host_sim/cli/model.hpp"
#include "host_sim/cli/process_memory.hpp"
#include "host_sim/cli/session.hpp"
#include "host_sim/cli/window.hpp"
#include "raster/span/shadow.hpp"
#include <spangle/boards/boards.hpp>

namespace spangle::cli {

namespace {

/// What is drawn, scene or model.
struct Program {
    std::string name;
    std::function<void(int, int)> setup;
    std::function<void(int)> draw;
};

const char* name_of(Precision p) {
    constexpr const char* names[] = {"exact",  "balanced",        "fast",       "double",
                                     "shadow", "shadow-balanced", "shadow-fast"};
    return names[static_cast<unsigned>(p)];
}

bool is_shadow(Precision p) {
    return p >= Precision::shadow;
}

std::string make_program(const RunOptions& options, Model& model, Program& out) {
    if (options.model.empty()) {
        const scenes::Scene* const scene = scenes::find(options.scene.c_str());
        if (scene == nullptr)
            return "no scene '" + options.scene + "'; `spangle scenes` lists them";
        out = {scene->id, scene->setup, scene->draw};
        return "";
    }
    ModelResult loaded = load_model(options.model);
    if (!loaded.error.empty())
        return loaded.error;
    model = std::move(loaded.model);
    out = {model.name, [&model](int w, int h) { setup_model(model, w, h); },
           [&model](int f) { draw_model(model, f); }};
    return "";
}

/// The board with other ways to present, or the rule that this breaks.
std::string present_as(const PresentOptions& options, hal::Board& board) {
    hal::PanelConfig& display = board.display;
    display.row_hash = options.row_hash || display.row_hash;
    if (options.tear_free == "te")
        display.wait_te = board.has_te = true;
    if (options.tear_free == "poll")
        display.poll_line = true;
    if (options.pacing != "block") {
        display.pacing = options.pacing == "drop" ? hal::Pacing::drop : hal::Pacing::coalesce;
        display.buffers = display.wire.converts() ? 1 : 2;
    }
    if (options.buffers != 0)
        display.buffers = static_cast<std::uint8_t>(options.buffers);
    const bool against_the_scan = hal::scan_order(*display.panel, display.orientation).turns();
    if (options.tear_free != "off" && against_the_scan && !display.wire.converts() && options.buffers != 1) {
        display.scan_order = true;
        display.buffers = 2;
    }
    const char* const rule = hal::flaw(board);
    return rule == nullptr ? "" : std::string(board.name) + ": " + rule;
}

void start(const Program& program, const Session& session, bool dither) {
    program.setup(session.width(), session.height());
    if (dither)
        glEnable(GL_DITHER);
    else
        glDisable(GL_DITHER);
}

/// The same frames in double, held against ours.
class Comparison {
  public:
    std::string open(const Session& ours, const Program& program, bool dither) {
        egl::use_reference_engines();
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
        unsnapped_ += differences(covered.snapped, ideal.exact);
        snapping_ += differences(ideal.snapped, ideal.exact);
        const sim::Image theirs = reference_.read();
        const std::vector<bool> mask = coverage_->take_mask();
        const sim::Difference d = sim::compare_565(ours, theirs, &mask);
        total_.pixels += d.pixels;
        total_.identical += d.identical;
        total_.max_lsb = std::max(total_.max_lsb, d.max_lsb);
        worst_psnr_ = std::min(worst_psnr_, d.psnr_db);
        picture_ = sim::difference_picture(ours, theirs);
    }

    void finish(Report& report, const Coverage& ours) const {
        report.compared = true;
        report.identical_565_percent = total_.identical_percent();
        report.max_lsb = total_.max_lsb;
        report.psnr_565_db = worst_psnr_;
        report.coverage_mismatches = ours.mismatches();
        report.coverage_unsnapped = unsnapped_;
        report.coverage_snapping = snapping_;
        report.covered = total_.pixels;
    }
    const sim::Image& picture() const { return picture_; }

  private:
    Session reference_;
    std::unique_ptr<Coverage> coverage_;
    raster::Counters counters_;
    sim::Difference total_;
    double worst_psnr_ = 99.0;
    std::uint64_t unsnapped_ = 0, snapping_ = 0;
    sim::Image picture_;
};

/// Collects what shadow draws report while it exists.
class ShadowSession {
  public:
    explicit ShadowSession(bool wanted)
        : wanted_(wanted), old_(raster::report_shadow(wanted ? &report_ : nullptr)) {}
    ~ShadowSession() { raster::report_shadow(old_); }
    ShadowSession(const ShadowSession&) = delete;
    ShadowSession& operator=(const ShadowSession&) = delete;

    void finish(Report& report) const {
        for (int i = 0; wanted_ && i < raster::shadow_stages; ++i) {
            const raster::ShadowRecord& r = report_.stage[i];
            const auto stage = static_cast<raster::ShadowStage>(i);
            if (r.count != 0)
                report.stages.push_back({raster::name_of(stage), raster::unit_of(stage), r.count, r.worst,
                                         r.rms(), r.least, r.greatest, r.saturated});
        }
    }

  private:
    bool wanted_;
    raster::ShadowReport report_;
    raster::ShadowReport* old_;
};

/// A line that is rewritten, on terminals and for runs that take a while.
void progress(int frame, int frames) {
    if (frames < 30 || isatty(STDERR_FILENO) == 0)
        return;
    fmt::print(stderr, "\rframe {} of {}{}", frame + 1, frames, frame + 1 == frames ? "\r\033[K" : "");
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

    const bool on_board = options.width == 0;
    const hal::Board* const description = on_board ? bringup::find_board(options.board) : nullptr;
    if (on_board && description == nullptr) {
        result.error = "no board '" + options.board + "'; `spangle boards` lists them";
        return result;
    }
    if (options.precision == Precision::reference || is_shadow(options.precision))
        egl::use_reference_engines();
    hal::Board built = on_board ? *description : hal::Board{};
    built.display.band = options.bands.height;
    if (on_board)
        result.error = present_as(options.present, built);
    if (!result.error.empty())
        return result;
    std::unique_ptr<sim::SimBoard> board = on_board ? std::make_unique<sim::SimBoard>(built) : nullptr;
    Session session;
    result.error = on_board ? session.open_board(*board, options.precision, options.bands)
                            : session.open_picture(options.width, options.height, options.precision);
    if (!result.error.empty())
        return result;
    if (!options.vcd.empty() && (board == nullptr || !board->record_vcd(options.vcd))) {
        result.error = board == nullptr ? "--vcd records a board's wires; leave out --size"
                                        : "cannot write '" + options.vcd + "'";
        return result;
    }
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

    const sim::BoardCounters before = on_board ? board->counters() : sim::BoardCounters{};
    const sim::Time started = on_board ? board->now() : 0;
    Report& report = result.report;
    std::string last_hash;
    for (int f = 0; f < options.frames && !window.closed(); ++f) {
        counters.triangles = counters.fragments = 0;
        const bool read = f + 1 == options.frames || options.compare;
        int calls = 0;
        const auto draw = [&] {
            program.draw(f);
            if (read)
                session.read(result.picture);
            if (on_board && calls++ == 0)
                board->pass(static_cast<sim::Time>(options.present.draw_ms) * 1'000'000);
        };
        if (!on_board)
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
            window.show(on_board ? board->glass() : session.read(), on_board ? board->memory() : sim::Image(),
                        on_board ? board->counters() : sim::BoardCounters{});
        progress(f, options.frames);
        ++report.frames;
    }
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
        result.error = fmt::format("{} raised GL error 0x{:04X}", program.name, error);
        return result;
    }

    report.scene = program.name;
    report.board =
        on_board ? description->name : fmt::format("off-screen {}x{}", session.width(), session.height());
    report.precision = name_of(options.precision);
    report.picture_hash = sim::hash(result.picture);
    report.full_frame_bytes =
        static_cast<std::uint64_t>(session.width()) * static_cast<std::uint64_t>(session.height()) * 2;
    if (on_board) {
        if (const auto shown = board->display().finish(); !shown.ok())
            result.error = shown.error().rule;
        if (options.present.any())
            report.presents = board->presents();
        report.virtual_fps = report.frames / (static_cast<double>(board->now() - started) * 1e-9);
        const sim::BoardCounters after = board->counters();
        report.bus_bytes = after.bytes - before.bytes;
        report.bus_commands = after.commands - before.commands;
        const double seconds = static_cast<double>(after.busy_ns - before.busy_ns) * 1e-9;
        report.fps_at_bus_clock = seconds > 0.0 ? report.frames / seconds : 0.0;
        result.picture = board->glass();
        result.violations = board->violations_text();
    }
    shadow.finish(report);
    if (options.stats)
        report.memory = {session.context_bytes(), session.surface_bytes(), memory_use().peak, process_peak()};
    if (options.bands.height != 0) {
        const std::size_t record =
            options.bands.record ? static_cast<std::size_t>(options.bands.record_bytes) : 0;
        report.bands =
            BandMemory{hal::bus_memory(built), session.surface_bytes() - record, session.record_peak()};
    }
    if (options.compare) {
        comparison.finish(report, coverage);
        result.difference = comparison.picture();
    }
    return result;
}

} // namespace spangle::cli
