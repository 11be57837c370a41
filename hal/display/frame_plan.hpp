// Which windows a frame is sent in: one rectangle, rows, or spans, whichever costs this bus least.
#pragma once

#include "hal/display/span_plan.hpp"
#include "hal/display/window_plan.hpp"

namespace spangle::hal {

class FramePlan {
  public:
    FramePlan(const WindowPlan& rows, const SpanPlan& spans)
        : rows_(rows), spans_(spans), by_spans_(spans.total() < rows.total()) {}

    /// The next window from the top, or false after the last.
    bool next(Rect& window) { return by_spans_ ? spans_.next(window) : rows_.next(window); }
    void rewind() {
        rows_.rewind();
        spans_.rewind();
    }
    /// Bytes of all windows as planned.
    std::uint32_t total() const { return by_spans_ ? spans_.total() : rows_.total(); }

  private:
    WindowPlan rows_;
    SpanPlan spans_;
    bool by_spans_;
};

} // namespace spangle::hal
