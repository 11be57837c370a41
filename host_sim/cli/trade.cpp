#include "host_sim/cli/trade.hpp"

#include <algorithm>
#include <deque>
#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include "boards/scenes/baked_model.hpp"
#include "boards/scenes/scene.hpp"
#include "host_sim/cli/callgrind.hpp"
#include "host_sim/cli/model.hpp"
#include "host_sim/cli/model_baked.hpp"
#include "host_sim/cli/replays.hpp"
#include "host_sim/cli/say.hpp"
#include "host_sim/cli/trade_boards.hpp"
#include "host_sim/trade/advice.hpp"
#include "host_sim/trade/boxes.hpp"
#include "host_sim/trade/bytes.hpp"
#include "host_sim/trade/corpus.hpp"
#include "host_sim/trade/knobs.hpp"
#include "host_sim/trade/page.hpp"
#include "host_sim/trade/sweep.hpp"

namespace spangle::cli {

namespace {

template <unsigned Count, class Named> std::vector<std::string> names_of(const Named (&all)[Count]) {
    std::vector<std::string> names;
    for (const Named& one : all)
        names.emplace_back(one.name);
    return names;
}

/// Everything that a sweep draws, and the models that must live as long.
struct Corpus {
    std::deque<Model> models;
    std::deque<BakedModel> baked;
    std::vector<trade::Program> programs;

    std::string add_scene(const std::string& id) {
        const scenes::Scene* scene = scenes::find(id.c_str());
        for (const scenes::Scene& other : trade::corpus())
            scene = id == other.id ? &other : scene;
        if (scene == nullptr)
            return "no scene '" + id + "'; `spangle scenes` lists them, and `spangle trade --help` more";
        programs.push_back({scene->id, scene->setup, scene->draw, trade::needs_stencil(*scene)});
        return "";
    }
    /// The program that draws a model as images of firmware do.
    std::shared_ptr<const trade::Program> on_board(const Model& model) {
        const baked::Mesh& mesh = baked.emplace_back(model).mesh();
        return std::make_shared<trade::Program>(
            trade::Program{model.name, [&mesh](int w, int h) { scenes::setup_baked(mesh, w, h); },
                           [&mesh](int f) { scenes::draw_baked(mesh, f); }});
    }
    std::string add_model(const std::string& file, bool for_boards) {
        ModelResult loaded = load_model(file);
        if (!loaded.error.empty())
            return loaded.error;
        for (const std::string& note : loaded.model.notes)
            tell(note + "\n");
        const Model& model = models.emplace_back(std::move(loaded.model));
        programs.push_back({one_line(model.name), [&model](int w, int h) { setup_model(model, w, h); },
                            [&model](int f) { draw_model(model, f); }, false, nullptr,
                            for_boards ? on_board(model) : nullptr});
        return "";
    }
    std::string add_trace(const std::string& file) {
        std::shared_ptr<trade::Recording> recording;
        std::string problem = open_trace(file, recording);
        programs.push_back({one_line(std::filesystem::path(file).stem().string()), {}, {}, false, recording});
        return problem;
    }
    std::string add_program(const std::vector<std::string>& words) {
        std::shared_ptr<trade::Recording> recording;
        std::string problem = open_program(words, recording);
        programs.push_back(
            {one_line(std::filesystem::path(words[0]).filename().string()), {}, {}, false, recording});
        return problem;
    }
    std::string add(const TradeOptions& options) {
        std::string problem;
        if (options.runs_program && options.program.empty())
            return "name a program after --";
        for (const std::string& id : options.scenes)
            problem = problem.empty() ? add_scene(id) : problem;
        if (options.runs_program && problem.empty())
            problem = add_program(options.program);
        for (const std::string& file : options.traces)
            problem = problem.empty() ? add_trace(file) : problem;
        for (const std::string& file : options.models)
            problem = problem.empty() ? add_model(file, !options.firmware.empty()) : problem;
        if (programs.empty())
            for (const scenes::SceneList& list : {scenes::all(), trade::corpus()})
                for (const scenes::Scene& scene : list)
                    problem = problem.empty() ? add_scene(scene.id) : problem;
        return problem;
    }
};

/// Appends the tiers that the user composed to those already there.
std::string read_own_tiers(const TradeOptions& options, std::vector<trade::Tier>& out) {
    for (const std::string& words : options.own_tiers) {
        trade::Tier own;
        if (std::string problem = trade::read_tier(words, out, own); !problem.empty())
            return problem;
        out.push_back(own);
    }
    return "";
}

std::string read_setting(const TradeOptions& options, trade::Sweep& out) {
    char rest = 0;
    trade::Setting& s = out.setting;
    if (std::sscanf(options.size.c_str(), "%dx%d%c", &s.width, &s.height, &rest) != 2 || s.width < 1 ||
        s.height < 1 || s.width > 2048 || s.height > 2048)
        return "--size takes WIDTHxHEIGHT, each 1 to 2048, not '" + options.size + "'";
    if (!options.shard.empty() &&
        (std::sscanf(options.shard.c_str(), "%d/%d%c", &out.shard, &out.shards, &rest) != 2 ||
         out.shard < 1 || out.shards < out.shard))
        return "--shard takes I/N, I from 1 to N, not '" + options.shard + "'";
    s.frames = options.frames;
    s.dither = options.dither == "on";
    out.times = !options.no_times;
    for (const trade::Tier& tier : trade::tiers) // takes the tiers in the order of the table
        for (const std::string& name : options.tiers)
            if (name == tier.name)
                out.tiers.push_back(tier);
    for (const std::string& name : options.formats)
        out.formats.push_back(*trade::find(trade::formats, name));
    return read_own_tiers(options, out.tiers);
}

/// Returns a function that counts instructions with callgrind. It reports a problem once.
auto counter(const TradeOptions& options) {
    return [&options, told = false](const trade::Program& program, const trade::Tier& tier,
                                    const trade::Format& format) mutable -> std::uint64_t {
        if (told || format.format != PixelFormat::rgb565_be || program.recording != nullptr)
            return 0;
        std::vector<std::string> words = {"run",
                                          tier.knobs ? "--knobs" : "--precision",
                                          tier.knobs ? tier.words : tier.name,
                                          "--size",
                                          options.size,
                                          "--dither",
                                          options.dither};
        if (scenes::find(program.name.c_str()) != nullptr)
            words.insert(words.begin() + 1, program.name);
        else if (options.models.size() == 1)
            words.insert(words.end(), {"--model", options.models.front()});
        else
            return 0;
        std::string problem;
        const std::uint64_t count = instructions_of_frame(words, problem);
        if (!problem.empty()) {
            tell("instructions are not counted: " + problem + "\n");
            told = true;
        }
        return count;
    };
}

/// Prints a hash of the frames of each job and tier, a line each, in alphabetical order.
int print_bytes(const trade::Sweep& what) {
    std::vector<std::string> lines;
    int number = 0;
    for (const trade::Program& program : what.programs)
        for (const trade::Format& format : what.formats) {
            if (number++ % what.shards != what.shard - 1)
                continue;
            for (const trade::Tier& tier : what.tiers) {
                std::uint64_t hash = 0;
                if (const std::string problem = trade::hash_frames(program, tier, format, what.setting, hash);
                    !problem.empty())
                    return refuse(problem);
                lines.push_back(
                    fmt::format("{} {} {} {:016x}\n", program.name, format.name, tier.name, hash));
            }
        }
    std::sort(lines.begin(), lines.end());
    for (const std::string& line : lines)
        print_text(line);
    return 0;
}

/// Prints the results. Writes the page, too, unless the sweep is only a part of a larger sweep.
int report(const TradeOptions& options, const trade::SweepResult& swept, bool whole) {
    int missed = 0;
    for (const trade::Table::Row& row : swept.accuracy.rows)
        for (const std::string& box : trade::missed_boxes(swept.accuracy, row)) {
            print("{} in {}, {}: {}\n", swept.accuracy.text(row, "scene"), swept.accuracy.text(row, "format"),
                  swept.accuracy.text(row, "tier"), box);
            ++missed;
        }
    if (whole) {
        for (const trade::Advice& a : trade::advise(swept.accuracy, swept.cost))
            print("{:<9} {:<6}take {}. {}\n", a.scene, a.format, a.take, a.why);
        std::string note;
        if (const std::string problem = trade::write_page(options.out, swept.accuracy, swept.cost, note);
            !problem.empty())
            return refuse(problem, not_done);
        tell(note);
        print("page: {}{}\n", options.out, trade::page_file);
    }
    print("figures: {}{}\n", options.out, trade::accuracy_file);
    return options.strict && missed != 0 ? refuse(fmt::format("{} promises are broken", missed), not_done)
                                         : 0;
}

} // namespace

CLI::App* add_trade(CLI::App& app, TradeOptions& o) {
    CLI::App* const command = app.add_subcommand(
        "trade",
        "speed against accuracy: every tier and format against the same frames in double, as CSV and "
        "as a page with plots, pictures and advice");
    std::string more;
    for (const scenes::Scene& scene : trade::corpus())
        more += fmt::format("  {:<11}{}\n", scene.id, scene.title);
    command->footer(
        "Beside the scenes:\n" + more +
        "\nWrites accuracy.csv (the same bytes on every machine), cost.csv (times of this one) and "
        "index.html, which needs no other file. docs/trade.md explains the figures.\n"
        "Coverage is held against brute force on the tier's own snapped vertices (off_own), against vertices "
        "in double snapped to the same 1/256 pixel (off_snapped), and against unsnapped ones "
        "(off_unsnapped).\n"
        "  spangle trade --out all                      every scene, 565, three tiers\n"
        "  spangle trade S4r S9 --formats 565,888       two scenes in two formats\n"
        "  spangle trade --model duck.dae --targets host\n"
        "  spangle trade S9 --targets m0plus,m4 --firmware build/trade-firmware\n"
        "  spangle trade S9 --tier fine=balanced,texel_bits=4    a tier of your own\n"
        "  spangle trade --trace game.trace             the first frames of a trace of apitrace\n"
        "  spangle trade --frames 60 -- glxgears        a program: it is recorded once, then replayed\n"
        "  spangle trade --shard 1/4 --out part1        and 2/4 ... elsewhere, then\n"
        "  spangle trade merge part1 part2 part3 part4 --out all");
    for (const trade::Tier& tier : trade::tiers)
        if ((SPANGLE_TIER_SET >> (&tier - trade::tiers) & 1) != 0) // this build has the tier
            o.tiers.emplace_back(tier.name);
    o.formats = {"565"};
    command->add_option(
        "scenes", o.scenes,
        "ids of scenes (see `spangle scenes`); after -- comes a program with its arguments; none "
        "and no model or trace: all scenes");
    command->add_option("--model", o.models, "a model file: any format libassimp reads; may be repeated")
        ->allow_extra_args(false);
    command
        ->add_option("--trace", o.traces,
                     "a trace of apitrace: its first frames, in its own size; may be repeated")
        ->allow_extra_args(false);
    command
        ->add_option("--tiers", o.tiers,
                     "which tiers; times are relative to the first: exact, balanced, fast")
        ->check(CLI::IsMember(names_of(trade::tiers)))
        ->delimiter(',')
        ->allow_extra_args(false);
    command->add_option("--formats", o.formats, "which formats of surfaces, as 565,888 (565)")
        ->check(CLI::IsMember(names_of(trade::formats)))
        ->delimiter(',')
        ->allow_extra_args(false);
    command->add_option("--size", o.size, "WIDTHxHEIGHT of the pictures, and of a program's windows")
        ->capture_default_str();
    command->add_option("--frames", o.frames, "how many frames of each program are judged: the first")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command->add_option("--dither", o.dither, "GL_DITHER")
        ->check(CLI::IsMember({"on", "off"}))
        ->capture_default_str();
    command->add_option("--shard", o.shard, "I/N: only the Ith of N parts of the jobs, and no page");
    command->add_flag("--no-times", o.no_times, "measure no times: cost.csv has none");
    command
        ->add_option("--targets", o.targets,
                     "count the instructions of a frame in 565 there, as host,m4: host is this machine "
                     "(valgrind; takes minutes), m0plus, m3, m4 and rv32 run images of --firmware in QEMU")
        ->check(CLI::IsMember(trade::target_names()))
        ->delimiter(',')
        ->allow_extra_args(false);
    command->add_flag("--instructions", o.instructions, "the same as --targets host");
    command->add_option(
        "--firmware", o.firmware,
        "the folder of images that `./dev firmware --out DIR` has built from Spangle's source");
    command
        ->add_option(
            "--tier", o.own_tiers,
            "one more tier, NAME=BASE,KNOB=VALUE,...: BASE is exact, balanced or fast; may be repeated")
        ->allow_extra_args(false);
    command->add_flag("--knobs", o.knobs,
                      "list the knobs of all tiers, those of --tier among them, and do nothing else");
    command->add_flag("--strict", o.strict, "exit with 1 where a tier breaks one of its promises");
    command->add_flag(
        "--bytes", o.bytes,
        "only print a hash of what each program draws in each format and tier, and measure nothing");
    command->add_option("--out", o.out, "the folder for all files")->capture_default_str();
    CLI::App* const merge = command->add_subcommand("merge", "put the folders of shards together");
    merge->add_option("parts", o.parts, "the folders")->required();
    merge->add_option("--out", o.out, "the folder for all files")->capture_default_str();
    merge->add_flag("--strict", o.strict, "exit with 1 where a tier breaks one of its promises");
    return command;
}

int trade(const TradeOptions& options, bool merging) {
    if (options.knobs) {
        std::vector<trade::Tier> own;
        std::string problem = read_own_tiers(options, own);
        if (problem.empty())
            print("{}", trade::knob_table(own));
        return problem.empty() ? 0 : refuse(problem);
    }
    if (merging) {
        const trade::SweepResult swept = trade::merge_folders(options.parts, options.out);
        return swept.problem.empty() ? report(options, swept, true) : refuse(swept.problem);
    }
    Corpus corpus;
    trade::Sweep sweep;
    std::string problem = read_setting(options, sweep);
    if (problem.empty())
        problem = read_targets(options, sweep);
    if (problem.empty())
        problem = corpus.add(options);
    if (!problem.empty())
        return refuse(problem);
    sweep.programs = corpus.programs;
    if (!options.own_tiers.empty() && std::any_of(sweep.programs.begin(), sweep.programs.end(),
                                                  [](const auto& p) { return p.recording != nullptr; }))
        return refuse("--tier is for scenes and models: a trace or a program takes exact, balanced or fast");
    if (options.bytes)
        return print_bytes(sweep);
    if (options.instructions || is_asked(options, trade::host_target))
        sweep.count = counter(options);
    sweep.count_board = board_counter(options, sweep.setting);
    if (isatty(STDERR_FILENO) != 0)
        sweep.progress = [](const trade::Job& job) {
            tell(fmt::format("\r\033[K{} of {}: {} in {}{}", job.number + 1, job.of, job.scene,
                             job.format.name, job.number + 1 == job.of ? "\r\033[K" : ""));
        };
    const trade::SweepResult swept = trade::sweep(sweep, options.out);
    return swept.problem.empty() ? report(options, swept, options.shard.empty()) : refuse(swept.problem);
}

} // namespace spangle::cli
