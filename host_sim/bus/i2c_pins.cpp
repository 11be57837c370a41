#include "host_sim/bus/i2c_pins.hpp"

#include <algorithm>

namespace spangle::sim {

void I2cPins::set(bool scl, bool sda, Time now) {
    const bool condition =
        scl && sda != sda_level_; // data stand still while SCL is high; START and STOP do not
    const bool clocked = scl && !scl_level_;
    scl_level_ = scl;
    sda_level_ = sda;
    if (condition)
        sda ? stop(now) : start(now);
    else if (clocked)
        clock_rises(now);
}

/// Begins a message. A repeated START ends the message before it.
void I2cPins::start(Time now) {
    stop(now);
    phase_ = Phase::address;
}

/// Ends a message. The clock of the STOP itself counts as the first bit of a byte that does not come.
void I2cPins::stop(Time now) {
    if (phase_ != Phase::idle && bit_count_ > 1)
        ++stray_messages_;
    if (phase_ == Phase::bytes)
        target_.stop(now);
    phase_ = Phase::idle;
    shift_register_ = bit_count_ = 0;
    shortest_period_ = ClockPeriod::unknown;
    clock_period_.restart();
}

void I2cPins::clock_rises(Time now) {
    shortest_period_ = std::min(shortest_period_, clock_period_.note_edge(now));
    if (++bit_count_ <= 8) {
        shift_register_ = shift_register_ << 1 | (sda_level_ ? 1u : 0u);
        return;
    }
    byte(now);
    shift_register_ = bit_count_ = 0;
    shortest_period_ = ClockPeriod::unknown;
}

void I2cPins::byte(Time now) {
    if (phase_ == Phase::bytes)
        target_.byte(static_cast<std::uint8_t>(shift_register_), now, shortest_period_);
    if (phase_ != Phase::address)
        return;
    const bool mine = shift_register_ == address_ << 1;
    phase_ = mine ? Phase::bytes : Phase::other;
    if (mine)
        target_.start(now);
    else
        ++stray_messages_;
}

} // namespace spangle::sim
