// I2C master of TI's Stellaris. LM3S811 datasheet (DS-LM3S811), 14.5.
#pragma once

#include <cstdint>

#include <spangle/hal/result.hpp>
#include <spangle/mcu/registers.hpp>

namespace spangle::mcu {

/// One master, for I2cWires.
class StellarisI2c {
  public:
    /// `base`: the block's address.
    explicit constexpr StellarisI2c(std::uintptr_t base) : base_(base) {}

    /// SCL = clock / (20 (period + 1)).
    void start(std::uint32_t period) const {
        constexpr std::uint32_t master_enable = 1u << 4;
        reg(base_ + mcr) = master_enable;
        reg(base_ + mtpr) = period;
    }

    /// Sends START, the address and the first byte.
    hal::Fault begin(std::uint8_t address, std::uint8_t first) const {
        reg(base_ + msa) = std::uint32_t{address} << 1; // R/S = 0: the master sends
        return command(first, start_condition | run);
    }
    /// Sends a further byte. Fault::no_answer: it was not acknowledged, and STOP was sent.
    hal::Fault write(std::uint8_t byte) const { return command(byte, run); }
    /// Sends the last byte, and STOP.
    hal::Fault end(std::uint8_t byte) const { return command(byte, run | stop_condition); }

    /// Offsets of the block's registers.
    static constexpr std::uintptr_t msa = 0x00, mcs = 0x04, mdr = 0x08, mtpr = 0x0C, mcr = 0x20;

  private:
    static constexpr std::uint32_t run = 1u << 0, start_condition = 1u << 1, stop_condition = 1u << 2;
    static constexpr std::uint32_t busy = 1u << 0, error = 1u << 1; // bits of MCS when it is read

    /// Sends a byte. Without an acknowledgement the bus is released, and the message is over.
    hal::Fault command(std::uint8_t byte, std::uint32_t bits) const {
        reg(base_ + mdr) = byte;
        reg(base_ + mcs) = bits;
        std::uint32_t status = 0;
        do
            status = reg(base_ + mcs);
        while ((status & busy) != 0);
        if ((status & error) == 0)
            return hal::Fault::none;
        if ((bits & stop_condition) == 0)
            reg(base_ + mcs) = stop_condition;
        return hal::Fault::no_answer;
    }

    std::uintptr_t base_;
};

} // namespace spangle::mcu
