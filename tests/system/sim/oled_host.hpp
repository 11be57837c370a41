// Sends bytes to a model of an OLED controller as a host would, and reads its glass.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <vector>

#include "host_sim/controller/oled.hpp"

namespace sim_test {

using namespace spangle::sim;

template <class Controller, class Chip> struct OledHost {
    Controller chip;
    Time now = 0;
    unsigned period = 250;
    bool parameters_are_data;

    OledHost(const Chip& c, const GlassMount& glass, OledBus bus = OledBus::serial)
        : chip(c, glass, bus), parameters_are_data(c.chip.parameters_are_data) {
        if (bus == OledBus::i2c)
            period = 2500;
        reset(100'000);
        now += 100'000'000;
    }
    void reset(Time low) {
        chip.reset(true, now);
        now += low;
        chip.reset(false, now);
    }
    void byte(int value, bool data) {
        chip.select(true, now);
        chip.write(static_cast<std::uint8_t>(value), data, now += 8 * period, period);
        chip.select(false, now);
    }
    /// Sends a command, and its parameters in the way the chip takes them.
    void send(int command, std::initializer_list<int> parameters = {}) {
        byte(command, false);
        for (const int p : parameters)
            byte(p, parameters_are_data);
    }
    void commands(std::initializer_list<int> bytes) {
        for (const int b : bytes)
            byte(b, false);
    }
    void data(std::initializer_list<int> bytes) {
        for (const int b : bytes)
            byte(b, true);
    }
    void fill(int value, int count) {
        for (int i = 0; i < count; ++i)
            byte(value, true);
    }
    bool reported(Rule rule) const {
        return std::any_of(chip.violations().begin(), chip.violations().end(),
                           [rule](const Violation& v) { return v.rule == rule; });
    }
    /// Returns the rules that were broken, and forgets them.
    std::string broken() {
        std::string rules;
        for (const Violation& v : chip.violations())
            rules += (rules.empty() ? "" : " ") + std::to_string(static_cast<int>(v.rule));
        chip.forget_violations();
        return rules;
    }
    Rgb666 seen(int x, int y) {
        return chip.glass(now)[static_cast<std::size_t>(y * chip.mount().width + x)];
    }
};

} // namespace sim_test
