// The part of a Linux kernel that display programs talk to, inside the program itself: device files that
// models answer, and a clock that runs while programs sleep. Programs linked with `spangle_linux_doubles`
// open these files instead of the machine's own (interpose.cpp).
#pragma once

#include <climits>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include <spangle/sim/violations.hpp>

namespace spangle::sim {

/// One system call on a modelled device.
struct Call {
    enum class Kind { open, ioctl, read, write, poll, sleep };
    Kind kind;
    const std::string& path;   ///< path of the device file; empty for a sleep
    unsigned long request = 0; ///< request number of an ioctl
};

/// What the kernel does to a call before it reaches the device.
struct CallVerdict {
    int error = 0;                ///< errno with which the call fails; 0: the device answers
    std::size_t limit = SIZE_MAX; ///< bytes of a transfer that are still carried out
    bool stall = false;           ///< the call returns no sooner than Kernel::release()
    bool late = false;            ///< the device acts before the call fails
};

/// An open file of a device. Its functions answer as functions inside the kernel do: negative errno on
/// failure.
class OpenFile {
  public:
    virtual ~OpenFile() = default;
    /// `limit` is the number of bytes of a transfer after which it is cut short.
    virtual long ioctl(unsigned long request, void* argument, std::size_t limit);
    virtual long read(void* into, std::size_t count);
    virtual long write(const void* from, std::size_t count, std::size_t limit);
    /// The first time from now to `until` at which there is something to read, or `never`.
    virtual Time readable(Time until);
    virtual long seek(long offset);
    /// A real file that callers poll in place of this one, and that the kernel then owns; negative: none.
    virtual int descriptor() { return -1; }
    /// Whether a request is answered even after the device went.
    virtual bool answers_when_dead(unsigned long) const { return false; }

    static constexpr Time never = ~Time{0};
};

class Device {
  public:
    virtual ~Device() = default;
    virtual std::unique_ptr<OpenFile> open() = 0;
    /// The errno of calls on files that were open when the device went.
    virtual int gone_error() const = 0;
};

class Kernel {
  public:
    /// The kernel that the interposed system calls reach.
    static Kernel& instance();

    // --- files
    /// Makes a device file. The device stays the caller's, and must live until forget_all().
    void add_device(const std::string& path, Device& device, unsigned major, unsigned minor);
    void add_text(const std::string& path, const std::string& text);
    void add_link(const std::string& path, const std::string& target);
    void forget_all();
    /// Removes a device as when its adapter is pulled. Open files are dead, and the path is gone until
    /// plug().
    void unplug(const std::string& path);
    void plug(const std::string& path);
    int open_files() const;

    /// Keeps calls of other threads from running while the lock is held: std::lock_guard lock(kernel).
    void lock() { mutex_.lock(); }
    void unlock() { mutex_.unlock(); }

    // --- virtual time, ns
    Time now() const;
    void advance(Time ns);
    /// Sleeps `ns`, or until a signal interrupts. Returns the time that is left.
    Time sleep(Time ns);

    // --- faults of system calls
    using Judge = std::function<CallVerdict(const Call&)>;
    void set_judge(Judge judge);
    /// Lets stalled calls go on.
    void release();
    bool has_stalled_calls() const;
    std::uint64_t calls() const;
    /// Processor time that the devices took to answer, by which a program's own work can be told from theirs.
    Time device_cpu() const;

    // --- the system calls. They return false when the path or file is not modelled; `answer` is negative
    // errno on failure.
    bool open(const char* path, long& answer);
    bool close(int file);
    bool ioctl(int file, unsigned long request, void* argument, long& answer);
    bool read(int file, void* into, std::size_t count, long& answer);
    bool write(int file, const void* from, std::size_t count, long& answer);
    bool seek(int file, long offset, long& answer);
    /// `timeout` is in nanoseconds; a negative one lasts for ever.
    bool poll(int file, std::int64_t timeout, long& answer);
    bool device_number(const char* path, unsigned& major, unsigned& minor) const;
    bool text_exists(const char* path) const;
    bool link_target(const char* path, std::string& target) const;

    /// Opens a file on behalf of a device that answers with another file. Returns its number, or negative
    /// errno.
    int add_open_file(std::unique_ptr<OpenFile> file, const std::string& path);

  private:
    struct Node {
        Device* device;
        unsigned major, minor;
        bool present = true;
    };
    struct Entry {
        std::unique_ptr<OpenFile> file;
        std::string path;
        bool dead = false;
    };

    mutable std::recursive_mutex mutex_; ///< guards all members, so that one call runs at a time
    std::condition_variable_any release_signal_;
    std::map<std::string, Node> device_nodes_;
    std::map<std::string, std::string> text_files_, symbolic_links_;
    std::map<int, Entry> open_files_;
    Judge fault_judge_;
    Time now_ = 0;
    Time device_cpu_ = 0;
    std::uint64_t call_count_ = 0, release_count_ = 0;
    int stalled_calls_ = 0;

    Entry* find(int file);
    CallVerdict judge(const Call& call);
    template <class Answer>
    bool answer(int file, Call::Kind kind, unsigned long request, Answer device, long& out);
};

} // namespace spangle::sim
