#include "tests/unit/hal_kernel/gadget.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include <fcntl.h>
#include <linux/usb/functionfs.h>
#include <poll.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/unit/hal_kernel/files.hpp"

namespace kernel_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

const std::string gadget = "/sys/kernel/config/usb_gadget/display";
const std::string function_folder = gadget + "/functions/ffs.display",
                  configuration = gadget + "/configs/c.1";
const std::string files = "/run/display";
constexpr std::size_t packet_bytes = 512;
constexpr auto moment = std::chrono::milliseconds(1);

void put(Bytes& to, std::uint32_t word) {
    for (int i = 0; i < 4; ++i)
        to.push_back(static_cast<std::uint8_t>(word >> 8 * i));
}

/// Returns a block as both halves of the description have it: a magic number, the length, the rest.
Bytes block(std::uint32_t magic, const Bytes& rest) {
    Bytes out;
    put(out, magic);
    put(out, static_cast<std::uint32_t>(8 + rest.size()));
    out.insert(out.end(), rest.begin(), rest.end());
    return out;
}

void demand(bool done, const char* what) {
    if (!done)
        throw std::runtime_error(std::string(what) + ": " + std::strerror(errno));
}

std::string hexadecimal(unsigned low, unsigned high) {
    char text[8];
    std::snprintf(text, sizeof text, "0x%04x", low | high << 8);
    return text;
}

} // namespace

Gadget::Gadget(spangle::sim::UsbFunction& function) : function_(function) {
    const Bytes d = function_.descriptors();
    mkdir(gadget.c_str(), 0755);
    write_text(gadget + "/idVendor", hexadecimal(d[8], d[9]));
    write_text(gadget + "/idProduct", hexadecimal(d[10], d[11]));
    mkdir(configuration.c_str(), 0755);
    mkdir(function_folder.c_str(), 0755);
    demand(symlink(function_folder.c_str(), (configuration + "/ffs.display").c_str()) == 0,
           "gadget function");
    mkdir(files.c_str(), 0755);
    demand(mount("display", files.c_str(), "functionfs", 0, nullptr) == 0, "functionfs");
    control_ = open((files + "/ep0").c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    demand(control_ >= 0, "ep0");
    describe();
    pipe_ = open((files + "/ep1").c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    demand(pipe_ >= 0, "ep1");
}

Gadget::~Gadget() {
    unplug();
    close(pipe_);
    close(control_);
    umount(files.c_str());
    unlink((configuration + "/ffs.display").c_str());
    rmdir(function_folder.c_str());
    rmdir(configuration.c_str());
    rmdir(gadget.c_str());
}

/// FunctionFS takes the interface and the endpoint, which the function has behind the descriptors of device
/// and configuration.
void Gadget::describe() {
    constexpr std::size_t before = 18 + 9;
    const Bytes all = function_.descriptors();
    Bytes rest;
    put(rest, FUNCTIONFS_HAS_HS_DESC);
    put(rest, 2); // number of descriptors
    rest.insert(rest.end(), all.begin() + before, all.end());
    Bytes strings;
    put(strings, 0);
    put(strings, 0);
    for (const Bytes& half :
         {block(FUNCTIONFS_DESCRIPTORS_MAGIC_V2, rest), block(FUNCTIONFS_STRINGS_MAGIC, strings)})
        demand(write(control_, half.data(), half.size()) == static_cast<ssize_t>(half.size()), "description");
}

void Gadget::plug() {
    unplug();
    plugged_ = true;
    control_thread_ = std::thread([this] { serve_control(); });
    pipe_thread_ = std::thread([this] { serve_pipe(); });
    write_text(gadget + "/UDC", "dummy_udc.0");
}

/// Takes the controller away. The kernel refuses if the device has left by itself.
void Gadget::leave() {
    try {
        write_text(gadget + "/UDC", "\n");
    } catch (const std::runtime_error&) {
    }
}

void Gadget::unplug() {
    plugged_ = false;
    leave();
    if (control_thread_.joinable())
        control_thread_.join();
    if (pipe_thread_.joinable())
        pipe_thread_.join();
}

void Gadget::misbehave(Fate fate, std::size_t after) {
    const std::lock_guard lock(mutex_);
    fate_ = fate;
    until_fate_ = after;
}

// --- Requests

void Gadget::serve_control() {
    while (plugged_) {
        pollfd wait = {control_, POLLIN, 0};
        usb_functionfs_event event;
        if (poll(&wait, 1, 10) > 0 && read(control_, &event, sizeof event) == sizeof event &&
            event.type == FUNCTIONFS_SETUP)
            answer(event);
    }
}

/// The host is done with a transfer when the controller has the last packet, and its next request may be read
/// before that packet. So the function gets all packets before it answers the request. A thread that sleeps
/// in read() has no packet; a thread that was woken does not sleep.
void Gadget::await_packets() const {
    const auto settled = [&] {
        const Hand hand = hand_;
        if (hand != Hand::reads)
            return hand == Hand::empty;
        const std::string status = read_text("/proc/self/task/" + std::to_string(reader_) + "/stat");
        return status[status.rfind(')') + 2] == 'S' && hand_ == Hand::reads;
    };
    while (plugged_ && !settled())
        std::this_thread::yield();
}

/// A transfer in the wrong direction is a STALL. Once the data of a request were read, a STALL is no longer
/// possible.
void Gadget::answer(const usb_functionfs_event& event) {
    const auto& s = event.u.setup;
    const spangle::sim::UsbSetup setup = {s.bRequestType, s.bRequest, s.wValue, s.wIndex, s.wLength};
    Bytes bytes(setup.length), in;
    const bool to_host = (setup.type & 0x80) != 0;
    await_packets();
    if (!to_host && read(control_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
        return;
    const std::lock_guard lock(mutex_);
    const bool answered = function_.control(setup, bytes.data(), in);
    if (to_host && answered)
        (void)!write(control_, in.data(), in.size());
    else if (to_host)
        (void)!read(control_, bytes.data(), 0);
}

// --- The pipe
/// Reads packet by packet, because only the function knows how long a transfer is.
void Gadget::serve_pipe() {
    reader_ = gettid();
    halted_ = false;
    while (plugged_) {
        if (!behave()) {
            std::this_thread::sleep_for(moment);
            continue;
        }
        std::uint8_t packet[packet_bytes];
        hand_ = Hand::reads;
        const ssize_t count = read(pipe_, packet, sizeof packet);
        hand_ = count > 0 ? Hand::full : Hand::empty;
        if (count > 0)
            take(packet, static_cast<std::size_t>(count));
        else // the device is not configured, or gone
            std::this_thread::sleep_for(moment);
        hand_ = Hand::empty;
    }
}

/// No event tells when the host clears a halt, but packets come only after that.
void Gadget::take(const std::uint8_t* packet, std::size_t count) {
    const std::lock_guard lock(mutex_);
    if (halted_)
        function_.clear_halt();
    until_fate_ -= std::min(until_fate_, count);
    halted_ = !function_.bulk_out(1, packet, count);
    if (halted_)
        (void)!write(pipe_, packet, 1); // this write halts the pipe
}

/// Carries out the fate that is due. Returns false if the device must read nothing now.
bool Gadget::behave() {
    Fate due;
    {
        const std::lock_guard lock(mutex_);
        due = until_fate_ == 0 ? fate_ : Fate::normal;
        if (due != Fate::silent && due != Fate::normal)
            fate_ = Fate::normal;
    }
    const std::uint8_t nothing = 0;
    if (due == Fate::stall)
        (void)!write(pipe_, &nothing, 1);
    if (due == Fate::unplug)
        leave();
    return due == Fate::normal;
}

} // namespace kernel_test
