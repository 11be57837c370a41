// An I2C target at its two lines: it finds START, address, bytes and STOP in their levels (UM10204, 3.1.4 to
// 3.1.10). The model only listens; it takes for granted that the target acknowledges.
#pragma once

#include "host_sim/bus/i2c_target.hpp"
#include "host_sim/bus/pins.hpp"

namespace spangle::sim {

class I2cPins {
  public:
    /// `address` is the target's address of seven bits.
    I2cPins(I2cTarget& target, unsigned address) : target_(target), address_(address) {}
    /// Sets the levels of both lines, which start high. Times never go back, and one line changes at a time.
    void set(bool scl, bool sda, Time now);
    /// The number of messages to other addresses, of reads, and of bytes that a START or a STOP cut short.
    unsigned stray_messages() const { return stray_messages_; }

  private:
    enum class Phase : std::uint8_t { idle, address, bytes, other };
    I2cTarget& target_;
    unsigned address_;
    bool scl_level_ = true, sda_level_ = true;
    Phase phase_ = Phase::idle;
    unsigned shift_register_ = 0, bit_count_ = 0, stray_messages_ = 0;
    ClockPeriod clock_period_;
    unsigned shortest_period_ = ClockPeriod::unknown;

    void start(Time now);
    void stop(Time now);
    void clock_rises(Time now);
    void byte(Time now);
};

} // namespace spangle::sim
