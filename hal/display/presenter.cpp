#include <spangle/hal/presenter.hpp>

#include "hal/display/frame_plan.hpp"

namespace spangle::hal {
namespace {

/// Operations before the first window of a frame that is tear-free.
constexpr std::size_t sync_ops = 2;

} // namespace

Result<void> Presenter::acquire_wire() {
    if (!layout().config.wire.converts() || !wire_.empty())
        return {};
    // A window that ends inside a byte takes the whole byte. There is at most one window per row.
    const Extent most = held(layout().config, layout().placement().size);
    const std::size_t size =
        layout().wire_bytes(most.width, most.height) + static_cast<std::size_t>(most.height);
    const Result<Buffer> wire = transfer_.bus().acquire(size);
    if (!wire)
        return wire.error();
    if (wire.value().bytes == nullptr || wire.value().size < size)
        return Error{Fault::no_answer, "display: the bus gave less memory than one frame"};
    wire_ = BusBuffer(wire.value());
    return {};
}

Result<void> Presenter::send(const SentRows& rows, const RowSpan* damage, const RowHash& hash,
                             const Parts& parts) {
    begin(rows);
    SpanPlan spans;
    const RowHashCode* const code = memory_.hash.code;
    // Rows that share bytes cannot be sent apart.
    const bool apart = hash.enabled() && transfer_.windows().shared().height == 1;
    WindowCost cost = window_cost(transfer_.caps(), *layout().config.panel->commands, layout().wire_bits());
    for (;;) {
        if (apart)
            code->plan(spans, hash, cost);
        FramePlan plan(WindowPlan(damage, rows.count, cost, memory_.plan), apart ? &spans : nullptr, code);
        if (parts.count_ops == nullptr || !one_list(layout().config) || cost.window >= dearest_window ||
            parts.count_ops(*this, plan) + sync_ops <= transfer_.list().capacity())
            return send_windows(plan, parts);
        cost.window = 2 * cost.window + 1; // a plan in which windows cost more has fewer of them
    }
}

Result<void> Presenter::send_windows(FramePlan& plan, const Parts& parts) {
    Rect window;
    if (!plan.next(window))
        return {};
    if (parts.sync != nullptr && tear_free(layout().config)) {
        parts.sync(*this, plan);
        plan.next(window);
    }
    do {
        if (const auto r = append_windows({window.x, first_ + window.y, window.w, window.h}); !r)
            return r;
    } while (plan.next(window));
    return end();
}

/// Columns are widened to whole bytes, and rows end at whole bytes.
Result<void> Presenter::send_all(const SentRows& rows) {
    begin(rows);
    const std::int32_t unit = layout().shared(transfer_.windows().shared()).width;
    if (const auto r =
            append_windows({0, rows.first, (layout().picture.width + unit - 1) / unit * unit, rows.count});
        !r)
        return r;
    return end();
}

void Presenter::begin(const SentRows& rows) {
    buffer_ = rows.buffer;
    first_ = rows.first;
    transfer_.list().clear();
    wire_end_ = 0;
}

Result<void> Presenter::end() {
    if (const auto r = transfer_.start(); !r)
        return r;
    (layout().config.wire.converts() ? wire_ : *buffer_).lend(transfer_.token());
    pacer_.count_sent();
    return {};
}

// --- Windows and their pixels ---

Result<void> Presenter::append_windows(const Rect& area) {
    return for_each_window(transfer_.windows(), area,
                           [this](const Rect& window) { return append_window(window); });
}

/// Converts the window's pixels to those of the wire, behind those of the windows before it. Returns their
/// bytes.
std::size_t Presenter::convert(const Rect& window) {
    const auto stride = static_cast<std::int32_t>(layout().stride());
    const Picture picture = {buffer_->to_send() - std::ptrdiff_t{first_} * stride,
                             stride,
                             layout().placement().size.height,
                             layout().config.format,
                             (layout().placement().madctl & dcs::MV) != 0,
                             memory_.palette};
    return layout().config.wire.convert(picture, window, wire_.to_draw(transfer_.bus()) + wire_end_);
}

Result<void> Presenter::append_window(const Rect& window) {
    if (const auto r = transfer_.open_window(window); !r)
        return r;
    const std::uint32_t stride = layout().sent_stride();
    if (layout().config.wire.converts()) {
        const std::uint8_t* const converted = wire_.to_draw(transfer_.bus()) + wire_end_;
        const std::size_t bytes = convert(window);
        wire_end_ += bytes;
        return transfer_.append_pixels(converted, static_cast<std::uint32_t>(bytes), 1, stride);
    }
    const std::uint32_t line = layout().line_bytes(window.w);
    const std::uint8_t* data =
        buffer_->to_send() +
        static_cast<std::size_t>((window.y - first_) / layout().rows_at_once()) * stride +
        layout().line_bytes(window.x);
    const auto rows = static_cast<std::uint32_t>(window.h / layout().rows_at_once());
    return line == stride ? transfer_.append_pixels(data, line * rows, 1, stride)
                          : transfer_.append_pixels(data, line, rows, stride);
}

/// The number of operations that the window's pixels take, as append_window() makes them.
std::size_t Presenter::pixel_ops(const Rect& window) const {
    if (layout().config.wire.converts()) // converted pixels are one long row
        return transfer_.pixel_ops(static_cast<std::uint32_t>(layout().wire_bytes(window.w, window.h)), 1);
    const std::uint32_t line = layout().line_bytes(window.w);
    const auto lines = static_cast<std::uint32_t>(window.h / layout().rows_at_once());
    return line == layout().sent_stride() ? transfer_.pixel_ops(line * lines, 1)
                                          : transfer_.pixel_ops(line, lines);
}

// --- Before a frame is sent ---

/// Calls `visit` with each window as it will be sent, and the operations that open it.
template <class Visit> void Presenter::rehearse(FramePlan& plan, Visit visit) const {
    constexpr std::size_t most = 16; // more than the commands of any window
    Op ops[most];
    OpParams params[most];
    Windows windows = transfer_.windows();
    plan.rewind();
    for (Rect area; plan.next(area);)
        (void)for_each_window(transfer_.windows(), area, [&](const Rect& window) -> Result<void> {
            OpList opening(ops, params, most);
            windows.open(opening, window);
            visit(window, opening);
            return {};
        });
    plan.rewind();
}

std::size_t Presenter::ops_of(FramePlan& plan) const {
    std::size_t count = 0;
    rehearse(plan,
             [&](const Rect& window, const OpList& opening) { count += opening.size() + pixel_ops(window); });
    return count;
}

/// Computes when the windows may be sent without tearing.
SafeStart Presenter::safe_start(FramePlan& plan) const {
    const Placement& placed = layout().placement();
    const BusCaps& caps = transfer_.caps();
    const bool swapped = (placed.madctl & dcs::MV) != 0, upward = (placed.madctl & dcs::MY) != 0;
    const auto row_of = [&](std::int32_t along) {
        const std::int32_t row = along + (swapped ? placed.offset.x : placed.offset.y);
        return upward ? layout().config.panel->memory.height - 1 - row : row;
    };
    SafeStart start(pacer_.refresh());
    std::int64_t at = 0;
    rehearse(plan, [&](const Rect& w, const OpList& opening) {
        at += wire_nanoseconds(caps, opening.bytes()) +
              static_cast<std::int64_t>(opening.size()) * caps.command_cost_ns;
        const std::int64_t row = wire_nanoseconds(caps, layout().wire_bytes(w.w, 1));
        const std::int64_t end = at + row * w.h;
        if (swapped) { // rows of the memory are columns of the window
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

void Presenter::append_sync(FramePlan& plan) {
    pacer_.append_sync(safe_start(plan));
}

} // namespace spangle::hal
