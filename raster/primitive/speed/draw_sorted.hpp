// Draws a sorted triangle by the fastest way that its size and state allow.
#pragma once

#include <type_traits>

#include "raster/primitive/triangle_rows.hpp"
#include "raster/primitive/triangle_tile.hpp"
#include "raster/primitive/triangle_trapezoids.hpp"

namespace spangle::raster {

namespace detail {

/// Sets up a triangle within SmallEdge::extent, whose box fits a word. `width` is in subpixels.
template <class P>
SPANGLE_INLINE void set_up_small(Pen<P>& pen, const Sorted<typename P::Vertex>& t,
                                 const typename P::Vertex& provoking, std::int32_t width) {
    if constexpr (!std::is_same_v<P, Fixed>) {
        set_up(pen, t, provoking);
    } else if (!pen.is_set_up()) {
        Setup<P>(pen.span, *t.a.vertex, *t.b.vertex, *t.c.vertex, provoking,
                 Setup<P>::Area::in_box(static_cast<std::int32_t>(t.area2),
                                        static_cast<std::uint32_t>(width * (t.c.y - t.a.y))));
        pen.set_up();
    }
}

/// Draws a triangle within low_extent and SmallEdge::extent.
template <class P>
SPANGLE_INLINE void draw_low(Pen<P>& pen, const Sorted<typename P::Vertex>& t,
                             const typename P::Vertex& provoking, std::int32_t width) {
    static_assert(low_extent <= (Pen<P>::batch - 1) * subpixel_one);
    using Low = std::conditional_t<numeric::divides, LowEdge, ShortEdge>;
    const std::int32_t xs[3] = {t.a.x, t.b.x, t.c.x}, ys[3] = {t.a.y, t.b.y, t.c.y};
    Row* const begin = pen.rows();
    const auto rows = [&]<class E>(E) {
        return pen.needs_scissor() ? low_rows<E, true>(begin, xs, ys, t.area2 < 0, pen.clip())
                                   : low_rows<E, false>(begin, xs, ys, t.area2 < 0, pen.clip());
    };
    const Row* const end = width <= Low::extent ? rows(Low()) : rows(SmallEdge());
    if (end == begin)
        return;
    set_up_small(pen, t, provoking, width);
    pen.begin();
    pen.draw(end);
}

/// Draws a triangle as one or two tiles, if it is small enough and its state and kind draw tiles. Returns
/// false where nothing was drawn.
template <class P>
SPANGLE_INLINE bool draw_tile(Pen<P>& pen, const Sorted<typename P::Vertex>& t,
                              const typename P::Vertex& provoking, std::int32_t width, std::int32_t left,
                              std::int32_t right) {
    if constexpr (host_lanes > 1 && std::is_same_v<P, Fixed>) {
        const DrawState& state = *pen.span.state;
        Tile tile;
        int tiles;
        if (!state.tiles || pen.needs_scissor() || state.counters != nullptr ||
            !make_tile(tile, tiles, *t.a.vertex, *t.b.vertex, *t.c.vertex, t.area2 < 0, left, right,
                       pen.clip()))
            return false;
        if (tile.rows <= 0)
            return true;
        set_up_small(pen, t, provoking, width);
        const Shapes* const shapes = state.variant[static_cast<unsigned>(pen.span.kind)].shapes;
        if (shapes == nullptr || shapes->tile == nullptr)
            return false;
        const bool touched = is_touched(*pen.span.target, tile, left, right);
        for (;; tile.move_right()) {
            if (!touched) [[unlikely]]
                touch_tile(*pen.span.target, tile);
            shapes->tile(pen.span, tile);
            if (--tiles == 0)
                return true;
        }
    }
    return false;
}

/// Draws a triangle as trapezoids, if it is small enough and its state and kind draw trapezoids. Returns
/// false where nothing was drawn.
template <class P>
SPANGLE_INLINE bool draw_trapezoids(Pen<P>& pen, const Sorted<typename P::Vertex>& t,
                                    const typename P::Vertex& provoking, std::int32_t width,
                                    std::int32_t right) {
    if constexpr (host_lanes > 1 && std::is_same_v<P, Fixed>) {
        const DrawState& state = *pen.span.state;
        if (!state.shapes || pen.needs_scissor() || state.counters != nullptr || width > SmallEdge::extent ||
            t.c.y - t.a.y > SmallEdge::extent || right > pen.column_end() - Lanes<8>::count)
            return false;
        const std::int32_t low = first_center(t.a.y), high = first_center(t.c.y),
                           begin = low < pen.row_begin() ? pen.row_begin() : low,
                           end = high < pen.row_end() ? high : pen.row_end();
        if (begin >= end)
            return true;
        set_up_small(pen, t, provoking, width);
        const Shapes* const shapes = state.variant[static_cast<unsigned>(pen.span.kind)].shapes;
        if (shapes == nullptr)
            return false;
        const std::int32_t xs[3] = {t.a.x, t.b.x, t.c.x}, ys[3] = {t.a.y, t.b.y, t.c.y};
        shapes->trapezoids(pen.span, make_trapezoids(xs, ys, t.area2 < 0, begin, end));
        return true;
    }
    return false;
}

/// Draws a sorted triangle that may reach columns of the scissor rectangle.
template <class P>
SPANGLE_INLINE void draw_sorted(Pen<P>& pen, const Sorted<typename P::Vertex>& t,
                                const typename P::Vertex& provoking, const Breadth& breadth) {
    const std::int32_t width = breadth.width, height = t.c.y - t.a.y;
    if (draw_tile(pen, t, provoking, width, breadth.left, breadth.right))
        return;
    if (draw_trapezoids(pen, t, provoking, width, breadth.right))
        return;
    if (width <= SmallEdge::extent && height <= low_extent)
        draw_low(pen, t, provoking, width);
    else if (width <= SmallEdge::extent && height <= SmallEdge::extent)
        draw_rows<SmallEdge>(pen, t, provoking);
    else
        draw_rows<Edge>(pen, t, provoking);
}

} // namespace detail

} // namespace spangle::raster
