#include "host_sim/bus/sim_bus.hpp"

#include <algorithm>
#include <utility>

namespace spangle::sim {

SimBus::SimBus(Controller& controller, const hal::BusCaps& caps) : controller_(controller), caps_(caps) {}

hal::Result<hal::Buffer> SimBus::acquire(std::size_t size) {
    buffers_.push_back(std::make_unique<std::uint8_t[]>(size));
    return hal::Buffer{buffers_.back().get(), size};
}

std::uint64_t SimBus::checksum(const WatchedBuffer& w) {
    std::uint64_t sum = 0;
    for (std::uint32_t row = 0; row < w.rows; ++row) {
        const std::uint8_t* const at = w.data + static_cast<std::ptrdiff_t>(row) * w.stride;
        for (std::uint32_t i = 0; i < w.length; ++i)
            sum = (sum ^ at[i]) * 0x100000001B3u;
    }
    return sum;
}

hal::Result<hal::Token> SimBus::submit(const hal::Op* ops, std::size_t count) {
    if (ops == nullptr && count != 0)
        return hal::Error{hal::Fault::bad_argument, "SimBus: submit without operations"};
    if (next_fault_ != hal::Fault::none && next_fault_ != hal::Fault::short_write &&
        next_fault_ != hal::Fault::timeout) {
        const hal::Fault fault = std::exchange(next_fault_, hal::Fault::none);
        return hal::Error{fault, "SimBus: the transfer was made to fail"};
    }
    const std::size_t sent = next_fault_ == hal::Fault::short_write ? count / 2 : count;
    wire_end_ = std::max(wire_end_, now_);
    ++counters_.transfers;
    watched_buffers_.clear();
    if (!is_framed())
        chip_select(true);
    for (std::size_t i = 0; i < sent; ++i)
        run(ops[i]);
    end_message();
    if (!is_framed())
        chip_select(false);
    token_end_ = wire_end_;
    return hal::Token{++last_token_};
}

bool SimBus::done(hal::Token token) const {
    return token.id < last_token_ || now_ >= token_end_;
}

hal::Result<void> SimBus::wait(hal::Token token, std::uint32_t timeout_micros) {
    if (token.id == 0 || token.id > last_token_)
        return hal::Error{hal::Fault::bad_argument, "SimBus: wait for a token that was never given"};
    if (next_fault_ == hal::Fault::short_write) {
        next_fault_ = hal::Fault::none;
        now_ = std::max(now_, token_end_); // the transfer is over, and half of it was lost
        return hal::Error{hal::Fault::short_write, "SimBus: half of the transfer was made to be lost"};
    }
    if (std::exchange(is_unacknowledged_, false)) {
        now_ = std::max(now_, token_end_);
        return hal::Error{hal::Fault::no_answer, "SimBus: nobody acknowledged the address"};
    }
    const Time deadline = now_ + static_cast<Time>(timeout_micros) * 1000;
    if (next_fault_ == hal::Fault::timeout || (token.id == last_token_ && token_end_ > deadline)) {
        if (next_fault_ == hal::Fault::timeout)
            token_end_ = deadline + 1'000'000'000; // the transfer hangs for another second
        next_fault_ = hal::Fault::none;
        now_ = deadline;
        return hal::Error{hal::Fault::timeout, "SimBus: the transfer did not end in time"};
    }
    if (token.id == last_token_) {
        now_ = std::max(now_, token_end_);
        for (const WatchedBuffer& w : watched_buffers_)
            if (checksum(w) != w.checksum)
                controller_.report(Rule::buffer_changed, "a buffer was drawn into while it was on the wire",
                                   now_);
        watched_buffers_.clear();
    }
    return {};
}

void SimBus::chip_select(bool selected) {
    if (listener_ != nullptr && selected)
        listener_->chip_select(wire_end_, true);
    controller_.select(selected, wire_end_);
    if (listener_ != nullptr && !selected)
        listener_->chip_select(wire_end_, false);
}

/// Begins a message unless one of this kind is open. An I2C message holds commands or data; a message that a
/// start byte opens holds one index, or data.
void SimBus::begin_message(bool data) {
    if (is_in_message_ && data == message_is_data_ && (data || is_i2c()))
        return;
    end_message();
    is_in_message_ = true;
    message_is_data_ = data;
    if (!is_i2c()) { // an index ends when CS rises
        constexpr std::uint8_t index = 0x70, value = 0x72;
        chip_select(true);
        carry(data ? value : index, data);
        return;
    }
    is_in_message_ = false;
    constexpr std::uint8_t address = 0x3C << 1, data_follows = 0x40;
    send_condition(&Listener::start);
    if (carry(address, false))
        target_.start(wire_end_);
    else
        is_unacknowledged_ = true;
    is_in_message_ = true;
    carry(data ? data_follows : std::uint8_t{0}, data);
}

void SimBus::end_message() {
    if (!is_in_message_)
        return;
    is_in_message_ = false;
    if (is_i2c()) {
        target_.stop(wire_end_);
        send_condition(&Listener::stop);
    } else
        chip_select(false);
}

/// Puts START or STOP of I2C on the wire. UM10204 (table 10) asks for times around them that take one period
/// of the clock each.
void SimBus::send_condition(void (Listener::*which)(Time, unsigned)) {
    const unsigned period = period_ns();
    if (listener_ != nullptr)
        (listener_->*which)(wire_end_, period);
    wire_end_ += period;
    counters_.busy_ns += period;
}

void SimBus::send(std::uint8_t byte, bool data) {
    if (is_framed())
        begin_message(data);
    carry(byte, data);
}

/// Puts one byte on the wire. Returns false if the wire lost the byte.
bool SimBus::carry(std::uint8_t byte, bool data) {
    // The `write_hz` of an I2C bus counts only the eight bits of a byte. The wire's clock is faster, so that
    // nine clocks take the time of eight periods of `write_hz`.
    const unsigned period = period_ns(), cycles = 8u / caps_.bits_per_cycle;
    // Times are exact over a whole transfer, although a clock's period is seldom a whole number of
    // nanoseconds.
    owed_wire_time_ += Time(1'000'000'000) * cycles;
    const Time length = owed_wire_time_ / caps_.write_hz;
    owed_wire_time_ %= caps_.write_hz;
    if (listener_ != nullptr)
        listener_->byte(wire_end_, period, data, byte, counters_.bytes != drop_at_);
    wire_end_ += length;
    counters_.busy_ns += length;
    if (counters_.bytes++ == drop_at_)
        return false;
    if (!is_i2c())
        controller_.write(byte, data, wire_end_, period);
    else if (is_in_message_)
        target_.byte(byte, wire_end_, period);
    return true;
}

void SimBus::run(const hal::Op& op) {
    using Kind = hal::Op::Kind;
    switch (op.kind) {
    case Kind::command:
        ++counters_.commands;
        if (!is_i2c()) { // on I2C a command costs only the bytes of its message
            wire_end_ += caps_.command_cost_ns;
            counters_.busy_ns += caps_.command_cost_ns;
        }
        send(op.command, false);
        for (std::uint32_t i = 0; i < op.length; ++i)
            send(op.data[i], !op.parameters_are_commands);
        break;
    case Kind::pixels: {
        const WatchedBuffer w{op.data, op.length, op.rows, op.stride, 0};
        watched_buffers_.push_back({w.data, w.length, w.rows, w.stride, checksum(w)});
        for (std::uint32_t row = 0; row < op.rows; ++row) {
            const std::uint8_t* const at = op.data + static_cast<std::ptrdiff_t>(row) * op.stride;
            for (std::uint32_t i = 0; i < op.length; ++i)
                send(at[i], true);
        }
        counters_.pixel_bytes += std::uint64_t{op.length} * op.rows;
        break;
    }
    case Kind::repeat:
        for (std::uint32_t n = 0; n < op.rows; ++n)
            for (std::uint32_t i = 0; i < op.length; ++i)
                send(op.data[i], true);
        counters_.pixel_bytes += std::uint64_t{op.length} * op.rows;
        break;
    case Kind::delay:
        end_message();
        wire_end_ += static_cast<Time>(op.micros) * 1000;
        break;
    case Kind::wait_te:
        wait_te(op);
        break;
    case Kind::wait_line:
        wait_line(op);
        break;
    case Kind::read:
        read(op);
        break;
    case Kind::reset:
        controller_.reset(true, wire_end_);
        if (listener_ != nullptr)
            listener_->reset(wire_end_, true);
        wire_end_ += static_cast<Time>(op.micros) * 1000;
        controller_.reset(false, wire_end_);
        if (listener_ != nullptr)
            listener_->reset(wire_end_, false);
        break;
    }
}

void SimBus::read(const hal::Op& op) {
    ++counters_.commands;
    send(op.command, false);
    const unsigned period =
        caps_.read_hz == 0 ? 0
                           : static_cast<unsigned>((1'000'000'000ull + caps_.read_hz / 2) / caps_.read_hz);
    if (caps_.bits_per_cycle == 1) {
        for (int i = 0; i < op.dummy_bits; ++i)
            controller_.read_bit(wire_end_ += period, period);
        for (std::uint32_t i = 0; i < op.length; ++i) {
            op.into[i] = controller_.read_byte(wire_end_, period);
            wire_end_ += static_cast<Time>(period) * 8;
        }
        return;
    }
    for (int i = 0; i < op.dummy_bits / 8; ++i)
        controller_.read_byte(wire_end_ += period, period);
    for (std::uint32_t i = 0; i < op.length; ++i)
        op.into[i] = controller_.read_byte(wire_end_ += period, period);
}

void SimBus::wait_line(const hal::Op& op) {
    std::uint8_t answer[2] = {};
    hal::Op look;
    look.kind = hal::Op::Kind::read;
    look.command = op.command;
    look.dummy_bits = op.dummy_bits;
    look.into = answer;
    look.length = sizeof answer;
    const Time deadline = wire_end_ + static_cast<Time>(op.micros) * 1000;
    do
        read(look);
    while (!hal::line_reached(op, answer) && wire_end_ < deadline);
    hal::tell_moment(op, static_cast<std::uint32_t>(wire_end_ / 1000));
}

void SimBus::wait_te(const hal::Op& op) {
    const Time step = controller_.line_time(), deadline = wire_end_ + static_cast<Time>(op.micros) * 1000;
    // No command comes while the bus waits, so an edge that two refreshes do not bring never comes.
    const Time last_look = std::min(deadline, wire_end_ + 2 * controller_.refresh_time());
    while (wire_end_ < last_look && controller_.te(wire_end_))
        wire_end_ += step; // waits for the next rising edge of TE; TE may be high already
    while (wire_end_ < last_look && !controller_.te(wire_end_))
        wire_end_ += step;
    if (wire_end_ >= last_look)
        wire_end_ = std::max(wire_end_, deadline);
    hal::tell_moment(op, static_cast<std::uint32_t>(wire_end_ / 1000));
}

} // namespace spangle::sim
