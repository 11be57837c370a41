#include "host_sim/linux/kernel.hpp"

#include <cerrno>
#include <cstring>

#include <sys/eventfd.h>
#include <time.h>

namespace spangle::sim {
namespace {

/// The virtual time that a system call costs a program, in ns; thus the clock never stands still.
constexpr Time call_ns = 500;

Time thread_cpu() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return Time{static_cast<std::uint64_t>(now.tv_sec)} * 1'000'000'000 +
           static_cast<std::uint64_t>(now.tv_nsec);
}

class TextFile final : public OpenFile {
  public:
    explicit TextFile(std::string text) : text_(std::move(text)) {}
    long read(void* into, std::size_t count) override {
        const std::size_t left = text_.size() - position_, taken = count < left ? count : left;
        std::memcpy(into, text_.data() + position_, taken);
        position_ += taken;
        return static_cast<long>(taken);
    }

  private:
    std::string text_;
    std::size_t position_ = 0;
};

} // namespace

long OpenFile::ioctl(unsigned long, void*, std::size_t) {
    return -ENOTTY;
}

long OpenFile::read(void*, std::size_t) {
    return -EINVAL;
}

long OpenFile::write(const void*, std::size_t, std::size_t) {
    return -EINVAL;
}

long OpenFile::seek(long) {
    return -ESPIPE;
}

Time OpenFile::readable(Time) {
    return never;
}

Kernel& Kernel::instance() {
    static Kernel& kernel = *new Kernel; // never destroyed: files are closed after all destructors
    return kernel;
}

// --- device files, texts and links

void Kernel::add_device(const std::string& path, Device& device, unsigned major, unsigned minor) {
    const std::lock_guard lock(mutex_);
    device_nodes_[path] = {&device, major, minor};
}

void Kernel::add_text(const std::string& path, const std::string& text) {
    const std::lock_guard lock(mutex_);
    text_files_[path] = text;
}

void Kernel::add_link(const std::string& path, const std::string& target) {
    const std::lock_guard lock(mutex_);
    symbolic_links_[path] = target;
}

void Kernel::forget_all() {
    const std::lock_guard lock(mutex_);
    device_nodes_.clear();
    text_files_.clear();
    symbolic_links_.clear();
    fault_judge_ = nullptr;
    for (auto& [number, entry] : open_files_)
        entry.dead = true;
}

void Kernel::unplug(const std::string& path) {
    const std::lock_guard lock(mutex_);
    device_nodes_.at(path).present = false;
    for (auto& [number, entry] : open_files_)
        entry.dead = entry.dead || entry.path == path;
}

void Kernel::plug(const std::string& path) {
    const std::lock_guard lock(mutex_);
    device_nodes_.at(path).present = true;
}

int Kernel::open_files() const {
    const std::lock_guard lock(mutex_);
    return static_cast<int>(open_files_.size());
}

bool Kernel::device_number(const char* path, unsigned& major, unsigned& minor) const {
    const std::lock_guard lock(mutex_);
    const auto it = device_nodes_.find(path);
    if (it == device_nodes_.end() || !it->second.present)
        return false;
    major = it->second.major;
    minor = it->second.minor;
    return true;
}

bool Kernel::text_exists(const char* path) const {
    const std::lock_guard lock(mutex_);
    return text_files_.count(path) != 0;
}

bool Kernel::link_target(const char* path, std::string& target) const {
    const std::lock_guard lock(mutex_);
    const auto it = symbolic_links_.find(path);
    if (it == symbolic_links_.end())
        return false;
    target = it->second;
    return true;
}

// --- time and faults

Time Kernel::now() const {
    const std::lock_guard lock(mutex_);
    return now_;
}

void Kernel::advance(Time ns) {
    const std::lock_guard lock(mutex_);
    now_ += ns;
}

Time Kernel::sleep(Time ns) {
    const std::lock_guard lock(mutex_);
    static const std::string no_path;
    const bool interrupted = judge({Call::Kind::sleep, no_path}).error == EINTR;
    const Time slept = interrupted ? ns / 2 : ns;
    now_ += slept;
    return ns - slept;
}

void Kernel::set_judge(Judge judge) {
    const std::lock_guard lock(mutex_);
    fault_judge_ = std::move(judge);
}

void Kernel::release() {
    {
        const std::lock_guard lock(mutex_);
        ++release_count_;
    }
    release_signal_.notify_all();
}

bool Kernel::has_stalled_calls() const {
    const std::lock_guard lock(mutex_);
    return stalled_calls_ != 0;
}

Time Kernel::device_cpu() const {
    const std::lock_guard lock(mutex_);
    return device_cpu_;
}

std::uint64_t Kernel::calls() const {
    const std::lock_guard lock(mutex_);
    return call_count_;
}

CallVerdict Kernel::judge(const Call& call) {
    ++call_count_;
    now_ += call_ns;
    const CallVerdict verdict = fault_judge_ ? fault_judge_(call) : CallVerdict{};
    if (verdict.stall) {
        ++stalled_calls_;
        const std::uint64_t before = release_count_;
        std::unique_lock lock(mutex_);
        mutex_.unlock(); // releases the lock that the call itself holds
        release_signal_.wait(lock, [&] { return release_count_ != before; });
        mutex_.lock();
        --stalled_calls_;
    }
    return verdict;
}

// --- system calls of the program

bool Kernel::open(const char* path, long& answer) {
    const std::lock_guard lock(mutex_);
    if (const auto text = text_files_.find(path); text != text_files_.end()) {
        answer = add_open_file(std::make_unique<TextFile>(text->second), path);
        return true;
    }
    const auto node = device_nodes_.find(path);
    if (node == device_nodes_.end())
        return false;
    const CallVerdict verdict = judge({Call::Kind::open, node->first});
    if (!node->second.present || verdict.error != 0) {
        answer = node->second.present ? -verdict.error : -ENOENT;
        return true;
    }
    answer = add_open_file(node->second.device->open(), path);
    return true;
}

int Kernel::add_open_file(std::unique_ptr<OpenFile> file, const std::string& path) {
    const std::lock_guard lock(mutex_);
    const int own = file->descriptor();
    // An eventfd reserves a number that nobody else gets.
    const int number = own >= 0 ? own : eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
    if (number < 0)
        return -errno;
    open_files_[number] = {std::move(file), path};
    return number;
}

bool Kernel::close(int file) {
    const std::lock_guard lock(mutex_);
    return open_files_.erase(file) != 0;
}

Kernel::Entry* Kernel::find(int file) {
    const auto it = open_files_.find(file);
    return it != open_files_.end() ? &it->second : nullptr;
}

template <class Answer>
bool Kernel::answer(int file, Call::Kind kind, unsigned long request, Answer device, long& out) {
    const std::lock_guard lock(mutex_);
    Entry* const entry = find(file);
    if (entry == nullptr)
        return false;
    const auto node = device_nodes_.find(entry->path);
    const CallVerdict verdict =
        node != device_nodes_.end() ? judge({kind, node->first, request}) : CallVerdict{};
    if (entry->dead && !entry->file->answers_when_dead(request))
        out = node != device_nodes_.end() ? -node->second.device->gone_error() : -ENODEV;
    else if (verdict.error == 0 || verdict.late) {
        const Time before = thread_cpu();
        out = device(*entry->file, verdict.limit);
        device_cpu_ += thread_cpu() - before;
    }
    if (!entry->dead && verdict.error != 0)
        out = -verdict.error;
    return true;
}

bool Kernel::ioctl(int file, unsigned long request, void* argument, long& out) {
    return answer(
        file, Call::Kind::ioctl, request,
        [&](OpenFile& f, std::size_t limit) { return f.ioctl(request, argument, limit); }, out);
}

bool Kernel::read(int file, void* into, std::size_t count, long& out) {
    return answer(
        file, Call::Kind::read, 0, [&](OpenFile& f, std::size_t) { return f.read(into, count); }, out);
}

bool Kernel::write(int file, const void* from, std::size_t count, long& out) {
    return answer(
        file, Call::Kind::write, 0,
        [&](OpenFile& f, std::size_t limit) { return f.write(from, count, limit); }, out);
}

bool Kernel::seek(int file, long offset, long& out) {
    const std::lock_guard lock(mutex_);
    Entry* const entry = find(file);
    if (entry != nullptr)
        out = entry->file->seek(offset);
    return entry != nullptr;
}

bool Kernel::poll(int file, std::int64_t timeout, long& out) {
    const auto wait = [&](OpenFile& f, std::size_t) -> long {
        const Time until = timeout < 0 ? OpenFile::never : now_ + static_cast<Time>(timeout);
        const Time at = f.readable(until);
        if (at != OpenFile::never)
            now_ = at > now_ ? at : now_;
        else if (timeout > 0)
            now_ = until;
        return at != OpenFile::never ? 1 : 0;
    };
    return answer(file, Call::Kind::poll, 0, wait, out);
}

} // namespace spangle::sim
