#include <spangle/hal/transfer.hpp>

namespace spangle::hal {
namespace {

std::uint32_t deadline(std::uint32_t expected, std::uint32_t late) {
    return expected < (UINT32_MAX - late) / 2 ? expected * 2 + late : UINT32_MAX;
}

} // namespace

void Transfer::open(const BusCaps& caps, const OpList& list) {
    const PanelDesc& panel = *layout_.config.panel;
    caps_ = caps;
    windows_ = Windows(panel, layout_.placement(), wire_format(layout_.config));
    ops_ = list;
    ops_.parameters_are_commands(panel.commands->parameters_are_commands);
}

/// The longest operation of the bus in bytes, whole pixels where these have whole bytes.
std::uint32_t Transfer::op_limit() const {
    const std::uint32_t limit = caps_.max_transfer != 0 ? caps_.max_transfer : UINT32_MAX;
    const std::uint32_t bits = layout_.wire_bits();
    return bits % 8 == 0 ? limit - limit % (bits / 8) : limit;
}

Result<void> Transfer::make_room(std::size_t ops) {
    if (ops_.room() >= ops)
        return {};
    return run();
}

Result<void> Transfer::append(Program program) {
    while (!program.empty()) {
        const Program::Step step = program.next();
        if (const auto r = make_room(1); !r)
            return r;
        if (step.delay_micros != 0) {
            ops_.delay(step.delay_micros);
            continue;
        }
        if (step.count > op_limit())
            return Error{Fault::unsupported,
                         "display: a setup command is longer than one operation of the bus"};
        ops_.command(*step.command, step.params, step.count);
    }
    return {};
}

Result<void> Transfer::open_window(const Rect& window) {
    if (const auto r = make_room(windows_.commands() + 1); !r)
        return r;
    windows_.open(ops_, window);
    return {};
}

Result<void> Transfer::append_pixels(const std::uint8_t* data, std::uint32_t row_bytes, std::uint32_t rows,
                                     std::uint32_t stride) {
    const std::uint32_t limit = op_limit();
    const std::uint32_t piece = row_bytes < limit ? row_bytes : limit;
    const std::uint32_t rows_at_once = row_bytes <= limit ? limit / row_bytes : 1;
    for (std::uint32_t y = 0; y < rows; y += rows_at_once) {
        const std::uint32_t count = rows - y < rows_at_once ? rows - y : rows_at_once;
        for (std::uint32_t x = 0; x < row_bytes; x += piece) {
            if (const auto r = make_room(1); !r)
                return r;
            const std::uint32_t bytes = row_bytes - x < piece ? row_bytes - x : piece;
            ops_.pixels(data + std::size_t{y} * stride + x, bytes, count, static_cast<std::int32_t>(stride));
        }
    }
    return {};
}

std::size_t Transfer::pixel_ops(std::uint32_t row_bytes, std::uint32_t rows) const {
    const auto pieces = [](std::size_t whole, std::size_t part) { return (whole + part - 1) / part; };
    const std::size_t limit = op_limit();
    return row_bytes > limit ? pieces(row_bytes, limit) * rows : pieces(rows, limit / row_bytes);
}

Result<void> Transfer::append_black(const Rect& window, std::size_t bytes) {
    // Operations repeat whole pixels where a pixel has whole bytes.
    const std::uint32_t bits = layout_.wire_bits(), unit = bits % 8 == 0 ? bits / 8 : 1;
    std::size_t left = bytes / unit;
    const std::uint32_t most = op_limit() / unit;
    if (const auto r = make_room(windows_.commands()); !r)
        return r;
    windows_.open(ops_, window);
    while (left != 0) {
        const std::uint32_t count = left < most ? static_cast<std::uint32_t>(left) : most;
        if (const auto r = make_room(1); !r)
            return r;
        ops_.repeat_black(unit, count);
        left -= count;
    }
    return {};
}

Result<void> Transfer::start() {
    if (ops_.size() == 0)
        return {};
    const Result<Token> token = ops_.submit(bus_);
    const std::uint32_t time = ops_.duration(caps_);
    ops_.clear();
    if (!token) {
        windows_.forget();
        return token.error();
    }
    token_ = token.value();
    token_time_ = time;
    in_flight_ = true;
    return {};
}

Result<void> Transfer::complete() {
    const Result<void> done = bus_.wait(token_, deadline(token_time_, caps_.late_us));
    in_flight_ = !done && !bus_.done(token_);
    late_ = in_flight_;
    if (!done)
        windows_.forget();
    return done;
}

Result<void> Transfer::run() {
    if (const auto r = start(); !r)
        return r;
    return complete();
}

} // namespace spangle::hal
