#include "host_sim/cli/exec.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "host_sim/bringup/attach.hpp"
#include "host_sim/cli/bus_options.hpp"
#include "host_sim/cli/pair.hpp"
#include "host_sim/cli/report.hpp"
#include "host_sim/cli/say.hpp"
#include "host_sim/cli/size.hpp"

namespace spangle::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char* no_board = "none";

/// Reads the report of the drop-in pair: names and values, a line each (host_sim/dropin/stage.cpp), then
/// violations as text.
std::map<std::string, std::string> read_figures(const fs::path& path, std::string& violations) {
    std::map<std::string, std::string> out;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        const std::size_t blank = line.find(' ');
        if (line == "violations") {
            violations.assign(std::istreambuf_iterator<char>(file), {});
            break;
        }
        if (blank != std::string::npos)
            out[line.substr(0, blank)] = line.substr(blank + 1);
    }
    return out;
}

/// Sets the variables that the drop-in pair reads. docs/programs.md lists these variables.
void set_environment(const ExecOptions& options, const std::string& report) {
    const bringup::BusOptions& bus = options.bus;
    const auto number = [](std::uint32_t value) { return value != 0 ? std::to_string(value) : ""; };
    pair::set("SPANGLE_BOARD", bus.board == no_board ? "" : bus.board_name());
    pair::set("SPANGLE_SPIDEV", bus.spidev);
    pair::set("SPANGLE_DC", bus.dc);
    pair::set("SPANGLE_RESET", bus.reset);
    pair::set("SPANGLE_LIGHT", bus.light);
    pair::set("SPANGLE_TE", bus.te);
    pair::set("SPANGLE_I2C", bus.i2c);
    pair::set("SPANGLE_ADDRESS", bus.i2c.empty() ? "" : std::to_string(bus.address));
    pair::set("SPANGLE_FTDI", bus.ftdi ? "1" : "");
    pair::set("SPANGLE_GUD", bus.gud ? "1" : "");
    pair::set("SPANGLE_USB", bus.usb_file);
    pair::set("SPANGLE_HZ", number(bus.hz));
    pair::set("SPANGLE_READ_HZ", number(bus.read_hz));
    pair::set("SPANGLE_PRECISION", options.precision);
    pair::set("SPANGLE_SIZE", options.size);
    pair::set("SPANGLE_FORMAT", options.format);
    pair::set("SPANGLE_SHOT", options.shot.empty() || options.shot == "-"
                                  ? options.shot
                                  : fs::absolute(options.shot).string());
    pair::set("SPANGLE_FRAMES", options.frames != 0 ? std::to_string(options.frames) : "");
    pair::set("SPANGLE_REPORT", report);
}

std::uint64_t number(const std::map<std::string, std::string>& figures, const char* name) {
    const auto at = figures.find(name);
    return at == figures.end() ? 0 : std::strtoull(at->second.c_str(), nullptr, 10);
}

Report report_of(const ExecOptions& options, const std::map<std::string, std::string>& figures) {
    Report out;
    const std::uint64_t pixels = number(figures, "width") * number(figures, "height");
    const auto board = figures.find("board"), hash = figures.find("picture_hash");
    out.scene = fs::path(options.program[0]).filename().string();
    out.board = board != figures.end()
                    ? board->second
                    : fmt::format("off-screen {}x{}", number(figures, "width"), number(figures, "height"));
    out.precision = options.precision;
    out.frames = static_cast<int>(number(figures, "frames"));
    out.triangles = number(figures, "triangles");
    out.fragments = number(figures, "fragments");
    out.bus_bytes = number(figures, "bus_bytes");
    out.bus_pixel_bytes = number(figures, "bus_pixel_bytes");
    out.bus_commands = number(figures, "bus_commands");
    const std::uint64_t bits = board != figures.end() ? number(figures, "wire_bits") : 16;
    out.full_frame_bytes = (pixels * bits + 7) / 8;
    if (const auto where = figures.find("where"); where != figures.end()) {
        out.board += " at " + where->second;
        const double shown = static_cast<double>(number(figures, "shown_ns")) * 1e-9;
        out.measured_fps = shown > 0.0 ? out.frames / shown : 0.0;
    }
    const double seconds = static_cast<double>(number(figures, "busy_ns")) * 1e-9;
    out.fps_at_bus_clock = seconds > 0.0 ? out.frames / seconds : 0.0;
    out.picture_hash = hash != figures.end() ? hash->second : "";
    return out;
}

} // namespace

namespace {

/// Why the options cannot be used, found before anything is run; empty if they can.
std::string flaw(const ExecOptions& options) {
    const bringup::BusOptions& bus = options.bus;
    if (int width = 0, height = 0; !options.size.empty())
        if (std::string problem = read_size(options.size, width, height); !problem.empty())
            return problem;
    if (bus.board == no_board)
        return bus.real() ? "--board none shows nothing; leave it out, or the real display" : "";
    const hal::Board* const board = bringup::find_board(bus.board_name());
    return board == nullptr ? "no board '" + bus.board + "'; `spangle boards` lists them, none is none"
                            : bringup::mismatch(bus, *board);
}

} // namespace

int exec(const ExecOptions& options) {
    if (const std::string problem = flaw(options); !problem.empty())
        return refuse(problem);
    if (const std::string problem = pair::use(); !problem.empty())
        return refuse(problem);
    const pair::Folder folder;
    if (folder.path().empty())
        return refuse(pair::Folder::problem(), not_done);
    const fs::path report = folder.path() / "report";
    set_environment(options, report.string());
    const int status = pair::run(options.program);
    std::string violations;
    const auto figures = read_figures(report, violations);
    tell(violations);
    if (figures.empty()) {
        if (status == 0)
            tell("spangle: " + options.program[0] + " showed no frame\n");
        return status;
    }
    const Report figured = report_of(options, figures);
    if (options.json)
        print_text(to_json(figured));
    else if (options.stats || options.shot.empty())
        print_text(to_table(figured));
    if (!options.json && !options.shot.empty() && options.shot != "-")
        print("picture: {}\n", options.shot);
    return status;
}

int replay(ExecOptions options) {
    const std::string trace = options.program[0];
    if (const std::string problem = pair::trace_problem(trace); !problem.empty())
        return refuse(problem);
    options.program = pair::retrace(trace);
    return exec(options);
}

namespace {

void add_common(CLI::App& command, ExecOptions& options) {
    add_bus_options(command, options.bus, "; none: no board");
    command.add_option("--precision", options.precision, "exact, balanced, fast; double: the reference")
        ->check(CLI::IsMember({"exact", "balanced", "fast", "double"}))
        ->capture_default_str();
    command
        .add_option("--format", options.format,
                    "pixels that windows have: rgba, which presents turn into what the panel takes; panel: "
                    "the panel's own")
        ->check(CLI::IsMember({"rgba", "panel"}))
        ->capture_default_str();
    command.add_option("--shot", options.shot,
                       "write the glass as PNG at the end, or what a real one was sent");
    command.add_option("--frames", options.frames, "end the program after so many frames")
        ->check(CLI::Range(1, 1000000000));
    command.add_flag("--stats", options.stats, "print the figures, with --shot too");
    command.add_flag("--json", options.json, "print the figures as one JSON object");
}

} // namespace

CLI::App* add_exec(CLI::App& app, ExecOptions& options) {
    CLI::App* const command =
        app.add_subcommand("exec", "run a program of OpenGL, unmodified, on a simulated board or a real one");
    add_common(*command, options);
    command->add_option("--size", options.size, "WIDTHxHEIGHT of its windows, instead of the board's");
    command->add_option("program", options.program, "the program and its arguments, after --")->required();
    return command;
}

CLI::App* add_replay(CLI::App& app, ExecOptions& options) {
    CLI::App* const command = app.add_subcommand(
        "replay",
        "replay a trace of apitrace on a simulated board or a real one (needs Debian's package apitrace)");
    add_common(*command, options);
    command->add_option("trace", options.program, "the trace")->required()->expected(1);
    return command;
}

} // namespace spangle::cli
