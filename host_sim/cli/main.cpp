// spangle: draws scenes and models on simulated boards, and tells what the frames cost.
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "boards/scenes/scene.hpp"
#include "gl/context/version.hpp"
#include "host_sim/capture/names.hpp"
#include "host_sim/cli/bake.hpp"
#include "host_sim/cli/bench.hpp"
#include "host_sim/cli/bringup.hpp"
#include "host_sim/cli/bus_options.hpp"
#include "host_sim/cli/exec.hpp"
#include "host_sim/cli/formats.hpp"
#include "host_sim/cli/profile.hpp"
#include "host_sim/cli/run.hpp"
#include "host_sim/cli/samples.hpp"
#include "host_sim/cli/say.hpp"
#include "host_sim/cli/size.hpp"
#include "host_sim/cli/trade.hpp"
#include "host_sim/trade/knobs.hpp"
#include <spangle/boards/boards.hpp>

namespace {

using namespace spangle;
using cli::Precision;

using cli::refuse;

std::vector<std::string> precision_names() {
    std::vector<std::string> out;
    for (const names::Precision& p : names::precisions)
        out.emplace_back(p.name);
    return out;
}

Precision precision_of(const std::string& name) {
    const names::Precision* const found = names::find(names::precisions, name);
    return found != nullptr ? static_cast<Precision>(found->value) : Precision::exact;
}

/// The name of the most accurate tier of this build.
const char* first_tier() {
    constexpr unsigned exact = 1, balanced = 2;
    return (SPANGLE_TIER_SET & exact) != 0      ? "exact"
           : (SPANGLE_TIER_SET & balanced) != 0 ? "balanced"
                                                : "fast";
}

/// The files that a run writes. They are opened before anything is drawn.
struct RunFiles {
    sim::Output shot, difference;

    std::string open(const cli::RunOptions& options) {
        std::string problem = cli::open(shot, "--shot", options.shot);
        if (problem.empty())
            problem = cli::open(difference, "--difference", options.difference);
        if (problem.empty())
            problem = cli::claim_output("--vcd", options.vcd);
        if (problem.empty() && options.json && !cli::claiming_option().empty())
            problem = "--json prints on standard output, which " + cli::claiming_option() +
                      " takes; name a file there";
        return problem;
    }
    std::string write(const cli::RunResult& result) {
        const std::string problem = shot.is_open() ? cli::finish(shot, result.picture) : "";
        return !problem.empty() || !difference.is_open() ? problem
                                                         : cli::finish(difference, result.difference);
    }
};

int run_command(cli::RunOptions options, const std::string& size, const std::string& dither) {
    if (options.scene.empty() == options.model.empty())
        return refuse(fmt::format("run takes a scene or --model FILE{}; `spangle scenes` lists the scenes",
                                  options.scene.empty() ? "" : ", not both"));
    if (!size.empty())
        if (const std::string problem = cli::read_size(size, options.width, options.height); !problem.empty())
            return refuse(problem);
    options.dither = dither == "on";
    options.compare = options.compare || !options.difference.empty();
    RunFiles files;
    if (const std::string problem = files.open(options); !problem.empty())
        return refuse(problem);
    const cli::RunResult result = cli::run(options);
    if (!result.error.empty())
        return refuse(result.error);
    cli::tell(result.notes + result.violations);
    if (!result.unwritten.empty())
        return refuse(result.unwritten, cli::not_done);
    if (const std::string problem = files.write(result); !problem.empty())
        return refuse(problem, cli::not_done);
    if (options.json)
        cli::print_text(cli::to_json(result.report));
    else if (options.stats || options.compare || options.shot.empty())
        cli::print_text(cli::to_table(result.report));
    if (!options.json && !options.shot.empty())
        cli::print("picture: {}\n", options.shot);
    if (!options.json && !options.difference.empty())
        cli::print("difference: {}\n", options.difference);
    return 0;
}

int list_scenes() {
    for (const scenes::Scene& scene : scenes::all())
        cli::print("{:<6}{}\n", scene.id, scene.title);
    return 0;
}

int list_boards() {
    for (const hal::Board* board : boards::all)
        cli::print("{:<18}{}\n", board->name, board->summary);
    return 0;
}

/// Draws the gears, the torus with all features on, and a model from elsewhere, on one board.
int demo(const std::string& folder) {
    std::error_code problem;
    std::filesystem::create_directories(folder, problem);
    if (problem)
        return refuse("cannot make folder '" + folder + "': " + problem.message());
    struct Item {
        const char *scene, *model, *file;
    };
    const Item items[] = {{"S5", "", "gears.png"},
                          {"S9", "", "torus.png"},
                          {"", "/usr/share/assimp/models/Collada/duck.dae", "model.png"}};
    for (const Item& item : items) {
        cli::RunOptions options;
        options.scene = item.scene;
        options.model = item.model;
        options.frames = 20;
        options.compare = true;
        const cli::RunResult result = cli::run(options);
        if (!result.error.empty())
            return refuse(result.error);
        const std::string path = folder + "/" + item.file;
        if (const std::string failed = sim::write_png(result.picture, path); !failed.empty())
            return refuse(failed, cli::not_done);
        cli::print("{}{}  picture     {}\n\n", result.violations, cli::to_table(result.report), path);
        sim::standard_output().flush();
    }
    return 0;
}

/// Draws a picture for the documents and writes it to a file.
int draw_sheet(std::string (&draw)(sim::Image&), const std::string& path) {
    sim::Output file;
    if (const std::string problem = cli::open(file, "--shot", path); !problem.empty())
        return refuse(problem);
    sim::Image sheet;
    if (const std::string problem = draw(sheet); !problem.empty())
        return refuse(problem);
    if (const std::string problem = cli::finish(file, sheet); !problem.empty())
        return refuse(problem, cli::not_done);
    cli::print("picture: {}\n", path);
    return 0;
}

/// The whole program, without the handling of unforeseen exceptions.
int spangle_main(int argc, char** argv) {
    CLI::App app{"Spangle: OpenGL for small display boards. Draws scenes and models on simulated boards."};
    app.require_subcommand(1);
    app.set_version_flag("--version", "spangle " SPANGLE_VERSION);
    app.name("spangle");
    app.failure_message([&](const CLI::App*, const CLI::Error& error) {
        const auto commands = app.get_subcommands();
        if (commands.empty() && argc > 1 && argv[1][0] != '-')
            return fmt::format("spangle: no command '{}'; see spangle --help\n", argv[1]);
        return fmt::format("spangle: {}; see spangle {}--help\n", error.what(),
                           commands.empty() ? "" : commands.front()->get_name() + " ");
    });

    app.add_subcommand("scenes", "list the scenes");
    app.add_subcommand("boards", "list the simulated boards");
    bool bench_json = false;
    CLI::App* const bench_command =
        app.add_subcommand("bench", "time every scene in each precision: median and quartiles");
    bench_command->add_flag("--json", bench_json, "print the figures as one JSON object");
    std::string sheet;
    CLI::App* const formats_command =
        app.add_subcommand("formats", "one scene on every format of surfaces, as a picture");
    formats_command->add_option("--shot", sheet, "the PNG to write")->required();
    CLI::App* const samples_command = app.add_subcommand(
        "samples", "edges and fading things with one sample, with four, and antialiased, as a picture");
    samples_command->add_option("--shot", sheet, "the PNG to write")->required();
    std::string folder = "out";
    CLI::App* const demo_command =
        app.add_subcommand("demo", "gears, a torus and a model on the ILI9341, with pictures and figures");
    demo_command->add_option("--out", folder, "folder for the pictures")->capture_default_str();

    cli::RunOptions options;
    std::string size, dither = "on", precision = first_tier(), knobs;
    CLI::App* const run = app.add_subcommand("run", "draw a scene or a model");
    run->add_option("scene", options.scene, "id of a scene, see `spangle scenes`");
    run->add_option("--model", options.model, "a model file instead: any format libassimp reads");
    CLI::Option* const board = cli::add_bus_options(*run, options.bus);
    run->add_option("--frames", options.frames, "how many frames")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    run->add_option("--size", size, "an off-screen picture of WIDTHxHEIGHT instead of a board")
        ->excludes(board)
        ->excludes("--spidev")
        ->excludes("--i2c")
        ->excludes("--ftdi")
        ->excludes("--gud");
    run->add_option("--precision", precision,
                    "exact, balanced, fast; double: the reference; shadow, shadow-balanced, shadow-fast: the "
                    "tiers with "
                    "every stage held against a double beside it, and an error report")
        ->check(CLI::IsMember(precision_names()))
        ->capture_default_str();
    run->add_option("--knobs", knobs,
                    "a tier of your own, BASE,KNOB=VALUE,...; `spangle trade --knobs` lists the knobs")
        ->excludes("--precision");
    run->add_option("--dither", dither, "GL_DITHER")
        ->check(CLI::IsMember({"on", "off"}))
        ->capture_default_str();
    run->add_option("--tear-free", options.present.tear_free,
                    "presents lead or lag the beam: te waits for the tearing-effect line, poll reads the "
                    "scanned line (45h); landscape is sent in the order of the scan")
        ->check(CLI::IsMember({"off", "te", "poll"}))
        ->capture_default_str()
        ->excludes("--size");
    run->add_option(
           "--pacing", options.present.pacing,
           "a frame while the last is still on the wire: waits, is dropped, or is merged with the next")
        ->check(CLI::IsMember({"block", "drop", "coalesce"}))
        ->capture_default_str()
        ->excludes("--size");
    run->add_option("--buffers", options.present.buffers,
                    "2: the next frame is drawn while the last is on the wire")
        ->check(CLI::Range(1, 2))
        ->excludes("--size");
    run->add_option("--draw-ms", options.present.draw_ms,
                    "what drawing takes the board's processor, in virtual time")
        ->check(CLI::Range(0, 10000))
        ->capture_default_str()
        ->excludes("--size");
    run->add_flag("--row-hash", options.present.row_hash,
                  "cells of 16x1 pixels that were drawn again as they were are not sent")
        ->excludes("--size");
    std::string bands = "redraw";
    run->add_option("--band-height", options.bands.height,
                    "rows that memory holds: frames are drawn band by band; 0: whole")
        ->check(CLI::Range(0, 4096))
        ->capture_default_str()
        ->excludes("--size");
    run->add_option("--bands", bands, "bands are drawn from a record, or the scene is drawn again for each")
        ->check(CLI::IsMember({"record", "redraw"}))
        ->capture_default_str()
        ->needs("--band-height");
    run->add_option("--record-bytes", options.bands.record_bytes, "memory for the record")
        ->check(CLI::Range(1, 1 << 25))
        ->capture_default_str()
        ->needs("--bands");
    run->add_option(
        "--shot", options.shot,
        "write the last frame as PNG: the simulated glass, or what was drawn; -: on standard output");
    run->add_flag("--compare", options.compare, "draw with the double reference too: error figures");
    run->add_option("--difference", options.difference,
                    "with --compare: write a picture of where the last frame is another one");
    run->add_flag("--stats", options.stats, "print the figures, memory among them");
    run->add_option("--vcd", options.vcd, "record the simulated bus for GTKWave, PulseView or sigrok");
    run->add_option(
           "--vcd-limit", options.vcd_limit,
           "most bytes of that file, as 64MB; where it ends earlier than the run, the run says so (512MB)")
        ->transform(CLI::AsSizeValue(false))
        ->check(CLI::PositiveNumber)
        ->needs("--vcd");
    run->add_flag(
        "--window", options.window,
        "show the glass, its memory and the bus counters until the window is closed; after --frames the "
        "scene goes on, and is neither reported nor recorded");
    run->add_flag("--json", options.json, "print the figures as one JSON object");

    cli::BringupOptions bringup;
    CLI::App* const probe = app.add_subcommand("probe", "ask the panel on a bus who it is");
    cli::add_bus_options(*probe, bringup.bus);
    CLI::App* const card = app.add_subcommand("card", "show the test card");
    cli::add_bus_options(*card, bringup.bus);
    card->add_option("--shot", bringup.shot, "write the simulated glass as PNG");
    card->add_option("--wrong", bringup.wrong, "with one setting that is not as it should be");
    card->add_flag("--list-wrong", bringup.list_wrong, "list these settings, and what mends each");
    CLI::App* const wizard =
        app.add_subcommand("wizard", "ask what the test card looks like, print the board's definition");
    cli::add_bus_options(*wizard, bringup.bus);
    wizard->add_option("--glass", bringup.glass, "size of the glass, WIDTHxHEIGHT, as it is held upright");
    wizard->add_option("--shot", bringup.shot, "write the simulated glass as PNG, for each card");

    cli::ExecOptions to_exec, to_replay;
    CLI::App* const exec_command = cli::add_exec(app, to_exec);
    CLI::App* const replay_command = cli::add_replay(app, to_replay);

    cli::ProfileOptions to_profile;
    CLI::App* const profile_command = cli::add_profile(app, to_profile);
    to_profile.program = std::find(argv, argv + argc, std::string_view("--")) != argv + argc;

    cli::BakeOptions to_bake;
    CLI::App* const bake = cli::add_bake(app, to_bake);

    cli::TradeOptions to_trade;
    CLI::App* const trade = cli::add_trade(app, to_trade);
    // Words after -- belong to the program that is measured, not to spangle.
    if (argc > 1 && argv[1] == std::string_view("trade")) {
        char** const dashes = std::find(argv, argv + argc, std::string_view("--"));
        if (dashes != argv + argc)
            to_trade.program.assign(dashes + 1, argv + argc);
        to_trade.runs_program = dashes != argv + argc;
        argc = static_cast<int>(dashes - argv);
    }

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        std::ostringstream words, problems;
        const int status = app.exit(error, words, problems);
        cli::print_text(words.str());
        cli::tell(problems.str());
        return status == 0 ? 0 : cli::bad_input;
    }
    if (app.got_subcommand("scenes"))
        return list_scenes();
    if (app.got_subcommand("boards"))
        return list_boards();
    if (app.got_subcommand(bench_command))
        return cli::bench(bench_json);
    if (app.got_subcommand(formats_command))
        return draw_sheet(cli::draw_formats, sheet);
    if (app.got_subcommand(samples_command))
        return draw_sheet(cli::draw_samples, sheet);
    if (app.got_subcommand("demo"))
        return demo(folder);
    if (app.got_subcommand(exec_command))
        return cli::exec(to_exec);
    if (app.got_subcommand(replay_command))
        return cli::replay(to_replay);
    if (app.got_subcommand(profile_command))
        return cli::profile(to_profile);
    if (app.got_subcommand(bake))
        return cli::bake(to_bake);
    if (app.got_subcommand(trade))
        return cli::trade(to_trade, trade->got_subcommand("merge"));
    if (app.got_subcommand(probe))
        return cli::probe(bringup);
    if (app.got_subcommand(card))
        return cli::card(bringup);
    if (app.got_subcommand(wizard))
        return cli::wizard(bringup);
    options.precision = precision_of(precision);
    if (!knobs.empty()) {
        trade::Tier tier;
        if (const std::string problem = trade::read_knobs(knobs, tier); !problem.empty())
            return refuse("--knobs: " + problem);
        options.precision = precision_of(tier.name);
        options.knobs = tier.knobs;
    }
    options.bands.record = bands == "record";
    return run_command(options, size, dither);
}

/// Opens /dev/null for each standard stream that is closed. Otherwise the next file opened would take the
/// stream's number, and what is written to the stream.
void hold_standard_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) < 0)
            (void)open("/dev/null", O_RDONLY); // read-only, so that writing to the stream is an error
}

} // namespace

/// Ignores the signals for a reader that goes away and for a file that may not grow, so that both are
/// reported as errors like any other.
int main(int argc, char** argv) {
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    hold_standard_streams();
    int status = cli::bad_input;
    try {
        status = spangle_main(argc, argv);
    } catch (const std::exception& problem) {
        refuse(problem.what());
    }
    const std::string lost = sim::standard_output().commit();
    return lost.empty() || status != 0 ? status : refuse(lost, cli::not_done);
}
