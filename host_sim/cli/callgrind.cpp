#include "host_sim/cli/callgrind.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <sys/wait.h>
#include <unistd.h>

namespace spangle::cli {

namespace {

constexpr int no_program = 127, more_frames = 4;

/// What callgrind collected while this program ran so; 0 and `problem` on failure.
std::uint64_t collected(std::vector<std::string> words, int frames, std::string& problem) {
    words.insert(words.begin(),
                 {"valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", "/proc/self/exe"});
    char self[4096] = {};
    if (readlink("/proc/self/exe", self, sizeof self - 1) > 0)
        words[3] = self; // of this program, not of valgrind
    words.insert(words.end(), {"--frames", std::to_string(frames)});
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::FILE* const said = std::tmpfile();
    if (said == nullptr) {
        problem = "no temporary file can be made";
        return 0;
    }
    const pid_t child = fork();
    if (child == 0) {
        dup2(fileno(said), STDERR_FILENO);
        if (std::freopen("/dev/null", "w", stdout) != nullptr)
            execvp(arguments[0], arguments.data());
        _exit(no_program);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
        problem = WIFEXITED(status) && WEXITSTATUS(status) == no_program ? "valgrind is not installed"
                                                                         : "valgrind failed";
    std::rewind(said);
    std::uint64_t count = 0;
    for (char line[512]; std::fgets(line, sizeof line, said) != nullptr;)
        if (const char* const at = std::strstr(line, "Collected : "); at != nullptr)
            count = std::strtoull(at + std::strlen("Collected : "), nullptr, 10);
    std::fclose(said);
    if (count == 0 && problem.empty())
        problem = "valgrind did not say what it counted";
    return problem.empty() ? count : 0;
}

} // namespace

std::uint64_t instructions_of_frame(const std::vector<std::string>& words, std::string& problem) {
    const std::uint64_t one = collected(words, 1, problem);
    const std::uint64_t more = problem.empty() ? collected(words, 1 + more_frames, problem) : 0;
    return problem.empty() && more > one ? (more - one) / more_frames : 0;
}

} // namespace spangle::cli
