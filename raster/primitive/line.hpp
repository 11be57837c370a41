// Lines of whole widths: diamond exit, replicated across the minor axis (GL 1.3, 3.4.1 and 3.4.2).
#pragma once

#include "raster/primitive/diamond.hpp"
#include "raster/primitive/draw.hpp"
#include "raster/primitive/keep.hpp"
#include "raster/primitive/line_stipple.hpp"
#include "raster/primitive/pen.hpp"

namespace spangle::raster {

namespace detail {

/// The centre of fragment `i` in subpixels.
constexpr std::int32_t center_of(std::int32_t i) {
    return i * subpixel_one + subpixel_one / 2;
}

/// The interval along which attributes of a line run, from one end to the other. Where the centre of the
/// first or last fragment lies beyond an end, the end is moved there. So no attribute is extrapolated, which
/// could make depth wrap.
struct LineInterval {
    std::int32_t begin, end;
    LineInterval(const DiamondWalk& walk, std::int32_t a, std::int32_t b) {
        const std::int32_t low = center_of(walk.major), high = center_of(walk.major + walk.count - 1);
        begin = walk.ascends ? (low < a ? low : a) : (high > a ? high : a);
        end = walk.ascends ? (high > b ? high : b) : (low < b ? low : b);
    }
};

template <class P, class Mask>
void draw_x_major(Pen<P>& pen, DiamondWalk walk, std::int32_t width, const Mask& kept) {
    while (walk.count > 0) {
        const std::int32_t row = walk.minor, left = walk.major;
        const bool drawn = kept(left);
        do {
            walk.step();
        } while (walk.count > 0 && walk.minor == row && kept(walk.major) == drawn);
        if (!drawn)
            continue;
        std::int32_t y = row < pen.row_begin() ? pen.row_begin() : row;
        const std::int32_t top = row + width < pen.row_end() ? row + width : pen.row_end();
        for (; y < top; ++y)
            pen.add(y, left, walk.major);
    }
}

template <class P, class Mask>
void draw_y_major(Pen<P>& pen, DiamondWalk walk, std::int32_t width, const Mask& kept) {
    for (; walk.count > 0; walk.step())
        if (kept(walk.major))
            pen.add(walk.major, walk.minor, walk.minor + width);
}

} // namespace detail

/// Pattern is SolidLine or StippledLine.
template <class P, class Pattern = SolidLine>
void draw_line_of(const DrawState& state, const Surface& target, const typename P::Vertex& a,
                  const typename P::Vertex& b, const typename P::Vertex& provoking, std::int32_t width,
                  Pattern pattern = {}) {
    observe_other(state);
    Pen<P> pen(state, target);
    const Position pa = position(a), pb = position(b);
    DiamondWalk walk(pa.x, pa.y, pb.x, pb.y, (width - 1) * (subpixel_one / 2));
    const typename Pattern::Mask kept = pattern.along(walk);
    if (state.nothing && !keep(state, Primitive::Shape::line, width, Pattern::of(kept), provoking, a, b))
        return;
    if (walk.count == 0)
        return;
    const detail::LineInterval interval(walk, walk.along_x ? pa.x : pa.y, walk.along_x ? pb.x : pb.y);
    if (walk.along_x)
        walk.clip(pen.column_begin(), pen.column_end());
    else
        walk.clip(pen.row_begin(), pen.row_end());
    if (walk.count == 0)
        return;
    Setup<P>(pen.span, a, b, provoking, walk.along_x, interval.begin, interval.end);
    pen.begin();
    if (walk.along_x)
        detail::draw_x_major(pen, walk, width, kept);
    else
        detail::draw_y_major(pen, walk, width, kept);
    pen.flush();
}

} // namespace spangle::raster
