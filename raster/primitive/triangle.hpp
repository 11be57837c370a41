// Triangles: sorted by y, walked exactly, set up when the first row shows a pixel (GL 1.3, 3.5.1).
#pragma once

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

/// By y, then x: the order in which a triangle's corners are walked does not depend on the order they came
/// in.
template <class V> inline bool below(const V* a, const V* b) {
    return position(*a).y != position(*b).y ? position(*a).y < position(*b).y
                                            : position(*a).x < position(*b).x;
}

template <class V> inline void sort_pair(const V*& low, const V*& high, bool& odd) {
    if (below(high, low)) {
        const V* const t = low;
        low = high;
        high = t;
        odd = !odd;
    }
}

} // namespace detail

namespace detail {

template <class E, class P>
void draw_rows(Pen<P>& pen, const typename P::Vertex* const corners[3], const typename P::Vertex& provoking,
               const std::int32_t xs[3], const std::int32_t ys[3], std::int64_t area2) {
    TriangleRows<E> rows(xs, ys, area2 < 0, pen.row_begin(), pen.row_end());
    const auto fill = [&] {
        return pen.cuts()
                   ? rows.template fill<true>(pen.rows(), pen.batch, pen.column_begin(), pen.column_end())
                   : rows.template fill<false>(pen.rows(), pen.batch, 0, 0);
    };
    int count = fill();
    if (count == 0)
        return;
    Setup<P>(pen.span, *corners[0], *corners[1], *corners[2], provoking, area2);
    pen.begin();
    do {
        pen.draw(count);
    } while (count == pen.batch && (count = fill()) != 0);
}

template <class E, class P>
void draw_low(Pen<P>& pen, const typename P::Vertex* const corners[3], const typename P::Vertex& provoking,
              const std::int32_t xs[3], const std::int32_t ys[3], std::int64_t area2) {
    static_assert(low_extent <= (Pen<P>::batch - 1) * subpixel_one);
    const int count = pen.cuts() ? low_rows<E, true>(pen.rows(), xs, ys, area2 < 0, pen.clip())
                                 : low_rows<E, false>(pen.rows(), xs, ys, area2 < 0, pen.clip());
    if (count == 0)
        return;
    Setup<P>(pen.span, *corners[0], *corners[1], *corners[2], provoking, area2);
    pen.begin();
    pen.draw(count);
}

} // namespace detail

template <class P>
void draw_triangle_of(const DrawState& state, const Surface& target, const typename P::Vertex& a,
                      const typename P::Vertex& b, const typename P::Vertex& c,
                      const typename P::Vertex& provoking, std::int64_t area2) {
    const typename P::Vertex* corners[3] = {&a, &b, &c};
    bool odd = false;
    detail::sort_pair(corners[0], corners[1], odd);
    detail::sort_pair(corners[1], corners[2], odd);
    detail::sort_pair(corners[0], corners[1], odd);
    if (odd)
        area2 = -area2;
    std::int32_t xs[3], ys[3];
    for (int i = 0; i < 3; ++i)
        xs[i] = position(*corners[i]).x, ys[i] = position(*corners[i]).y;
    std::int32_t least = xs[0] < xs[1] ? xs[0] : xs[1], most = xs[0] < xs[1] ? xs[1] : xs[0];
    least = xs[2] < least ? xs[2] : least;
    most = xs[2] > most ? xs[2] : most;

    detail::observe(state, corners);
    Pen<P> pen(state, target);
    if (state.nothing || !pen.sees(first_center(least), first_center(most)))
        return;
    const std::int32_t width = most - least, height = ys[2] - ys[0];
    if (numeric::cheap_branches && width <= ShortEdge::extent && height <= low_extent)
        detail::draw_low<ShortEdge>(pen, corners, provoking, xs, ys, area2);
    else if (width <= SmallEdge::extent && height <= low_extent)
        detail::draw_low<SmallEdge>(pen, corners, provoking, xs, ys, area2);
    else if (width <= SmallEdge::extent && height <= SmallEdge::extent)
        detail::draw_rows<SmallEdge>(pen, corners, provoking, xs, ys, area2);
    else
        detail::draw_rows<Edge>(pen, corners, provoking, xs, ys, area2);
}

} // namespace spangle::raster
