#include "host_sim/usb/usbip.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

namespace spangle::sim {
namespace {

constexpr char attach_file[] = "/sys/devices/platform/vhci_hcd.0/attach";
constexpr unsigned device_id = 0x10002;
constexpr int most_tries = 2000;

// Offsets of words in a packet. They are big-endian; the setup bytes are not.
enum Word : std::size_t {
    command = 0,
    sequence = 4,
    direction = 12,
    endpoint = 16,
    buffer_length = 24,
    setup_bytes = 40,
    victim = 20,        // offset in CMD_UNLINK
    status = 20,        // offset in answers
    actual_length = 24, // offset in RET_SUBMIT
};
enum Command : std::uint32_t { cmd_submit = 1, cmd_unlink = 2, ret_submit = 3, ret_unlink = 4 };

template <class Packet> std::uint32_t word(const Packet& packet, std::size_t at) {
    return std::uint32_t{packet[at]} << 24 | std::uint32_t{packet[at + 1]} << 16 |
           std::uint32_t{packet[at + 2]} << 8 | packet[at + 3];
}

template <class Packet> void put_word(Packet& packet, std::size_t at, std::uint32_t value) {
    for (int i = 0; i < 4; ++i)
        packet[at + static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(value >> (24 - 8 * i));
}

/// Reads the setup bytes, which are little-endian as on the wire of USB.
template <class Packet> UsbSetup setup_of(const Packet& p) {
    const auto half = [&](std::size_t at) {
        return static_cast<std::uint16_t>(p[setup_bytes + at] | p[setup_bytes + at + 1] << 8);
    };
    return {p[setup_bytes], p[setup_bytes + 1], half(2), half(4), half(6)};
}

} // namespace

// --- plugging in and out

bool UsbipDevice::plug() {
    unplug();
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        return false;
    const bool attached = attach(ends[1]);
    const int error = errno;
    ::close(ends[1]); // the kernel keeps its own reference to the socket
    if (!attached) {
        ::close(ends[0]);
        errno = error;
        return false;
    }
    socket_ = ends[0];
    thread_ = std::thread([this] { serve_socket(); });
    return true;
}

/// Attaches the socket to the first port. A port that was used a moment ago stays taken for a while, so this
/// tries again.
bool UsbipDevice::attach(int socket) {
    const int file = ::open(attach_file, O_WRONLY | O_CLOEXEC);
    if (file < 0)
        return false;
    char line[64]; // holds port, socket, device and speed
    const int count =
        std::snprintf(line, sizeof line, "0 %d %u %d", socket, device_id, is_high_speed_ ? 3 : 2);
    bool attached = false;
    for (int tries = 0; tries < most_tries && !attached; ++tries) {
        attached = ::write(file, line, static_cast<std::size_t>(count)) == count;
        if (!attached && errno != EBUSY)
            break;
        if (!attached)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    const int error = errno;
    ::close(file);
    errno = error;
    return attached;
}

void UsbipDevice::unplug() {
    if (!thread_.joinable())
        return;
    ::shutdown(socket_, SHUT_RDWR);
    thread_.join();
    ::close(socket_);
    pending_transfers_.clear();
}

bool UsbipDevice::receive(void* into, std::size_t count) {
    return count == 0 || ::recv(socket_, into, count, MSG_WAITALL) == static_cast<ssize_t>(count);
}

bool UsbipDevice::send(const void* from, std::size_t count) {
    return ::send(socket_, from, count, MSG_NOSIGNAL) == static_cast<ssize_t>(count);
}

// --- Packets of the host

/// Serves the host until one of both ends hangs up.
void UsbipDevice::serve_socket() {
    Packet packet;
    bool there = true;
    while (there && receive(packet.data(), packet.size())) {
        if (word(packet, command) == cmd_submit)
            there = handle_submit(packet);
        else
            there = word(packet, command) == cmd_unlink && unlinked(packet);
    }
    ::shutdown(socket_, SHUT_RDWR);
}

bool UsbipDevice::handle_submit(const Packet& packet) {
    Transfer t;
    t.sequence = word(packet, sequence);
    t.length = word(packet, buffer_length);
    t.to_host = word(packet, direction) != 0;
    t.endpoint = static_cast<std::uint8_t>(word(packet, endpoint) | (t.to_host ? 0x80 : 0));
    t.setup = setup_of(packet);
    if (!t.to_host) {
        t.bytes.resize(t.length);
        if (!receive(t.bytes.data(), t.bytes.size()))
            return false;
    }
    const std::lock_guard lock(mutex_);
    if ((t.endpoint & 0x7F) == 0) {
        const int result = control(t);
        const std::size_t length = t.to_host ? t.bytes.size() : t.length;
        return finish(t, result, result == 0 ? length : 0);
    }
    pending_transfers_.push_back(std::move(t));
    return run();
}

/// The host takes a transfer back. Answers with status 0 if the transfer was done before.
bool UsbipDevice::unlinked(const Packet& packet) {
    const std::lock_guard lock(mutex_);
    const auto it = std::find_if(pending_transfers_.begin(), pending_transfers_.end(),
                                 [&](const Transfer& t) { return t.sequence == word(packet, victim); });
    Packet answer{};
    put_word(answer, command, ret_unlink);
    put_word(answer, sequence, word(packet, sequence));
    put_word(answer, status, it != pending_transfers_.end() ? static_cast<std::uint32_t>(-ECONNRESET) : 0);
    const bool head = it == pending_transfers_.begin();
    if (it != pending_transfers_.end())
        pending_transfers_.erase(it);
    return send(answer.data(), answer.size()) && (!head || run());
}

// --- the bulk pipe

/// Works off the waiting transfers in order, until the device keeps one. Returns false when the connection
/// ends.
bool UsbipDevice::run() {
    while (!pending_transfers_.empty()) {
        Transfer& next = pending_transfers_.front();
        const Fate met = fate && !next.to_host ? fate(next.length) : Fate::normal;
        if (met == Fate::silent)
            return true;
        if (met == Fate::unplug || !carry(next, met))
            return false;
        pending_transfers_.pop_front();
    }
    return true;
}

bool UsbipDevice::carry(Transfer& t, Fate met) {
    if (met == Fate::stall)
        return finish(t, -EPIPE, 0);
    if (met == Fate::error)
        return finish(t, -EPROTO, 0);
    if (t.to_host) {
        const bool answered = function_.bulk_in(t.endpoint, t.length, t.bytes);
        return finish(t, answered ? 0 : -EPIPE, t.bytes.size());
    }
    const std::size_t count = met == Fate::cut ? t.length / 2 : t.length;
    const bool taken = function_.bulk_out(t.endpoint, t.bytes.data(), count);
    return finish(t, taken ? 0 : -EPIPE, taken ? count : 0);
}

bool UsbipDevice::finish(const Transfer& t, int result, std::size_t length) {
    Packet answer{};
    put_word(answer, command, ret_submit);
    put_word(answer, sequence, t.sequence);
    put_word(answer, status, static_cast<std::uint32_t>(result));
    put_word(answer, actual_length, static_cast<std::uint32_t>(length));
    return send(answer.data(), answer.size()) && (!t.to_host || length == 0 || send(t.bytes.data(), length));
}

// --- the control pipe

int UsbipDevice::control(Transfer& t) {
    std::vector<std::uint8_t> in;
    const bool answered = (t.setup.type & 0x60) == 0 ? handle_standard_request(t.setup, in)
                                                     : function_.control(t.setup, t.bytes.data(), in);
    in.resize(std::min<std::size_t>(in.size(), t.setup.length));
    if (t.to_host)
        t.bytes = std::move(in);
    return answered ? 0 : -EPIPE;
}

/// Answers what a device's USB engine answers without its firmware (USB 2.0, 9.4). The device has one
/// configuration, one setting of each interface, no strings and no other speed.
bool UsbipDevice::handle_standard_request(const UsbSetup& setup, std::vector<std::uint8_t>& in) {
    constexpr std::size_t device_bytes = 18;
    constexpr unsigned get_status = 0, clear_feature = 1, get_descriptor = 6, of_endpoint = 2;
    const std::vector<std::uint8_t> all = function_.descriptors();
    const auto split = all.begin() + device_bytes;
    const unsigned kind = setup.value >> 8;
    if ((setup.type & 0x80) == 0) {
        if (setup.request == clear_feature && (setup.type & 0x1F) == of_endpoint)
            function_.clear_halt();
        return true;
    }
    if (setup.request == get_status)
        in = {0, 0};
    else if (setup.request == get_descriptor && kind == 1)
        in.assign(all.begin(), split);
    else if (setup.request == get_descriptor && kind == 2)
        in.assign(split, all.end());
    return !in.empty();
}

} // namespace spangle::sim
