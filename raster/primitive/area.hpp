// How much of each pixel of a row lies inside of an outline: sums of exact areas under its edges
// (GL 1.3, 3.5.3).
//
// An edge gives each column the area between itself and the column's right side; edges going up count against
// those going down. What an edge gives is a function of its two ends and the row alone, and is negated when
// it goes the other way: outlines that share an edge cover its pixels to exactly 1 together. Off by less than
// 2^-14.
#pragma once

#include <cstdint>

#include "raster/numeric/bits.hpp"
#include "raster/span/primitive_state.hpp"
#include "raster/span/vertex.hpp"

namespace spangle::raster {

/// Fraction bits of outlines: corners of lines and points of circles lie between those of vertices.
inline constexpr int outline_bits = 12;
inline constexpr std::int32_t outline_one = 1 << outline_bits;

struct OutlinePoint {
    std::int32_t x, y;
};
constexpr OutlinePoint outline_point(const Position& p) {
    return {p.x * (outline_one / subpixel_one), p.y * (outline_one / subpixel_one)};
}

/// A part of an edge inside of one row, going up: x with 16 fraction bits, and how high it is.
class RowEdge {
  public:
    /// False: the edge does not reach the row.
    bool enter(const OutlinePoint& from, const OutlinePoint& to, std::int32_t row);

    /// Columns it lies in.
    std::int32_t first() const { return (low_ < high_ ? low_ : high_) >> 16; }
    std::int32_t last() const { return (low_ < high_ ? high_ : low_) >> 16; }
    /// The area right of it in a column, of full_coverage; signed.
    std::int32_t covers(std::int32_t column) const {
        const std::int64_t area = beyond(column + 1) - beyond(column) + height_ * std::int64_t{2 << 16};
        return static_cast<std::int32_t>(down_ ? -area : area);
    }

  private:
    /// The integral of max(x - column, 0) over the height.
    std::int64_t beyond(std::int32_t column) const;

    std::int32_t low_ = 0, high_ = 0; ///< x at the lower and at the upper end
    std::int32_t height_ = 0;
    bool down_ = false;
};

/// The corners of a polygon, whatever they lie in.
struct Outline {
    const void* corners;
    int count;
    OutlinePoint (*at)(const void* corners, int i);

    OutlinePoint operator[](int i) const { return at(corners, i < count ? i : 0); } ///< i = count: the first
};
inline Outline outline_of(const OutlinePoint* corners, int count) {
    return {corners, count, [](const void* all, int i) { return static_cast<const OutlinePoint*>(all)[i]; }};
}

/// The row of a convex outline, counter-clockwise or clockwise.
class AreaRow {
  public:
    AreaRow(const Outline& outline, std::int32_t row);
    bool empty() const { return edges_ == 0; }
    std::int32_t first() const { return first_; } ///< column that is reached
    std::int32_t last() const { return last_; }
    std::uint32_t coverage(std::int32_t column) const;
    /// From this column on, up to where, coverage is 0 or 1 throughout.
    std::int32_t plain_end(std::int32_t column) const;

  private:
    /// Calls found(edge) for each edge in the row while it says so.
    template <class Found> void each(Found found) const;

    /// Kept while they are looked at; more than those are found anew each time.
    static constexpr int kept_edges = 40;
    RowEdge edge_[kept_edges];
    int edges_ = 0;
    Outline outline_;
    int unkept_; ///< edges of the outline from this one on are not kept
    std::int32_t row_;
    std::int32_t first_ = INT32_MAX, last_ = INT32_MIN;
};

} // namespace spangle::raster
