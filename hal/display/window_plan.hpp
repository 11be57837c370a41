// Plans the windows that send the damage at the least cost: one rectangle, groups of rows, or single rows.
#pragma once

#include <cstdint>

#include <spangle/format.hpp>
#include <spangle/hal/bus.hpp>
#include <spangle/hal/command_set.hpp>

namespace spangle::hal {

/// Costs on the wire. Both are in the same unit.
struct WindowCost {
    std::uint32_t window = 11; ///< cost of opening one window, commands included
    std::uint32_t pixel = 2;
};

/// The largest cost of a window. With it every sum stays below 2^32: 4096 windows, and 4096 x 4096 pixels of
/// 32 bits.
inline constexpr std::uint32_t dearest_window = 1u << 18;

/// The costs in bits. On controllers whose windows have one row of bytes, a window costs nothing.
WindowCost window_cost(const BusCaps& caps, const CommandSet& set, std::uint32_t bits_per_pixel);

/// Partitions the rows that are not empty into groups. A group is sent as its bounding rectangle.
///
/// The plan is dynamic programming over runs of equal rows: best(i) = min over j of best(before j) +
/// cost(rectangle of j..i). The search for j stops where the rectangle wastes more than one window for each
/// run of the group costs. The waste only grows, so single runs are cheaper from there on. The search also
/// stops after `reach` runs, which bounds time (height * reach) and memory. Rectangles that this limit has
/// cut are joined again while they are given out. Splitting inside of a run of equal rows never helps,
/// because the cost is linear in the cut.
class WindowPlan {
  public:
    static constexpr std::int32_t reach = 32;

    /// `rows` must outlive the plan. `links` is scratch memory of `height` elements. height <= 4096.
    WindowPlan(const RowSpan* rows, std::int32_t height, WindowCost cost, std::uint16_t* links);

    /// Gives the next window from the top, or returns false after the last window.
    bool next(Rect& window);
    void rewind() {
        next_row_ = 0;
        next_group(pending_window_);
    }
    /// The cost of all windows as planned.
    std::uint32_t total_cost() const { return total_cost_; }

  private:
    struct Run {
        std::int32_t first = 0, last = 0; ///< first and last row
        RowSpan columns;
        std::uint32_t best_before = 0; ///< least cost of all rows above this run
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
    /// While planning, links_ holds the first row of a group at its last row. Afterwards it holds the last
    /// row at the first row.
    std::uint16_t* links_;
    std::int32_t height_;
    WindowCost cost_;
    std::uint32_t total_cost_ = 0;
    std::int32_t next_row_ = 0;
    Rect pending_window_; ///< a window that was planned, and may still be joined with the next
};

} // namespace spangle::hal
