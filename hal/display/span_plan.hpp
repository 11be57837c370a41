// Plans windows around changed cells. A row may have several windows, where these cost less than one window
// around all cells.
#pragma once

#include <cstdint>

#include <spangle/hal/row_hash.hpp>

#include "hal/display/window_plan.hpp"

namespace spangle::hal {

/// Plans the windows of a frame. The changed cells of a row form runs.
///
/// The plain way is one window for each block of equal runs below each other. On a bus without overhead,
/// where windows cost nothing, the plan is the plain way. Otherwise a window may take in another run, from
/// the next row or beside it. This wastes pixels, but saves the window of that run. A window may waste as
/// much as it has saved so far. So a frame costs at most twice the plain way, and mostly less.
///
/// Windows are kept until they cannot become longer, and are given out from the top. There is room for `room`
/// windows. Where others wait behind a long window, it is given out early and goes on as another window.
class SpanPlan {
  public:
    SpanPlan() = default;
    /// Plans windows around the cells that reduce() has left, in the memory of the row hash. The hash and its
    /// memory must outlive the plan.
    SpanPlan(const RowHash& hash, const WindowCost& cost);

    /// Gives the next window from the top, or returns false after the last window.
    bool next(Rect& window);
    void rewind() { next_row_ = first_window_ = window_count_ = 0; }
    /// The cost of all windows; UINT32_MAX where there is no plan.
    std::uint32_t total_cost() const { return total_cost_; }

  private:
    static constexpr std::int32_t room = RowHashMemory::window_count, most_runs = 16;
    using Window = SpanWindow;
    struct Run {
        std::int32_t begin, end; ///< columns [begin, end)
    };

    Window& window(std::int32_t i) const { return windows_[(first_window_ + i) % room]; }
    bool settled() const {
        return next_row_ == height_ || window_count_ > room - most_runs || window(0).bottom < next_row_;
    }
    void plan_row();
    std::int32_t saved_bytes(Run run) const;
    std::uint32_t merge_window(Window& above, std::uint32_t cells) const;
    void open_windows(std::uint32_t cells);
    Run first_run(std::uint32_t cells) const;
    static std::uint32_t without(std::uint32_t cells, Run run);

    const std::uint32_t* changed_cells_ = nullptr;
    std::int32_t width_ = 0, height_ = 0;
    WindowCost cost_;
    std::uint32_t total_cost_ = UINT32_MAX;
    std::int32_t next_row_ = 0; ///< the next row to plan
    /// A ring of `window_count_` windows, ordered by their top, from `first_window_` on.
    Window* windows_ = nullptr;
    std::int32_t first_window_ = 0, window_count_ = 0;
};

} // namespace spangle::hal
