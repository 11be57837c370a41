#include "host_sim/bus/pins.hpp"

#include <algorithm>

namespace spangle::sim {

void SerialPins::set(Pin pin, bool high, Time now) {
    if (high == level(pin))
        return;
    levels_[static_cast<unsigned>(pin)] = high;
    switch (pin) {
    case Pin::reset:
        controller_.reset(!high, now);
        begin_byte();
        break;
    case Pin::select: // raised inside a byte it drops what came of it
        controller_.select(!high, now);
        begin_byte();
        period_.restart();
        miso_ = answering_ = false;
        break;
    case Pin::data:
        if (!level(Pin::select) && bits_ != 0)
            controller_.report(Rule::dc_in_byte,
                               "D/C changed after " + std::to_string(bits_) + " bits of a byte", now);
        break;
    case Pin::clock:
        if (!level(Pin::select))
            high ? rise(now) : fall();
        break;
    case Pin::mosi:
        break;
    }
}

void SerialPins::begin_byte() {
    shift_ = bits_ = 0;
    shortest_ = ClockPeriod::unknown;
}

void SerialPins::rise(Time now) {
    const unsigned period = period_.edge(now);
    shortest_ = std::min(shortest_, period);
    if (answering_)
        controller_.read_clock(now, period);
    shift_ = shift_ << 1 | (level(Pin::mosi) ? 1u : 0u);
    if (++bits_ < 8)
        return;
    controller_.write(static_cast<std::uint8_t>(shift_), level(Pin::data), now, shortest_);
    begin_byte();
}

void SerialPins::fall() {
    answering_ = controller_.answers();
    miso_ = answering_ && controller_.drive_bit();
}

void ParallelPins::set(Pin pin, bool high, Time now) {
    if (high == level(pin))
        return;
    levels_[static_cast<unsigned>(pin)] = high;
    const bool selected = !level(Pin::select);
    switch (pin) {
    case Pin::reset:
        controller_.reset(!high, now);
        break;
    case Pin::select:
        controller_.select(selected, now);
        write_cycle_.restart();
        read_cycle_.restart();
        break;
    case Pin::data:
        if (selected && !level(Pin::write))
            controller_.report(Rule::dc_in_byte, "D/C changed while WRX was low", now);
        break;
    case Pin::write:
        if (selected && high)
            controller_.write(lines_, level(Pin::data), now, write_cycle_.edge(now));
        break;
    case Pin::read:
        answer_ = 0;
        if (selected && high) {
            const unsigned period = read_cycle_.edge(now);
            for (int bit = 0; bit < 8; ++bit)
                controller_.read_clock(now, period);
        } else if (selected) {
            for (int bit = 0; bit < 8; ++bit)
                answer_ = static_cast<std::uint8_t>(answer_ << 1 | (controller_.drive_bit() ? 1 : 0));
        }
        break;
    }
}

} // namespace spangle::sim
