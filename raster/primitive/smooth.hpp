// Antialiased points, lines and polygons (GL 1.3, 3.3, 3.4.2, 3.5.3): an outline says how much of each pixel
// is covered, a fan of triangles what is painted there.
//
// A fragment whose centre lies outside of the fan takes the data of the nearest centre inside, in its row or
// in the nearest row that has one: nothing is extrapolated, so no colour and no depth leaves the range of its
// corners. Where hardly any centre is inside, attributes vary along the longer axis only.
#pragma once

#include "raster/primitive/covered_row.hpp"
#include "raster/primitive/line_outline.hpp"
#include "raster/primitive/triangle.hpp"

namespace spangle::raster {

namespace detail {

struct Columns {
    std::int32_t begin = 0, end = 0;
    bool none() const { return begin >= end; }
};

/// The box of an outline, whole pixels.
struct PixelBox {
    Columns columns{INT32_MAX, INT32_MIN}, rows{INT32_MAX, INT32_MIN};
    PixelBox(const OutlinePoint* point, int n) {
        const auto widen = [](Columns& c, std::int32_t v) {
            const std::int32_t low = v >> outline_bits, high = (v + outline_one - 1) >> outline_bits;
            c.begin = low < c.begin ? low : c.begin;
            c.end = high > c.end ? high : c.end;
        };
        for (int i = 0; i < n; ++i) {
            widen(columns, point[i].x);
            widen(rows, point[i].y);
        }
    }
};

/// Which centres of a row a triangle holds, by the rule of edge.hpp.
template <class V> Columns centers(const Sorted<V>& t, std::int32_t row) {
    Columns found{INT32_MAX, INT32_MIN};
    const auto edge = [&](const Corner<V>& low, const Corner<V>& high) {
        if (row < first_center(low.y) || row >= first_center(high.y))
            return;
        const std::int32_t column = Edge::at(low.x, low.y, high.x, high.y, row).column();
        found.begin = column < found.begin ? column : found.begin;
        found.end = column > found.end ? column : found.end;
    };
    edge(t.a, t.b);
    edge(t.b, t.c);
    edge(t.a, t.c);
    return found.begin > found.end ? Columns{} : found;
}

template <class V> Sorted<V> sorted(const V& a, const V& b, const V& c) {
    Corner<V> low(a), middle(b), high(c);
    std::int64_t area2 = signed_area(low.x, low.y, middle.x, middle.y, high.x, high.y);
    sort_pair(low, middle, area2);
    sort_pair(middle, high, area2);
    sort_pair(low, middle, area2);
    return {low, middle, high, area2};
}

} // namespace detail

/// What a convex polygon paints.
template <class P> class SmoothFan {
  public:
    using Vertex = typename P::Vertex;

    SmoothFan(const DrawState& state, const Surface& target, PrimitiveState& primitive,
              const Vertex* const* corner, int corners, const Vertex& provoking)
        : pen_(state, target), primitive_(primitive), corner_(corner), corners_(corners),
          provoking_(provoking) {}

    /// Inside of an outline that lies in the polygon.
    void draw(const OutlinePoint* outline, int n) {
        const detail::PixelBox box(outline, n);
        outline_ = outline;
        outline_corners_ = n;
        rows_.begin = box.rows.begin < pen_.row_begin() ? pen_.row_begin() : box.rows.begin;
        rows_.end = box.rows.end < pen_.row_end() ? box.rows.end : pen_.row_end();
        if (rows_.none() || !pen_.sees(box.columns.begin, box.columns.end))
            return;
        pen_.begin();
        if (is_thin())
            return draw_thin(box);
        for (int i = 1; i + 1 < corners_; ++i)
            draw_part(i);
    }

  private:
    detail::Sorted<Vertex> part(int i) const {
        return detail::sorted(*corner_[0], *corner_[i], *corner_[i + 1]);
    }

    /// All centres of a row.
    detail::Columns centers(std::int32_t row) const {
        detail::Columns all;
        for (int i = 1; i + 1 < corners_; ++i) {
            const detail::Columns one = detail::centers(part(i), row);
            if (one.none())
                continue;
            if (all.none())
                all = one;
            all.begin = one.begin < all.begin ? one.begin : all.begin;
            all.end = one.end > all.end ? one.end : all.end;
        }
        return all;
    }

    /// The nearest row with centres; how far that may be away is what a pointed corner needs.
    bool find_centers(std::int32_t row, std::int32_t& found, detail::Columns& columns) const {
        constexpr std::int32_t farthest = 64;
        for (std::int32_t away = 0; away <= 2 * farthest; ++away) {
            found = (away & 1) != 0 ? row - (away + 1) / 2 : row + away / 2;
            columns = centers(found);
            if (!columns.none())
                return true;
        }
        return false;
    }

    /// Nowhere wider than a pixel: most of its rows or columns may have no centre.
    bool is_thin() const {
        std::int64_t area2 = 0;
        Position low = position(*corner_[0]), high = low;
        for (int i = 0; i < corners_; ++i) {
            const Position p = position(*corner_[i]);
            low = {p.x < low.x ? p.x : low.x, p.y < low.y ? p.y : low.y};
            high = {p.x > high.x ? p.x : high.x, p.y > high.y ? p.y : high.y};
            if (i > 0 && i + 1 < corners_)
                area2 += static_cast<std::int64_t>(numeric::abs_u64(part(i).area2));
        }
        const std::int32_t width = high.x - low.x, height = high.y - low.y;
        return area2 <= std::int64_t{subpixel_one} * (width > height ? width : height);
    }

    void draw_thin(const detail::PixelBox& box) {
        const Vertex *left = corner_[0], *right = left, *low = left, *high = left;
        for (int i = 1; i < corners_; ++i) {
            const Vertex* const v = corner_[i];
            left = position(*v).x < position(*left).x ? v : left;
            right = position(*v).x > position(*right).x ? v : right;
            low = position(*v).y < position(*low).y ? v : low;
            high = position(*v).y > position(*high).y ? v : high;
        }
        const bool along_x = position(*right).x - position(*left).x > position(*high).y - position(*low).y;
        const detail::Columns& reached = along_x ? box.columns : box.rows;
        const auto center = [](std::int32_t i) { return i * subpixel_one + subpixel_one / 2; };
        std::int32_t begin = along_x ? position(*left).x : position(*low).y,
                     end = along_x ? position(*right).x : position(*high).y;
        begin = center(reached.begin) < begin ? center(reached.begin) : begin;
        end = center(reached.end - 1) > end ? center(reached.end - 1) : end;
        Setup<P>(pen_.span, along_x ? *left : *low, along_x ? *right : *high, provoking_, along_x, begin,
                 end);
        CoveredRow<P> covered(pen_, primitive_);
        for (std::int32_t y = rows_.begin; y < rows_.end; ++y)
            if (const AreaRow area(outline_, outline_corners_, y); !area.empty())
                covered.draw(area, y, area.first(), area.last() + 1);
    }

    /// A row whose centres may be the nearest: all of them, and those of one triangle.
    struct Near {
        std::int32_t row = 0;
        detail::Columns all, own;
    };
    void enter(Near& near, std::int32_t row, const detail::Sorted<Vertex>& t) const {
        near.row = row;
        near.all = centers(row);
        near.own = near.all.none() ? detail::Columns{} : detail::centers(t, row);
    }

    void draw_part(int i) {
        const detail::Sorted<Vertex> t = part(i);
        if (t.area2 == 0)
            return;
        Setup<P>(pen_.span, *t.a.vertex, *t.b.vertex, *t.c.vertex, provoking_, t.area2);
        const Anchor anchor{pen_.span.anchor_x, pen_.span.anchor_y};
        CoveredRow<P> covered(pen_, primitive_);
        for (std::int32_t y = rows_.begin; y < rows_.end; ++y) {
            const AreaRow area(outline_, outline_corners_, y);
            if (area.empty())
                continue;
            Near near[3];
            enter(near[0], y, t);
            if (!near[0].own.none())
                covered.draw(area, y, near[0].own.begin, near[0].own.end);
            if (near[0].all.begin <= area.first() && near[0].all.end > area.last())
                continue;
            enter(near[1], y - 1, t);
            enter(near[2], y + 1, t);
            if (near[0].all.none() && near[1].all.none() && near[2].all.none()) {
                detail::Columns columns;
                if (find_centers(y, near[0].row, columns))
                    enter(near[0], near[0].row, t);
            }
            draw_beside(covered, area, y, near, anchor);
            pen_.span.anchor_x = anchor.x;
            pen_.span.anchor_y = anchor.y;
        }
    }

    struct Anchor {
        std::int32_t x, y;
    };
    /// Fragments whose own centre is not inside, where the nearest one is this triangle's.
    void draw_beside(CoveredRow<P>& covered, const AreaRow& area, std::int32_t y, const Near (&near)[3],
                     const Anchor& anchor) {
        std::int32_t x = area.first() < pen_.column_begin() ? pen_.column_begin() : area.first();
        const std::int32_t end = area.last() < pen_.column_end() ? area.last() + 1 : pen_.column_end();
        for (; x < end; ++x) {
            const Near* nearest = nullptr;
            std::int32_t column = 0, least = INT32_MAX;
            for (const Near& at : near) {
                if (at.all.none())
                    continue;
                const std::int32_t inside = numeric::clamp(x, at.all.begin, at.all.end - 1);
                const std::int32_t distance = (inside < x ? x - inside : inside - x) + (at.row != y ? 1 : 0);
                if (distance < least) {
                    nearest = &at;
                    column = inside;
                    least = distance;
                }
            }
            if (nearest == nullptr || least == 0 || column < nearest->own.begin || column >= nearest->own.end)
                continue;
            pen_.span.anchor_x = anchor.x + (x - column);
            pen_.span.anchor_y = anchor.y + (y - nearest->row);
            covered.draw(area, y, x, x + 1);
        }
    }

    Pen<P> pen_;
    PrimitiveState& primitive_;
    const Vertex* const* corner_;
    int corners_;
    const Vertex& provoking_;
    const OutlinePoint* outline_ = nullptr;
    int outline_corners_ = 0;
    detail::Columns rows_;
};

template <class P>
void draw_smooth_polygon_of(const DrawState& state, const Surface& target, PrimitiveState& primitive,
                            const typename P::Vertex* const* corner, int corners,
                            const typename P::Vertex& provoking) {
    if (state.nothing)
        return keep_polygon(state, corner, corners, provoking);
    OutlinePoint outline[most_smooth_corners];
    for (int i = 0; i < corners; ++i)
        outline[i] = outline_point(position(*corner[i]));
    SmoothFan<P>(state, target, primitive, corner, corners, provoking).draw(outline, corners);
}

template <class P>
void draw_smooth_line_of(const DrawState& state, const Surface& target, PrimitiveState& primitive,
                         const typename P::Vertex& a, const typename P::Vertex& b,
                         const typename P::Vertex& provoking, std::int32_t eighths, LineStipple* stipple) {
    observe_other(state);
    const LineOutline line(position(a), position(b), eighths);
    if (line.empty())
        return;
    if (state.nothing) {
        keep(state, Primitive::Shape::smooth_line, eighths, stipple, provoking, a, b);
        if (stipple != nullptr)
            stipple->advance(line.parts());
        return;
    }
    const LineCorners<typename P::Vertex> corners(line, a, b);
    const typename P::Vertex* fan[4];
    for (int i = 0; i < 4; ++i)
        fan[i] = &corners.at[i];
    SmoothFan<P> painted(state, target, primitive, fan, 4, provoking);
    line.each_kept(stipple, [&](std::uint32_t begin, std::uint32_t end) {
        OutlinePoint outline[4];
        line.corners(begin, end, outline);
        painted.draw(outline, 4);
    });
    if (stipple != nullptr)
        stipple->advance(line.parts());
}

/// A row of a disc: sides of 16 chords.
class DiscRow {
  public:
    DiscRow(const OutlinePoint& center, std::int32_t radius, std::int32_t row) {
        const std::int32_t bottom = row * outline_one;
        std::int32_t low = center.y - radius, high = center.y + radius;
        low = low > bottom ? low : bottom;
        high = high < bottom + outline_one ? high : bottom + outline_one;
        if (low >= high)
            return;
        // Chords are closest where the circle is flattest: between the ends in equal steps.
        count_ = 2 * (chords + 1);
        for (std::int32_t i = 0; i <= chords; ++i) {
            const std::int32_t y = low + (high - low) * i / chords;
            const std::int64_t r = radius, up = y - center.y;
            const auto half =
                static_cast<std::int32_t>(detail::whole_root(static_cast<std::uint64_t>(r * r - up * up)));
            point_[i] = {center.x + half, y};
            point_[count_ - 1 - i] = {center.x - half, y};
        }
    }
    AreaRow area(std::int32_t row) const { return AreaRow(point_, count_, row); }

  private:
    static constexpr int chords = 16;
    static_assert(2 * (chords + 1) <= AreaRow::most_edges);
    OutlinePoint point_[2 * (chords + 1)];
    int count_ = 0;
};

template <class P>
void draw_smooth_point_of(const DrawState& state, const Surface& target, PrimitiveState& primitive,
                          const typename P::Vertex& v, std::int32_t eighths) {
    observe_other(state);
    const OutlinePoint center = outline_point(position(v));
    const std::int32_t radius = eighths * (outline_one / 16);
    const OutlinePoint ends[2] = {{center.x - radius, center.y - radius},
                                  {center.x + radius, center.y + radius}};
    const detail::PixelBox box(ends, 2);
    Pen<P> pen(state, target);
    std::int32_t y = box.rows.begin < pen.row_begin() ? pen.row_begin() : box.rows.begin;
    const std::int32_t top = box.rows.end < pen.row_end() ? box.rows.end : pen.row_end();
    if (state.nothing)
        return keep(state, Primitive::Shape::smooth_point, eighths, nullptr, v, v);
    if (y >= top || !pen.sees(box.columns.begin, box.columns.end))
        return;
    Setup<P>(pen.span, v);
    pen.begin();
    CoveredRow<P> covered(pen, primitive);
    for (; y < top; ++y)
        if (const AreaRow area = DiscRow(center, radius, y).area(y); !area.empty())
            covered.draw(area, y, area.first(), area.last() + 1);
}

} // namespace spangle::raster
