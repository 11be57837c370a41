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
    bool down() const { return down_; }
    /// Adds the area right of it, of full_coverage and signed, to columns [begin, end): to each the
    /// difference to the column before.
    void add(std::int32_t begin, std::int32_t end, std::int64_t* change) const;

  private:
    /// The integral of max(x - column, 0) over the height.
    std::int64_t beyond(std::int32_t column) const;

    std::int32_t low_, high_; ///< x at the lower and at the upper end
    std::int32_t height_;
    bool down_;
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

/// The row of an outline, counter-clockwise or clockwise.
class AreaRow {
  public:
    AreaRow(const Outline& outline, std::int32_t row);
    bool empty() const { return edges_ == 0; }
    std::int32_t first() const { return first_; } ///< column that is reached
    std::int32_t last() const { return last_; }
    /// Columns between the edges that go up and those that go down, where those lie apart: no edge reaches
    /// them, so they have one coverage. None: begin = end.
    std::int32_t core_begin() const { return core_begin_; }
    std::int32_t core_end() const { return core_end_; }

    /// Columns that are computed together, at most.
    static constexpr int window = 32;
    /// The coverage of each of the columns [begin, end).
    void fill(std::int32_t begin, std::int32_t end, std::uint32_t* coverage) const;

  private:
    /// Kept while they are looked at; more than those are found anew each time.
    static constexpr int kept_edges = 40;
    RowEdge edge_[kept_edges];
    int edges_ = 0;
    Outline outline_;
    int unkept_; ///< edges of the outline from this one on are not kept
    std::int32_t row_;
    std::int32_t first_ = INT32_MAX, last_ = INT32_MIN;
    std::int32_t core_begin_ = 0, core_end_ = 0;
};

} // namespace spangle::raster
