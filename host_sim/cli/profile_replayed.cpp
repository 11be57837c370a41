#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include <spangle/sim/image.hpp>

#include "host_sim/cli/pair.hpp"
#include "host_sim/cli/profile_record.hpp"
#include "host_sim/cli/record_trace.hpp"
#include "host_sim/process/process.hpp"
#include "host_sim/profile/record_text.hpp"

namespace spangle::cli {

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Runs a tool of apitrace. What it prints is reported only if it fails. Returns what went wrong, or an empty
/// string.
std::string run_tool(const std::vector<std::string>& command, const fs::path& words,
                     bool any_status = false) {
    const int status = pair::run(command, words);
    if (status == process::no_program)
        return "there is no " + command[0] + "; Debian's packages apitrace and apitrace-tracers have it";
    if (status == 0 || any_status)
        return "";
    std::string said = text_of(words);
    said.erase(said.find_last_not_of('\n') + 1);
    return fmt::format("{} ended with {}: {}", command[0], status, said.substr(said.rfind('\n') + 1));
}

/// Makes pictures of a trace's frames, in their order. Returns what went wrong, or an empty string.
std::string pictures_of(const std::string& trace, const fs::path& folder, std::vector<fs::path>& out) {
    std::error_code ignored;
    fs::create_directories(folder, ignored);
    std::vector<std::string> command = pair::retrace(trace);
    command.insert(command.end() - 1, {"-s", folder.string() + "/", "-S", "frame"});
    if (std::string problem = run_tool(command, folder / "words"); !problem.empty())
        return problem;
    for (const auto& file : fs::directory_iterator(folder, ignored))
        if (file.path().extension() == ".png")
            out.push_back(file.path());
    std::sort(out.begin(), out.end());
    return out.empty() ? "the trace shows no frame" : "";
}

std::string compare(const std::vector<fs::path>& ours, const std::vector<fs::path>& theirs, TierRecord& out) {
    if (ours.size() != theirs.size())
        return fmt::format("the replay in the tier {} shows {} frames, and {} in double", out.tier,
                           ours.size(), theirs.size());
    sim::Difference total;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        sim::Image mine, reference;
        std::string problem = sim::read_png(ours[i].string(), mine);
        if (problem.empty())
            problem = sim::read_png(theirs[i].string(), reference);
        if (!problem.empty())
            return problem;
        if (mine.width != reference.width || mine.height != reference.height)
            return fmt::format("frame {} has another size in double", i);
        const sim::Difference d = sim::compare_565(mine, reference);
        total.pixels += d.pixels;
        total.identical += d.identical;
        out.max_lsb = std::max(out.max_lsb, d.max_lsb);
        out.psnr_db = std::min(out.psnr_db, d.psnr_db);
        if (i + 1 == ours.size())
            out.picture_hash = sim::hash(mine);
    }
    out.frames = static_cast<int>(ours.size());
    out.error = 100.0 - total.identical_percent();
    return "";
}

/// Replays the trace while the drop-in pair records. A run for pictures cannot record, because its retracer
/// reads the pictures by commands that the program never called.
std::string record(const std::string& trace, const std::string& format, const fs::path& folder,
                   TierRecord& out) {
    const fs::path file = folder / ("record-" + out.tier);
    pair::set("SPANGLE_RECORD", file.string());
    pair::set("SPANGLE_RECORD_FORMAT", format == "program" ? "" : format);
    std::string problem = run_tool(pair::retrace(trace), folder / "words");
    pair::set("SPANGLE_RECORD", "");
    if (!problem.empty())
        return problem;
    if (!fs::exists(file))
        return "the trace shows no frame";
    return profile::from_text(text_of(file), out.record);
}

/// Whether a trace shows frames. A trace of GLX shows none if the program used EGL. A trace of EGL shows none
/// if it used GLX.
bool shows_frames(const std::string& trace, const fs::path& folder) {
    const fs::path calls = folder / "calls";
    pair::run({"apitrace", "dump", "--color=never", "--grep=SwapBuffers", trace}, calls);
    return text_of(calls).find("SwapBuffers") != std::string::npos;
}

} // namespace

std::string record_replayed(ProfileOptions& options, const fs::path& folder, std::vector<TierRecord>& out) {
    std::string problem = options.program ? "" : pair::trace_problem(options.trace);
    if (problem.empty())
        problem = pair::use();
    if (!problem.empty())
        return problem;
    for (const char* const variable : {"SPANGLE_BOARD", "SPANGLE_SHOT", "SPANGLE_FRAMES", "SPANGLE_REPORT",
                                       "SPANGLE_FORMAT", "SPANGLE_PRECISION"})
        pair::set(variable, "");
    std::string& trace = options.trace;
    if (options.program) {
        // The window of a program comes from GLX or from EGL, and a tracer sees only one of these.
        for (const char* const api : {"gl", "egl"}) {
            trace = (folder / (api + std::string(".trace"))).string();
            problem = record_trace(options.words, api, options.run.width, options.run.height,
                                   options.run.frames, folder, trace);
            pair::set("SPANGLE_FRAMES", ""); // a retracer shows all frames
            if (!problem.empty())
                problem = fmt::format("apitrace recorded nothing of {}: {}", options.words[0], problem);
            if (!problem.empty() || shows_frames(trace, folder))
                break;
        }
    } else if (options.run.frames != 0) {
        const std::string shorter = (folder / "shorter.trace").string();
        problem = run_tool(
            {"apitrace", "trim", fmt::format("--frames=0-{}", options.run.frames - 1), "-o", shorter, trace},
            folder / "words");
        trace = shorter;
    }
    pair::set("SPANGLE_SIZE", options.size);
    std::vector<fs::path> reference;
    pair::set("SPANGLE_PRECISION", "double");
    if (problem.empty())
        problem = pictures_of(trace, folder / "double", reference);
    for (const std::string& tier : options.tiers) {
        if (!problem.empty())
            break;
        TierRecord& one = out.emplace_back();
        one.tier = tier;
        pair::set("SPANGLE_PRECISION", tier);
        std::vector<fs::path> pictures;
        problem = record(trace, options.format, folder, one);
        if (problem.empty())
            problem = pictures_of(trace, folder / tier, pictures);
        if (problem.empty())
            problem = compare(pictures, reference, one);
    }
    return problem;
}

} // namespace spangle::cli
