#include <spangle/linux/transfer_bus.hpp>

#include <chrono>
#include <cstdio>

#include "hal/linux/persist.hpp"

namespace spangle::hal {
namespace {

/// Bytes of the block that a repeated pattern is written to before it is sent.
constexpr std::size_t repeat_block = 4096;

Result<void> open_pin(Lines& lines, const LineRef& ref, bool level) {
    if (!ref.wired())
        return {};
    const unsigned offsets[] = {ref.offset};
    return lines.open_outputs(ref.chip, offsets, level != ref.inverted ? 1 : 0);
}

Result<void> set_pin(Lines& lines, const LineRef& ref, bool level) {
    return lines.set(level != ref.inverted ? 1 : 0);
}

} // namespace

TransferBus::TransferBus(const PanelPins& pins, bool asynchronous)
    : pins_(pins), asynchronous_(asynchronous) {
    if (asynchronous)
        thread_ = std::thread([this] { carry(); });
}

TransferBus::~TransferBus() {
    stop();
}

void TransferBus::stop() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable())
        thread_.join();
}

Result<void> TransferBus::open_pins() {
    if (const auto r = open_pin(reset_, pins_.reset, true); !r)
        return r;
    if (const auto r = open_pin(backlight_, pins_.backlight, true); !r)
        return r;
    return pins_.te.wired() ? te_.open(pins_.te) : Result<void>{};
}

bool TransferBus::busy() const {
    const std::lock_guard lock(mutex_);
    return running_;
}

Result<void> TransferBus::backlight(bool on) {
    if (!has_backlight())
        return Error{Fault::unsupported, "bus: no backlight line is wired"};
    return set_backlight(on);
}

Result<void> TransferBus::set_backlight(bool on) {
    return set_pin(backlight_, pins_.backlight, on);
}

Result<void> TransferBus::set_reset(bool high) {
    return set_pin(reset_, pins_.reset, high);
}

Result<std::uint64_t> TransferBus::await_te(std::uint32_t at_most_micros) {
    return te_.next_edge(at_most_micros);
}

Result<Buffer> TransferBus::acquire(std::size_t size) {
    buffers_.push_back(std::make_unique<std::uint8_t[]>(size));
    return Buffer{buffers_.back().get(), size};
}

// --- Tokens

const char* TransferBus::refusal_of(const Op& op) const {
    using Kind = Op::Kind;
    const bool from = op.kind == Kind::command || op.kind == Kind::pixels || op.kind == Kind::repeat;
    if (from && op.length != 0 && op.data == nullptr)
        return "bus: an operation without data";
    if (op.kind == Kind::repeat && (op.length == 0 || op.length > 4))
        return "bus: a repeated pattern has one to four bytes";
    if (op.kind == Kind::read && op.length != 0 && op.into == nullptr)
        return "bus: a read without room for the answer";
    if ((op.kind == Kind::read || op.kind == Kind::wait_line) && caps().read_hz == 0)
        return "bus: this bus cannot read";
    if (op.kind == Kind::wait_te && !has_te())
        return "bus: no tearing-effect line is wired";
    if (op.kind == Kind::reset && !has_reset())
        return "bus: no reset line is wired";
    return refusal(op);
}

Result<Token> TransferBus::submit(const Op* ops, std::size_t count) {
    if (ops == nullptr && count != 0)
        return Error{Fault::bad_argument, "bus: submit without operations"};
    for (std::size_t i = 0; i < count; ++i)
        if (const char* rule = refusal_of(ops[i]))
            return Error{Fault::unsupported, rule};
    Token token;
    {
        const std::lock_guard lock(mutex_);
        if (running_)
            return Error{Fault::busy, "bus: a transfer is still under way"};
        ops_.assign(ops, ops + count);
        if (++last_token_ == 0)
            ++last_token_;
        token.id = last_token_;
        running_ = true;
    }
    if (asynchronous_)
        changed_.notify_all();
    else
        finish(run_list());
    return token;
}

bool TransferBus::done(Token token) const {
    const std::lock_guard lock(mutex_);
    return !running_ || token.id != last_token_;
}

Result<void> TransferBus::wait(Token token, std::uint32_t timeout_micros) {
    std::unique_lock lock(mutex_);
    const auto over = [&] { return !running_ || token.id != last_token_; };
    if (!changed_.wait_for(lock, std::chrono::microseconds(timeout_micros), over))
        return Error{Fault::timeout, "bus: the transfer did not end in time"};
    const Outcome& outcome = outcomes_[token.id % outcomes_.size()];
    if (token.id == 0 || outcome.token != token.id)
        return Error{Fault::bad_argument, "bus: wait for a token that was never given, or long ago"};
    return outcome.error.fault == Fault::none ? Result<void>{} : outcome.error;
}

/// The thread: carries one list after the other until the bus ends.
void TransferBus::carry() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [&] { return running_ || stopping_; });
        if (!running_)
            return;
        lock.unlock();
        const Result<void> result = run_list();
        finish(result);
        lock.lock();
    }
}

void TransferBus::finish(const Result<void>& result) {
    {
        const std::lock_guard lock(mutex_);
        Outcome& outcome = outcomes_[last_token_ % outcomes_.size()];
        outcome.token = last_token_;
        outcome.error = result.error();
        // The text of an error may change with the device's next failure; this copy stays.
        std::snprintf(outcome.text.data(), outcome.text.size(), "%s", result.error().rule);
        outcome.error.rule = outcome.text.data();
        running_ = false;
    }
    changed_.notify_all();
}

// --- Operations

Result<void> TransferBus::run_list() {
    Result<void> result = begin();
    for (std::size_t i = 0; result.ok() && i < ops_.size(); ++i)
        result = run(ops_[i]);
    if (result)
        result = flush();
    const Result<void> ended = end();
    return result ? ended : result;
}

Result<void> TransferBus::run(const Op& op) {
    using Kind = Op::Kind;
    switch (op.kind) {
    case Kind::command:
        if (const auto r = put(Byte::command, &op.command, 1); !r)
            return r;
        return op.length != 0
                   ? put(op.parameters_are_commands ? Byte::command : Byte::parameter, op.data, op.length)
                   : Result<void>{};
    case Kind::pixels:
        return put_rows(op);
    case Kind::repeat:
        return put_repeat(op);
    default:
        break;
    }
    if (const auto r = flush(); !r)
        return r;
    switch (op.kind) {
    case Kind::delay:
        pause_micros(op.micros);
        return {};
    case Kind::wait_te: {
        const Result<std::uint64_t> edge = await_te(op.micros);
        if (!edge)
            return edge.error();
        tell_moment(op, static_cast<std::uint32_t>(edge.value() / 1000));
        return {};
    }
    case Kind::wait_line:
        return wait_line(op);
    case Kind::read:
        return read(op);
    default:
        return pulse_reset(op.micros);
    }
}

/// Waits for a scanned line. The calls of one read take longer than a line, so nothing is gained by pausing
/// between them.
Result<void> TransferBus::wait_line(const Op& op) {
    using Clock = std::chrono::steady_clock;
    std::uint8_t answer[2] = {};
    Op look;
    look.kind = Op::Kind::read;
    look.command = op.command;
    look.dummy_bits = op.dummy_bits;
    look.into = answer;
    look.length = sizeof answer;
    for (const auto end = Clock::now() + std::chrono::microseconds(op.micros);;) {
        if (const auto r = read(look); !r)
            return r;
        const auto now = Clock::now();
        if (line_reached(op, answer)) {
            const auto moment = std::chrono::duration_cast<std::chrono::microseconds>(now.time_since_epoch());
            tell_moment(op, static_cast<std::uint32_t>(moment.count()));
            return {};
        }
        if (now >= end)
            return Error{Fault::timeout, "bus: the scanned line (45h) does not come; is the panel awake, and "
                                         "its data output wired?"};
    }
}

Result<void> TransferBus::put_rows(const Op& op) {
    const bool gapless = op.stride == static_cast<std::int64_t>(op.length);
    const std::size_t bytes = gapless ? std::size_t{op.length} * op.rows : op.length;
    const std::uint32_t pieces = gapless ? 1 : op.rows;
    for (std::uint32_t row = 0; row < pieces && bytes != 0; ++row) {
        const std::uint8_t* const at = op.data + static_cast<std::ptrdiff_t>(row) * op.stride;
        if (const auto r = put(Byte::pixel, at, bytes); !r)
            return r;
    }
    return {};
}

Result<void> TransferBus::put_repeat(const Op& op) {
    std::array<std::uint8_t, repeat_block> block;
    const std::size_t whole = block.size() - block.size() % op.length;
    std::uint64_t left = std::uint64_t{op.length} * op.rows;
    for (std::size_t i = 0; i < whole; ++i)
        block[i] = op.data[i % op.length];
    while (left != 0) {
        const std::size_t count = left < whole ? static_cast<std::size_t>(left) : whole;
        if (const auto r = put(Byte::pixel, block.data(), count); !r)
            return r;
        left -= count;
    }
    return {};
}

Result<void> TransferBus::pulse_reset(std::uint32_t micros) {
    if (const auto r = set_reset(false); !r)
        return r;
    pause_micros(micros);
    return set_reset(true);
}

} // namespace spangle::hal
