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
    explicit PixelBox(const Outline& outline) {
        const auto widen = [](Columns& c, std::int32_t v) {
            const std::int32_t low = v >> outline_bits, high = (v + outline_one - 1) >> outline_bits;
            c.begin = low < c.begin ? low : c.begin;
            c.end = high > c.end ? high : c.end;
        };
        for (int i = 0; i < outline.count; ++i) {
            const OutlinePoint point = outline[i];
            widen(columns, point.x);
            widen(rows, point.y);
        }
    }
};

/// Which centres of a row lie between edges, by the rule of edge.hpp.
class RowCenters {
  public:
    void add(const Position& low, const Position& high, std::int32_t row) {
        if (row < first_center(low.y) || row >= first_center(high.y))
            return;
        const std::int32_t column = Edge::at(low.x, low.y, high.x, high.y, row).column();
        found_.begin = column < found_.begin ? column : found_.begin;
        found_.end = column > found_.end ? column : found_.end;
    }
    Columns columns() const { return found_.begin > found_.end ? Columns{} : found_; }

  private:
    Columns found_{INT32_MAX, INT32_MIN};
};

/// Which of them a triangle holds.
template <class V> Columns centers(const Sorted<V>& t, std::int32_t row) {
    const Position a = {t.a.x, t.a.y}, b = {t.b.x, t.b.y}, c = {t.c.x, t.c.y};
    RowCenters found;
    found.add(a, b, row);
    found.add(b, c, row);
    found.add(a, c, row);
    return found.columns();
}

template <class V> Sorted<V> sorted(const V& a, const V& b, const V& c) {
    Corner<V> low(a), middle(b), high(c);
    std::int64_t area2 = signed_area(low.x, low.y, middle.x, middle.y, high.x, high.y);
    sort<true>(low, middle, high, area2);
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
    void draw(const Outline& outline) {
        const detail::PixelBox box(outline);
        rows_.begin = box.rows.begin < pen_.row_begin() ? pen_.row_begin() : box.rows.begin;
        rows_.end = box.rows.end < pen_.row_end() ? box.rows.end : pen_.row_end();
        if (rows_.none() || !pen_.sees(box.columns.begin, box.columns.end))
            return;
        pen_.begin();
        if (is_thin())
            draw_thin(outline, box);
        else
            draw_rows(outline);
    }

  private:
    detail::Sorted<Vertex> part(int i) const {
        return detail::sorted(*corner_[0], *corner_[i], *corner_[i + 1]);
    }

    /// All centres of a row.
    detail::Columns centers(std::int32_t row) const {
        detail::RowCenters found;
        for (int i = 0; i < corners_; ++i) {
            const Position a = position(*corner_[i]), b = position(*corner_[i + 1 < corners_ ? i + 1 : 0]);
            const bool up = a.y < b.y || (a.y == b.y && a.x < b.x); // as corners are sorted
            found.add(up ? a : b, up ? b : a, row);
        }
        return found.columns();
    }

    /// A row whose centres may be the nearest: all of them, and those of one triangle.
    struct Near {
        std::int32_t row = 0;
        detail::Columns all, own;
    };

    /// The nearest row with centres; how far that may be away is what a pointed corner needs.
    void find_centers(Near& near) const {
        constexpr std::int32_t farthest = 64;
        const std::int32_t row = near.row;
        for (std::int32_t away = 1; near.all.none() && away <= 2 * farthest; ++away) {
            near.row = (away & 1) != 0 ? row - (away + 1) / 2 : row + away / 2;
            near.all = centers(near.row);
        }
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

    void draw_thin(const Outline& outline, const detail::PixelBox& box) {
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
        painted_ = 0;
        CoveredRow<P> covered(pen_, primitive_);
        for (std::int32_t y = rows_.begin; y < rows_.end; ++y)
            if (const AreaRow area(outline, y); !area.empty())
                covered.draw(area, y, area.first(), area.last() + 1);
    }

    void draw_rows(const Outline& outline) {
        CoveredRow<P> covered(pen_, primitive_);
        for (std::int32_t y = rows_.begin; y < rows_.end; ++y) {
            const AreaRow area(outline, y);
            if (area.empty())
                continue;
            Near near[3] = {{y, centers(y), {}}, {y - 1, {}, {}}, {y + 1, {}, {}}};
            const bool beside = near[0].all.begin > area.first() || near[0].all.end <= area.last();
            if (beside) {
                near[1].all = centers(y - 1);
                near[2].all = centers(y + 1);
                if (near[0].all.none() && near[1].all.none() && near[2].all.none())
                    find_centers(near[0]);
            }
            for (int i = 1; i + 1 < corners_; ++i)
                draw_part(i, covered, area, y, near, beside);
        }
    }

    /// Of a row, what the i-th triangle paints.
    void draw_part(int i, CoveredRow<P>& covered, const AreaRow& area, std::int32_t y, Near (&near)[3],
                   bool beside) {
        const detail::Sorted<Vertex> t = part(i);
        if (t.area2 == 0)
            return;
        bool any = false;
        for (Near& at : near) {
            at.own = at.all.none() ? detail::Columns{} : detail::centers(t, at.row);
            any = any || !at.own.none();
        }
        if (!any)
            return;
        if (painted_ != i)
            Setup<P>(pen_.span, *t.a.vertex, *t.b.vertex, *t.c.vertex, provoking_, t.area2);
        painted_ = i;
        if (near[0].row == y && !near[0].own.none())
            covered.draw(area, y, near[0].own.begin, near[0].own.end);
        if (!beside)
            return;
        const Anchor anchor{pen_.span.anchor_x, pen_.span.anchor_y};
        draw_beside(covered, area, y, near, anchor);
        pen_.span.anchor_x = anchor.x;
        pen_.span.anchor_y = anchor.y;
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
    int painted_ = 0; ///< the triangle whose planes the span has, or 0
    detail::Columns rows_;
};

template <class P>
void draw_smooth_polygon_of(const DrawState& state, const Surface& target, PrimitiveState& primitive,
                            const typename P::Vertex* const* corner, int corners,
                            const typename P::Vertex& provoking) {
    if (state.nothing)
        return keep_polygon(state, corner, corners, provoking);
    using Vertex = typename P::Vertex;
    const Outline outline = {corner, corners, [](const void* all, int i) {
                                 return outline_point(position(*static_cast<const Vertex* const*>(all)[i]));
                             }};
    SmoothFan<P>(state, target, primitive, corner, corners, provoking).draw(outline);
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
        painted.draw(outline_of(outline, 4));
    });
    if (stipple != nullptr)
        stipple->advance(line.parts());
}

/// A row of a disc: chords on either side, 12 in each half of the disc. They are about as long as each other,
/// going in equal steps of the root of the distance from the pole: what the arcs lie beyond them is less than
/// 1/300 of a pixel.
class DiscRow {
  public:
    DiscRow(const OutlinePoint& center, std::int32_t radius, std::int32_t row)
        : center_(center), radius_(radius) {
        const std::int32_t bottom = row * outline_one;
        std::int32_t low = center.y - radius, high = center.y + radius;
        low = low > bottom ? low : bottom;
        high = high < bottom + outline_one ? high : bottom + outline_one;
        if (low < high && low < center.y)
            add(low, high < center.y ? high : center.y);
        if (low < high && high > center.y)
            add(low > center.y ? low : center.y, high);
        for (int i = 0; i < side_; ++i) // the other side
            point_[2 * side_ - 1 - i] = {2 * center.x - point_[i].x, point_[i].y};
    }
    Outline outline() const { return outline_of(point_, 2 * side_); }

  private:
    static constexpr int chords = 12;
    const OutlinePoint center_;
    const std::int32_t radius_;
    int side_ = 0; ///< points on the right
    OutlinePoint point_[2 * (2 * chords + 1)];

    /// From y to y, both below or both above the centre.
    void add(std::int32_t from, std::int32_t to) {
        constexpr int root_bits = 10;
        const bool above = from >= center_.y;
        const auto root = [&](std::int32_t y) {
            const std::int32_t away = above ? center_.y + radius_ - y : y - (center_.y - radius_);
            return std::int64_t{detail::whole_root(static_cast<std::uint64_t>(away) << (2 * root_bits))};
        };
        const std::int64_t first = root(from), last = root(to);
        for (int i = side_ == 0 ? 0 : 1; i <= chords; ++i) {
            const std::int64_t u = first + numeric::quotient((last - first) * i, chords);
            const auto away = static_cast<std::int32_t>((u * u) >> (2 * root_bits));
            const std::int32_t y = i == 0        ? from
                                   : i == chords ? to
                                   : above       ? center_.y + radius_ - away
                                                 : center_.y - radius_ + away;
            const std::int64_t r = radius_, up = y - center_.y;
            const auto half =
                static_cast<std::int32_t>(detail::whole_root(static_cast<std::uint64_t>(r * r - up * up)));
            point_[side_++] = {center_.x + half, y};
        }
    }
};

template <class P>
void draw_smooth_point_of(const DrawState& state, const Surface& target, PrimitiveState& primitive,
                          const typename P::Vertex& v, std::int32_t eighths) {
    observe_other(state);
    const OutlinePoint center = outline_point(position(v));
    const std::int32_t radius = eighths * (outline_one / 16);
    const OutlinePoint ends[2] = {{center.x - radius, center.y - radius},
                                  {center.x + radius, center.y + radius}};
    const detail::PixelBox box(outline_of(ends, 2));
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
    for (; y < top; ++y) {
        const DiscRow disc(center, radius, y);
        if (const AreaRow area(disc.outline(), y); !area.empty())
            covered.draw(area, y, area.first(), area.last() + 1);
    }
}

} // namespace spangle::raster
