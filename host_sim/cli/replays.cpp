#include "host_sim/cli/replays.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "host_sim/capture/names.hpp"
#include "host_sim/cli/confined.hpp"
#include "host_sim/cli/pair.hpp"
#include "host_sim/cli/record_trace.hpp"
#include "host_sim/cli/say.hpp"

namespace spangle::cli {

namespace {

namespace fs = std::filesystem;

/// Variables that are unset, because the pair shall draw nothing but the frames to be measured.
constexpr const char* other_variables[] = {"SPANGLE_BOARD", "SPANGLE_SIZE",   "SPANGLE_FORMAT",
                                           "SPANGLE_SHOT",  "SPANGLE_REPORT", "SPANGLE_SIGNAL"};

constexpr const char* no_frame = "it shows no frame";

/// Functions of later versions of OpenGL, which the pair has by name alone.
constexpr std::string_view later_functions[] = {
#define LATER(name) #name,
#include "host_sim/dropin/later_functions.inc"
#undef LATER
};

/// Why a retracer failed: its first line about an error, or its last line.
std::string reason_in(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string last = "it says nothing";
    for (std::string line; std::getline(in, line);) {
        if (line.find("error: ") != std::string::npos)
            return one_line(line);
        if (!line.empty())
            last = line;
    }
    return one_line(last);
}

/// Restores an environment variable to its old value at the end of a scope.
class ScopedVariable {
  public:
    explicit ScopedVariable(const char* variable) : variable_(variable) {
        const char* const value = std::getenv(variable);
        value_ = value != nullptr ? value : "";
    }
    ~ScopedVariable() { pair::set(variable_, value_); }
    ScopedVariable(const ScopedVariable&) = delete;
    ScopedVariable& operator=(const ScopedVariable&) = delete;

  private:
    const char* variable_;
    std::string value_;
};

/// What a retracer printed about calls that it could not make, or that raised errors.
struct RetraceErrors {
    std::string unavailable; ///< name of the first function that does not exist
    std::string first_error;
    int errors = 0;
};

RetraceErrors complaints_of(const fs::path& words) {
    constexpr std::string_view error = "glGetError(";
    RetraceErrors out;
    out.unavailable = unavailable_function(words);
    std::ifstream in(words, std::ios::binary);
    for (std::string line; std::getline(in, line);) {
        if (const std::size_t at = line.find(error); at != std::string::npos) {
            const std::size_t name = at + error.size(), end = line.find(')', name);
            const std::string function = line.substr(name, end - name);
            if (std::find(std::begin(later_functions), std::end(later_functions), function) !=
                    std::end(later_functions) &&
                out.unavailable.empty())
                out.unavailable = function;
            if (out.errors++ == 0)
                out.first_error = one_line(function);
        }
    }
    return out;
}

/// Draws a trace, each time in a process of its own.
class Replays final : public trade::Recording {
  public:
    explicit Replays(std::string trace) : trace_(std::move(trace)) {}
    explicit Replays(std::vector<std::string> program) : program_words_(std::move(program)) {}

    std::string settle(trade::Setting& setting) override;
    std::string capture(PixelFormat format, EGLint precision, const trade::Setting& setting,
                        trade::CaptureReader& out) override;
    std::vector<double> times(const std::vector<trade::Tier>& chosen, const trade::Format& format,
                              const trade::Setting& setting) override;

  private:
    using Key = std::pair<PixelFormat, EGLint>;

    pair::Folder folder_;
    std::string trace_;                      ///< file; empty: the program is not yet recorded
    std::vector<std::string> program_words_; ///< words of the program; empty: a trace is given
    std::map<Key, fs::path> saved_captures_; ///< captures that will be asked for again
    std::string trace_message_;              ///< message about the trace's errors; empty: not printed yet
    int files_ = 0;

    std::string replay(PixelFormat format, EGLint precision, const trade::Setting& setting, bool times_only,
                       const fs::path& file);
    std::string draws(trade::Setting& setting);
    void tell_errors(const RetraceErrors& found);
};

std::string Replays::replay(PixelFormat format, EGLint precision, const trade::Setting& setting,
                            bool times_only, const fs::path& file) {
    std::string problem = folder_.path().empty() ? pair::Folder::problem() : pair::use();
    if (!problem.empty())
        return problem;
    const ScopedVariable display(
        "DISPLAY"); // the retracer unsets DISPLAY, which a program recorded next needs
    for (const char* const variable : other_variables)
        pair::set(variable, "");
    pair::set("SPANGLE_CAPTURE", file.string());
    pair::set("SPANGLE_CAPTURE_FORMAT", names::name_of(names::formats, format));
    pair::set("SPANGLE_CAPTURE_TIMES", times_only ? "1" : "");
    pair::set("SPANGLE_CAPTURE_DITHER", setting.dither ? "1" : "0");
    pair::set("SPANGLE_PRECISION", names::name_of(names::precisions, precision));
    pair::set("SPANGLE_FRAMES", std::to_string(setting.frames));
    std::vector<std::string> command = pair::retrace(trace_);
    if (times_only)
        // Without --benchmark the retracer asks for errors after each call.
        command.insert(command.end() - 1, "--benchmark");
    const fs::path words = folder_.path() / "words";
    const ToolResult ended = run_bounded(command, words);
    pair::set("SPANGLE_CAPTURE", "");
    if (!ended.problem.empty())
        return ended.problem;
    const RetraceErrors found = complaints_of(words);
    if (!found.unavailable.empty())
        return fmt::format("the replay misses the function {}; Spangle is OpenGL 1.5", found.unavailable);
    if (ended.status != 0)
        return fmt::format("{} cannot replay it: {}", command[0], reason_in(words));
    if (!fs::exists(file)) // the program made no context
        return no_frame;
    tell_errors(found);
    return "";
}

/// Prints once how many calls raise errors. The errors are the program's own: where it was recorded, it went
/// on after them, too.
void Replays::tell_errors(const RetraceErrors& found) {
    if (found.errors == 0 || !trace_message_.empty())
        return;
    trace_message_ = fmt::format("spangle: {} calls raise errors of OpenGL, {} the first\n", found.errors,
                                 found.first_error);
    tell(trace_message_);
}

std::string Replays::capture(PixelFormat format, EGLint precision, const trade::Setting& setting,
                             trade::CaptureReader& out) {
    // Every tier is compared with the captures in double, so these are kept.
    const bool again = precision == EGL_PRECISION_DOUBLE_SPANGLE;
    const Key key{format, precision};
    fs::path file = folder_.path() / fmt::format("{}.capture", files_);
    if (const auto kept = saved_captures_.find(key); kept != saved_captures_.end()) {
        file = kept->second;
    } else {
        ++files_;
        if (std::string problem = replay(format, precision, setting, false, file); !problem.empty())
            return problem;
    }
    if (std::string problem = out.open(file.string()); !problem.empty())
        return problem;
    std::error_code ignored;
    if (again)
        saved_captures_[key] = file;
    else
        fs::remove(file, ignored); // the file stays readable while it is open
    return "";
}

/// Reads how large the frames are, and how many they are. Returns why there is nothing to judge, or an empty
/// string.
std::string Replays::draws(trade::Setting& setting) {
    trade::CaptureReader frames;
    std::string problem = capture(PixelFormat::rgba8888, EGL_PRECISION_DOUBLE_SPANGLE, setting, frames);
    if (!problem.empty())
        return problem;
    trade::DrawnFrame frame;
    double time = 0;
    int count = 0;
    bool drawn = false;
    for (; frames.next(frame, time); ++count) {
        if (count == 0) {
            setting.width = frame.picture.width;
            setting.height = frame.picture.height;
        }
        const std::vector<std::uint8_t>& rgba = frame.picture.rgba;
        drawn = drawn || std::find(frame.mask.begin(), frame.mask.end(), true) != frame.mask.end() ||
                !std::equal(rgba.begin() + 4, rgba.end(), rgba.begin());
    }
    if (!frames.whole())
        return "the replay was not finished";
    if (!frames.end().missed.empty())
        return fmt::format("the replay calls {}, which Spangle does not have", frames.end().missed);
    setting.frames = count;
    return count == 0 ? "it shows no frame"
           : drawn    ? ""
                      : fmt::format("it draws nothing in {} frames", count);
}

std::string Replays::settle(trade::Setting& setting) {
    if (!trace_.empty())
        return draws(setting);
    const fs::path file = folder_.path() / "program.trace";
    std::string problem;
    // A tracer records the calls of GLX or those of EGL, not both. Most programs get their windows by GLX,
    // and others by EGL.
    for (const char* const api : {"gl", "egl"}) {
        trade::Setting own = setting;
        saved_captures_.clear();
        problem = record_trace(program_words_, api, own.width, own.height, own.frames, folder_.path(), file);
        if (!problem.empty())
            break;
        trace_ = file.string();
        problem = draws(own);
        if (problem.empty())
            setting = own;
        else
            trace_.clear();
        if (problem != no_frame)
            break;
    }
    return problem;
}

std::vector<double> Replays::times(const std::vector<trade::Tier>& chosen, const trade::Format& format,
                                   const trade::Setting& setting) {
    constexpr int rounds = 5;
    std::vector<double> out(chosen.size(), -1);
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            const fs::path file = folder_.path() / "times.capture";
            trade::CaptureReader frames;
            if (!replay(format.format, chosen[i].precision, setting, true, file).empty() ||
                !frames.open(file.string()).empty())
                continue;
            trade::DrawnFrame frame;
            double time = 0, spent = 0;
            int count = 0;
            while (frames.next(frame, time))
                if (count++ != 0 || setting.frames == 1) // frame 0 includes what a program makes at its start
                    spent += time;
            const double mean = spent / std::max(1, setting.frames - 1);
            if (count == setting.frames && (out[i] < 0 || mean < out[i]))
                out[i] = mean;
        }
    return out;
}

} // namespace

std::string open_trace(const std::string& file, std::shared_ptr<trade::Recording>& out) {
    std::ifstream in(file, std::ios::binary);
    if (!in || in.peek() == std::ifstream::traits_type::eof())
        return "cannot read the trace '" + file + "'";
    out = std::make_shared<Replays>(fs::absolute(file).string());
    return "";
}

std::string open_program(const std::vector<std::string>& words, std::shared_ptr<trade::Recording>& out) {
    out = std::make_shared<Replays>(words);
    return "";
}

} // namespace spangle::cli
