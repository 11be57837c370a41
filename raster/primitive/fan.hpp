// Finds the pixel centres of a row that a fan of triangles covers, and the centres that each triangle of the
// fan covers.
#pragma once

#include "raster/primitive/area.hpp"
#include "raster/primitive/fan_memory.hpp"
#include "raster/primitive/triangle.hpp"

namespace spangle::raster {

namespace detail {

struct Columns {
    std::int32_t begin = 0, end = 0;
    bool none() const { return begin >= end; }
};

/// The bounding box of an outline, in whole pixels.
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

/// Finds which centres of a row lie between edges, by the rule of edge.hpp.
class RowCenters {
  public:
    void add(const Position& low, const Position& high, std::int32_t row) {
        if (row < first_center(low.y) || row >= first_center(high.y))
            return;
        add(Edge::at(low.x, low.y, high.x, high.y, row).column());
    }
    void add(std::int32_t column) {
        columns_.begin = column < columns_.begin ? column : columns_.begin;
        columns_.end = column > columns_.end ? column : columns_.end;
    }
    Columns columns() const { return columns_.begin > columns_.end ? Columns{} : columns_; }

  private:
    Columns columns_{INT32_MAX, INT32_MIN};
};

/// The centres of a row that a triangle covers.
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

/// An edge of a fan, evaluated at rows in ascending order.
class FanEdge {
  public:
    FanEdge() = default;
    FanEdge(const Position& a, const Position& b) {
        const bool up = a.y < b.y || (a.y == b.y && a.x < b.x); // the order of corners in Sorted
        low_ = up ? a : b;
        high_ = up ? b : a;
        first_row_ = first_center(low_.y);
        end_row_ = first_center(high_.y);
    }
    /// Adds the column where the edge meets `row` to `first` and `second`, if the edge reaches the row.
    void add(std::int32_t row, RowCenters& first, RowCenters& second) {
        if (row < first_row_ || row >= end_row_)
            return;
        if (row == current_row_ + 1)
            edge_.step();
        else
            edge_ = Edge::at(low_.x, low_.y, high_.x, high_.y, row);
        current_row_ = row;
        first.add(edge_.column());
        second.add(edge_.column());
    }

  private:
    Position low_, high_;
    std::int32_t first_row_, end_row_;
    std::int32_t current_row_ = INT32_MIN; ///< the row that edge_ is at
    Edge edge_;
};

/// Whether two vertices differ only in their position. All planes through such vertices are constant.
inline bool have_equal_attributes(const FixedVertex& a, const FixedVertex& b) {
    FixedVertex moved = a;
    place(moved, position(b));
#if SPANGLE_TIER_SET & 1
    moved.x_rest = b.x_rest;
    moved.y_rest = b.y_rest;
#endif
    return __builtin_memcmp(&moved, &b, sizeof b) == 0;
}
inline bool have_equal_attributes(const DoubleVertex& a, const DoubleVertex& b) {
    DoubleVertex moved = a;
    place(moved, position(b));
    moved.x_exact = b.x_exact;
    moved.y_exact = b.y_exact;
    return __builtin_memcmp(&moved, &b, sizeof b) == 0;
}
inline bool have_equal_attributes(const ShadowVertex& a, const ShadowVertex& b) {
    return have_equal_attributes(a.fixed, b.fixed) && have_equal_attributes(a.twin, b.twin);
}

} // namespace detail

/// The covered centres of one row: those of the whole fan, and, where they are kept, those of each triangle.
struct FanRow {
    static constexpr int kept = kept_fan_triangles;
    std::int32_t row = 0;
    detail::Columns all, triangle_columns[kept == 0 ? 1 : kept];
};

/// A fan of triangles: triangle i, counted from 1, has corners 0, i and i + 1.
template <class V> class Fan {
  public:
    Fan(const V* const* corner, int corners) : corner_(corner), corner_count_(corners) {
        if (!stores_triangles())
            return;
        for (int i = 1; i < corners; ++i)
            outer_edges_[i] =
                detail::FanEdge(position(*corner[i]), position(*corner[i + 1 < corners ? i + 1 : 0]));
        // The first and the last of these edges are sides of the fan, too.
        for (int i = 1; i < corners; ++i)
            inner_edges_[i] = detail::FanEdge(position(*corner[0]), position(*corner[i]));
    }

    int corners() const { return corner_count_; }
    const V& operator[](int i) const { return *corner_[i]; }
    detail::Sorted<V> part(int i) const { return detail::sorted(*corner_[0], *corner_[i], *corner_[i + 1]); }

    /// The number of a triangle of non-zero area if all triangles have the same planes, and otherwise 0.
    int uniform_part() const {
        for (int i = 1; i < corner_count_; ++i)
            if (!detail::have_equal_attributes(*corner_[0], *corner_[i]))
                return 0;
        int i = corner_count_ - 2;
        while (i > 0 && part(i).area2 == 0)
            --i;
        return i;
    }

    /// Finds the centres of a row. The call is fast where rows are asked for one by one upwards.
    void find(FanRow& out, std::int32_t row) {
        out.row = row;
        if (!stores_triangles()) {
            out.all = centers(row);
            return;
        }
        detail::RowCenters all, triangle_centers[edges];
        for (int i = 1; i < corner_count_; ++i)
            inner_edges_[i].add(row, i > 1 ? triangle_centers[i - 1] : all,
                                i + 1 < corner_count_ ? triangle_centers[i] : all);
        for (int i = 1; i + 1 < corner_count_; ++i)
            outer_edges_[i].add(row, all, triangle_centers[i]);
        out.all = all.columns();
        for (int i = 1; i + 1 < corner_count_; ++i)
            out.triangle_columns[i - 1] = triangle_centers[i].columns();
    }
    /// Finds the centres that the fan as a whole covers in a row. Rows may be asked for in any order.
    detail::Columns centers(std::int32_t row) const {
        detail::RowCenters found;
        for (int i = 0; i < corner_count_; ++i) {
            const Position a = position(*corner_[i]),
                           b = position(*corner_[i + 1 < corner_count_ ? i + 1 : 0]);
            const bool up = a.y < b.y || (a.y == b.y && a.x < b.x); // the order of corners in Sorted
            found.add(up ? a : b, up ? b : a, row);
        }
        return found.columns();
    }
    /// The centres that triangle i covers in a row that find() has found. `kept` says that find() wrote `row`
    /// last, so its `triangle_columns` is valid.
    detail::Columns triangle_columns(const FanRow& row, int i, bool kept = true) const {
        if (row.all.none())
            return {};
        return kept && stores_triangles() ? row.triangle_columns[i - 1] : detail::centers(part(i), row.row);
    }

  private:
    bool stores_triangles() const { return FanRow::kept != 0 && corner_count_ <= FanRow::kept + 2; }
    const V* const* corner_;
    int corner_count_;
    static constexpr int edges = FanRow::kept == 0 ? 1 : FanRow::kept + 2;
    detail::FanEdge outer_edges_[edges], inner_edges_[edges];
};

} // namespace spangle::raster
