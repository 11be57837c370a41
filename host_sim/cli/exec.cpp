#include "host_sim/cli/exec.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>

#include <sys/wait.h>
#include <unistd.h>

#include "host_sim/bringup/attach.hpp"
#include "host_sim/cli/report.hpp"
#include "host_sim/cli/say.hpp"

namespace spangle::cli {

namespace {

namespace fs = std::filesystem;

constexpr int no_program = 127, could_not_run = 126, of_signals = 128; ///< as shells have them
constexpr const char* core_library = "libspangle-dropin.so.0";

/// The folder of the pair: beside this program where it was built, below lib where it was installed. Empty:
/// neither.
fs::path pair_folder() {
    if (const char* const named = std::getenv("SPANGLE_DROPIN"); named != nullptr && *named != '\0')
        return fs::path(named);
    std::error_code ignored;
    const fs::path here = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    for (const fs::path& folder : {here / "dropin", here / ".." / SPANGLE_LIBDIR / "spangle" / "dropin"})
        if (fs::exists(folder / core_library, ignored))
            return fs::weakly_canonical(folder, ignored);
    return {};
}

/// A file that is gone when this is.
class ReportFile {
  public:
    ReportFile() {
        std::string name = (fs::temp_directory_path() / "spangle-XXXXXX").string();
        const int file = mkstemp(name.data());
        if (file < 0)
            return;
        close(file);
        path_ = name;
    }
    ~ReportFile() {
        std::error_code ignored;
        if (!path_.empty())
            fs::remove(path_, ignored);
    }
    ReportFile(const ReportFile&) = delete;
    ReportFile& operator=(const ReportFile&) = delete;
    const std::string& path() const { return path_; }

    /// Names and values, a line each, as the pair writes them (host_sim/dropin/stage.cpp); the rest is text.
    std::map<std::string, std::string> read(std::string& violations) const {
        std::map<std::string, std::string> out;
        std::ifstream file(path_);
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

  private:
    std::string path_;
};

void set(const char* variable, const std::string& value) {
    if (value.empty())
        unsetenv(variable);
    else
        setenv(variable, value.c_str(), 1);
}

/// What the pair reads; docs/programs.md lists the variables.
void set_environment(const ExecOptions& options, const fs::path& pair, const std::string& report) {
    const char* const old = std::getenv("LD_LIBRARY_PATH");
    set("LD_LIBRARY_PATH", pair.string() + (old != nullptr && *old != '\0' ? ":" + std::string(old) : ""));
    set("SPANGLE_BOARD", options.board == "none" ? "" : options.board);
    set("SPANGLE_PRECISION", options.precision);
    set("SPANGLE_SIZE", options.size);
    set("SPANGLE_FORMAT", options.format);
    set("SPANGLE_SHOT", options.shot.empty() ? "" : fs::absolute(options.shot).string());
    set("SPANGLE_FRAMES", options.frames != 0 ? std::to_string(options.frames) : "");
    set("SPANGLE_REPORT", report);
}

/// The program in a process of its own, to its end; 127 and 126 as of a shell.
int run_program(const std::vector<std::string>& program) {
    std::vector<char*> arguments;
    arguments.reserve(program.size() + 1);
    for (const std::string& word : program)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const pid_t child = fork();
    if (child < 0)
        return could_not_run;
    if (child == 0) {
        std::signal(SIGPIPE, SIG_DFL);
        std::signal(SIGXFSZ, SIG_DFL);
        execvp(arguments[0], arguments.data());
        const int status = errno == ENOENT ? no_program : could_not_run;
        tell("spangle: cannot run '" + program[0] + "': " + std::strerror(errno) + "\n");
        _exit(status);
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
        continue;
    return WIFEXITED(status) ? WEXITSTATUS(status) : of_signals + WTERMSIG(status);
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
    out.bus_commands = number(figures, "bus_commands");
    const std::uint64_t bits = board != figures.end() ? number(figures, "wire_bits") : 16;
    out.full_frame_bytes = (pixels * bits + 7) / 8;
    const double seconds = static_cast<double>(number(figures, "busy_ns")) * 1e-9;
    out.fps_at_bus_clock = seconds > 0.0 ? out.frames / seconds : 0.0;
    out.picture_hash = hash != figures.end() ? hash->second : "";
    return out;
}

} // namespace

int exec(const ExecOptions& options) {
    if (options.board != "none" && bringup::find_board(options.board) == nullptr)
        return refuse("no board '" + options.board + "'; `spangle boards` lists them, none is none");
    const fs::path pair = pair_folder();
    if (pair.empty())
        return refuse("there is no drop-in pair beside this program; SPANGLE_DROPIN names its folder");
    const ReportFile report;
    if (report.path().empty())
        return refuse("no file can be made in " + fs::temp_directory_path().string(), not_done);
    set_environment(options, pair, report.path());
    const int status = run_program(options.program);
    std::string violations;
    const auto figures = report.read(violations);
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
    if (!options.json && !options.shot.empty())
        print("picture: {}\n", options.shot);
    return status;
}

int replay(ExecOptions options) {
    const std::string trace = options.program[0];
    if (!fs::exists(trace))
        return refuse("there is no trace '" + trace + "'");
    // A retracer that finds no X draws to pbuffers; each that it swaps is shown on the board.
    unsetenv("DISPLAY");
    set("WAFFLE_PLATFORM", "surfaceless_egl");
    options.program = {"eglretrace", "--headless", trace};
    return exec(options);
}

namespace {

void add_common(CLI::App& command, ExecOptions& options) {
    command.add_option("--board", options.board, "the simulated board that shows each swap; none: no board")
        ->capture_default_str();
    command.add_option("--precision", options.precision, "exact, balanced, fast; double: the reference")
        ->check(CLI::IsMember({"exact", "balanced", "fast", "double"}))
        ->capture_default_str();
    command
        .add_option("--format", options.format,
                    "pixels that windows have: rgba, which presents turn into what the panel takes; panel: "
                    "the panel's own")
        ->check(CLI::IsMember({"rgba", "panel"}))
        ->capture_default_str();
    command.add_option("--shot", options.shot, "write the glass as PNG at the end");
    command.add_option("--frames", options.frames, "end the program after so many frames")
        ->check(CLI::Range(1, 1000000000));
    command.add_flag("--stats", options.stats, "print the figures, with --shot too");
    command.add_flag("--json", options.json, "print the figures as one JSON object");
}

} // namespace

CLI::App* add_exec(CLI::App& app, ExecOptions& options) {
    CLI::App* const command =
        app.add_subcommand("exec", "run a program of OpenGL, unmodified, on a simulated board");
    add_common(*command, options);
    command->add_option("--size", options.size, "WIDTHxHEIGHT of its windows, instead of the board's");
    command->add_option("program", options.program, "the program and its arguments, after --")->required();
    return command;
}

CLI::App* add_replay(CLI::App& app, ExecOptions& options) {
    CLI::App* const command = app.add_subcommand(
        "replay", "replay a trace of apitrace on a simulated board (needs Debian's package apitrace)");
    add_common(*command, options);
    command->add_option("trace", options.program, "the trace")->required()->expected(1);
    return command;
}

} // namespace spangle::cli
