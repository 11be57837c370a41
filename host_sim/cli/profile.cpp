#include "host_sim/cli/profile.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <spangle/GL/gl.h>

#include "gl/context/context.hpp"
#include "host_sim/cli/program.hpp"
#include "host_sim/cli/report.hpp"
#include "host_sim/cli/run.hpp"
#include "host_sim/cli/say.hpp"
#include "host_sim/profile/emit.hpp"
#include "host_sim/profile/recorder.hpp"

namespace spangle::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char* tier_names[] = {"exact", "balanced", "fast"}; ///< the cheapest last

Precision precision_of(const std::string& tier) {
    return tier == "exact" ? Precision::exact : tier == "balanced" ? Precision::balanced : Precision::fast;
}

/// One tier: what the program asked for, and how far its pictures are from the reference.
struct Recorded {
    std::string tier, picture_hash;
    profile::Record record;
    Report report;
    double error = 0.0; ///< percent of pixels
};

#if SPANGLE_WATCHED

/// Empty, or why nothing was recorded.
std::string record(ProfileOptions& options, const std::string& tier, Recorded& out) {
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
                           Session::complaint().empty() ? "" : ": ", Session::complaint());
    options.run.dither = glIsEnabled(GL_DITHER) != GL_FALSE; // the reference does as the program did
    out.tier = tier;
    out.picture_hash = sim::hash(session.read());
    return "";
}

#endif

/// The same frames against the double reference.
std::string compare(const ProfileOptions& options, Recorded& out) {
    RunOptions run = options.run;
    run.precision = precision_of(out.tier);
    run.compare = true;
    RunResult result = cli::run(run);
    out.report = std::move(result.report);
    out.error = 100.0 - out.report.identical_565_percent;
    return result.error;
}

nlohmann::json to_json(const std::vector<Recorded>& all, const Recorded& chosen,
                       const profile::Profile& made) {
    nlohmann::json out;
    for (const Recorded& r : all)
        out["tiers"][r.tier] = {{"different_percent", r.error},
                                {"max_lsb", r.report.max_lsb},
                                {"psnr_565_db", r.report.psnr_565_db},
                                {"picture_hash", r.picture_hash}};
    out["scene"] = chosen.report.scene;
    out["tier"] = chosen.tier;
    out["features"] = made.features;
    for (const auto& [limit, value] : made.limits)
        out["limits"][limit] = std::stol(value);
    out["chain"] = made.chain;
    out["keys"] = nlohmann::json::array();
    for (const profile::KeyUse& use : chosen.record.keys)
        out["keys"].push_back(
            {{"key", profile::words(use.key)},
             {"pixels", use.pixels},
             {"fused", std::find(made.fused.begin(), made.fused.end(), use.key) != made.fused.end()},
             {"needed", use.needed}});
    out["commands"] = chosen.record.commands;
    out["arena_bytes_of_host"] = chosen.record.arena_peak;
    return out;
}

std::string to_text(const std::vector<Recorded>& all, const Recorded& chosen, const profile::Profile& made) {
    std::string out;
    for (const Recorded& r : all)
        out += fmt::format("  {:<10}{:9.4f} % of pixels differ, at most {} steps of RGB565, {:.1f} dB{}\n",
                           r.tier, r.error, r.report.max_lsb, r.report.psnr_565_db,
                           &r == &chosen ? "   <- the profile's" : "");
    out += "\n  systems     ";
    for (const std::string& feature : made.features)
        out += " " + feature;
    out += fmt::format("\n  the chain    {}\n\n  pixels     drawn by  state key\n",
                       made.chain ? "is needed" : "is left out");
    std::vector<profile::KeyUse> keys = chosen.record.keys;
    std::stable_sort(keys.begin(), keys.end(),
                     [](const auto& a, const auto& b) { return a.pixels > b.pixels; });
    for (const profile::KeyUse& use : keys) {
        const bool fused = std::find(made.fused.begin(), made.fused.end(), use.key) != made.fused.end();
        if (fused || use.pixels != 0)
            out += fmt::format("  {:>9}  {:<8}  {}\n", use.pixels, fused ? "a loop" : "the chain",
                               profile::words(use.key));
    }
    out += "\n  calls      command\n";
    std::vector<std::pair<std::string, std::uint64_t>> commands(chosen.record.commands.begin(),
                                                                chosen.record.commands.end());
    std::stable_sort(commands.begin(), commands.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    for (const auto& [name, count] : commands)
        out += fmt::format("  {:>9}  {}\n", count, name);
    return out;
}

/// The cheapest within the bound, or the most accurate where there is none; null: none is within it.
const Recorded* choose(const std::vector<Recorded>& all, double max_error) {
    if (max_error < 0.0)
        return &all.front();
    const auto at =
        std::find_if(all.rbegin(), all.rend(), [&](const Recorded& r) { return r.error <= max_error; });
    return at == all.rend() ? nullptr : &*at;
}

} // namespace

CLI::App* add_profile(CLI::App& app, ProfileOptions& o) {
    CLI::App* const command = app.add_subcommand(
        "profile", "write the profile of a build that holds what a scene or a model asks for");
    command->add_option("scene", o.run.scene, "id of a scene, see `spangle scenes`");
    command->add_option("--model", o.run.model, "a model file instead: any format libassimp reads");
    command
        ->add_option("--out", o.out,
                     "the profile to write, as scene.cmake; its fused spans go beside it, as scene.inc")
        ->required();
    command->add_option("--frames", o.run.frames, "how many frames are recorded")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    command->add_option("--size", o.size, "WIDTHxHEIGHT of the picture")->capture_default_str();
    command->add_option("--dither", o.dither, "GL_DITHER; program: as the program sets it")
        ->check(CLI::IsMember({"program", "on", "off"}))
        ->capture_default_str();
    command->add_option("--tiers", o.tiers, "the tiers of accuracy to choose from: exact, balanced, fast")
        ->delimiter(',')
        ->check(CLI::IsMember({"exact", "balanced", "fast"}));
    command
        ->add_option("--max-error", o.max_error,
                     "percent of pixels that may be others than the double reference's: the cheapest tier "
                     "within it is taken; "
                     "else the most accurate one is")
        ->check(CLI::Range(0.0, 100.0));
    command->add_flag("--small", o.small, "leave out what is only faster, too");
    command->add_flag("--json", o.json, "print what was recorded as one JSON object");
    return command;
}

int profile([[maybe_unused]] ProfileOptions options) {
#if SPANGLE_WATCHED
    RunOptions& run = options.run;
    if (run.scene.empty() == run.model.empty())
        return refuse("profile takes a scene or --model FILE; `spangle scenes` lists the scenes");
    char rest = 0;
    if (std::sscanf(options.size.c_str(), "%dx%d%c", &run.width, &run.height, &rest) != 2 || run.width < 1 ||
        run.height < 1 || run.width > 2048 || run.height > 2048)
        return refuse("--size takes WIDTHxHEIGHT, each 1 to 2048, not '" + options.size + "'");
    const fs::path path = options.out, list = fs::path(path).replace_extension(".inc");
    if (path.extension() != ".cmake")
        return refuse("--out takes a file that ends with .cmake, not '" + options.out + "'");
    sim::Output file, spans;
    for (auto [to, name] : {std::pair{&file, path}, std::pair{&spans, list}})
        if (const std::string problem = open(*to, "--out", name.string()); !problem.empty())
            return refuse(problem);

    std::vector<Recorded> all;
    for (const char* const tier : tier_names)
        if (std::find(options.tiers.begin(), options.tiers.end(), tier) != options.tiers.end()) {
            std::string problem = record(options, tier, all.emplace_back());
            if (problem.empty())
                problem = compare(options, all.back());
            if (!problem.empty())
                return refuse(problem);
        }
    const Recorded* const chosen = choose(all, options.max_error);
    if (chosen == nullptr)
        return refuse(fmt::format("no tier is within {} %: {} differs in {:.4f} % of its pixels",
                                  options.max_error, all.front().tier, all.front().error));
    const profile::Choice choice{chosen->report.scene, list.filename().string(), options.small};
    const profile::Profile made = profile::make(chosen->record, choice);
    file.write(profile::settings(made, chosen->record, choice));
    spans.write("// Fused spans of " + options.out + ".\n" + profile::fused_lines(made));
    for (sim::Output* const to : {&file, &spans})
        if (const std::string problem = to->commit(); !problem.empty())
            return refuse(problem, not_done);
    if (options.json)
        print("{}\n", to_json(all, *chosen, made).dump());
    else
        print("{}: {} in the tier {}\n{}", options.out, chosen->report.scene, chosen->tier,
              to_text(all, *chosen, made));
    return 0;
#else
    return refuse("this build does not record: it leaves out messages or display lists");
#endif
}

} // namespace spangle::cli
