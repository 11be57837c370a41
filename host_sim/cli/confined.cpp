#include "host_sim/cli/confined.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <new>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace spangle::cli {

namespace {

constexpr std::size_t longest_line = 400;

enum Exit : int { handed_over = 0, out_of_memory = 1, thrown = 2, lost = 3 };

// AddressSanitizer reserves more memory than any limit here.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer);
#else
constexpr bool sanitized = false;
#endif

void lower_limit(int resource, rlim_t most) {
    rlimit limit{};
    getrlimit(static_cast<__rlimit_resource_t>(resource), &limit);
    limit.rlim_cur = std::min(limit.rlim_cur, most);
    setrlimit(static_cast<__rlimit_resource_t>(resource), &limit);
}

/// Sets the limits of the child. A few bytes of a broken file can ask for all memory there is, and the system
/// would end other programs for it. Processor time is limited too, in case the waiting parent is stopped.
void limit_process(const ReadLimits& limits, pid_t parent) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) // the parent ended before prctl() took effect
        _exit(lost);
    std::signal(SIGPIPE, SIG_IGN);
    if (!sanitized)
        lower_limit(RLIMIT_DATA, limits.memory);
    lower_limit(RLIMIT_CPU, static_cast<rlim_t>(limits.seconds) + 1);
    lower_limit(RLIMIT_FSIZE, 0);
    lower_limit(RLIMIT_CORE, 0);
    const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
    if (nowhere < 0)
        return;
    dup2(nowhere, STDOUT_FILENO);
    if (!sanitized) // the user of a sanitizer build waits for its report
        dup2(nowhere, STDERR_FILENO);
}

bool put(int pipe, const std::string& bytes) {
    for (std::size_t at = 0; at < bytes.size();) {
        const ssize_t taken = write(pipe, bytes.data() + at, bytes.size() - at);
        if (taken < 0 && errno == EINTR)
            continue;
        if (taken <= 0)
            return false;
        at += static_cast<std::size_t>(taken);
    }
    return true;
}

/// Runs the reader in the child process and exits. Objects of the parent are not cleaned up, because they
/// belong to the parent.
[[noreturn]] void serve_reader(const std::function<std::string()>& read, int pipe) {
    int status = thrown;
    try {
        status = put(pipe, read()) ? handed_over : lost;
    } catch (const std::bad_alloc&) {
        status = out_of_memory;
    } catch (...) {
        status = thrown;
    }
    _exit(status);
}

/// Takes what the child sends until it closes its end. Returns which limit was met, or an empty string.
std::string take(int pipe, const ReadLimits& limits, std::string& answer) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::seconds(limits.seconds);
    static char buffer[1 << 16];
    for (;;) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        pollfd waiting{pipe, POLLIN, 0};
        const int ready = left <= 0 ? 0 : poll(&waiting, 1, static_cast<int>(left));
        if (ready < 0 && errno == EINTR)
            continue;
        if (ready <= 0)
            return "takes longer than " + std::to_string(limits.seconds) + " s";
        const ssize_t taken = read(pipe, buffer, sizeof buffer);
        if (taken < 0 && errno == EINTR)
            continue;
        if (taken < 0)
            return std::strerror(errno);
        if (taken == 0)
            return "";
        if (answer.size() + static_cast<std::size_t>(taken) > limits.handed_over)
            return "holds more than " + std::to_string(limits.handed_over >> 20) + " MiB of data";
        answer.append(buffer, static_cast<std::size_t>(taken));
    }
}

int wait_for(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
            return -1;
    return status;
}

std::string describe_status(int status, const ReadLimits& limits) {
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
        return "takes longer than " + std::to_string(limits.seconds) + " s";
    if (WIFSIGNALED(status))
        return "crashes its reader (" + std::string(strsignal(WTERMSIG(status))) + ")";
    if (!WIFEXITED(status) || WEXITSTATUS(status) == handed_over)
        return "";
    return WEXITSTATUS(status) == out_of_memory
               ? "asks for more than " + std::to_string(limits.memory >> 30) + " GiB of memory"
               : "crashes its reader (status " + std::to_string(WEXITSTATUS(status)) + ")";
}

} // namespace

std::string run_confined(const std::function<std::string()>& read, const ReadLimits& limits,
                         std::string& answer) {
    answer.clear();
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        return std::string("cannot be read in a process of its own: ") + std::strerror(errno);
    const pid_t parent = getpid(), child = fork();
    if (child < 0) {
        const int error = errno;
        close(ends[0]);
        close(ends[1]);
        return std::string("cannot be read in a process of its own: ") + std::strerror(error);
    }
    if (child == 0) {
        close(ends[0]);
        limit_process(limits, parent);
        serve_reader(read, ends[1]);
    }
    close(ends[1]);
    std::string problem = take(ends[0], limits, answer);
    close(ends[0]);
    if (!problem.empty())
        kill(child, SIGKILL);
    const std::string end = describe_status(wait_for(child), limits);
    return problem.empty() ? end : problem;
}

std::string one_line(const std::string& text) {
    std::string out = text.substr(0, longest_line);
    std::replace_if(
        out.begin(), out.end(), [](unsigned char c) { return c < 32 || c == 127; }, ' ');
    return text.size() > longest_line ? out + "..." : out;
}

} // namespace spangle::cli
