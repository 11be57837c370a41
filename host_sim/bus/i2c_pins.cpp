#include "host_sim/bus/i2c_pins.hpp"

#include <algorithm>

namespace spangle::sim {

void I2cPins::set(bool scl, bool sda, Time now) {
    const bool condition = scl && sda != sda_; // data stand still while SCL is high; START and STOP do not
    const bool clocked = scl && !scl_;
    scl_ = scl;
    sda_ = sda;
    if (condition)
        sda ? stop(now) : start(now);
    else if (clocked)
        rise(now);
}

/// Begins a message. A repeated START ends the message before it.
void I2cPins::start(Time now) {
    stop(now);
    phase_ = Phase::address;
}

/// Ends a message. The clock of the STOP itself counts as the first bit of a byte that does not come.
void I2cPins::stop(Time now) {
    if (phase_ != Phase::idle && bits_ > 1)
        ++strays_;
    if (phase_ == Phase::bytes)
        target_.stop(now);
    phase_ = Phase::idle;
    shift_ = bits_ = 0;
    shortest_ = ClockPeriod::unknown;
    period_.restart();
}

void I2cPins::rise(Time now) {
    shortest_ = std::min(shortest_, period_.edge(now));
    if (++bits_ <= 8) {
        shift_ = shift_ << 1 | (sda_ ? 1u : 0u);
        return;
    }
    byte(now);
    shift_ = bits_ = 0;
    shortest_ = ClockPeriod::unknown;
}

void I2cPins::byte(Time now) {
    if (phase_ == Phase::bytes)
        target_.byte(static_cast<std::uint8_t>(shift_), now, shortest_);
    if (phase_ != Phase::address)
        return;
    const bool mine = shift_ == address_ << 1;
    phase_ = mine ? Phase::bytes : Phase::other;
    if (mine)
        target_.start(now);
    else
        ++strays_;
}

} // namespace spangle::sim
