#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include <spangle/GL/gl.h>

#include "gl/context/context.hpp"
#include "host_sim/cli/profile_record.hpp"
#include "host_sim/cli/program.hpp"
#include "host_sim/cli/run.hpp"
#include "host_sim/profile/recorder.hpp"

namespace spangle::cli {

std::string title_of(const ProfileOptions& options) {
    namespace fs = std::filesystem;
    if (options.program)
        return fs::path(options.words[0]).filename().string();
    if (!options.trace.empty())
        return fs::path(options.trace).filename().string();
    return options.run.scene.empty() ? fs::path(options.run.model).filename().string() : options.run.scene;
}

#if SPANGLE_WATCHED

namespace {

Precision precision_of(const std::string& tier) {
    return tier == "exact" ? Precision::exact : tier == "balanced" ? Precision::balanced : Precision::fast;
}

std::string record(ProfileOptions& options, const std::string& tier, TierRecord& out) {
    Model model;
    Program program;
    std::string problem = make_program(options.run, model, program);
    Session session;
    if (problem.empty())
        problem = session.open_picture(options.run.width, options.run.height, precision_of(tier));
    if (!problem.empty())
        return problem;
    {
        profile::Recorder recorder(*gl::current_context());
        program.setup(session.width(), session.height());
        if (options.dither != "program")
            (options.dither == "on" ? glEnable : glDisable)(GL_DITHER);
        for (int f = 0; f < options.run.frames; ++f)
            program.draw(f);
        out.record = recorder.finish();
    }
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        return fmt::format("{} raised GL error 0x{:04X}{}{}", program.name, error,
                           Session::last_error_text().empty() ? "" : ": ", Session::last_error_text());
    options.run.dither = glIsEnabled(GL_DITHER) != GL_FALSE; // the reference dithers as the program did
    out.tier = tier;
    out.frames = options.run.frames;
    out.picture_hash = sim::hash(session.read());
    return "";
}

/// Draws the recorded frames again, and compares each with the double reference.
std::string compare(const ProfileOptions& options, TierRecord& out) {
    RunOptions run = options.run;
    run.precision = precision_of(out.tier);
    run.compare = true;
    const RunResult result = cli::run(run);
    out.error = 100.0 - result.report.identical_565_percent;
    out.max_lsb = result.report.max_lsb;
    out.psnr_db = result.report.psnr_565_db;
    return result.error;
}

} // namespace

std::string record_drawn(ProfileOptions& options, std::vector<TierRecord>& out) {
    std::string problem;
    for (const std::string& tier : options.tiers)
        if (problem.empty()) {
            problem = record(options, tier, out.emplace_back());
            if (problem.empty())
                problem = compare(options, out.back());
        }
    return problem;
}

#else

std::string record_drawn(ProfileOptions&, std::vector<TierRecord>&) {
    return "this build does not record: it leaves out messages or display lists";
}

#endif

} // namespace spangle::cli
