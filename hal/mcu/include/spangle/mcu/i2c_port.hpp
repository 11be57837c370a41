// A display on I2C: a control byte stands for D/C (SSD1306 datasheet, 8.1.5).
//
// PolledBus takes a port, and FrameDisplay takes the wires themselves.
// `I2c` has begin(address, byte), write(byte) and end(byte), `Timer` has pause(micros).
#pragma once

#include <cstdint>

#include <spangle/hal/polled_bus.hpp>

namespace spangle::mcu {

/// The wires of a display on I2C, with the functions of a PolledPort.
template <class I2c, class Timer> class I2cWires {
  public:
    /// `address` is the controller's, of seven bits.
    constexpr I2cWires(I2c i2c, std::uint8_t address, Timer timer)
        : i2c_(i2c), address_(address), timer_(timer) {}

    /// Says whether commands or data follow; it does not fail.
    hal::Fault begin(bool data) {
        data_ = data;
        return hal::Fault::none;
    }
    /// Data go into one message. Each command is a message of its own, Co = 1: SSD0303 takes no more in one.
    hal::Fault write(const std::uint8_t* bytes, std::uint32_t count) {
        if (data_)
            return message(data_follow, bytes, count);
        hal::Fault fault = hal::Fault::none;
        for (; count != 0 && fault == hal::Fault::none; --count)
            fault = message(one_command, bytes++, 1);
        return fault;
    }
    /// Fails with Fault::unsupported: these controllers do not answer.
    hal::Fault read(std::uint8_t, std::uint8_t*, std::uint32_t) { return hal::Fault::unsupported; }
    /// Does nothing: each message ends by itself.
    void end() {}
    void reset(bool) {} ///< this port has no reset line
    /// Lets at least `micros` microseconds pass.
    void pause(std::uint32_t micros) { timer_.pause(micros); }

  private:
    static constexpr std::uint8_t one_command = 0x80, data_follow = 0x40;

    hal::Fault message(std::uint8_t control, const std::uint8_t* bytes, std::uint32_t count) const {
        if (count == 0)
            return hal::Fault::none;
        hal::Fault fault = i2c_.begin(address_, control);
        for (; count > 1 && fault == hal::Fault::none; --count)
            fault = i2c_.write(*bytes++);
        return fault == hal::Fault::none ? i2c_.end(*bytes) : fault;
    }

    I2c i2c_;
    std::uint8_t address_;
    Timer timer_;
    bool data_ = false;
};
/// The wires of a display on I2C as a PolledPort.
template <class I2c, class Timer> using I2cPort = hal::PolledPortOf<I2cWires<I2c, Timer>>;

} // namespace spangle::mcu
