// Which windows carry the damage at the least cost: one rectangle, groups of rows, or single rows.
#pragma once

#include <cstdint>

#include <spangle/format.hpp>
#include <spangle/hal/bus.hpp>
#include <spangle/hal/command_set.hpp>

namespace spangle::hal {

/// Costs on the wire, both in one unit.
struct WindowCost {
    std::uint32_t window = 11; ///< opening one window, overhead of its commands included
    std::uint32_t pixel = 2;
};

/// The largest cost of a window. It keeps every sum below 2^32: 4096 windows and 4096 x 4096 pixels of 32
/// bits.
inline constexpr std::uint32_t dearest_window = 1u << 18;

/// The costs in bits. Where windows have one row of bytes anyway, opening one costs nothing more.
WindowCost window_cost(const BusCaps& caps, const CommandSet& set, std::uint32_t bits_per_pixel);

/// Partitions the rows that are not empty into groups; a group is sent as its bounding rectangle.
///
/// Dynamic programming over runs of equal rows, best(i) = min over j of best(before j) + cost(rectangle of
/// j..i). The search for j stops when the rectangle wastes more than a window per run of the group would
/// cost, since the waste only grows: from there on single runs are cheaper. It also stops after `reach` runs,
/// which bounds time (height * reach) and memory; rectangles cut by that are joined again while they are
/// handed out. Splitting inside a run of equal rows never helps: the cost is linear in the cut.
class WindowPlan {
  public:
    static constexpr std::int32_t reach = 32;

    /// `rows` must stay; `links` is scratch of `height` elements. height <= 4096.
    WindowPlan(const RowSpan* rows, std::int32_t height, WindowCost cost, std::uint16_t* links);

    /// The next window from the top, or false after the last.
    bool next(Rect& window);
    void rewind() {
        next_row_ = 0;
        next_group(pending_window_);
    }
    /// Cost of all windows as planned.
    std::uint32_t total_cost() const { return total_cost_; }

  private:
    struct Run {
        std::int32_t first = 0, last = 0; ///< rows, inclusive
        RowSpan columns;
        std::uint32_t best_before = 0; ///< least cost of everything above
    };
    struct Choice {
        std::uint32_t cost = 0;
        std::int32_t first = 0;
    };

    Run run_from(std::int32_t first) const;
    Choice best_group(const Run* ring, std::uint32_t count) const;
    void plan();
    void reverse_links(std::int32_t last);
    bool next_group(Rect& window);
    std::uint32_t payload(const Rect& window) const;

    const RowSpan* rows_;
    std::uint16_t* links_; ///< while planning: group's first row at its last; then its last row at its first
    std::int32_t height_;
    WindowCost cost_;
    std::uint32_t total_cost_ = 0;
    std::int32_t next_row_ = 0;
    Rect pending_window_; ///< read ahead, to be joined with what follows
};

} // namespace spangle::hal
