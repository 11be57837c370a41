// Sends a frame: its windows, their pixels in the wire's format, and the moment at which they may start.
#include <spangle/hal/panel_display.hpp>

#include "hal/display/frame_plan.hpp"

namespace spangle::hal {
namespace {

/// Operations before the first window of a tear-free frame.
constexpr std::size_t sync_ops = 2;

} // namespace

Result<void> PanelDisplay::send() {
    widen_damage();
    SpanPlan spans;
    // Rows that share bytes cannot be sent apart.
    const bool apart = hash_.enabled() && windows_.shared().height == 1;
    WindowCost cost = window_cost(caps_, *config_.panel->commands, wire_bits());
    for (;;) {
        if (apart)
            memory_.hash.code->plan(spans, hash_, cost);
        FramePlan plan(WindowPlan(sent_damage(), sent_rows(), cost, memory_.plan), apart ? &spans : nullptr,
                       memory_.hash.code);
        if (parts_.count_ops == nullptr || !one_list(config_) || cost.window >= dearest_window ||
            (this->*parts_.count_ops)(plan) + sync_ops <= ops_.capacity())
            return send_windows(plan);
        cost.window = 2 * cost.window + 1; // the dearer a window, the fewer windows the plan has
    }
}

Result<void> PanelDisplay::send_windows(FramePlan& plan) {
    Rect window;
    if (!plan.next(window))
        return {};
    begin_send();
    if (parts_.sync != nullptr && tear_free()) {
        (this->*parts_.sync)(plan);
        plan.next(window);
    }
    do {
        if (const auto r = append_windows({window.x, band_.first + window.y, window.w, window.h}); !r)
            return r;
    } while (plan.next(window));
    return end_send();
}

void PanelDisplay::begin_send() {
    suspect_ = true; // until the last byte is known to have arrived
    ops_.clear();
    wire_end_ = 0;
}

Result<void> PanelDisplay::end_send() {
    if (const auto r = start(); !r)
        return r;
    sent_buffer().lend(token_);
    ++counters_.sent;
    return {};
}

/// Calls `visit` with each window as it will be sent, and with the operations that open it.
template <class Visit> void PanelDisplay::rehearse(FramePlan& plan, Visit visit) const {
    constexpr std::size_t most = 16; // window_size() is never larger
    Op ops[most];
    OpParams params[most];
    Windows windows = windows_;
    plan.rewind();
    for (Rect area; plan.next(area);)
        (void)for_each_window(windows_, area, [&](const Rect& window) -> Result<void> {
            OpList opening(ops, params, most);
            windows.open(opening, window);
            visit(window, opening);
            return {};
        });
    plan.rewind();
}

std::size_t PanelDisplay::ops_of(FramePlan& plan) const {
    std::size_t count = 0;
    rehearse(plan,
             [&](const Rect& window, const OpList& opening) { count += opening.size() + pixel_ops(window); });
    return count;
}

/// Computes when the windows may be sent without tearing.
SafeStart PanelDisplay::safe_start(FramePlan& plan) const {
    const PanelTiming& timing = config_.panel->timing;
    Refresh refresh;
    if (timing.scan_lines != 0) {
        refresh.line = line_ns_;
        refresh.lines = timing.scan_lines;
        refresh.porch = timing.porch_lines;
        // An edge is seen, or a line is read, within one or two commands, and never more exactly than to one
        // line.
        refresh.jitter = refresh.line + static_cast<std::int32_t>(2 * caps_.command_cost_ns);
    }
    const bool swapped = (placement_.madctl & dcs::MV) != 0, upward = (placement_.madctl & dcs::MY) != 0;
    const auto row_of = [&](std::int32_t along) {
        const std::int32_t row = along + (swapped ? placement_.offset.x : placement_.offset.y);
        return upward ? config_.panel->memory.height - 1 - row : row;
    };
    SafeStart start(refresh);
    std::int64_t at = 0;
    rehearse(plan, [&](const Rect& w, const OpList& opening) {
        at += wire_nanoseconds(caps_, opening.bytes()) +
              static_cast<std::int64_t>(opening.size()) * caps_.command_cost_ns;
        const std::int64_t row = wire_nanoseconds(caps_, wire_bytes({static_cast<std::int16_t>(w.w), 1}));
        const std::int64_t end = at + row * w.h;
        if (swapped) { // all rows of the memory are written during the whole transfer
            start.write(row_of(w.x), at, end);
            start.write(row_of(w.x + w.w - 1), at, end);
        } else {
            start.write(row_of(w.y), at, at + row);
            start.write(row_of(w.y + w.h - 1), end - row, end);
        }
        at = end;
    });
    return start;
}

/// Makes the transfer lead or lag the scan. Where every start would tear, the transfer starts in the
/// blanking, or at once.
void PanelDisplay::append_sync(FramePlan& plan) {
    const SafeStart start = safe_start(plan);
    const PanelTiming& timing = config_.panel->timing;
    const std::uint32_t at_most = 2 * timing.frame_us + grace_us;
    const std::int64_t delay = start.possible() ? start.after_blanking() : 0;
    ++(!start.possible() ? counters_.unsafe : delay == 0 ? counters_.led : counters_.lagged);
    if (config_.wait_te) {
        ops_.wait_te(at_most);
        if (delay != 0)
            ops_.delay(static_cast<std::uint32_t>((delay + 999) / 1000));
    } else if (start.possible()) {
        ops_.wait_line(register_dummy_bits(caps_, *config_.panel), start.first_line(), start.slack_lines(),
                       timing.scan_lines, at_most);
    }
}

Result<void> PanelDisplay::append_windows(const Rect& area) {
    return for_each_window(windows_, area, [this](const Rect& window) { return append_window(window); });
}

/// Converts the window's pixels to the wire's format, behind the pixels of the windows before it. Returns the
/// number of bytes.
std::size_t PanelDisplay::convert(const Rect& window) {
    const auto stride = static_cast<std::int32_t>(this->stride());
    const Picture picture = {buffers_[back_].to_send() - std::ptrdiff_t{band_.first} * stride,
                             stride,
                             placement_.size.height,
                             config_.format,
                             (placement_.madctl & dcs::MV) != 0,
                             memory_.palette};
    return config_.wire.convert(picture, window, wire_.to_draw(bus_) + wire_end_);
}

Result<void> PanelDisplay::append_window(const Rect& window) {
    if (const auto r = make_room(windows_.commands() + 1); !r)
        return r;
    windows_.open(ops_, window);
    if (config_.wire.converts()) {
        const std::uint8_t* const converted = wire_.to_draw(bus_) + wire_end_;
        const std::size_t bytes = convert(window);
        wire_end_ += bytes;
        return append_pixels(converted, static_cast<std::uint32_t>(bytes), 1);
    }
    const std::uint8_t* data =
        sent_buffer().to_send() +
        static_cast<std::size_t>((window.y - band_.first) / rows_at_once()) * sent_stride() +
        line_bytes(window.x);
    const std::uint32_t line = line_bytes(window.w);
    const auto rows = static_cast<std::uint32_t>(window.h / rows_at_once());
    return line == sent_stride() ? append_pixels(data, line * rows, 1) : append_pixels(data, line, rows);
}

/// The number of operations in which append_pixels() sends the window's pixels.
std::size_t PanelDisplay::pixel_ops(const Rect& window) const {
    const auto pieces = [](std::size_t whole, std::size_t part) { return (whole + part - 1) / part; };
    const std::size_t limit = op_limit(), line = line_bytes(window.w);
    const auto rows = static_cast<std::size_t>(window.h / rows_at_once());
    if (config_.wire.converts()) // one long row
        return pieces(wire_bytes({static_cast<std::int16_t>(window.w), static_cast<std::int16_t>(window.h)}),
                      limit);
    if (line == sent_stride())
        return pieces(line * rows, limit);
    return line > limit ? pieces(line, limit) * rows : pieces(rows, limit / line);
}

/// Appends several whole rows per operation of the bus where at least one row fits, and otherwise pieces of
/// rows.
Result<void> PanelDisplay::append_pixels(const std::uint8_t* data, std::uint32_t row_bytes,
                                         std::uint32_t rows) {
    const std::uint32_t limit = op_limit();
    const std::uint32_t piece = row_bytes < limit ? row_bytes : limit;
    const std::uint32_t rows_at_once = row_bytes <= limit ? limit / row_bytes : 1;
    for (std::uint32_t y = 0; y < rows; y += rows_at_once) {
        const std::uint32_t count = rows - y < rows_at_once ? rows - y : rows_at_once;
        for (std::uint32_t x = 0; x < row_bytes; x += piece) {
            if (const auto r = make_room(1); !r)
                return r;
            const std::uint32_t bytes = row_bytes - x < piece ? row_bytes - x : piece;
            ops_.pixels(data + std::size_t{y} * sent_stride() + x, bytes, count,
                        static_cast<std::int32_t>(sent_stride()));
        }
    }
    return {};
}

} // namespace spangle::hal
