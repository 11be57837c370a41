// spangle: draws scenes and models on simulated boards and says what it cost.
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "boards/scenes/scene.hpp"
#include "host_sim/cli/bake.hpp"
#include "host_sim/cli/bringup.hpp"
#include "host_sim/cli/formats.hpp"
#include "host_sim/cli/run.hpp"
#include "host_sim/cli/samples.hpp"
#include "host_sim/cli/session.hpp"
#include <spangle/boards/boards.hpp>

namespace {

using namespace spangle;
using cli::Precision;

constexpr int bad_input = 2;

/// One line on standard error, exit status 2.
int refuse(const std::string& why) {
    fmt::print(stderr, "spangle: {}\n", why);
    return bad_input;
}

struct NamedPrecision {
    const char* name;
    Precision precision;
};
constexpr NamedPrecision precisions[] = {{"exact", Precision::exact},
                                         {"balanced", Precision::balanced},
                                         {"fast", Precision::fast},
                                         {"double", Precision::reference},
                                         {"shadow", Precision::shadow},
                                         {"shadow-balanced", Precision::shadow_balanced},
                                         {"shadow-fast", Precision::shadow_fast}};

std::vector<std::string> precision_names() {
    std::vector<std::string> names;
    for (const NamedPrecision& p : precisions)
        names.emplace_back(p.name);
    return names;
}

Precision precision_of(const std::string& name) {
    for (const NamedPrecision& p : precisions)
        if (name == p.name)
            return p.precision;
    return Precision::exact;
}

/// "320x240", both sides 1 to 2048.
std::string read_size(const std::string& text, int& width, int& height) {
    char rest = 0;
    if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) != 2 || width < 1 || height < 1 ||
        width > 2048 || height > 2048)
        return "--size takes WIDTHxHEIGHT, each 1 to 2048, not '" + text + "'";
    return "";
}

/// A picture file can be written there: asked before anything is drawn.
std::string check_writable(const std::string& path) {
    if (path.empty())
        return "";
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    std::error_code ignored;
    if (!folder.empty() && !std::filesystem::is_directory(folder, ignored))
        return "cannot write '" + path + "': there is no folder " + folder.string();
    const std::filesystem::path probe = path + ".part";
    std::FILE* const file = std::fopen(probe.c_str(), "wb");
    if (file == nullptr)
        return "cannot write '" + path + "': " + std::strerror(errno);
    std::fclose(file);
    std::filesystem::remove(probe, ignored);
    return "";
}

std::string difference_path(const std::string& shot) {
    const std::filesystem::path p =
        shot.empty() ? std::filesystem::path("difference.png") : std::filesystem::path(shot);
    return shot.empty() ? p.string() : (p.parent_path() / (p.stem().string() + "-difference.png")).string();
}

int run_command(cli::RunOptions options, const std::string& size, const std::string& dither) {
    if (options.scene.empty() == options.model.empty())
        return refuse(fmt::format("run takes a scene or --model FILE{}; `spangle scenes` lists the scenes",
                                  options.scene.empty() ? "" : ", not both"));
    if (!size.empty())
        if (const std::string problem = read_size(size, options.width, options.height); !problem.empty())
            return refuse(problem);
    options.dither = dither == "on";
    for (const std::string& path :
         {options.shot, options.compare ? difference_path(options.shot) : std::string()})
        if (const std::string problem = check_writable(path); !problem.empty())
            return refuse(problem);
    const cli::RunResult result = cli::run(options);
    if (!result.error.empty())
        return refuse(result.error);
    if (!options.shot.empty())
        if (const std::string problem = sim::write_png(result.picture, options.shot); !problem.empty())
            return refuse(problem);
    if (options.compare)
        if (const std::string problem = sim::write_png(result.difference, difference_path(options.shot));
            !problem.empty())
            return refuse(problem);
    fmt::print(stderr, "{}{}", result.notes, result.violations);
    if (options.json)
        fmt::print("{}", cli::to_json(result.report));
    else if (options.stats || options.compare || options.shot.empty())
        fmt::print("{}", cli::to_table(result.report));
    if (!options.json && !options.shot.empty())
        fmt::print("picture: {}\n", options.shot);
    if (!options.json && options.compare)
        fmt::print("difference: {}\n", difference_path(options.shot));
    return 0;
}

int list_scenes() {
    for (const scenes::Scene& scene : scenes::all())
        fmt::print("{:<6}{}\n", scene.id, scene.title);
    return 0;
}

int list_boards() {
    for (const hal::Board* board : boards::all)
        fmt::print("{:<18}{}\n", board->name, board->summary);
    return 0;
}

/// Mean time of a frame; the scene is warm.
double microseconds_per_frame(const scenes::Scene& scene, Precision precision) {
    cli::Session session;
    if (!session.open_picture(320, 240, precision).empty())
        return 0.0;
    scene.setup(session.width(), session.height());
    using Clock = std::chrono::steady_clock;
    for (int f = 0; f < 3; ++f)
        scene.draw(f);
    const auto start = Clock::now();
    int frames = 0;
    for (; Clock::now() - start < std::chrono::milliseconds(150); ++frames)
        scene.draw(frames);
    return std::chrono::duration<double, std::micro>(Clock::now() - start).count() / frames;
}

int bench() {
    fmt::print("Frames of 320x240 off screen, dithered, in this run; `./dev bench` holds them against Mesa "
               "and counts instructions.\n");
    fmt::print("{:<6}{:>14}{:>22}{:>18}\n", "scene", "exact us", "balanced, x faster", "fast, x faster");
    for (const scenes::Scene& scene : scenes::all()) {
        const double exact = microseconds_per_frame(scene, Precision::exact);
        fmt::print("{:<6}{:>14.1f}{:>22.2f}{:>18.2f}\n", scene.id, exact,
                   exact / microseconds_per_frame(scene, Precision::balanced),
                   exact / microseconds_per_frame(scene, Precision::fast));
    }
    return 0;
}

/// The gears, the torus with everything on, and a model nobody here made, on one board.
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
            return refuse(failed);
        fmt::print("{}{}  picture     {}\n\n", result.violations, cli::to_table(result.report), path);
    }
    return 0;
}

/// A picture of a document.
int draw_sheet(std::string (&draw)(sim::Image&), const std::string& path) {
    sim::Image sheet;
    if (const std::string problem = draw(sheet); !problem.empty())
        return refuse(problem);
    if (const std::string problem = sim::write_png(sheet, path); !problem.empty())
        return refuse(problem);
    fmt::print("picture: {}\n", path);
    return 0;
}

/// What names the bus a panel hangs on.
void add_bus_options(CLI::App& command, bringup::BusOptions& bus) {
    command.add_option("--board", bus.board, "the simulated board; with a real bus: whose panel it is like")
        ->capture_default_str();
    command.add_option("--spidev", bus.spidev, "a real panel behind this spidev");
    command.add_option("--dc", bus.dc, "its D/C line, CHIP:NUMBER; none: 3-wire");
    command.add_option("--reset", bus.reset, "its reset line");
    command.add_option("--light", bus.light, "its backlight's line");
    command.add_flag("--ftdi", bus.ftdi, "a real panel at an FT232H");
    command.add_option("--usb", bus.usb_file, "that adapter's file in /dev/bus/usb");
    command.add_option("--hz", bus.hz, "write clock, instead of the board's");
    command.add_option("--read-hz", bus.read_hz, "read clock, instead of the board's");
}

/// The program, but for what nobody can foresee.
int spangle_main(int argc, char** argv) {
    CLI::App app{"Spangle: OpenGL for small display boards. Draws scenes and models on simulated boards."};
    app.require_subcommand(1);
    app.set_version_flag("--version", "spangle 0.1.0");
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
    app.add_subcommand("bench", "time every scene in each precision");
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
    std::string size, dither = "on", precision = "exact";
    CLI::App* const run = app.add_subcommand("run", "draw a scene or a model");
    run->add_option("scene", options.scene, "id of a scene, see `spangle scenes`");
    run->add_option("--model", options.model, "a model file instead: any format libassimp reads");
    auto* const board =
        run->add_option("--board", options.board, "the simulated board")->capture_default_str();
    run->add_option("--frames", options.frames, "how many frames")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    run->add_option("--size", size, "an off-screen picture of WIDTHxHEIGHT instead of a board")
        ->excludes(board);
    run->add_option("--precision", precision,
                    "exact, balanced, fast; double: the reference; shadow, shadow-balanced, shadow-fast: the "
                    "tiers with "
                    "every stage held against a double beside it, and an error report")
        ->check(CLI::IsMember(precision_names()))
        ->capture_default_str();
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
    run->add_option("--shot", options.shot, "write the last frame as PNG");
    run->add_flag("--compare", options.compare,
                  "draw with the double reference too: error figures and a difference picture");
    run->add_flag("--stats", options.stats, "print the figures, memory among them");
    run->add_option("--vcd", options.vcd, "record the bus for GTKWave or PulseView");
    run->add_flag("--window", options.window, "show the glass, its memory and the bus counters");
    run->add_flag("--json", options.json, "print the figures as one JSON object");

    cli::BringupOptions bringup;
    CLI::App* const probe = app.add_subcommand("probe", "ask the panel on a bus who it is");
    add_bus_options(*probe, bringup.bus);
    CLI::App* const card = app.add_subcommand("card", "show the test card");
    add_bus_options(*card, bringup.bus);
    card->add_option("--shot", bringup.shot, "write the simulated glass as PNG");
    card->add_option("--wrong", bringup.wrong, "with one setting that is not as it should be");
    card->add_flag("--list-wrong", bringup.list_wrong, "list these settings, and what mends each");
    CLI::App* const wizard =
        app.add_subcommand("wizard", "ask what the test card looks like, print the board's definition");
    add_bus_options(*wizard, bringup.bus);
    wizard->add_option("--glass", bringup.glass, "size of the glass, WIDTHxHEIGHT, as it is held upright");
    wizard->add_option("--shot", bringup.shot, "write the simulated glass as PNG, for each card");

    cli::BakeOptions to_bake;
    CLI::App* const bake = cli::add_bake(app, to_bake);

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : bad_input;
    }
    if (app.got_subcommand("scenes"))
        return list_scenes();
    if (app.got_subcommand("boards"))
        return list_boards();
    if (app.got_subcommand("bench"))
        return bench();
    if (app.got_subcommand(formats_command))
        return draw_sheet(cli::draw_formats, sheet);
    if (app.got_subcommand(samples_command))
        return draw_sheet(cli::draw_samples, sheet);
    if (app.got_subcommand("demo"))
        return demo(folder);
    if (app.got_subcommand(bake)) {
        const std::string problem = cli::bake(to_bake);
        return problem.empty() ? 0 : refuse(problem);
    }
    if (app.got_subcommand(probe))
        return cli::probe(bringup);
    if (app.got_subcommand(card))
        return cli::card(bringup);
    if (app.got_subcommand(wizard))
        return cli::wizard(bringup);
    options.precision = precision_of(precision);
    options.bands.record = bands == "record";
    return run_command(options, size, dither);
}

} // namespace

int main(int argc, char** argv) try {
    return spangle_main(argc, argv);
} catch (const std::exception& problem) {
    std::fprintf(stderr, "spangle: %s\n", problem.what());
    return bad_input;
}
