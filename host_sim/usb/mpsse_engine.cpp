#include "host_sim/usb/mpsse_engine.hpp"

#include <algorithm>

namespace spangle::sim {
namespace {

constexpr Time second = 1'000'000'000;

/// How far ahead, and at which interval, a stream looks that waits for a pin, in ns. The chip's latency timer
/// is a millisecond.
constexpr Time patience = 1'000'000, look = 1000;

/// The number of bytes of a command with its parameters; 0: there is no such command.
std::size_t length_of(std::uint8_t command) {
    switch (command) {
    case 0x11:
    case 0x20:
    case 0x80:
    case 0x82:
    case 0x86:
        return 3;
    case 0x81:
    case 0x83:
    case 0x84:
    case 0x85:
    case 0x87:
    case 0x88:
    case 0x89:
    case 0x8A:
    case 0x8B:
    case 0x8D:
    case 0x97:
        return 1;
    default:
        return 0;
    }
}

} // namespace

void MpsseEngine::restart() {
    output_mask_ = pin_values_ = divisor_ = 0;
    is_60_mhz_ = false;
    has_loopback_ = true; // the chip starts in this mode; drivers must turn loopback off
    changed();
}

void MpsseEngine::purge_buffers(bool stream, bool answers) {
    if (stream)
        pending_commands_.clear();
    if (answers)
        answers_.clear();
}

void MpsseEngine::feed(const std::uint8_t* bytes, std::size_t count) {
    pending_commands_.insert(pending_commands_.end(), bytes, bytes + count);
    run_all();
}

void MpsseEngine::retry_waiting_stream() {
    run_all();
}

void MpsseEngine::run_all() {
    std::size_t done = 0;
    while (done < pending_commands_.size()) {
        const std::size_t taken = run(done);
        if (taken == 0)
            break;
        done += taken;
    }
    pending_commands_.erase(pending_commands_.begin(),
                            pending_commands_.begin() + static_cast<std::ptrdiff_t>(done));
}

std::vector<std::uint8_t> MpsseEngine::take_answers(std::size_t most) {
    const auto end = answers_.begin() + static_cast<std::ptrdiff_t>(std::min(most, answers_.size()));
    std::vector<std::uint8_t> taken(answers_.begin(), end);
    answers_.erase(answers_.begin(), end);
    return taken;
}

std::size_t MpsseEngine::run(std::size_t at) {
    const std::uint8_t command = pending_commands_[at];
    const std::size_t length = length_of(command);
    if (length == 0) {
        ++bad_commands_;
        answers_.insert(answers_.end(), {0xFA, command});
        return 1;
    }
    if (pending_commands_.size() - at < length)
        return 0;
    switch (command) {
    case 0x11:
        return write_bytes(at);
    case 0x20:
        read_bytes(at);
        break;
    case 0x80:
    case 0x82:
        set_pins(command == 0x80 ? 0 : 8, pending_commands_[at + 1], pending_commands_[at + 2]);
        break;
    case 0x81:
    case 0x83:
        answers_.push_back(get_pins(command == 0x81 ? 0 : 8));
        break;
    case 0x84:
    case 0x85:
        has_loopback_ = command == 0x84;
        break;
    case 0x86:
        divisor_ = pending_commands_[at + 1] | static_cast<unsigned>(pending_commands_[at + 2]) << 8;
        break;
    case 0x88:
    case 0x89:
        return wait_for(command == 0x88) ? length : 0;
    case 0x8A:
    case 0x8B:
        is_60_mhz_ = command == 0x8A;
        break;
    default: // the settings of these commands change nothing in the model
        break;
    }
    return length;
}

std::uint32_t MpsseEngine::clock_hz() const {
    return (is_60_mhz_ ? 60'000'000u : 12'000'000u) / ((1 + divisor_) * 2);
}

// --- levels of the pins

std::uint64_t MpsseEngine::levels() const {
    return (pin_values_ & output_mask_) |
           (~output_mask_ & 0xFFFFu & ~pulled_down); // inputs are pulled up (FT232H, 3.4)
}

void MpsseEngine::changed() {
    if (on_change)
        on_change(levels(), kernel_.now());
}

void MpsseEngine::set_pins(unsigned shift, std::uint8_t values, std::uint8_t outputs) {
    const unsigned mask = 0xFFu << shift;
    pin_values_ = (pin_values_ & ~mask) | static_cast<unsigned>(values) << shift;
    output_mask_ = (output_mask_ & ~mask) | static_cast<unsigned>(outputs) << shift;
    changed();
}

void MpsseEngine::drive(unsigned pin, bool high) {
    pin_values_ = (pin_values_ & ~(1u << pin)) | (high ? 1u : 0u) << pin;
    changed();
}

bool MpsseEngine::level(unsigned pin) {
    if ((output_mask_ >> pin & 1) != 0 || !input)
        return (levels() >> pin & 1) != 0;
    return input(pin, kernel_.now());
}

std::uint8_t MpsseEngine::get_pins(unsigned shift) {
    unsigned value = 0;
    for (unsigned i = 0; i < 8; ++i)
        value |= (level(shift + i) ? 1u : 0u) << i;
    return static_cast<std::uint8_t>(value);
}

bool MpsseEngine::wait_for(bool high) {
    for (Time waited = 0; waited < patience; waited += look, kernel_.advance(look))
        if (level(wait_pin) == high)
            return true;
    return false;
}

// --- bits on the serial lines

std::size_t MpsseEngine::write_bytes(std::size_t at) {
    const std::size_t count = (pending_commands_[at + 1] | std::size_t{pending_commands_[at + 2]} << 8) + 1;
    if (pending_commands_.size() - at < 3 + count)
        return 0;
    longest_burst_ = std::max(longest_burst_, count);
    for (std::size_t i = 0; i < count; ++i)
        exchange_byte(pending_commands_[at + 3 + i]);
    return 3 + count;
}

void MpsseEngine::read_bytes(std::size_t at) {
    const std::size_t count = (pending_commands_[at + 1] | std::size_t{pending_commands_[at + 2]} << 8) + 1;
    const bool out = (pin_values_ >> out_pin & 1) != 0;
    for (std::size_t i = 0; i < count; ++i)
        answers_.push_back(exchange_byte(out ? 0xFF : 0x00));
}

/// Exchanges a byte: data change at falling clocks, and are taken at rising clocks. Afterwards the data pin
/// keeps the last bit.
std::uint8_t MpsseEngine::exchange_byte(std::uint8_t out) {
    constexpr unsigned driven = 1u << clock_pin | 1u << out_pin;
    if ((output_mask_ & driven) != driven || (output_mask_ >> in_pin & 1) != 0)
        violations_ += "bits while SCK, MOSI or MISO points the wrong way\n";
    if ((pin_values_ >> clock_pin & 1) != 0)
        violations_ += "SCK rests high: that is not mode 0\n";
    if (has_loopback_)
        violations_ += "bits in loopback\n";
    const Time period = second / clock_hz();
    unsigned in = 0;
    for (unsigned bit = 8; bit-- != 0;) {
        drive(out_pin, (out >> bit & 1) != 0);
        kernel_.advance(period / 2);
        in = in << 1 | (level(in_pin) ? 1u : 0u);
        drive(clock_pin, true);
        kernel_.advance(period - period / 2);
        drive(clock_pin, false);
    }
    return static_cast<std::uint8_t>(in);
}

} // namespace spangle::sim
