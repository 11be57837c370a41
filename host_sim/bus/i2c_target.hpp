// A display controller at an I2C address. Control bytes in each message say whether commands or data follow
// (SSD1306 datasheet, 8.1.5.2: Co = 1 announces one byte, Co = 0 the rest of the message).
#pragma once

#include "host_sim/controller/controller.hpp"

namespace spangle::sim {

class I2cTarget {
  public:
    explicit I2cTarget(Controller& controller) : controller_(controller) {}
    /// Begins a message: START and the target's own address were received.
    void start(Time now);
    /// Takes a byte of the message after its address; `period_ns` is the period of SCL.
    void byte(std::uint8_t value, Time now, unsigned period_ns);
    void stop(Time now);

  private:
    enum class Expects : std::uint8_t { nothing, control, one_byte, bytes };
    Controller& controller_;
    Expects next_byte_ = Expects::nothing;
    bool is_data_ = false;
};

} // namespace spangle::sim
