#include "host_sim/output/output.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace spangle::sim {
namespace {

constexpr std::size_t most_kept = std::size_t{1} << 16;
constexpr int most_links = 40; // the kernel follows as many symbolic links

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

/// The descriptor of this program that a path names, or -1. Opening such a path anew would begin at the start
/// of the file behind it, and sockets cannot be opened at all.
int named_descriptor(const std::string& path) {
    if (path == "-" || path == "/dev/stdout")
        return 1;
    if (path == "/dev/stderr")
        return 2;
    for (const char* const folder : {"/dev/fd/", "/proc/self/fd/"}) {
        const std::size_t length = std::strlen(folder);
        if (path.compare(0, length, folder) != 0)
            continue;
        char* end = nullptr;
        const long number = std::strtol(path.c_str() + length, &end, 10);
        if (end != path.c_str() + length && *end == '\0' && number >= 0 && number < 1 << 20)
            return static_cast<int>(number);
    }
    return -1;
}

/// Follows symbolic links, the last of which may name something that does not exist. Returns false where they
/// form a circle.
bool follow_links(std::string& path) {
    for (int hops = 0; named_descriptor(path) < 0; ++hops) {
        struct stat status {};
        if (lstat(path.c_str(), &status) != 0 || !S_ISLNK(status.st_mode))
            return true;
        char text[4096];
        const ssize_t length = readlink(path.c_str(), text, sizeof text);
        if (length <= 0 || static_cast<std::size_t>(length) == sizeof text || hops == most_links)
            return false;
        const std::string there(text, static_cast<std::size_t>(length));
        path = there[0] == '/' ? there : folder_of(path).append("/").append(there);
    }
    return true;
}

const char* advice_for(int error) {
    switch (error) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
        return "; make room there, or name another place";
    case EPIPE:
        return "; nobody reads it any more";
    case EACCES:
    case EPERM:
    case EROFS:
        return "; name a place that you may write to";
    default:
        return "";
    }
}

/// Writes all bytes. Returns the errno of what failed, or 0.
int put(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t taken = ::write(file, bytes.data(), bytes.size());
        if (taken < 0 && errno == EINTR)
            continue;
        if (taken <= 0)
            return taken < 0 ? errno : ENOSPC;
        bytes.remove_prefix(static_cast<std::size_t>(taken));
    }
    return 0;
}

} // namespace

Output::~Output() {
    discard();
}

std::string Output::problem(int error) const {
    return "cannot write " + (descriptor_ == 1 ? "standard output" : "'" + path_ + "'") + ": " +
           std::strerror(error) + advice_for(error);
}

std::string Output::open(const std::string& path) {
    discard();
    path_ = path;
    target_ = path;
    size_ = 0;
    error_ = 0;
    if (path.empty())
        return "cannot write to a file without a name";
    if (!follow_links(target_))
        return problem(ELOOP);
    descriptor_ = named_descriptor(target_);
    if (descriptor_ >= 0)
        return open_descriptor();
    struct stat status {};
    const bool exists = stat(target_.c_str(), &status) == 0;
    if (!exists && errno != ENOENT)
        return problem(errno);
    if (exists && S_ISDIR(status.st_mode))
        return "cannot write '" + path_ + "': it is a folder";
    return !exists || S_ISREG(status.st_mode) ? open_new_file(exists) : open_device();
}

std::string Output::open_descriptor() {
    const int flags = fcntl(descriptor_, F_GETFL);
    if (flags < 0 || (flags & O_ACCMODE) == O_RDONLY)
        return problem(EBADF);
    file_ = fcntl(descriptor_, F_DUPFD_CLOEXEC, 0);
    return file_ < 0 ? problem(errno) : "";
}

std::string Output::open_device() {
    file_ = ::open(target_.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
    return file_ < 0 ? problem(errno) : "";
}

/// Opens the new file, without a name where the file system can do that. Then a program that is killed leaves
/// nothing behind.
std::string Output::open_new_file(bool exists) {
    const std::string folder = folder_of(target_);
    struct stat status {};
    if (stat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode))
        return "cannot write '" + path_ + "': there is no folder " + folder;
    if (exists && access(target_.c_str(), W_OK) != 0)
        return problem(errno);
    replaces_file_ = true;
    file_ = access("/proc/self/fd", X_OK) == 0
                ? ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666)
                : -1;
    if (file_ >= 0)
        return "";
    static int count = 0;
    temporary_name_ = target_ + "." + std::to_string(getpid()) + "-" + std::to_string(++count) + ".part";
    file_ = ::open(temporary_name_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (file_ >= 0)
        return "";
    const int error = errno;
    temporary_name_.clear();
    return problem(error);
}

bool Output::write(std::string_view bytes) {
    if (file_ < 0 && error_ == 0)
        error_ = EBADF;
    buffer_ += bytes;
    size_ += bytes.size();
    return buffer_.size() < most_kept ? error_ == 0 : flush();
}

bool Output::flush() {
    if (error_ == 0 && file_ >= 0)
        error_ = put(file_, buffer_);
    buffer_.clear();
    return error_ == 0;
}

/// Gives the new file its name, and the owner and permissions of the old file. Renaming is one step for all
/// other processes.
int Output::take_place() {
    struct stat old {};
    const bool exists = stat(target_.c_str(), &old) == 0;
    if (exists && !S_ISREG(old.st_mode)) // another process made something else of that name
        return EEXIST;
    if (exists) {
        // A user who may write a file need not be able to give it away. In that case the file is the user's
        // own from here on.
        if (fchown(file_, old.st_uid, old.st_gid) != 0)
            errno = 0;
        if (fchmod(file_, old.st_mode & 07777) != 0)
            return errno;
    }
    if (temporary_name_.empty()) {
        static int count = 0;
        std::string name = target_ + "." + std::to_string(getpid()) + "-" + std::to_string(++count) + ".link";
        const std::string open_file = "/proc/self/fd/" + std::to_string(file_);
        if (linkat(AT_FDCWD, open_file.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) != 0)
            return errno;
        temporary_name_ = std::move(name);
    }
    const int closed = close(std::exchange(file_, -1)) == 0 ? 0 : errno;
    if (closed != 0)
        return closed;
    if (std::rename(temporary_name_.c_str(), target_.c_str()) != 0)
        return errno;
    temporary_name_.clear();
    return 0;
}

std::string Output::commit() {
    flush();
    if (error_ == 0 && replaces_file_)
        error_ = take_place();
    // Some file systems tell only when a file is closed that there was no room.
    if (file_ >= 0 && !replaces_file_ && close(std::exchange(file_, -1)) != 0 && error_ == 0)
        error_ = errno;
    std::string text = error_ == 0 ? "" : problem(error_);
    discard();
    return text;
}

void Output::discard() {
    if (file_ >= 0)
        close(std::exchange(file_, -1));
    if (!temporary_name_.empty())
        unlink(temporary_name_.c_str());
    temporary_name_.clear();
    buffer_.clear();
    replaces_file_ = false;
}

std::string write_file(const std::string& path, std::string_view bytes) {
    Output file;
    if (std::string problem = file.open(path); !problem.empty())
        return problem;
    file.write(bytes);
    return file.commit();
}

bool is_standard_output(std::string path) {
    return follow_links(path) && named_descriptor(path) == STDOUT_FILENO;
}

Output& standard_output() {
    static Output output;
    static const std::string closed = output.open("-");
    return output;
}

} // namespace spangle::sim
