#include "tests/unit/hal_kernel/files.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <unistd.h>

namespace kernel_test {
namespace {

[[noreturn]] void fail(const std::string& what) {
    throw std::runtime_error(what + ": " + std::strerror(errno));
}

} // namespace

void write_text(const std::string& path, const std::string& text) {
    const int file = open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
    if (file < 0)
        fail(path);
    const bool taken = write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
    const int error = errno;
    close(file);
    errno = error;
    if (!taken)
        fail(path + " does not take '" + text + "'");
}

std::string read_text(const std::string& path) {
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0)
        fail(path);
    std::string text;
    char piece[65536];
    ssize_t count;
    while ((count = read(file, piece, sizeof piece)) > 0)
        text.append(piece, static_cast<std::size_t>(count));
    close(file);
    if (count < 0)
        fail(path);
    while (!text.empty() && text.back() == '\n')
        text.pop_back();
    return text;
}

bool exists(const std::string& path) {
    return access(path.c_str(), F_OK) == 0;
}

void await(const char* what, const std::function<bool()>& done, std::chrono::seconds patience) {
    using Clock = std::chrono::steady_clock;
    for (const auto end = Clock::now() + patience; !done();) {
        if (Clock::now() > end)
            throw std::runtime_error(std::string("the kernel does not ") + what);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

} // namespace kernel_test
