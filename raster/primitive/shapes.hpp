// Points and lines of multisample rasterization (GL 1.3, 3.3.2, 3.4.4). Their fragments are those whose
// centres lie in a disc or in a rectangle.
#pragma once

#include "raster/primitive/keep.hpp"
#include "raster/primitive/smooth.hpp"

namespace spangle::raster {

template <class P>
void draw_disc_of(const DrawState& state, const Surface& target, const typename P::Vertex& v,
                  std::int32_t eighths) {
    observe_other(state);
    if (state.nothing && !keep(state, Primitive::Shape::disc, eighths, nullptr, v, v))
        return;
    const Position at = position(v);
    const std::int64_t radius = eighths * (subpixel_one / 16);
    const auto low = static_cast<std::int32_t>(at.y - radius),
               high = static_cast<std::int32_t>(at.y + radius);
    Pen<P> pen(state, target);
    std::int32_t y = first_center(low) < pen.row_begin() ? pen.row_begin() : first_center(low);
    const std::int32_t top = first_center(high + 1) < pen.row_end() ? first_center(high + 1) : pen.row_end();
    if (y >= top || !pen.reaches_scissor(first_center(static_cast<std::int32_t>(at.x - radius)),
                                         first_center(static_cast<std::int32_t>(at.x + radius + 1))))
        return;
    Setup<P>(pen.span, v);
    pen.begin();
    for (; y < top; ++y) {
        const std::int64_t up = y * subpixel_one + subpixel_one / 2 - at.y;
        const auto half = static_cast<std::int32_t>(
            detail::integer_sqrt(static_cast<std::uint64_t>(radius * radius - up * up)));
        const std::int32_t left = first_center(at.x - half), right = first_center(at.x + half + 1);
        if (left < right)
            pen.add(y, left, right);
    }
    pen.flush();
}

namespace detail {

/// The centres of a row that a convex quad covers.
inline Columns centers(const Position (&quad)[4], std::int32_t row) {
    Columns found;
    for (int i = 1; i < 3; ++i) {
        const Columns one = centers(sorted(quad[0], quad[i], quad[i + 1]), row);
        if (one.none())
            continue;
        found.begin = found.none() || one.begin < found.begin ? one.begin : found.begin;
        found.end = one.end > found.end ? one.end : found.end;
    }
    return found;
}

/// Draws the part of a triangle that lies in the parts of a line's rectangle that the stipple leaves.
template <class P>
void draw_parts(const DrawState& state, const Surface& target, const Sorted<typename P::Vertex>& t,
                const typename P::Vertex& provoking, const LineOutline& line, const LineStipple& stipple) {
    Pen<P> pen(state, target);
    Setup<P>(pen.span, *t.a.vertex, *t.b.vertex, *t.c.vertex, provoking, t.area2);
    pen.begin();
    line.each_stippled_part(&stipple, [&](std::uint32_t begin, std::uint32_t end) {
        OutlinePoint outline[4];
        Position quad[4];
        line.strip(begin, end, outline);
        for (int i = 0; i < 4; ++i)
            quad[i] = snapped(outline[i]);
        const PixelBox box(outline_of(outline, 4));
        std::int32_t y = box.rows.begin < pen.row_begin() ? pen.row_begin() : box.rows.begin;
        const std::int32_t top = box.rows.end < pen.row_end() ? box.rows.end : pen.row_end();
        for (; y < top; ++y) {
            const Columns own = centers(t, y), part = centers(quad, y);
            const std::int32_t left = own.begin > part.begin ? own.begin : part.begin,
                               right = own.end < part.end ? own.end : part.end;
            if (left < right)
                pen.add(y, left, right);
        }
    });
    pen.flush();
}

} // namespace detail

template <class P>
void draw_line_rectangle_of(const DrawState& state, const Surface& target, const typename P::Vertex& a,
                            const typename P::Vertex& b, const typename P::Vertex& provoking,
                            std::int32_t eighths, LineStipple* stipple) {
    observe_other(state);
    const LineOutline line(position(a), position(b), eighths);
    if (line.empty())
        return;
    const bool is_drawn =
        !state.nothing || keep(state, Primitive::Shape::line_rectangle, eighths, stipple, provoking, a, b);
    const LineCorners<typename P::Vertex> corners(line, a, b);
    for (int i = 1; i < 3 && is_drawn; ++i) {
        const auto t = detail::sorted(corners.at[0], corners.at[i], corners.at[i + 1]);
        if (t.area2 == 0)
            continue;
        if (stipple == nullptr)
            draw_triangle(state, target, *t.a.vertex, *t.b.vertex, *t.c.vertex, provoking, t.area2);
        else
            detail::draw_parts<P>(state, target, t, provoking, line, *stipple);
    }
    if (stipple != nullptr)
        stipple->advance(line.parts());
}

} // namespace spangle::raster
