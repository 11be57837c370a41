// Sorts the corners of a triangle by y, and draws it row by row.
#pragma once

#include <type_traits>

#include "raster/primitive/draw.hpp"
#include "raster/primitive/edge.hpp"
#include "raster/primitive/fill_rows.hpp"
#include "raster/primitive/keep.hpp"
#include "raster/primitive/pen.hpp"

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

/// The columns of a triangle: the first centre not left of it, the first centre right of it, and its width in
/// subpixels.
struct Breadth {
    std::int32_t left, right, width;
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

/// Draws a triangle row by row. Edges of type E can walk it.
template <class E, class P>
void draw_rows(Pen<P>& pen, const Sorted<typename P::Vertex>& t, const typename P::Vertex& provoking) {
    const std::int32_t xs[3] = {t.a.x, t.b.x, t.c.x}, ys[3] = {t.a.y, t.b.y, t.c.y};
    TriangleRows<E> rows(xs, ys, t.area2 < 0, pen.row_begin(), pen.row_end());
    Row* const begin = pen.rows();
    Row* const full = begin + pen.batch;
    const auto fill = [&] { return fill_rows(rows, pen, begin); };
    Row* end = fill();
    if (end == begin)
        return;
    set_up(pen, t, provoking);
    pen.begin();
    do {
        pen.draw(end);
    } while (end == full && (end = fill()) != begin);
}

} // namespace detail

} // namespace spangle::raster
