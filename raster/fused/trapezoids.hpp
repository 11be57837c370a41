// Runs a list of stages over trapezoids. Each row is drawn in groups of eight lanes that start at its left
// side.
#pragma once

#include "raster/fused/gathered.hpp"
#include "raster/fused/groups.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/trapezoids.hpp"
#include "raster/surface/surface.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

template <class Case, class Rows>
SPANGLE_INLINE void draw_trapezoids(Rows& rows, const Surface& target, const Trapezoids& shape) {
    RowPlace at = row_of<Case>(target, shape.y);
    std::int32_t y = shape.y;
    for (const Trapezoids::Part& part : shape.part)
        for (Trapezoids::Side left = part.left, right = part.right; y < part.end; ++y) {
            const std::int32_t first = left.column(), last = right.column();
            if (first < last) {
                mark_damage(target, y, first, last);
                rows.draw(at, y, first, last);
            }
            rows.next_row();
            left.at += left.step;
            right.at += right.step;
            at.color += target.color_stride;
            if constexpr (Case::tested)
                at.depth += target.depth_stride;
        }
}

/// Draws trapezoids through a GatheredPacket. Returns false, and draws nothing, where the image is too large
/// for the packet.
template <class Case> SPANGLE_INLINE bool gathered_trapezoids(Span<Fixed>& span, const Trapezoids& shape) {
    const std::int32_t left = span.state->fragment.scissor.x;
    const PlaneRow at{span, nullptr, nullptr, left, shape.y, left};
    GatheredPacket<Case> packet(at);
    GatheredRows<Case> rows(at, packet);
    if (!rows.takes()) [[unlikely]]
        return false;
    const Surface target = *span.target; // a copy, which stays in registers
    draw_trapezoids<Case>(rows, target, shape);
    rows.flush();
    return true;
}

template <class Case> [[gnu::noinline]] void fused_trapezoids(Span<Fixed>& span, const Trapezoids& shape) {
    if constexpr (Case::gathered)
        if (gathered_trapezoids<typename Case::Gathered>(span, shape)) [[likely]]
            return;
    const typename Case::LanePattern pattern(span.flat_word);
    LaneRows<Case> rows(span, shape.y, pattern);
    const Surface target = *span.target; // a copy, which stays in registers
    draw_trapezoids<Case>(rows, target, shape);
}

/// Draws trapezoids by the case for gray colours, or otherwise by the case for all colours.
template <class Case, class Gray> void fused_trapezoids_by_gray(Span<Fixed>& span, const Trapezoids& shape) {
    if (span.gray)
        fused_trapezoids<Gray>(span, shape);
    else
        fused_trapezoids<Case>(span, shape);
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
