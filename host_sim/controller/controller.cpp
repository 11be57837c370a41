#include "host_sim/controller/controller.hpp"

#include <cstdio>

namespace spangle::sim {

bool Controller::read_bit(Time now, unsigned period_ns) {
    const bool bit = drive_bit();
    read_clock(now, period_ns);
    return bit;
}

std::uint8_t Controller::read_byte(Time now, unsigned period_ns) {
    unsigned byte = 0;
    for (int i = 0; i < 8; ++i)
        byte = byte << 1 | (read_bit(now, period_ns) ? 1u : 0u);
    return static_cast<std::uint8_t>(byte);
}

void Controller::report(Rule rule, const std::string& text, Time at) {
    violations_.push_back({rule, std::string(name_) + ": " + text, at});
}

std::string Controller::violations_text() const {
    std::string text;
    for (const Violation& v : violations_)
        text += "rule " + std::to_string(static_cast<int>(v.rule)) + " at " + std::to_string(v.at / 1000) +
                " us: " + v.text + "\n";
    return text;
}

std::string hex_text(unsigned v) {
    char text[8];
    std::snprintf(text, sizeof text, "%02Xh", v);
    return text;
}

} // namespace spangle::sim
