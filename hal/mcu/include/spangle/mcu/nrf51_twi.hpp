// I2C master (TWI) of Nordic's nRF51. nRF51 Series Reference Manual, chapter 28.
#pragma once

#include <cstdint>

#include <spangle/hal/result.hpp>
#include <spangle/mcu/registers.hpp>

namespace spangle::mcu {

/// A TWI block, for I2cWires.
class Nrf51Twi {
  public:
    /// Values of FREQUENCY: SCL of 100 and of 400 kHz.
    static constexpr std::uint32_t khz100 = 0x01980000, khz400 = 0x06680000;

    /// `base`: the block's address.
    explicit constexpr Nrf51Twi(std::uintptr_t base) : base_(base) {}

    /// Sets the block up; `clock` is a value of FREQUENCY.
    void start(unsigned scl_pin, unsigned sda_pin, std::uint32_t clock) const {
        constexpr std::uint32_t enabled = 5;
        reg(base_ + pselscl) = scl_pin;
        reg(base_ + pselsda) = sda_pin;
        reg(base_ + frequency) = clock;
        reg(base_ + enable) = enabled;
    }

    /// Sends START, the address and the first byte.
    hal::Fault begin(std::uint8_t slave, std::uint8_t first) const {
        reg(base_ + address) = slave;
        reg(base_ + event_error) = 0;
        reg(base_ + task_start_tx) = 1;
        return write(first);
    }
    /// Sends a further byte. Fault::no_answer: it was not acknowledged, and STOP was sent.
    hal::Fault write(std::uint8_t byte) const {
        reg(base_ + event_sent) = 0;
        reg(base_ + txd) = byte;
        while (reg(base_ + event_sent) == 0)
            if (reg(base_ + event_error) != 0) {
                stop();
                return hal::Fault::no_answer;
            }
        return hal::Fault::none;
    }
    /// Sends the last byte, and STOP.
    hal::Fault end(std::uint8_t byte) const {
        const hal::Fault fault = write(byte);
        if (fault == hal::Fault::none)
            stop();
        return fault;
    }

    /// Offsets of the block's registers.
    static constexpr std::uintptr_t task_start_tx = 0x008, task_stop = 0x014, event_stopped = 0x104,
                                    event_sent = 0x11C, event_error = 0x124, enable = 0x500, pselscl = 0x508,
                                    pselsda = 0x50C, txd = 0x51C, frequency = 0x524, address = 0x588;

  private:
    void stop() const {
        reg(base_ + event_stopped) = 0;
        reg(base_ + task_stop) = 1;
        while (reg(base_ + event_stopped) == 0) {
        }
    }

    std::uintptr_t base_;
};

} // namespace spangle::mcu
