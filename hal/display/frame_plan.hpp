// Selects the windows in which a frame is sent: one rectangle, rows, or spans. The cheapest choice depends on
// the bus.
#pragma once

#include "hal/display/span_plan.hpp"
#include "hal/display/window_plan.hpp"

namespace spangle::hal {

class FramePlan {
  public:
    /// `spans` is a plan of the row hash, whose code is `code`; both are null without a row hash.
    FramePlan(const WindowPlan& rows, SpanPlan* spans, const RowHashCode* code)
        : window_plan_(rows), span_plan_(spans), row_hashes_(code),
          uses_spans_(spans != nullptr && spans->total_cost() < rows.total_cost()) {}

    /// Gives the next window from the top, or returns false after the last window.
    bool next(Rect& window) {
        return uses_spans_ ? row_hashes_->next(*span_plan_, window) : window_plan_.next(window);
    }
    void rewind() {
        window_plan_.rewind();
        if (uses_spans_)
            span_plan_->rewind();
    }

  private:
    WindowPlan window_plan_;
    SpanPlan* span_plan_;
    const RowHashCode* row_hashes_;
    bool uses_spans_;
};

} // namespace spangle::hal
