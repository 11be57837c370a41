#include "host_sim/cli/pair.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "host_sim/cli/say.hpp"

namespace spangle::cli::pair {

namespace fs = std::filesystem;

namespace {

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

/// Standard output and error of this process go to a file.
void send_words(const fs::path& to) {
    const int file = ::open(to.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (file >= 0) {
        dup2(file, STDOUT_FILENO);
        dup2(file, STDERR_FILENO);
    }
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
        if (!words.empty())
            send_words(words);
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

std::vector<std::string> retrace(const std::string& trace) {
    unsetenv("DISPLAY"); // a retracer that finds no X draws to pbuffers
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
