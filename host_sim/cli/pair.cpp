#include "host_sim/cli/pair.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

#include "host_sim/cli/say.hpp"
#include "host_sim/process/process.hpp"

namespace spangle::cli::pair {

namespace fs = std::filesystem;

namespace {

constexpr const char* core_library = "libspangle-dropin.so.0";

/// The folder of the drop-in pair: beside this program where it was built, below lib where it was installed.
/// Empty if neither is there.
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

} // namespace

std::string use() {
    const fs::path folder = pair_folder();
    if (folder.empty())
        return "there is no drop-in pair beside this program; SPANGLE_DROPIN names its folder";
    const char* const old = std::getenv("LD_LIBRARY_PATH");
    const std::string before = old != nullptr ? old : "";
    if (before != folder.string() && !before.starts_with(folder.string() + ":"))
        set("LD_LIBRARY_PATH", folder.string() + (before.empty() ? "" : ":" + before));
    return "";
}

void set(const char* variable, const std::string& value) {
    if (value.empty())
        unsetenv(variable);
    else
        setenv(variable, value.c_str(), 1);
}

int run(const std::vector<std::string>& program, const fs::path& words) {
    process::Streams streams;
    if (!words.empty())
        streams.out = streams.error = ::open(words.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    const process::ExitStatus ended = process::run(program, streams);
    const std::string why =
        ended.error == 0 ? ""
                         : "spangle: cannot run '" + program[0] + "': " + std::strerror(ended.error) + "\n";
    if (streams.out < 0) {
        tell(why);
    } else {
        dprintf(streams.out, "%s", why.c_str());
        ::close(streams.out);
    }
    return ended.status;
}

/// Checks the trace with apitrace first, because a retracer that is given something else ends by a signal.
std::string trace_problem(const std::string& trace) {
    std::error_code ignored;
    if (!fs::exists(trace, ignored))
        return "there is no trace '" + trace + "'";
    const bool file = fs::is_regular_file(trace, ignored) && fs::file_size(trace, ignored) != 0;
    const int status = file ? run({"apitrace", "dump", "--calls=0", trace}, "/dev/null") : 0;
    if (status == process::no_program)
        return "traces are read by apitrace, which is not there; ./dev setup --programs installs it";
    return file && status == 0 ? ""
                               : "'" + trace + "' is not a trace of apitrace; `apitrace trace` makes one";
}

std::vector<std::string> retrace(const std::string& trace) {
    unsetenv("DISPLAY"); // a retracer that finds no X server draws to pbuffers
    set("WAFFLE_PLATFORM", "surfaceless_egl");
    return {"eglretrace", "--headless", trace};
}

Folder::Folder() {
    std::string name = (fs::temp_directory_path() / "spangle-XXXXXX").string();
    if (mkdtemp(name.data()) != nullptr)
        path_ = name;
}

Folder::~Folder() {
    std::error_code ignored;
    if (!path_.empty())
        fs::remove_all(path_, ignored);
}

std::string Folder::problem() {
    return "no folder can be made in " + fs::temp_directory_path().string();
}

} // namespace spangle::cli::pair
