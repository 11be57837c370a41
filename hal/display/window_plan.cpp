#include "hal/display/window_plan.hpp"

#include <spangle/hal/window.hpp>

namespace spangle::hal {
namespace {

bool empty(RowSpan row) {
    return row.begin >= row.end;
}

RowSpan around(RowSpan a, RowSpan b) {
    return {a.begin < b.begin ? a.begin : b.begin, a.end > b.end ? a.end : b.end};
}

std::uint32_t area(RowSpan columns, std::int32_t rows) {
    return static_cast<std::uint32_t>(columns.end - columns.begin) * static_cast<std::uint32_t>(rows);
}

} // namespace

WindowCost window_cost(const BusCaps& caps, const CommandSet& set, std::uint32_t bits_per_pixel) {
    if (names_one(set.rows))
        return {0, bits_per_pixel};
    const WindowSize size = window_size(set);
    const std::uint64_t bits_per_second = std::uint64_t{caps.write_hz} * caps.bits_per_cycle;
    const std::uint64_t overhead = bits_per_second * caps.command_cost_ns / 1000000000u * size.commands;
    const std::uint64_t whole = size.bytes * 8 + overhead;
    return {static_cast<std::uint32_t>(whole < dearest_window ? whole : dearest_window), bits_per_pixel};
}

WindowPlan::WindowPlan(const RowSpan* rows, std::int32_t height, WindowCost cost, std::uint16_t* links)
    : rows_(rows), links_(links), height_(height), cost_(cost) {
    plan();
    rewind();
}

std::uint32_t WindowPlan::payload(const Rect& r) const {
    return static_cast<std::uint32_t>(r.w) * static_cast<std::uint32_t>(r.h) * cost_.pixel;
}

WindowPlan::Run WindowPlan::run_from(std::int32_t first) const {
    Run run{first, first, rows_[first], total_cost_};
    while (run.last + 1 < height_ && rows_[run.last + 1] == run.columns)
        ++run.last;
    return run;
}

/// The best group that ends with the newest run, ring[(count - 1) % reach].
WindowPlan::Choice WindowPlan::best_group(const Run* ring, std::uint32_t count) const {
    const std::int32_t last = ring[(count - 1) % reach].last;
    RowSpan box;
    std::uint32_t own = 0, windows = 0;
    Choice best{UINT32_MAX, 0};
    for (std::uint32_t back = 1; back <= count && back <= reach; ++back) {
        const Run& run = ring[(count - back) % reach];
        box = around(box, run.columns);
        own += area(run.columns, run.last - run.first + 1) * cost_.pixel;
        windows += cost_.window;
        const std::uint32_t payload = area(box, last - run.first + 1) * cost_.pixel;
        const std::uint32_t cost = run.best_before + cost_.window + payload;
        if (cost < best.cost)
            best = {cost, run.first};
        if (payload - own > windows)
            break;
    }
    return best;
}

void WindowPlan::plan() {
    Run ring[reach];
    std::uint32_t count = 0;
    std::int32_t last = -1;
    for (std::int32_t y = 0; y < height_; ++y) {
        if (empty(rows_[y]))
            continue;
        const Run run = run_from(y);
        ring[count++ % reach] = run;
        const Choice best = best_group(ring, count);
        links_[run.last] = static_cast<std::uint16_t>(best.first);
        total_cost_ = best.cost;
        last = y = run.last;
    }
    reverse_links(last);
}

void WindowPlan::reverse_links(std::int32_t last) {
    while (last >= 0) {
        const std::int32_t first = links_[last];
        links_[first] = static_cast<std::uint16_t>(last);
        last = first - 1;
        while (last >= 0 && empty(rows_[last]))
            --last;
    }
}

bool WindowPlan::next_group(Rect& window) {
    window = Rect{};
    while (next_row_ < height_ && empty(rows_[next_row_]))
        ++next_row_;
    if (next_row_ >= height_)
        return false;
    const std::int32_t first = next_row_, last = links_[first];
    RowSpan box;
    for (; next_row_ <= last; ++next_row_)
        box = around(box, rows_[next_row_]);
    window = {box.begin, first, box.end - box.begin, last - first + 1};
    return true;
}

bool WindowPlan::next(Rect& window) {
    if (pending_window_.h == 0)
        return false;
    window = pending_window_;
    while (next_group(pending_window_)) {
        const std::int32_t x0 = window.x < pending_window_.x ? window.x : pending_window_.x;
        const std::int32_t x1 = window.x + window.w > pending_window_.x + pending_window_.w
                                    ? window.x + window.w
                                    : pending_window_.x + pending_window_.w;
        const Rect joined = {x0, window.y, x1 - x0, pending_window_.y + pending_window_.h - window.y};
        if (payload(joined) > payload(window) + payload(pending_window_) + cost_.window)
            break;
        window = joined;
    }
    return true;
}

} // namespace spangle::hal
