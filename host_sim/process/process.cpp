#include "host_sim/process/process.hpp"

#include <cerrno>
#include <csignal>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace spangle::process {

namespace {

/// Connects a stream in the child to what the caller asked for.
bool connect(int from, int stream) {
    const int file = from == nowhere ? open("/dev/null", O_RDWR | O_CLOEXEC) : from;
    return from == inherited || dup2(file, stream) == stream;
}

/// Runs in the child, and turns it into the program. If that fails, the parent reads the error from the pipe.
[[noreturn]] void exec_program(char* const arguments[], const Streams& streams, int pipe) {
    // The command line ignores these signals (main.cpp), and a child would inherit that.
    std::signal(SIGPIPE, SIG_DFL);
    std::signal(SIGXFSZ, SIG_DFL);
    if (connect(streams.in, STDIN_FILENO) && connect(streams.out, STDOUT_FILENO) &&
        connect(streams.error, STDERR_FILENO))
        execvp(arguments[0], arguments);
    const int error = errno;
    const bool told = write(pipe, &error, sizeof error) == sizeof error;
    _exit(told && error == ENOENT ? no_program : could_not_run);
}

/// The error that a child wrote before its end of the pipe was closed, by exec or by the child's end. 0:
/// none.
int error_from(int pipe) {
    int error = 0;
    ssize_t taken = 0;
    while ((taken = read(pipe, &error, sizeof error)) < 0 && errno == EINTR)
        continue;
    return taken == sizeof error ? error : 0;
}

} // namespace

ExitStatus run(const std::vector<std::string>& words, const Streams& streams) {
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (const std::string& word : words)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        return {could_not_run, errno};
    const pid_t child = fork();
    if (child == 0)
        exec_program(arguments.data(), streams, ends[1]);
    ExitStatus ended{could_not_run, child < 0 ? errno : 0};
    close(ends[1]);
    if (child > 0)
        ended.error = error_from(ends[0]);
    close(ends[0]);
    int status = 0;
    if (child < 0)
        return ended;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
            return {could_not_run, errno};
    ended.status = WIFEXITED(status) ? WEXITSTATUS(status) : of_signals + WTERMSIG(status);
    return ended;
}

TemporaryFile::~TemporaryFile() {
    if (file_ != nullptr)
        std::fclose(file_);
}

bool TemporaryFile::put(const std::string& text) {
    if (file_ == nullptr || std::fwrite(text.data(), 1, text.size(), file_) != text.size())
        return false;
    const bool written = std::fflush(file_) == 0;
    std::rewind(file_);
    return written;
}

std::string TemporaryFile::text() const {
    std::string text;
    if (file_ == nullptr)
        return text;
    std::rewind(file_);
    char piece[4096];
    for (std::size_t n; (n = std::fread(piece, 1, sizeof piece, file_)) > 0;)
        text.append(piece, n);
    return text;
}

} // namespace spangle::process
