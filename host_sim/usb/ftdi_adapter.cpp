#include "host_sim/usb/ftdi_adapter.hpp"

#include <algorithm>

namespace spangle::sim {
namespace {

constexpr std::size_t packet_bytes = 512; // bytes of a USB packet at high speed
constexpr std::uint8_t modem_status[] = {0x32, 0x60};

enum Request : std::uint8_t { RESET = 0, SET_LATENCY_TIMER = 9, SET_BITMODE = 11 };

} // namespace

std::vector<std::uint8_t> FtdiAdapter::descriptors() const {
    const unsigned interfaces = two_channels ? 2 : 1;
    const auto word = [](std::vector<std::uint8_t>& to, unsigned value) {
        to.insert(to.end(), {static_cast<std::uint8_t>(value), static_cast<std::uint8_t>(value >> 8)});
    };
    std::vector<std::uint8_t> d = {18, 1, 0x00, 0x02, 0, 0, 0, 64};
    word(d, 0x0403);
    word(d, !has_mpsse ? 0x6001 : two_channels ? 0x6010 : 0x6014);
    word(d, !has_mpsse ? 0x0600 : two_channels ? 0x0700 : 0x0900);
    d.insert(d.end(), {0, 0, 0, 1});
    d.insert(d.end(), {9, 2});
    word(d, 9 + interfaces * (9 + 2 * 7));
    d.insert(d.end(), {static_cast<std::uint8_t>(interfaces), 1, 0, 0x80, 45});
    for (unsigned i = 0; i < interfaces; ++i) {
        d.insert(d.end(), {9, 4, static_cast<std::uint8_t>(i), 0, 2, 0xFF, 0xFF, 0xFF, 0});
        for (const unsigned endpoint : {0x81 + 2 * i, 0x02 + 2 * i}) {
            d.insert(d.end(), {7, 5, static_cast<std::uint8_t>(endpoint), 2});
            word(d, packet_bytes);
            d.push_back(0);
        }
    }
    return d;
}

void FtdiAdapter::power_cycle() {
    mode_ = Mode::serial;
    latency_ms_ = 16;
    engine.purge_buffers(true, true);
    engine.restart();
}

bool FtdiAdapter::control(const UsbSetup& setup, const std::uint8_t*, std::vector<std::uint8_t>& in) {
    if (refused_request_ == setup.request && (setup.type & 0x60) == 0x40) {
        refused_request_ = -1;
        return false;
    }
    if (setup.type == 0x80 && setup.request == 0) { // the standard request GET_STATUS
        in.assign(2, 0);
        return true;
    }
    return setup.type == 0x40 && vendor(setup);
}

/// Answers a vendor request. The low byte of wIndex is the channel, counted from 1.
bool FtdiAdapter::vendor(const UsbSetup& setup) {
    if ((setup.index & 0xFF) != channel + 1) {
        violations_ += "request " + std::to_string(setup.request) + " to the other channel\n";
        return true;
    }
    switch (setup.request) {
    case RESET: // value 0 clears both directions, 1 what came from the host, 2 what goes to the host
        engine.purge_buffers(setup.value != 2, setup.value != 1);
        return setup.value <= 2;
    case SET_LATENCY_TIMER:
        latency_ms_ = setup.value;
        return setup.value >= 1 && setup.value <= 255;
    case SET_BITMODE:
        mode_ = setup.value >> 8 == 2 && has_mpsse ? Mode::mpsse : Mode::serial;
        engine.restart();
        return true;
    default:
        return false;
    }
}

bool FtdiAdapter::bulk_out(std::uint8_t endpoint, const std::uint8_t* bytes, std::size_t count) {
    if (endpoint != out_endpoint())
        return false;
    if (log != nullptr)
        log->insert(log->end(), bytes, bytes + count);
    if (mode_ == Mode::mpsse)
        engine.feed(bytes, count);
    return true;
}

/// Sends full packets, then one that is not full, each of which begins with two bytes of status. When the
/// latency timer ends, at least these two are sent.
bool FtdiAdapter::bulk_in(std::uint8_t endpoint, std::size_t most, std::vector<std::uint8_t>& in) {
    if (endpoint != in_endpoint())
        return false;
    engine.retry_waiting_stream();
    do {
        const std::size_t room = std::min(packet_bytes, most - in.size());
        in.insert(in.end(), std::begin(modem_status), std::end(modem_status));
        const auto payload = engine.take_answers(room - std::size(modem_status));
        in.insert(in.end(), payload.begin(), payload.end());
        if (garbles_answer_ && !payload.empty()) {
            in.back() ^= 0x18; // flips the pins of select and D/C
            garbles_answer_ = false;
        }
    } while (in.size() % packet_bytes == 0 && in.size() < most);
    return true;
}

} // namespace spangle::sim
