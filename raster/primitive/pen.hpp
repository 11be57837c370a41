// Takes the rows of a primitive through the scissor rectangle, touched rows and counters to the span function
// of the state.
#pragma once

#include <cstdint>

#include "raster/ops/lanes.hpp"
#include "raster/primitive/setup.hpp"
#include "raster/span/rows.hpp"
#include "raster/surface/surface.hpp"

namespace spangle::raster {

/// Tells the observer that a primitive which is not a triangle begins.
inline void observe_other([[maybe_unused]] const DrawState& state) {
#ifndef SPANGLE_FIRMWARE
    if (state.counters != nullptr && state.counters->observer != nullptr &&
        state.counters->observer->other != nullptr)
        state.counters->observer->other(*state.counters->observer);
#endif
}

template <class P> class Pen {
  public:
    Span<P> span;

    Pen(const DrawState& state, const Surface& target) : scissor_(state.fragment.scissor) {
        span.state = &state;
        span.target = &target;
        span.depth = nullptr;
    }

    /// Whether the planes of `span` are set up. This is always false in builds that do not try tiles first.
    bool is_set_up() const { return host_lanes > 1 && is_set_up_; }
    void set_up() {
        if constexpr (host_lanes > 1)
            is_set_up_ = true;
    }

    const Rect& clip() const { return scissor_; }
    std::int32_t row_begin() const { return scissor_.y; }
    std::int32_t row_end() const { return scissor_.y + scissor_.h; }
    std::int32_t column_begin() const { return scissor_.x; }
    std::int32_t column_end() const { return scissor_.x + scissor_.w; }
    /// Takes the range of columns of a primitive. Returns true if some of its columns may be drawn.
    /// needs_scissor() then says whether some of them may have to be clipped.
    bool reaches_scissor(std::int32_t left, std::int32_t right) {
        needs_clipping_ = left < scissor_.x || right > column_end();
        return !needs_clipping_ || (left < column_end() && right > scissor_.x);
    }
    bool needs_scissor() const { return needs_clipping_; }

    /// Must be called once per primitive that reaches a pixel, after its set-up.
    void begin() {
        if (span.state->counters != nullptr)
            ++span.state->counters->triangles;
    }

    /// The number of rows that are drawn at once. Where rows share packets (shared_rows.hpp), this many rows
    /// fill several packets, even with one fragment each.
    static constexpr int batch = host_lanes > 1 ? 4 * packet : packet;
    /// Memory for `batch` rows, which are drawn together.
    Row* rows() { return rows_; }

    /// Draws rows from rows() up to `end`, one at least.
    void draw(const Row* end) {
        record_rows(end);
        const Variant& variant = span.state->variant[static_cast<unsigned>(span.kind)];
        reinterpret_cast<RowsFunction<P>>(variant.run)(span, rows_, end);
    }

    /// Adds columns [left, right) of row y, which lies inside the scissor rectangle. Draws all rows when
    /// `batch` rows are there.
    SPANGLE_INLINE void add(std::int32_t y, std::int32_t left, std::int32_t right) {
        std::int32_t first = left, last = right;
        if (needs_clipping_) {
            first = left < scissor_.x ? scissor_.x : left;
            last = right < column_end() ? right : column_end();
            if (first >= last)
                return;
        }
        rows_[row_count_] = {y, left, right, first, last};
        if (++row_count_ == batch)
            flush();
    }

    /// Draws the rows that add() has left. It must be called after the last add().
    void flush() {
        if (row_count_ != 0)
            draw(rows_ + row_count_);
        row_count_ = 0;
    }

  private:
    /// Records rows that are about to be drawn: touched columns, counters, observers.
    void record_rows(const Row* end) {
        const Surface& target = *span.target;
        if (target.touched != nullptr)
            for (const Row* row = rows_; row != end; ++row)
                mark_damage(target, row->y, row->first, row->last);
        Counters* const counters = span.state->counters;
        if (counters == nullptr)
            return;
        for (const Row* row = rows_; row != end; ++row) {
            counters->fragments += static_cast<std::uint32_t>(row->last - row->first);
#ifndef SPANGLE_FIRMWARE
            if (counters->observer != nullptr && counters->observer->span != nullptr)
                counters->observer->span(*counters->observer, row->y, row->first, row->last);
#endif
        }
    }

    const Rect& scissor_;
    [[maybe_unused]] bool is_set_up_ = false;
    bool needs_clipping_ = true; ///< some column may lie outside of the scissor rectangle
    int row_count_ = 0;
    Row rows_[batch];
};

} // namespace spangle::raster
