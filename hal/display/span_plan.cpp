#include "hal/display/span_plan.hpp"

#include <bit>

namespace spangle::hal {
namespace {

constexpr std::int32_t cell = RowHash::cell_width;

} // namespace

const RowHashCode row_hash_code = {
    [](RowHash& hash, RowSpan* damage, const std::uint8_t* pixels, std::int32_t stride, bool all) {
        hash.reduce(damage, pixels, stride, all);
    },
    [](SpanPlan& plan, const RowHash& hash, const WindowCost& cost) { plan = SpanPlan(hash, cost); },
    [](SpanPlan& plan, Rect& window) { return plan.next(window); }};

SpanPlan::SpanPlan(const RowHash& hash, const WindowCost& cost)
    : changed_cells_(hash.changed()), width_(hash.width()), height_(hash.height()), cost_(cost),
      total_cost_(0), windows_(hash.memory().windows) {
    for (Rect w; next(w);)
        total_cost_ += cost_.window + static_cast<std::uint32_t>(w.w * w.h) * cost_.pixel;
    rewind();
}

bool SpanPlan::next(Rect& out) {
    while (next_row_ < height_ && (window_count_ == 0 || !settled()))
        plan_row();
    if (window_count_ == 0)
        return false;
    const Window& w = window(0);
    out = {w.begin, w.top, w.end - w.begin, w.bottom - w.top};
    first_window_ = (first_window_ + 1) % room;
    --window_count_;
    return true;
}

void SpanPlan::plan_row() {
    std::uint32_t cells = changed_cells_[next_row_];
    for (std::int32_t i = 0; i < window_count_ && cells != 0; ++i)
        if (window(i).bottom == next_row_)
            cells = merge_window(window(i), cells);
    open_windows(cells);
    ++next_row_;
}

SpanPlan::Run SpanPlan::first_run(std::uint32_t cells) const {
    const std::int32_t first = std::countr_zero(cells), length = std::countr_one(cells >> first);
    const std::int32_t end = (first + length) * cell;
    return {first * cell, end < width_ ? end : width_};
}

std::uint32_t SpanPlan::without(std::uint32_t cells, Run run) {
    const std::int32_t after = (run.end + cell - 1) / cell;
    return after >= 32 ? 0 : cells >> after << after;
}

/// The cost of the window that the plain way opens for this run. It is 0 where the row above has the same
/// run.
std::int32_t SpanPlan::saved_bytes(Run run) const {
    if (next_row_ != 0) {
        const std::int32_t first = run.begin / cell, last = (run.end - 1) / cell;
        const std::uint32_t inside = 0xFFFFFFFFu >> (31 - (last - first)) << first;
        const std::uint32_t around = inside | inside << 1 | inside >> 1;
        if ((changed_cells_[next_row_ - 1] & around) == inside)
            return 0;
    }
    return static_cast<std::int32_t>(cost_.window);
}

/// Widens the window above by the runs that it can afford. Returns the cells that it has not taken.
std::uint32_t SpanPlan::merge_window(Window& above, std::uint32_t cells) const {
    std::int32_t begin = above.begin, end = above.end, pixels = 0, spare = above.spare;
    std::uint32_t taken = 0;
    for (std::uint32_t rest = cells; rest != 0;) {
        const Run run = first_run(rest);
        const std::uint32_t after = without(rest, run);
        if (run.begin < above.end && run.end > above.begin) {
            begin = run.begin < begin ? run.begin : begin;
            end = run.end > end ? run.end : end;
            pixels += run.end - run.begin;
            spare += saved_bytes(run);
            taken |= rest ^ after;
        }
        rest = after;
    }
    const std::int32_t height = above.bottom - above.top;
    const std::int32_t wasted = (end - begin) * (height + 1) - (above.end - above.begin) * height - pixels;
    spare -= wasted * static_cast<std::int32_t>(cost_.pixel);
    if (taken == 0 || spare < 0)
        return cells;
    above = {static_cast<std::int16_t>(begin), static_cast<std::int16_t>(end), above.top,
             static_cast<std::int16_t>(next_row_ + 1), spare};
    return cells & ~taken;
}

void SpanPlan::open_windows(std::uint32_t cells) {
    while (cells != 0) {
        Run run = first_run(cells);
        std::int32_t spare = 0;
        cells = without(cells, run);
        while (cells != 0) {
            const Run next = first_run(cells);
            const std::int32_t gap = (next.begin - run.end) * static_cast<std::int32_t>(cost_.pixel);
            if (spare + saved_bytes(next) < gap)
                break;
            spare += saved_bytes(next) - gap;
            run.end = next.end;
            cells = without(cells, next);
        }
        window(window_count_++) = {static_cast<std::int16_t>(run.begin), static_cast<std::int16_t>(run.end),
                                   static_cast<std::int16_t>(next_row_),
                                   static_cast<std::int16_t>(next_row_ + 1), spare};
    }
}

} // namespace spangle::hal
