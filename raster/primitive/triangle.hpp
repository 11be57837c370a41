// Draws triangles (GL 1.3, 3.5.1). Corners are sorted by y, edges are walked exactly, and planes are set up
// when the first row reaches a pixel.
#pragma once

#include <type_traits>

#include "raster/primitive/draw.hpp"
#include "raster/primitive/edge.hpp"
#include "raster/primitive/keep.hpp"
#include "raster/primitive/pen.hpp"
#include "raster/primitive/triangle_tile.hpp"
#include "raster/primitive/triangle_trapezoids.hpp"

namespace spangle::raster {

namespace detail {

template <class V>
inline void observe([[maybe_unused]] const DrawState& state, [[maybe_unused]] const V* const (&v)[3]) {
#ifndef SPANGLE_FIRMWARE
    if (!draws(state) || state.counters == nullptr || state.counters->observer == nullptr ||
        state.counters->observer->triangle == nullptr)
        return; // the observer hears only of primitives that are drawn
    std::int32_t x[3], y[3];
    for (int i = 0; i < 3; ++i)
        x[i] = position(*v[i]).x, y[i] = position(*v[i]).y;
    Observer& observer = *state.counters->observer;
    if constexpr (requires { exact_position(*v[0]); }) {
        double exact_x[3], exact_y[3];
        for (int i = 0; i < 3; ++i)
            exact_x[i] = exact_position(*v[i]).x, exact_y[i] = exact_position(*v[i]).y;
        observer.triangle(observer, x, y, exact_x, exact_y, state.fragment.scissor);
    } else {
        observer.triangle(observer, x, y, nullptr, nullptr, state.fragment.scissor);
    }
#endif
}

template <class V> struct Corner {
    const V* vertex;
    std::int32_t x, y;
    explicit Corner(const V& v) : vertex(&v), x(position(v).x), y(position(v).y) {}
};

template <class V> struct Sorted {
    Corner<V> a, b, c; ///< sorted by y, then x
    std::int64_t area2;
};

/// Swaps two corners that are in the wrong order, except for their x. Each swap inverts `turned`, which is 0
/// or all ones.
template <class V> SPANGLE_INLINE void sort_pair(Corner<V>& low, Corner<V>& high, std::int32_t& turned) {
    if (high.y > low.y || (high.y == low.y && position(*high.vertex).x >= position(*low.vertex).x))
        return;
    // Members are swapped one by one, so that they stay in registers.
    const auto swap = [](auto& a, auto& b) {
        const auto t = a;
        a = b;
        b = t;
    };
    swap(low.vertex, high.vertex);
    swap(low.y, high.y);
    turned = ~turned;
}

/// Sorts corners by y, then by x, so that the walk of a triangle does not depend on the order of its corners.
/// No two corners are the same.
template <bool Branches = numeric::cheap_branches, class V>
SPANGLE_INLINE void sort(Corner<V>& low, Corner<V>& middle, Corner<V>& high, std::int64_t& area2) {
    if constexpr (Branches) {
        std::int32_t turned = 0;
        sort_pair(low, middle, turned);
        sort_pair(middle, high, turned);
        sort_pair(low, middle, turned);
        low.x = position(*low.vertex).x;
        middle.x = position(*middle.vertex).x;
        high.x = position(*high.vertex).x;
        area2 = (area2 ^ turned) - turned;
    } else {
        // Three comparisons select the sorted order, and whether it turns the triangle, from a table. The
        // outcomes of branches would be hard to predict.
        struct Order {
            std::uint8_t low, middle, high, turned;
        };
        static constexpr Order orders[8] = {{0, 1, 2, 0}, {1, 0, 2, 1}, {},           {1, 2, 0, 0},
                                            {0, 2, 1, 1}, {},           {2, 0, 1, 0}, {2, 1, 0, 1}};
        const auto key = [](const Corner<V>& v) { return v.y * (std::int64_t{1} << 32) + v.x; };
        const std::int64_t a = key(low), b = key(middle), c = key(high);
        const Order order = orders[static_cast<unsigned>(b < a) | static_cast<unsigned>(c < a) << 1 |
                                   static_cast<unsigned>(c < b) << 2];
        const V* const v[3] = {low.vertex, middle.vertex, high.vertex};
        const std::int64_t turn = -std::int64_t{order.turned};
        low = Corner(*v[order.low]);
        middle = Corner(*v[order.middle]);
        high = Corner(*v[order.high]);
        area2 = (area2 ^ turn) - turn;
    }
}

/// Sets up the planes of a triangle once, as soon as part of it may be visible.
template <class P>
SPANGLE_INLINE void set_up(Pen<P>& pen, const Sorted<typename P::Vertex>& t,
                           const typename P::Vertex& provoking) {
    if (pen.is_set_up())
        return;
    Setup<P>(pen.span, *t.a.vertex, *t.b.vertex, *t.c.vertex, provoking, t.area2);
    pen.set_up();
}

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

template <class E, class P>
void draw_rows(Pen<P>& pen, const Sorted<typename P::Vertex>& t, const typename P::Vertex& provoking) {
    const std::int32_t xs[3] = {t.a.x, t.b.x, t.c.x}, ys[3] = {t.a.y, t.b.y, t.c.y};
    TriangleRows<E> rows(xs, ys, t.area2 < 0, pen.row_begin(), pen.row_end());
    Row* const begin = pen.rows();
    Row* const full = begin + pen.batch;
    const auto fill = [&] {
        return !has_shortcuts || pen.needs_scissor()
                   ? rows.template fill<true>(begin, pen.batch, pen.column_begin(), pen.column_end())
                   : rows.template fill<false>(begin, pen.batch, 0, 0);
    };
    Row* end = fill();
    if (end == begin)
        return;
    set_up(pen, t, provoking);
    pen.begin();
    do {
        pen.draw(end);
    } while (end == full && (end = fill()) != begin);
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

} // namespace detail

template <class P>
SPANGLE_INLINE void draw_triangle_of(const DrawState& state, const Surface& target,
                                     const typename P::Vertex& a, const typename P::Vertex& b,
                                     const typename P::Vertex& c, const typename P::Vertex& provoking,
                                     std::int64_t area2) {
    detail::Corner low(a), middle(b), high(c);
    detail::sort(low, middle, high, area2);
    std::int32_t least = low.x < middle.x ? low.x : middle.x, most = low.x < middle.x ? middle.x : low.x;
    least = high.x < least ? high.x : least;
    most = high.x > most ? high.x : most;
    const auto sorted = [&] { return detail::Sorted<typename P::Vertex>{low, middle, high, area2}; };

    detail::observe(state, {low.vertex, middle.vertex, high.vertex});
    Pen<P> pen(state, target);
    const std::int32_t left = first_center(least), right = first_center(most);
    if (state.nothing && !keep(state, Primitive::Shape::triangle, 0, nullptr, provoking, a, b, c))
        return;
    if (!pen.reaches_scissor(left, right))
        return;
    if constexpr (!has_shortcuts)
        return detail::draw_rows<Edge>(pen, sorted(), provoking);
    const std::int32_t width = most - least, height = high.y - low.y;
    if (detail::draw_tile(pen, sorted(), provoking, width, left, right))
        return;
    if (detail::draw_trapezoids(pen, sorted(), provoking, width, right))
        return;
    if (width <= SmallEdge::extent && height <= low_extent)
        detail::draw_low(pen, sorted(), provoking, width);
    else if (width <= SmallEdge::extent && height <= SmallEdge::extent)
        detail::draw_rows<SmallEdge>(pen, sorted(), provoking);
    else
        detail::draw_rows<Edge>(pen, sorted(), provoking);
}

} // namespace spangle::raster
