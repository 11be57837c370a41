#include <spangle/hal/polled_bus.hpp>

namespace spangle::hal {

Result<Token> PolledBus::submit(const Op* ops, std::size_t count) {
    if (ops == nullptr && count != 0)
        return Error{Fault::bad_argument, "PolledBus: submit without operations"};
    for (std::size_t i = 0; i < count; ++i) {
        if (ops[i].kind == Op::Kind::wait_te || ops[i].kind == Op::Kind::wait_line)
            return Error{Fault::unsupported, "PolledBus: nothing here waits for the beam"};
        if (ops[i].kind == Op::Kind::read && caps_.read_hz == 0)
            return Error{Fault::unsupported, "PolledBus: the list reads, and the port cannot"};
        if (ops[i].kind == Op::Kind::repeat && (ops[i].length == 0 || ops[i].length > 4))
            return Error{Fault::bad_argument, "PolledBus: a repeated pattern has one to four bytes"};
    }
    outcome_ = Fault::none;
    for (std::size_t i = 0; i < count && outcome_ == Fault::none; ++i)
        outcome_ = run(ops[i]);
    end_message();
    if (++last_token_ == 0)
        ++last_token_;
    return Token{last_token_};
}

Result<void> PolledBus::wait(Token token, std::uint32_t) {
    if (token.id == 0 || token.id != last_token_)
        return Error{Fault::bad_argument, "PolledBus: wait for a token that was never given, or long ago"};
    if (outcome_ != Fault::none)
        return Error{outcome_, "PolledBus: the port ended the transfer with a fault"};
    return {};
}

Fault PolledBus::run(const Op& op) {
    switch (op.kind) {
    case Op::Kind::command:
        if (const Fault fault = send(false, &op.command, 1); fault != Fault::none || op.length == 0)
            return fault;
        return send(!op.parameters_are_commands, op.data, op.length);
    case Op::Kind::pixels:
        return send_pixels(op);
    case Op::Kind::repeat:
        return send_repeat(op);
    case Op::Kind::read:
        return read(op);
    case Op::Kind::reset:
        end_message();
        port_.reset(true);
        port_.pause(op.micros);
        port_.reset(false);
        return Fault::none;
    default: // a delay: submit() refuses all other kinds
        end_message();
        port_.pause(op.micros);
        return Fault::none;
    }
}

/// Sends bytes in the message under way if it is of their kind. But every index takes a start byte of its
/// own.
Fault PolledBus::send(bool data, const std::uint8_t* bytes, std::uint32_t count) {
    const bool goes_on = open_ && data == data_ && (data || caps_.kind != BusKind::spi_start);
    open_ = true; // the message must be ended, even after a fault
    data_ = data;
    if (!goes_on)
        if (const Fault fault = port_.begin(data); fault != Fault::none)
            return fault;
    bytes_ += count;
    return port_.write(bytes, count);
}

/// Sends rows; those that touch are one piece.
Fault PolledBus::send_pixels(const Op& op) {
    if (op.stride == static_cast<std::int64_t>(op.length))
        return send(true, op.data, op.length * op.rows);
    for (std::uint32_t row = 0; row < op.rows; ++row)
        if (const Fault fault = send(true, op.data + static_cast<std::ptrdiff_t>(row) * op.stride, op.length);
            fault != Fault::none)
            return fault;
    return Fault::none;
}

Fault PolledBus::send_repeat(const Op& op) {
    std::uint8_t pattern[48]; // 48 is a multiple of every length, 1 to 4
    for (std::uint32_t i = 0; i < sizeof pattern; ++i)
        pattern[i] = op.data[i % op.length];
    const std::uint32_t at_once = sizeof pattern / op.length;
    for (std::uint32_t left = op.rows; left != 0;) {
        const std::uint32_t now = left < at_once ? left : at_once;
        if (const Fault fault = send(true, pattern, now * op.length); fault != Fault::none)
            return fault;
        left -= now;
    }
    return Fault::none;
}

/// Reads an answer in a message of its own.
Fault PolledBus::read(const Op& op) {
    end_message();
    Fault fault = send(false, &op.command, 1);
    if (fault == Fault::none)
        fault = port_.read(op.dummy_bits, op.into, op.length);
    end_message();
    return fault;
}

void PolledBus::end_message() {
    if (open_)
        port_.end();
    open_ = false;
}

} // namespace spangle::hal
