// A list of stages over trapezoids: groups of eight lanes from the left side of each row on.
#pragma once

#include "raster/span/fused_groups.hpp"
#include "raster/span/trapezoids.hpp"
#include "raster/surface/surface.hpp"

namespace spangle::raster {

template <class Case> [[gnu::noinline]] void fused_trapezoids(Span<Fixed>& span, const Trapezoids& shape) {
    LaneRows<Case> rows(span, shape.y);
    const Surface target = *span.target; // in registers
    RowPlace at = rows.row(target, shape.y);
    std::int32_t y = shape.y;
    for (const Trapezoids::Part& part : shape.part)
        for (Trapezoids::Side left = part.left, right = part.right; y < part.end; ++y) {
            const std::int32_t first = left.column(), last = right.column();
            if (first < last) {
                touch(target, y, first, last);
                rows.draw(at, y, first, last);
            }
            left.at += left.step;
            right.at += right.step;
            at.color += target.color_stride;
            if constexpr (Case::tested)
                at.depth += target.depth_stride;
        }
}

} // namespace spangle::raster
