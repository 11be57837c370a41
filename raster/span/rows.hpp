// Rows: what a primitive hands to a span function, several at a time, so that the walk of its edges and the
// drawing of its fragments each keep their own registers.
#pragma once

#include <cstddef>
#include <cstdint>

#include "raster/numeric/bits.hpp"
#include "raster/span/draw_state.hpp"
#include "raster/span/span.hpp"

namespace spangle::raster {

/// Columns [left, right) of window row y, of which [first, last) are drawn: left <= first < last <= right.
struct Row {
    std::int32_t y, left, right, first, last;
};

/// Draws rows of the primitive whose planes the span holds.
template <class P> using RowsFunction = void (*)(Span<P>&, const Row* row, const Row* end);

/// Pixel 0 of the span moves to (x, y), and with it every plane that `needs` and `kind` say is set up. Exact
/// in the fixed policy, so the way there does not matter.
template <class P>
SPANGLE_INLINE void move(Span<P>& span, const Needs& needs, Kind kind, std::int32_t x, std::int32_t y) {
    const std::int32_t columns = x - span.x, rows = y - span.y;
    span.x = x;
    span.y = y;
    if (needs.z)
        span.z.move(columns, rows);
    if (kind == Kind::flat)
        return;
    const auto several = [=](auto& planes, bool fourth) {
        planes[0].move(columns, rows);
        planes[1].move(columns, rows);
        planes[2].move(columns, rows);
        if (fourth)
            planes[3].move(columns, rows);
    };
    if (kind == Kind::textured || kind == Kind::full)
        span.q.move(columns, rows);
    if (needs.rgb)
        kind == Kind::full ? several(span.color_q, needs.alpha) : several(span.color_value, needs.alpha);
    if (needs.secondary)
        kind == Kind::full ? several(span.secondary_q, false) : several(span.secondary, false);
    if (needs.fog)
        kind == Kind::affine ? span.fog.move(columns, rows) : span.fog_q.move(columns, rows);
    for (int i = 0; i < max_texture_units; ++i) {
        if (!needs.unit[i])
            continue;
        if (kind == Kind::affine) {
            span.s[i].move(columns, rows);
            span.t[i].move(columns, rows);
            continue;
        }
        span.unit[i].s.move(columns, rows);
        span.unit[i].t.move(columns, rows);
        if (!span.unit[i].shares_q)
            span.unit[i].q.move(columns, rows);
    }
}

/// Where column `x` of the span's row is in memory.
SPANGLE_INLINE void point_at(std::uint8_t*& color, std::uint8_t*& depth, const Surface& target,
                             std::int32_t x, std::int32_t y, std::int32_t bytes, int depth_shift) {
    color = target.color + std::ptrdiff_t{y} * target.color_stride + std::ptrdiff_t{x} * bytes;
    if (target.depth != nullptr)
        depth = target.depth + std::ptrdiff_t{y} * target.depth_stride + (std::ptrdiff_t{x} << depth_shift);
}

/// The span becomes this row, whatever the state is.
template <class P> void enter(Span<P>& span, const Row& row) {
    move(span, span.state->needs, span.kind, row.left, row.y);
    span.length = row.right - row.left;
    span.begin = row.first - row.left;
    span.end = row.last - row.left;
    point_at(span.color, span.depth, *span.target, row.first, row.y,
             format_info(span.target->format).bytes_per_pixel,
             span.target->depth_format == DepthFormat::z16 ? 1 : 2);
}

/// A function of one row as one of many.
template <class P, void (*Draw)(const Span<P>&)> void by_row(Span<P>& span, const Row* row, const Row* end) {
    for (; row != end; ++row) {
        enter(span, *row);
        Draw(span);
    }
}

} // namespace spangle::raster
