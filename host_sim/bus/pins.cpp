#include "host_sim/bus/pins.hpp"

#include <algorithm>

#include "host_sim/controller/dcs_commands.hpp"

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
    case Pin::select: // raising CS inside a byte drops the bits of that byte
        controller_.select(!high, now);
        begin_byte();
        clock_period_.restart();
        miso_ = is_answering_ = false;
        break;
    case Pin::data:
        if (!level(Pin::select) && bit_count_ != 0 && !is_three_wire_)
            controller_.report(Rule::dc_in_byte,
                               "D/C changed after " + std::to_string(bit_count_) + " bits of a byte", now);
        break;
    case Pin::clock:
        if (!level(Pin::select))
            high ? clock_rises(now) : clock_falls();
        break;
    case Pin::mosi:
        break;
    }
}

void SerialPins::begin_byte() {
    shift_register_ = bit_count_ = 0;
    shortest_period_ = ClockPeriod::unknown;
}

void SerialPins::clock_rises(Time now) {
    const unsigned period = clock_period_.note_edge(now);
    shortest_period_ = std::min(shortest_period_, period);
    if (is_answering_) {
        controller_.read_clock(now, period);
        return;
    }
    shift_register_ = shift_register_ << 1 | (level(Pin::mosi) ? 1u : 0u);
    if (++bit_count_ < (is_three_wire_ ? 9u : 8u))
        return;
    const bool data = is_three_wire_ ? (shift_register_ >> 8 & 1) != 0 : level(Pin::data);
    controller_.write(static_cast<std::uint8_t>(shift_register_), data, now, shortest_period_);
    begin_byte();
}

void SerialPins::clock_falls() {
    is_answering_ = controller_.answers();
    miso_ = is_answering_ && controller_.drive_bit();
}

bool ParallelPins::two_bytes() const {
    const bool memory = command_ == dcs::memory_write || command_ == dcs::memory_write_on ||
                        command_ == dcs::memory_read || command_ == dcs::memory_read_on;
    return is_16_bits_ && memory;
}

void ParallelPins::write(Time now) {
    const bool data = level(Pin::data);
    const unsigned period = write_cycle_.note_edge(now);
    is_dummy_cycle_ = true;
    if (!data)
        command_ = static_cast<std::uint8_t>(data_lines_);
    else if (two_bytes())
        controller_.write(static_cast<std::uint8_t>(data_lines_ >> 8), true, now, period);
    controller_.write(static_cast<std::uint8_t>(data_lines_), data, now, period);
}

void ParallelPins::read(bool high, Time now) {
    const int bits = two_bytes() && !is_dummy_cycle_ ? 16 : 8;
    answer_ = 0;
    if (high) {
        const unsigned period = read_cycle_.note_edge(now);
        for (int bit = 0; bit < bits; ++bit)
            controller_.read_clock(now, period);
        is_dummy_cycle_ = false;
        return;
    }
    for (int bit = 0; bit < bits; ++bit)
        answer_ = answer_ << 1 | (controller_.drive_bit() ? 1u : 0u);
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
            write(now);
        break;
    case Pin::read:
        if (selected)
            read(high, now);
        else
            answer_ = 0;
        break;
    }
}

} // namespace spangle::sim
