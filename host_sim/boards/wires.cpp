#include "host_sim/boards/wires.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "host_sim/board/module.hpp"

namespace spangle::sim {

namespace {

/// The level of a pin, as its register was last written. It has no level before the first write.
class PinLevel {
  public:
    explicit PinLevel(const WirePin& pin) : pin_(pin) {}

    /// Returns true when the write changed the level, or was the first.
    bool write(std::uint64_t address, std::uint32_t value) {
        if (pin_.address == 0 || address != pin_.address)
            return false;
        int level = (value >> pin_.bit & 1) != 0 ? 1 : 0;
        if (pin_.set_reset && level == 0)
            level = (value >> (pin_.bit + 16) & 1) != 0 ? 0 : level_;
        return std::exchange(level_, level) != level;
    }
    bool high() const { return level_ == 1; }

  private:
    WirePin pin_;
    int level_ = -1;
};

bool parse_pin(const char* text, WirePin& pin) {
    char* end = nullptr;
    pin.address = std::strtoull(text, &end, 0);
    if (*end != ':')
        return false;
    pin.bit = static_cast<unsigned>(std::strtoul(end + 1, &end, 0));
    pin.set_reset = std::strcmp(end, ":set_reset") == 0;
    return *end == '\0' || pin.set_reset;
}

} // namespace

bool parse_wiring(const std::string& word, Wiring& wiring) {
    const std::size_t at = word.find('=');
    if (at == std::string::npos)
        return false;
    const std::string key = word.substr(0, at);
    const char* const value = word.c_str() + at + 1;
    if (key == "select")
        return parse_pin(value, wiring.select);
    if (key == "data")
        return parse_pin(value, wiring.data_command);
    if (key == "reset")
        return parse_pin(value, wiring.reset);
    if (key == "spi")
        wiring.data_register = std::strtoull(value, nullptr, 0);
    else if (key == "select_high")
        wiring.select_high = std::strcmp(value, "1") == 0;
    else if (key == "pause") {
        char* end = nullptr;
        wiring.pause_register = std::strtoull(value, &end, 0);
        wiring.pause_hz = *end == ':' ? std::strtoull(end + 1, nullptr, 0) : 0;
        return wiring.pause_hz != 0;
    } else
        return false;
    return true;
}

std::vector<WireEvent> read_trace(std::istream& trace, const Wiring& wiring) {
    using Kind = WireEvent::Kind;
    // A timer that counts instructions is set to run as far as it can; such a write is no pause.
    constexpr std::uint32_t free_running = 0xFFFFFF;
    PinLevel select(wiring.select), data(wiring.data_command), reset(wiring.reset);
    std::vector<WireEvent> events;
    for (std::string line; std::getline(trace, line);) {
        const std::size_t at = line.find(" addr ");
        unsigned long long address = 0;
        unsigned value = 0;
        if (at == std::string::npos ||
            std::sscanf(line.c_str() + at, " addr %llx value %x", &address, &value) != 2)
            continue;
        if (address == wiring.data_register)
            events.push_back({Kind::byte, value & 0xFF});
        if (select.write(address, value))
            events.push_back({select.high() == wiring.select_high ? Kind::select : Kind::release, 0});
        if (data.write(address, value))
            events.push_back({data.high() ? Kind::data : Kind::command, 0});
        if (reset.write(address, value))
            events.push_back({reset.high() ? Kind::reset_high : Kind::reset_low, 0});
        if (address == wiring.pause_register && wiring.pause_register != 0 && value != free_running)
            events.push_back({Kind::pause, static_cast<std::uint32_t>(std::min<std::uint64_t>(
                                               value * 1000000000ull / wiring.pause_hz, UINT32_MAX))});
    }
    return events;
}

WiredPanel::WiredPanel(const hal::Board& board, const Wiring& wiring, std::vector<WireEvent> events)
    : board_(board), has_pauses_(wiring.pause_register != 0),
      controller_(make_controller(*board.display.panel, board.bus)), events_(std::move(events)),
      is_selected_(wiring.select.address == 0) {}

void WiredPanel::take(const WireEvent& event) {
    using Kind = WireEvent::Kind;
    const auto period = static_cast<unsigned>(1000000000u / board_.write_hz);
    switch (event.kind) {
    case Kind::byte:
        current_time_ += Time{8} * period;
        if (!is_selected_)
            break;
        controller_->write(static_cast<std::uint8_t>(event.value), is_data_, current_time_, period);
        payload_ += board_.bus == hal::BusKind::spi_start && !is_started_ ? 0 : 1;
        is_started_ = true;
        break;
    case Kind::select:
    case Kind::release:
        is_selected_ = event.kind == Kind::select;
        is_started_ = false;
        controller_->select(is_selected_, current_time_);
        break;
    case Kind::data:
    case Kind::command:
        is_data_ = event.kind == Kind::data;
        break;
    case Kind::reset_low:
    case Kind::reset_high:
        controller_->reset(event.kind == Kind::reset_low, current_time_);
        break;
    case Kind::pause:
        current_time_ += event.value;
        break;
    }
}

bool WiredPanel::advance(std::uint64_t payload) {
    while (payload_ < payload && next_ < events_.size())
        take(events_[next_++]);
    // Other events after the last byte, such as deselecting the panel, are taken together with this byte.
    while (payload_ == payload && next_ < events_.size() && events_[next_].kind != WireEvent::Kind::byte)
        take(events_[next_++]);
    return payload_ == payload;
}

bool WiredPanel::at_end() const {
    return next_ == events_.size();
}

Image WiredPanel::glass() {
    current_time_ += 2 * controller_->refresh_time();
    return upright(picture_of_glass(*controller_, current_time_), board_.display.orientation);
}

std::string WiredPanel::violations() const {
    std::string text;
    for (const Violation& v : controller_->violations())
        if (has_pauses_ || (v.rule != Rule::too_early && v.rule != Rule::reset_pulse))
            text += v.text + "\n";
    return text;
}

} // namespace spangle::sim
