#include "host_sim/cli/profile.hpp"

#include <algorithm>
#include <filesystem>
#include <tuple>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "host_sim/capture/names.hpp"
#include "host_sim/cli/pair.hpp"
#include "host_sim/cli/profile_firmware.hpp"
#include "host_sim/cli/profile_page.hpp"
#include "host_sim/cli/profile_record.hpp"
#include "host_sim/cli/profile_report.hpp"
#include "host_sim/cli/say.hpp"
#include "host_sim/profile/emit.hpp"

namespace spangle::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char* tier_names[] = {"exact", "balanced", "fast"}; ///< the cheapest tier last
constexpr int usual_frames = 60; ///< frames recorded of a program, which needs some to show what it does

/// Returns the cheapest tier within the bound, or the most accurate tier where there is no bound. Returns
/// null where no tier is within the bound.
const TierRecord* choose(const std::vector<TierRecord>& all, double max_error) {
    if (max_error < 0.0)
        return &all.front();
    const auto at =
        std::find_if(all.rbegin(), all.rend(), [&](const TierRecord& r) { return r.error <= max_error; });
    return at == all.rend() ? nullptr : &*at;
}

/// Finds out what is to be recorded. Returns the rule that the options break, or an empty string.
std::string take_words(ProfileOptions& options) {
    RunOptions& run = options.run;
    if (!options.program && options.words.size() > 1)
        return "profile takes one scene; a program and its arguments come after --";
    if (!options.program && !options.words.empty())
        run.scene = options.words[0];
    const int named = (run.scene.empty() ? 0 : 1) + (run.model.empty() ? 0 : 1) +
                      (options.trace.empty() ? 0 : 1) + (options.program && !options.words.empty() ? 1 : 0);
    if (named != 1)
        return "profile takes a scene or --model FILE, or --trace FILE, or -- PROGRAM; `spangle scenes` "
               "lists the "
               "scenes";
    run.baked = true; // a board draws what `spangle bake` writes
    char rest = 0;
    if (std::sscanf(options.size.c_str(), "%dx%d%c", &run.width, &run.height, &rest) != 2 || run.width < 1 ||
        run.height < 1 || run.width > 2048 || run.height > 2048)
        return "--size takes WIDTHxHEIGHT, each 1 to 2048, not '" + options.size + "'";
    if (run.frames == 0 && options.trace.empty())
        run.frames = options.program ? usual_frames : 1;
    // The tiers are put in order, from the most accurate to the cheapest, each once.
    std::vector<std::string> tiers;
    for (const char* const tier : tier_names)
        if (std::find(options.tiers.begin(), options.tiers.end(), tier) != options.tiers.end())
            tiers.emplace_back(tier);
    options.tiers = std::move(tiers);
    return "";
}

std::vector<std::string> format_names() {
    std::vector<std::string> out;
    for (const names::Format& format : names::formats)
        out.emplace_back(format.name);
    out.emplace_back("program");
    return out;
}

} // namespace

CLI::App* add_profile(CLI::App& app, ProfileOptions& o) {
    CLI::App* const command =
        app.add_subcommand("profile", "write the profile of a build that holds what a program asks for");
    command->add_option(
        "scene", o.words,
        "id of a scene, see `spangle scenes`; after --: a program of OpenGL and its arguments, "
        "which apitrace records");
    command->add_option("--model", o.run.model,
                        "a model file instead, drawn as `spangle bake` writes it: any format "
                        "libassimp reads");
    command->add_option("--trace", o.trace, "a trace of apitrace instead");
    command
        ->add_option("--out", o.out,
                     "the profile to write, as scene.cmake; its fused spans go beside it, as scene.inc")
        ->required();
    o.run.frames = 0;
    command
        ->add_option("--frames", o.run.frames,
                     "how many frames are recorded (1; of a program 60; all of a trace)")
        ->check(CLI::Range(1, 1000000));
    command->add_option("--size", o.size, "WIDTHxHEIGHT of the picture, or of the program's windows")
        ->capture_default_str();
    command->add_option("--dither", o.dither, "GL_DITHER; program: as the program sets it")
        ->check(CLI::IsMember({"program", "on", "off"}))
        ->capture_default_str();
    command
        ->add_option(
            "--format", o.format,
            "of a trace or a program: pixels of the surfaces that the build draws on; program: as the "
            "program chose them")
        ->check(CLI::IsMember(format_names()))
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
    command->add_flag(
        "--no-clipping", o.unclipped,
        "leave out clipping, and perspective, where the recorded program needed neither: what would "
        "be cut later is an error, and not drawn");
    command->add_option(
        "--report", o.report,
        "build the program as firmware, whole and in the profile, measure both on an emulated "
        "Cortex-M4, and write a page about it");
    command->add_flag("--json", o.json, "print what was recorded, and measured, as one JSON object");
    return command;
}

int profile(ProfileOptions options) {
    if (const std::string problem = take_words(options); !problem.empty())
        return refuse(problem);
    const fs::path path = options.out, list = fs::path(path).replace_extension(".inc");
    if (path.extension() != ".cmake")
        return refuse("--out takes a file that ends with .cmake, not '" + options.out + "'");
    sim::Output file, spans, page;
    for (auto [to, option, name] :
         {std::tuple{&file, "--out", path.string()}, std::tuple{&spans, "--out", list.string()},
          std::tuple{&page, "--report", options.report}})
        if (const std::string problem = open(*to, option, name); !problem.empty())
            return refuse(problem);

    const std::string title = title_of(options);
    std::vector<TierRecord> all;
    const bool drawn = options.trace.empty() && !options.program;
    const pair::Folder folder;
    if (folder.path().empty())
        return refuse(pair::Folder::problem(), not_done);
    if (const std::string problem =
            drawn ? record_drawn(options, all) : record_replayed(options, folder.path(), all);
        !problem.empty())
        return refuse(problem);
    const TierRecord* const chosen = choose(all, options.max_error);
    if (chosen == nullptr)
        return refuse(fmt::format("no tier is within {} %: {} differs in {:.4f} % of its pixels",
                                  options.max_error, all.front().tier, all.front().error));
    const profile::Choice choice{title, list.filename().string(), options.small, options.unclipped};
    const profile::Profile made = profile::make(chosen->record, choice);
    file.write(profile::settings(made, chosen->record, choice));
    spans.write("// Fused spans of " + options.out + ".\n" + profile::fused_lines(made));
    for (sim::Output* const to : {&file, &spans})
        if (const std::string problem = to->commit(); !problem.empty())
            return refuse(problem, not_done);
    ProfileReport report{choice.title, &all, chosen, &made, {}};
    if (!options.report.empty()) {
        std::string problem = measure_firmware(options, *chosen, folder.path(), report.firmware);
        if (problem.empty()) {
            page.write(to_page(report));
            problem = page.commit();
        }
        if (!problem.empty())
            return refuse(problem, not_done);
    }
    if (options.json)
        print("{}\n", to_json(report).dump());
    else
        print("{}: {} in the tier {}\n{}", options.out, report.title, chosen->tier, to_text(report));
    return 0;
}

} // namespace spangle::cli
