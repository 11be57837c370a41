#include <spangle/hal/dma_bus.hpp>

namespace spangle::hal {

Result<Token> DmaBus::submit(const Op* ops, std::size_t count) {
    if (running_.load(std::memory_order_acquire))
        return Error{Fault::busy, "DmaBus: a transfer is still under way"};
    if (count > memory_.op_count || (ops == nullptr && count != 0))
        return Error{Fault::bad_argument, "DmaBus: a list longer than its memory"};
    for (std::size_t i = 0; i < count; ++i) {
        const bool reads = ops[i].kind == Op::Kind::read || ops[i].kind == Op::Kind::wait_line;
        if ((reads && caps_.read_hz == 0) || (ops[i].kind == Op::Kind::wait_te && !caps_.has_te))
            return Error{Fault::unsupported, "DmaBus: the list reads or waits for TE, and the port cannot"};
        if (ops[i].kind == Op::Kind::repeat && (ops[i].length == 0 || ops[i].length > 4))
            return Error{Fault::bad_argument, "DmaBus: a repeated pattern has one to four bytes"};
        memory_.ops[i] = ops[i];
    }
    if (++last_token_ == 0)
        ++last_token_;
    count_ = count;
    at_ = part_ = 0;
    running_.store(true, std::memory_order_release);
    port_.select(true);
    step();
    return Token{last_token_};
}

bool DmaBus::done(Token token) const {
    return token.id != last_token_ || !running_.load(std::memory_order_acquire);
}

Result<void> DmaBus::wait(Token token, std::uint32_t timeout_micros) {
    if (token.id != last_token_ || token.id == 0)
        return Error{Fault::bad_argument, "DmaBus: wait for a token that was never given, or long ago"};
    for (const std::uint32_t from = port_.micros(); running_.load(std::memory_order_acquire); port_.sleep())
        if (port_.micros() - from >= timeout_micros)
            return Error{Fault::timeout, "DmaBus: the transfer did not end in time"};
    if (outcome_ != Fault::none)
        return Error{outcome_, "DmaBus: the port ended the transfer with a fault"};
    return {};
}

void DmaBus::step(Fault fault) {
    if (!running_.load(std::memory_order_relaxed))
        return;
    if (fault != Fault::none)
        return end(fault);
    for (; at_ < count_; ++at_, part_ = 0)
        if (start_part(memory_.ops[at_]))
            return;
    end(Fault::none);
}

void DmaBus::end(Fault fault) {
    port_.select(false);
    outcome_ = fault;
    running_.store(false, std::memory_order_release);
}

void DmaBus::write(bool data, const std::uint8_t* bytes, std::uint32_t count) {
    ++part_;
    port_.write(data, bytes, count);
}

/// Starts the next part of the operation; false when none is left.
bool DmaBus::start_part(const Op& op) {
    switch (op.kind) {
    case Op::Kind::command:
        if (part_ == 0)
            write(false, &op.command, 1);
        else if (part_ == 1 && op.length != 0)
            write(!op.parameters_are_commands, op.data, op.length);
        else
            return false;
        return true;
    case Op::Kind::pixels:
        return start_pixels(op);
    case Op::Kind::repeat:
        return start_repeat(op);
    case Op::Kind::wait_line:
        return start_wait_line(op);
    case Op::Kind::read:
        if (part_ == 2) { // CS must rise, which ends the controller's answer
            port_.select(false);
            port_.select(true);
            return false;
        }
        if (part_ == 0) {
            write(false, &op.command, 1);
        } else {
            ++part_;
            port_.read(op.dummy_bits, op.into, op.length);
        }
        return true;
    case Op::Kind::delay:
    case Op::Kind::wait_te:
    case Op::Kind::reset:
        break;
    }
    if (op.kind == Op::Kind::reset)
        port_.reset(part_ == 0);
    if (part_++ != 0) {
        if (op.kind == Op::Kind::wait_te)
            tell_moment(op, port_.micros()); // TE has risen: its interrupt called
        return false;
    }
    if (op.kind == Op::Kind::wait_te)
        port_.wait_te(op.micros);
    else
        port_.pause(op.micros);
    return true;
}

/// Starts the next rows; those that touch are one piece.
bool DmaBus::start_pixels(const Op& op) {
    const bool whole = op.stride == static_cast<std::int64_t>(op.length);
    if (part_ >= (whole ? 1 : op.rows) || op.length == 0 || op.rows == 0)
        return false;
    const std::uint8_t* const row = op.data + static_cast<std::ptrdiff_t>(part_) * op.stride;
    write(true, row, whole ? op.length * op.rows : op.length);
    return true;
}

bool DmaBus::start_repeat(const Op& op) {
    const std::uint32_t at_once = sizeof pattern_ / op.length, sent = part_ * at_once;
    if (sent >= op.rows)
        return false;
    for (std::uint32_t i = 0; part_ == 0 && i < at_once * op.length; ++i)
        pattern_[i] = op.data[i % op.length];
    const std::uint32_t left = op.rows - sent;
    write(true, pattern_, (left < at_once ? left : at_once) * op.length);
    return true;
}

/// Sends command and reads answer in turn, until the line is there.
bool DmaBus::start_wait_line(const Op& op) {
    if (part_ == 0)
        since_ = port_.micros();
    if (part_ % 2 != 0) {
        ++part_;
        port_.read(op.dummy_bits, answer_, sizeof answer_);
        return true;
    }
    if (part_ != 0) {
        port_.select(false);
        port_.select(true);
        if (line_reached(op, answer_)) {
            tell_moment(op, port_.micros());
            return false;
        }
        if (port_.micros() - since_ >= op.micros) {
            end(Fault::timeout);
            return true;
        }
    }
    write(false, &op.command, 1);
    return true;
}

} // namespace spangle::hal
