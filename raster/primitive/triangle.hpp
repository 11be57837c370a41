// Triangles: sorted by y, walked exactly, set up when the first row shows a pixel (GL 1.3, 3.5.1).
#pragma once

#include <type_traits>

#include "raster/primitive/draw.hpp"
#include "raster/primitive/edge.hpp"
#include "raster/primitive/pen.hpp"

namespace spangle::raster {

namespace detail {

template <class V>
inline void observe([[maybe_unused]] const DrawState& state, [[maybe_unused]] const V* const (&v)[3]) {
#ifndef SPANGLE_FIRMWARE
    if (state.counters == nullptr || state.counters->observer == nullptr ||
        state.counters->observer->triangle == nullptr)
        return;
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

/// By y, then x: the order in which a triangle's corners are walked does not depend on the order they came
/// in.
template <class V> SPANGLE_INLINE void sort_pair(Corner<V>& low, Corner<V>& high, std::int64_t& area2) {
    if (high.y > low.y || (high.y == low.y && high.x >= low.x))
        return;
    // Member by member: registers.
    const auto swap = [](auto& a, auto& b) {
        const auto t = a;
        a = b;
        b = t;
    };
    swap(low.vertex, high.vertex);
    swap(low.x, high.x);
    swap(low.y, high.y);
    area2 = -area2;
}

template <class V> struct Sorted {
    Corner<V> a, b, c; ///< upwards
    std::int64_t area2;
};

template <class E, class P>
void draw_rows(Pen<P>& pen, const Sorted<typename P::Vertex>& t, const typename P::Vertex& provoking) {
    const std::int32_t xs[3] = {t.a.x, t.b.x, t.c.x}, ys[3] = {t.a.y, t.b.y, t.c.y};
    TriangleRows<E> rows(xs, ys, t.area2 < 0, pen.row_begin(), pen.row_end());
    Row* const begin = pen.rows();
    Row* const full = begin + pen.batch;
    const auto fill = [&] {
        return pen.cuts() ? rows.template fill<true>(begin, pen.batch, pen.column_begin(), pen.column_end())
                          : rows.template fill<false>(begin, pen.batch, 0, 0);
    };
    Row* end = fill();
    if (end == begin)
        return;
    Setup<P>(pen.span, *t.a.vertex, *t.b.vertex, *t.c.vertex, provoking, t.area2);
    pen.begin();
    do {
        pen.draw(end);
    } while (end == full && (end = fill()) != begin);
}

template <class E, class P>
SPANGLE_INLINE void draw_low(Pen<P>& pen, const Sorted<typename P::Vertex>& t,
                             const typename P::Vertex& provoking) {
    static_assert(low_extent <= (Pen<P>::batch - 1) * subpixel_one);
    const std::int32_t xs[3] = {t.a.x, t.b.x, t.c.x}, ys[3] = {t.a.y, t.b.y, t.c.y};
    Row* const begin = pen.rows();
    const Row* const end = pen.cuts() ? low_rows<E, true>(begin, xs, ys, t.area2 < 0, pen.clip())
                                      : low_rows<E, false>(begin, xs, ys, t.area2 < 0, pen.clip());
    if (end == begin)
        return;
    Setup<P>(pen.span, *t.a.vertex, *t.b.vertex, *t.c.vertex, provoking, t.area2);
    pen.begin();
    pen.draw(end);
}

} // namespace detail

template <class P>
SPANGLE_INLINE void draw_triangle_of(const DrawState& state, const Surface& target,
                                     const typename P::Vertex& a, const typename P::Vertex& b,
                                     const typename P::Vertex& c, const typename P::Vertex& provoking,
                                     std::int64_t area2) {
    detail::Corner low(a), middle(b), high(c);
    detail::sort_pair(low, middle, area2);
    detail::sort_pair(middle, high, area2);
    detail::sort_pair(low, middle, area2);
    std::int32_t least = low.x < middle.x ? low.x : middle.x, most = low.x < middle.x ? middle.x : low.x;
    least = high.x < least ? high.x : least;
    most = high.x > most ? high.x : most;
    const auto sorted = [&] { return detail::Sorted<typename P::Vertex>{low, middle, high, area2}; };

    detail::observe(state, {low.vertex, middle.vertex, high.vertex});
    Pen<P> pen(state, target);
    if (state.nothing || !pen.sees(first_center(least), first_center(most)))
        return;
    const std::int32_t width = most - least, height = high.y - low.y;
    using Low = std::conditional_t<numeric::divides, LowEdge, ShortEdge>;
    if (width <= Low::extent && height <= low_extent)
        detail::draw_low<Low>(pen, sorted(), provoking);
    else if (width <= SmallEdge::extent && height <= low_extent)
        detail::draw_low<SmallEdge>(pen, sorted(), provoking);
    else if (width <= SmallEdge::extent && height <= SmallEdge::extent)
        detail::draw_rows<SmallEdge>(pen, sorted(), provoking);
    else
        detail::draw_rows<Edge>(pen, sorted(), provoking);
}

} // namespace spangle::raster
