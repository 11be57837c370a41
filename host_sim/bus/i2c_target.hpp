// A display controller at an I2C address: messages in, whose control bytes say whether commands or data
// follow (SSD1306 datasheet, 8.1.5.2: Co = 1 one byte, Co = 0 the rest of the message).
#pragma once

#include "host_sim/controller/controller.hpp"

namespace spangle::sim {

class I2cTarget {
  public:
    explicit I2cTarget(Controller& controller) : controller_(controller) {}
    /// START and the address that is its own.
    void start(Time now);
    /// A byte of the message behind the address; `period_ns` of SCL.
    void byte(std::uint8_t value, Time now, unsigned period_ns);
    void stop(Time now);

  private:
    enum class Expects : std::uint8_t { nothing, control, one_byte, bytes };
    Controller& controller_;
    Expects expects_ = Expects::nothing;
    bool data_ = false;
};

} // namespace spangle::sim
