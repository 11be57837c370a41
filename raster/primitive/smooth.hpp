// Antialiased points, lines and polygons (GL 1.3, 3.3, 3.4.2, 3.5.3). An outline gives the coverage of each
// pixel, and a fan of triangles gives its data.
//
// A fragment whose centre lies outside of the fan takes the data of the nearest centre inside, in its row or
// in the nearest row that has one. Nothing is extrapolated, so no colour and no depth leaves the range of its
// corners. Where hardly any centre is inside, attributes vary along the longer axis only.
#pragma once

#include "raster/primitive/covered_pieces.hpp"
#include "raster/primitive/fan.hpp"
#include "raster/primitive/line_outline.hpp"

namespace spangle::raster {

/// Draws fragments with the data of a convex polygon.
template <class P> class SmoothFan {
  public:
    using Vertex = typename P::Vertex;

    SmoothFan(const DrawState& state, const Surface& target, PrimitiveState& primitive,
              const Vertex* const* corner, int corners, const Vertex& provoking)
        : pen_(state, target), primitive_(primitive), fan_(corner, corners), provoking_(provoking) {}

    /// Draws the inside of an outline, which must lie in the polygon.
    void draw(const Outline& outline) {
        const detail::PixelBox box(outline);
        rows_.begin = box.rows.begin < pen_.row_begin() ? pen_.row_begin() : box.rows.begin;
        rows_.end = box.rows.end < pen_.row_end() ? box.rows.end : pen_.row_end();
        if (rows_.none() || !pen_.reaches_scissor(box.columns.begin, box.columns.end))
            return;
        pen_.begin();
        if (is_thin())
            draw_thin(outline, box);
        else
            draw_rows(outline);
    }

  private:
    /// Finds the nearest row that holds centres. `farthest` is the largest number of rows between a pointed
    /// corner and such a row.
    void find_centers(FanRow& near) const {
        constexpr std::int32_t farthest = 64;
        const std::int32_t row = near.row;
        for (std::int32_t away = 1; near.all.none() && away <= 2 * farthest; ++away) {
            near.row = (away & 1) != 0 ? row - (away + 1) / 2 : row + away / 2;
            near.all = fan_.centers(near.row);
        }
    }

    /// Whether the polygon is nowhere wider than a pixel. Most of its rows or columns may then hold no
    /// centre.
    bool is_thin() const {
        std::int64_t area2 = 0;
        Position low = position(fan_[0]), high = low;
        for (int i = 0; i < fan_.corners(); ++i) {
            const Position p = position(fan_[i]);
            low = {p.x < low.x ? p.x : low.x, p.y < low.y ? p.y : low.y};
            high = {p.x > high.x ? p.x : high.x, p.y > high.y ? p.y : high.y};
            if (i > 0 && i + 1 < fan_.corners())
                area2 += static_cast<std::int64_t>(numeric::abs_u64(fan_.part(i).area2));
        }
        const std::int32_t width = high.x - low.x, height = high.y - low.y;
        return area2 <= std::int64_t{subpixel_one} * (width > height ? width : height);
    }

    void draw_thin(const Outline& outline, const detail::PixelBox& box) {
        const Vertex *left = &fan_[0], *right = left, *low = left, *high = left;
        for (int i = 1; i < fan_.corners(); ++i) {
            const Vertex* const v = &fan_[i];
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
        CoveredPieces<P> pieces(pen_, primitive_, {});
        pieces.add_rows(outline, rows_.begin, rows_.end, {});
    }

    static void set_up(void* of, int i) {
        auto& self = *static_cast<SmoothFan*>(of);
        const detail::Sorted<Vertex> t = self.fan_.part(i);
        Setup<P>(self.pen_.span, *t.a.vertex, *t.b.vertex, *t.c.vertex, self.provoking_, t.area2);
    }

    void draw_rows(const Outline& outline) {
        CoveredPieces<P> pieces(pen_, primitive_, {&SmoothFan::set_up, this});
        if (const int part = fan_.uniform_part(); part != 0)
            return pieces.add_rows(outline, rows_.begin, rows_.end, {part, 0, 0});
        FanRow rows[3]; // the row before, this row and the next row, by turns
        FanRow *before = rows, *here = rows + 1, *next = rows + 2;
        fan_.find(*before, rows_.begin - 1);
        fan_.find(*here, rows_.begin);
        for (std::int32_t y = rows_.begin; y < rows_.end; ++y) {
            fan_.find(*next, y + 1);
            draw_row(pieces, outline, y, *before, *here, *next);
            FanRow* const last = before;
            before = here;
            here = next;
            next = last;
        }
    }

    void draw_row(CoveredPieces<P>& pieces, const Outline& outline, std::int32_t y, const FanRow& before,
                  const FanRow& here, const FanRow& next) {
        const AreaRow area(outline, y);
        if (area.empty())
            return;
        RowCoverage coverage(area, pen_.column_begin(), pen_.column_end());
        for (int i = 1; i + 1 < fan_.corners(); ++i)
            if (const detail::Columns triangle_columns = fan_.triangle_columns(here, i);
                !triangle_columns.none())
                pieces.add(coverage, y, triangle_columns.begin, triangle_columns.end, {i, 0, 0});
        if (here.all.begin <= coverage.begin() && here.all.end >= coverage.end())
            return;
        if (!here.all.none() || !before.all.none() || !next.all.none()) {
            const FanRow* const near[3] = {&here, &before, &next};
            return draw_beside(pieces, coverage, y, near, true);
        }
        FanRow far = here;
        find_centers(far);
        const FanRow* const near[3] = {&far, &before, &next};
        draw_beside(pieces, coverage, y, near, false);
    }

    /// Adds the fragments whose own centre is not inside, with the data of the nearest centre inside. `kept`
    /// says that the rows of `near` are as Fan::find() wrote them.
    void draw_beside(CoveredPieces<P>& pieces, RowCoverage& coverage, std::int32_t y,
                     const FanRow* const (&near)[3], bool kept) {
        for (std::int32_t x = coverage.begin(); x < coverage.end(); ++x) {
            const FanRow* nearest = nullptr;
            std::int32_t column = 0, least = INT32_MAX;
            for (const FanRow* const at : near) {
                if (at->all.none())
                    continue;
                const std::int32_t inside = numeric::clamp(x, at->all.begin, at->all.end - 1);
                const std::int32_t distance = (inside < x ? x - inside : inside - x) + (at->row != y ? 1 : 0);
                if (distance < least) {
                    nearest = at;
                    column = inside;
                    least = distance;
                }
            }
            if (nearest == nullptr)
                return;
            if (least == 0) { // the centre is inside: all such columns are skipped
                x = nearest->all.end - 1;
                continue;
            }
            for (int i = 1; i + 1 < fan_.corners(); ++i)
                if (const detail::Columns triangle_columns = fan_.triangle_columns(*nearest, i, kept);
                    column >= triangle_columns.begin && column < triangle_columns.end)
                    pieces.add(coverage, y, x, x + 1, {i, x - column, y - nearest->row});
        }
    }

    Pen<P> pen_;
    PrimitiveState& primitive_;
    Fan<Vertex> fan_;
    const Vertex& provoking_;
    detail::Columns rows_;
};

template <class P>
void draw_smooth_polygon_of(const DrawState& state, const Surface& target, PrimitiveState& primitive,
                            const typename P::Vertex* const* corner, int corners,
                            const typename P::Vertex& provoking) {
    if (state.nothing && !keep_polygon(state, corner, corners, provoking))
        return;
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
    if (state.nothing && !keep(state, Primitive::Shape::smooth_line, eighths, stipple, provoking, a, b)) {
        if (stipple != nullptr)
            stipple->advance(line.parts());
        return;
    }
    const LineCorners<typename P::Vertex> corners(line, a, b);
    const typename P::Vertex* fan[4];
    for (int i = 0; i < 4; ++i)
        fan[i] = &corners.at[i];
    SmoothFan<P> painted(state, target, primitive, fan, 4, provoking);
    line.each_stippled_part(stipple, [&](std::uint32_t begin, std::uint32_t end) {
        OutlinePoint outline[4];
        line.corners(begin, end, outline);
        painted.draw(outline_of(outline, 4));
    });
    if (stipple != nullptr)
        stipple->advance(line.parts());
}

/// One row of a disc that is bounded by chords, 12 on each side in each half of the disc. They are about
/// equally long, because they go in equal steps of the root of the distance from the pole. The arcs lie less
/// than 1/300 of a pixel beyond the chords.
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
        for (int i = 0; i < right_count_; ++i) // the left side mirrors the right
            point_[2 * right_count_ - 1 - i] = {2 * center.x - point_[i].x, point_[i].y};
    }
    Outline outline() const { return outline_of(point_, 2 * right_count_); }

  private:
    static constexpr int chords = 12;
    const OutlinePoint center_;
    const std::int32_t radius_;
    int right_count_ = 0; ///< number of points on the right side
    OutlinePoint point_[2 * (2 * chords + 1)];

    /// Adds the points on the right side between two y, which are both below or both above the centre.
    void add(std::int32_t from, std::int32_t to) {
        constexpr int root_bits = 10;
        const bool above = from >= center_.y;
        const auto root = [&](std::int32_t y) {
            const std::int32_t away = above ? center_.y + radius_ - y : y - (center_.y - radius_);
            return std::int64_t{detail::integer_sqrt(static_cast<std::uint64_t>(away) << (2 * root_bits))};
        };
        const std::int64_t first = root(from), last = root(to);
        for (int i = right_count_ == 0 ? 0 : 1; i <= chords; ++i) {
            const std::int64_t u = first + numeric::quotient((last - first) * i, chords);
            const auto away = static_cast<std::int32_t>((u * u) >> (2 * root_bits));
            const std::int32_t y = i == 0        ? from
                                   : i == chords ? to
                                   : above       ? center_.y + radius_ - away
                                                 : center_.y - radius_ + away;
            const std::int64_t r = radius_, up = y - center_.y;
            const auto half =
                static_cast<std::int32_t>(detail::integer_sqrt(static_cast<std::uint64_t>(r * r - up * up)));
            point_[right_count_++] = {center_.x + half, y};
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
    if (state.nothing && !keep(state, Primitive::Shape::smooth_point, eighths, nullptr, v, v))
        return;
    if (y >= top || !pen.reaches_scissor(box.columns.begin, box.columns.end))
        return;
    Setup<P>(pen.span, v);
    pen.begin();
    CoveredPieces<P> pieces(pen, primitive, {});
    for (; y < top; ++y) {
        const DiscRow disc(center, radius, y);
        pieces.add_rows(disc.outline(), y, y + 1, {});
    }
}

} // namespace spangle::raster
