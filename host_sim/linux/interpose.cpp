// The system calls that libgpiod and Spangle's buses make, defined in the program itself. The dynamic linker
// looks there first, so the unmodified libraries call these functions. Calls on files that are not modelled
// go on to the C library.
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <tuple>

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include "host_sim/linux/kernel.hpp"

namespace {

using spangle::sim::Kernel;

template <class Function> Function next(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

/// Turns an answer of the kernel into the form of the C library: -1, and the error in errno.
template <class T = int> T user_answer(long answer) {
    if (answer >= 0)
        return static_cast<T>(answer);
    errno = static_cast<int>(-answer);
    return -1;
}

int open_file(const char* path, int flags, mode_t mode) {
    long answer = 0;
    if (Kernel::instance().open(path, answer))
        return user_answer(answer);
    static const auto real = next<int (*)(const char*, int, ...)>("open");
    return real(path, flags, mode);
}

bool fake_stat(const char* path, struct stat* status) {
    unsigned major = 0, minor = 0;
    if (!Kernel::instance().device_number(path, major, minor))
        return false;
    *status = {};
    status->st_mode = S_IFCHR | 0660;
    status->st_rdev = makedev(major, minor);
    return true;
}

} // namespace

// These functions have other names with the C library's symbols, because its headers declare the usual names
// with attributes of their own.
#define SPANGLE_SYMBOL(name) __asm__(name) __attribute__((visibility("default"), used))

extern "C" {

int spangle_open(const char* path, int flags, mode_t mode) SPANGLE_SYMBOL("open");
int spangle_open64(const char* path, int flags, mode_t mode) SPANGLE_SYMBOL("open64");
int spangle_open_2(const char* path, int flags) SPANGLE_SYMBOL("__open_2");
int spangle_close(int file) SPANGLE_SYMBOL("close");
int spangle_ioctl(int file, unsigned long request, void* argument) SPANGLE_SYMBOL("ioctl");
ssize_t spangle_read(int file, void* into, std::size_t count) SPANGLE_SYMBOL("read");
ssize_t spangle_write(int file, const void* from, std::size_t count) SPANGLE_SYMBOL("write");
long spangle_lseek(int file, long offset, int whence) SPANGLE_SYMBOL("lseek");
int spangle_ppoll(pollfd* files, nfds_t count, const timespec* timeout, const sigset_t* mask)
    SPANGLE_SYMBOL("ppoll");
int spangle_stat(const char* path, struct stat* status) SPANGLE_SYMBOL("stat");
int spangle_lstat(const char* path, struct stat* status) SPANGLE_SYMBOL("lstat");
int spangle_access(const char* path, int mode) SPANGLE_SYMBOL("access");
char* spangle_realpath(const char* path, char* resolved) SPANGLE_SYMBOL("realpath");
int spangle_clock_nanosleep(clockid_t clock, int flags, const timespec* wanted, timespec* left)
    SPANGLE_SYMBOL("clock_nanosleep");
int spangle_cond_clockwait(pthread_cond_t* condition, pthread_mutex_t* mutex, clockid_t clock,
                           const timespec* deadline) SPANGLE_SYMBOL("pthread_cond_clockwait");

// open() and ioctl() have an optional last argument. Where none was passed, whatever stands in its register
// goes on to the C library, which does not look at it in that case.
int spangle_open(const char* path, int flags, mode_t mode) {
    return open_file(path, flags, mode);
}

int spangle_open64(const char* path, int flags, mode_t mode) {
    return open_file(path, flags, mode);
}

int spangle_open_2(const char* path, int flags) {
    return open_file(path, flags, 0);
}

int spangle_close(int file) {
    Kernel::instance().close(file);
    static const auto real = next<int (*)(int)>("close");
    return real(file);
}

int spangle_ioctl(int file, unsigned long request, void* argument) {
    long answer = 0;
    // The kernel looks at 32 bits of a request; libgpiod 2 keeps some requests in an int, which extends the
    // sign.
    if (Kernel::instance().ioctl(file, static_cast<std::uint32_t>(request), argument, answer))
        return user_answer(answer);
    static const auto real = next<int (*)(int, unsigned long, ...)>("ioctl");
    return real(file, request, argument);
}

ssize_t spangle_read(int file, void* into, std::size_t count) {
    long answer = 0;
    if (Kernel::instance().read(file, into, count, answer))
        return user_answer<ssize_t>(answer);
    static const auto real = next<ssize_t (*)(int, void*, std::size_t)>("read");
    return real(file, into, count);
}

ssize_t spangle_write(int file, const void* from, std::size_t count) {
    long answer = 0;
    if (Kernel::instance().write(file, from, count, answer))
        return user_answer<ssize_t>(answer);
    static const auto real = next<ssize_t (*)(int, const void*, std::size_t)>("write");
    return real(file, from, count);
}

long spangle_lseek(int file, long offset, int whence) {
    long answer = 0;
    if (whence == SEEK_SET && Kernel::instance().seek(file, offset, answer))
        return user_answer<long>(answer);
    static const auto real = next<long (*)(int, long, int)>("lseek");
    return real(file, offset, whence);
}

int spangle_ppoll(pollfd* files, nfds_t count, const timespec* timeout, const sigset_t* mask) {
    const std::int64_t wait =
        timeout == nullptr ? -1 : std::int64_t{timeout->tv_sec} * 1000000000 + timeout->tv_nsec;
    long answer = 0;
    if (count == 1 && Kernel::instance().poll(files[0].fd, wait, answer)) {
        files[0].revents = answer > 0 ? POLLIN : 0;
        return user_answer(answer);
    }
    static const auto real = next<int (*)(pollfd*, nfds_t, const timespec*, const sigset_t*)>("ppoll");
    return real(files, count, timeout, mask);
}

int spangle_stat(const char* path, struct stat* status) {
    static const auto real = next<int (*)(const char*, struct stat*)>("stat");
    return fake_stat(path, status) ? 0 : real(path, status);
}

int spangle_lstat(const char* path, struct stat* status) {
    static const auto real = next<int (*)(const char*, struct stat*)>("lstat");
    return fake_stat(path, status) ? 0 : real(path, status);
}

int spangle_access(const char* path, int mode) {
    unsigned major = 0, minor = 0;
    std::string target;
    const Kernel& kernel = Kernel::instance();
    if (kernel.text_exists(path) || kernel.link_target(path, target) ||
        kernel.device_number(path, major, minor))
        return 0;
    static const auto real = next<int (*)(const char*, int)>("access");
    return real(path, mode);
}

char* spangle_realpath(const char* path, char* resolved) {
    std::string target;
    if (Kernel::instance().link_target(path, target))
        return resolved != nullptr
                   ? static_cast<char*>(std::memcpy(resolved, target.c_str(), target.size() + 1))
                   : strdup(target.c_str());
    static const auto real = next<char* (*)(const char*, char*)>("realpath");
    return real(path, resolved);
}

/// Lets a sleep pass at once, on the virtual clock.
int spangle_clock_nanosleep(clockid_t, int, const timespec* wanted, timespec* left) {
    constexpr spangle::sim::Time second = 1000000000;
    const auto whole = static_cast<spangle::sim::Time>(wanted->tv_sec) * second;
    const spangle::sim::Time rest =
        Kernel::instance().sleep(whole + static_cast<spangle::sim::Time>(wanted->tv_nsec));
    if (rest == 0)
        return 0;
    *left = {static_cast<time_t>(rest / second), static_cast<long>(rest % second)};
    return EINTR;
}

/// Extends the deadline of a wait while system calls are answered and none hangs. A modelled transfer may
/// take many times the real one's time, on a busy machine or under a sanitizer.
int spangle_cond_clockwait(pthread_cond_t* condition, pthread_mutex_t* mutex, clockid_t clock,
                           const timespec* deadline) {
    using Wait = int (*)(pthread_cond_t*, pthread_mutex_t*, clockid_t, const timespec*);
    static const auto real = next<Wait>("pthread_cond_clockwait");
    const Kernel& kernel = Kernel::instance();
    timespec until{};
    clock_gettime(clock, &until);
    const bool waits = std::tie(until.tv_sec, until.tv_nsec) < std::tie(deadline->tv_sec, deadline->tv_nsec);
    until = *deadline;
    for (std::uint64_t calls = ~std::uint64_t{0};;) {
        const int answer = real(condition, mutex, clock, &until);
        if (answer != ETIMEDOUT || !waits || kernel.has_stalled_calls() || kernel.calls() == calls)
            return answer;
        calls = kernel.calls();
        clock_gettime(clock, &until);
        ++until.tv_sec;
    }
}

} // extern "C"
