#include "host_sim/bus/i2c_target.hpp"

namespace spangle::sim {
namespace {

constexpr std::uint8_t co = 0x80, dc = 0x40;

} // namespace

void I2cTarget::start(Time now) {
    controller_.select(true, now);
    next_byte_ = Expects::control;
}

void I2cTarget::byte(std::uint8_t value, Time now, unsigned period_ns) {
    switch (next_byte_) {
    case Expects::nothing:
        return;
    case Expects::control:
        if ((value & ~(co | dc)) != 0) {
            controller_.report(
                Rule::control_byte,
                hex_text(value) + " is no control byte: a message, or its next part, begins with one", now);
            next_byte_ = Expects::nothing;
            return;
        }
        is_data_ = (value & dc) != 0;
        next_byte_ = (value & co) != 0 ? Expects::one_byte : Expects::bytes;
        return;
    case Expects::one_byte:
        next_byte_ = Expects::control;
        [[fallthrough]];
    case Expects::bytes:
        controller_.write(value, is_data_, now, period_ns);
        return;
    }
}

void I2cTarget::stop(Time now) {
    if (next_byte_ == Expects::one_byte)
        controller_.report(Rule::control_byte, "the message ended behind a control byte", now);
    next_byte_ = Expects::nothing;
    controller_.select(false, now);
}

} // namespace spangle::sim
