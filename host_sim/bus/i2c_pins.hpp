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
    unsigned strays() const { return strays_; }

  private:
    enum class Phase : std::uint8_t { idle, address, bytes, other };
    I2cTarget& target_;
    unsigned address_;
    bool scl_ = true, sda_ = true;
    Phase phase_ = Phase::idle;
    unsigned shift_ = 0, bits_ = 0, strays_ = 0;
    ClockPeriod period_;
    unsigned shortest_ = ClockPeriod::unknown;

    void start(Time now);
    void stop(Time now);
    void rise(Time now);
    void byte(Time now);
};

} // namespace spangle::sim
