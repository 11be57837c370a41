// Windows around changed cells: several in a row, where these cost less than one around all of them.
#pragma once

#include <cstdint>

#include <spangle/hal/row_hash.hpp>

#include "hal/display/window_plan.hpp"

namespace spangle::hal {

/// The cells of a row form runs. The plain way is a window around each block of equal runs below each other.
/// That is the plan, too, where windows are as cheap as on a bus without overhead. A window that takes
/// another run in, from the row below or beside it, wastes pixels and saves the window of that run: it may
/// waste what it saved so far. So a frame costs at most twice the plain way, and mostly less.
///
/// Windows are kept until nothing can make them longer, and handed out from the top. There is room for `room`
/// windows. A long window that others wait behind is handed out early, and goes on as another window.
class SpanPlan {
  public:
    SpanPlan() = default;
    /// Plans windows around the cells that reduce() left, in the memory of the row hash; both must stay.
    SpanPlan(const RowHash& hash, const WindowCost& cost);

    /// The next window from the top, or false after the last.
    bool next(Rect& window);
    void rewind() { next_row_ = first_window_ = window_count_ = 0; }
    /// Cost of all windows; UINT32_MAX without a plan.
    std::uint32_t total_cost() const { return total_cost_; }

  private:
    static constexpr std::int32_t room = RowHashMemory::window_count, most_runs = 16;
    using Window = SpanWindow;
    struct Run {
        std::int32_t begin, end; ///< columns
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
    std::int32_t next_row_ = 0; ///< the next row to be planned
    Window* windows_ = nullptr; ///< a ring of `window_count_` windows from `first_window_` on, by their top
    std::int32_t first_window_ = 0, window_count_ = 0;
};

} // namespace spangle::hal
