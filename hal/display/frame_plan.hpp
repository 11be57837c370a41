// Selects the windows that a frame is sent in: one rectangle, rows, or spans, whichever costs least on this
// bus.
#pragma once

#include "hal/display/span_plan.hpp"
#include "hal/display/window_plan.hpp"

namespace spangle::hal {

class FramePlan {
  public:
    /// `spans`: a plan of the row hash, whose code is `code`; or null.
    FramePlan(const WindowPlan& rows, SpanPlan* spans, const RowHashCode* code)
        : rows_(rows), spans_(spans), code_(code),
          by_spans_(spans != nullptr && spans->total() < rows.total()) {}

    /// The next window from the top, or false after the last.
    bool next(Rect& window) { return by_spans_ ? code_->next(*spans_, window) : rows_.next(window); }
    void rewind() {
        rows_.rewind();
        if (by_spans_)
            spans_->rewind();
    }

  private:
    WindowPlan rows_;
    SpanPlan* spans_;
    const RowHashCode* code_;
    bool by_spans_;
};

} // namespace spangle::hal
