#include "host_sim/cli/callgrind.hpp"

#include <cstdlib>
#include <string_view>

#include <unistd.h>

#include "host_sim/process/process.hpp"

namespace spangle::cli {

namespace {

constexpr int more_frames = 4;

/// The number of instructions that callgrind collects while this program runs with these words and frames.
/// Returns 0 on failure, and sets `problem`.
std::uint64_t collected(std::vector<std::string> words, int frames, std::string& problem) {
    words.insert(words.begin(),
                 {"valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", "/proc/self/exe"});
    char self[4096] = {};
    if (readlink("/proc/self/exe", self, sizeof self - 1) > 0)
        words[3] = self; // the path of this program; /proc/self/exe would be valgrind's
    words.insert(words.end(), {"--frames", std::to_string(frames)});
    const process::TemporaryFile said;
    if (said.descriptor() < 0) {
        problem = "no temporary file can be made";
        return 0;
    }
    const process::ExitStatus ended =
        process::run(words, {process::inherited, process::nowhere, said.descriptor()});
    if (ended.status != 0)
        problem = ended.status == process::no_program ? "valgrind is not installed" : "valgrind failed";
    std::uint64_t count = 0;
    constexpr std::string_view before = "Collected : ";
    const std::string text = said.text();
    if (const std::size_t at = text.find(before); at != std::string::npos)
        count = std::strtoull(text.c_str() + at + before.size(), nullptr, 10);
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
