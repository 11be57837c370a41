#include "host_sim/cli/record_trace.hpp"

#include <cstdlib>
#include <fstream>
#include <string_view>

#include <fmt/format.h>

#include "host_sim/cli/confined.hpp"
#include "host_sim/cli/pair.hpp"
#include "host_sim/process/process.hpp"

namespace spangle::cli {

namespace {

namespace fs = std::filesystem;

constexpr int longest = 600;               ///< seconds that a tool may take
constexpr int timed_out = 124, killed = 9; ///< statuses of timeout(1) for a program that took longer
constexpr const char* grace = "10";        ///< seconds from the first signal to the last

bool found(const std::string& program) {
    return pair::run({"sh", "-c", "command -v \"$0\"", program}, "/dev/null") == 0;
}

/// The last line that a program printed which ended before it drew. Lines of the tracer do not count.
std::string last_words(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string last = "it says nothing";
    for (std::string line; std::getline(in, line);)
        if (!line.empty() && !line.starts_with("apitrace: "))
            last = line;
    return one_line(last);
}

/// The numbers of the calls for which EGL refused a context; `last` is the number of the last call. A
/// retracer ends at the first refused context.
std::vector<long> refused_contexts(const fs::path& trace, const fs::path& folder, long& last) {
    std::vector<long> out;
    const fs::path words = folder / "dump";
    if (run_bounded({"apitrace", "dump", "--color=never", trace.string()}, words).status != 0)
        return out;
    std::ifstream in(words, std::ios::binary);
    for (std::string line; std::getline(in, line);) {
        char* rest = nullptr;
        const long number = std::strtol(line.c_str(), &rest, 10);
        if (rest == line.c_str() || *rest != ' ')
            continue;
        last = number;
        const std::string_view call = rest + 1;
        if (call.starts_with("eglCreateContext(") && call.ends_with(" = NULL"))
            out.push_back(number);
    }
    std::error_code ignored;
    fs::remove(words, ignored);
    return out;
}

/// Removes the refused contexts from the trace. Returns what went wrong, or an empty string.
std::string without_refused_contexts(const fs::path& trace, const fs::path& folder) {
    long last = 0;
    const std::vector<long> refused = refused_contexts(trace, folder, last);
    if (refused.empty())
        return "";
    std::string calls;
    long begin = 0;
    for (const long call : refused) {
        calls += fmt::format("{}-{},", begin, call - 1);
        begin = call + 1;
    }
    calls += fmt::format("{}-{}", begin, last);
    const fs::path all = folder / "all.trace", words = folder / "words";
    std::error_code problem;
    fs::rename(trace, all, problem);
    const ToolResult ended =
        run_bounded({"apitrace", "trim", "--calls=" + calls, "-o", trace.string(), all.string()}, words);
    return ended.problem.empty() && ended.status == 0 && !problem ? "" : "apitrace cannot trim the trace";
}

} // namespace

ToolResult run_bounded(const std::vector<std::string>& command, const fs::path& words) {
    if (!found(command[0]))
        return {0, command[0] + " is not installed; `./dev setup --programs` installs it"};
    std::vector<std::string> bounded = {"timeout", "--kill-after", grace, std::to_string(longest)};
    bounded.insert(bounded.end(), command.begin(), command.end());
    const int status = pair::run(bounded, words);
    if (status == timed_out || status == process::of_signals + killed)
        return {status, fmt::format("{} took longer than {} s", command[0], longest)};
    return {status, ""};
}

std::string unavailable_function(const fs::path& words) {
    constexpr std::string_view lacks = "unavailable function ";
    std::ifstream in(words, std::ios::binary);
    for (std::string line; std::getline(in, line);)
        if (const std::size_t at = line.find(lacks); at != std::string::npos)
            return one_line(line.substr(at + lacks.size()));
    return "";
}

std::string record_trace(const std::vector<std::string>& program, const std::string& api, int width,
                         int height, int frames, const fs::path& folder, const fs::path& to) {
    std::string problem = folder.empty() ? pair::Folder::problem() : pair::use();
    if (!problem.empty())
        return problem;
    if (!found(program[0]))
        return "there is no such program";
    for (const char* const variable : {"SPANGLE_BOARD", "SPANGLE_FORMAT", "SPANGLE_SHOT", "SPANGLE_REPORT",
                                       "SPANGLE_CAPTURE", "SPANGLE_CAPTURE_FORMAT", "SPANGLE_PRECISION"})
        pair::set(variable, "");
    pair::set("SPANGLE_SIZE", fmt::format("{}x{}", width, height));
    pair::set("SPANGLE_FRAMES", std::to_string(frames));
    pair::set("SPANGLE_SIGNAL", "1"); // ends the program by a signal: the tracer writes its file
    std::error_code ignored;
    fs::remove(to, ignored);
    std::vector<std::string> command = {"apitrace", "trace", "-a", api, "-o", to.string()};
    command.insert(command.end(), program.begin(), program.end());
    const fs::path words = folder / "words";
    const ToolResult ended = run_bounded(command, words);
    pair::set("SPANGLE_SIZE", "");
    pair::set("SPANGLE_SIGNAL", "");
    if (!ended.problem.empty())
        return ended.problem;
    if (const std::string function = unavailable_function(words); !function.empty())
        return fmt::format("it calls {}, which Spangle does not have; it is OpenGL 1.5", function);
    if (!fs::exists(to))
        return fmt::format("it ended with {} before it drew: {}", ended.status, last_words(words));
    return api == "egl" ? without_refused_contexts(to, folder) : "";
}

} // namespace spangle::cli
