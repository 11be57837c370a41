// The part of each pixel of a row that lies inside of an outline, as a sum of exact areas under the outline's
// edges (GL 1.3, 3.5.3).
//
// Each edge contributes, to each column, the area between the edge and the column's right side. Edges that go
// up and edges that go down have opposite signs. The contribution of an edge depends only on its two ends and
// on the row, and is negated where the edge goes the other way. So outlines that share an edge cover its
// pixels to exactly 1 together. Coverage is off by less than 2^-14.
#pragma once

#include <cstdint>

#include "raster/numeric/bits.hpp"
#include "raster/span/primitive_state.hpp"
#include "raster/span/vertex.hpp"

namespace spangle::raster {

/// Fraction bits of outlines. Corners of lines and points of circles lie between the grid points of vertices.
inline constexpr int outline_bits = 12;
inline constexpr std::int32_t outline_one = 1 << outline_bits;

struct OutlinePoint {
    std::int32_t x, y;
};
constexpr OutlinePoint outline_point(const Position& p) {
    return {p.x * (outline_one / subpixel_one), p.y * (outline_one / subpixel_one)};
}

/// The part of an edge inside of one row, directed upwards. x has 16 fraction bits, and height has
/// outline_bits.
class RowEdge {
  public:
    /// Enters a row. Returns false where the edge does not reach the row.
    bool enter(const OutlinePoint& from, const OutlinePoint& to, std::int32_t row);

    /// The first column in which this part lies; last() is the last one.
    std::int32_t first() const { return (lower_x_ < upper_x_ ? lower_x_ : upper_x_) >> 16; }
    std::int32_t last() const { return (lower_x_ < upper_x_ ? upper_x_ : lower_x_) >> 16; }
    bool down() const { return goes_down_; }
    /// Adds the signed area to the right of this part to columns [begin, end). A whole pixel counts
    /// full_coverage. Each column of `change` takes the difference to the column before it.
    void add(std::int32_t begin, std::int32_t end, std::int64_t* change) const;

  private:
    /// Twice the integral of max(x - column, 0) over the height.
    std::int64_t beyond(std::int32_t column) const;

    std::int32_t lower_x_, upper_x_; ///< x at the lower and at the upper end
    std::int32_t height_;
    bool goes_down_;
};

/// The corners of a polygon, which may be kept in any structure.
struct Outline {
    const void* corners;
    int count;
    OutlinePoint (*at)(const void* corners, int i);

    /// Corner `count` is corner 0 again.
    OutlinePoint operator[](int i) const { return at(corners, i < count ? i : 0); }
};
inline Outline outline_of(const OutlinePoint* corners, int count) {
    return {corners, count, [](const void* all, int i) { return static_cast<const OutlinePoint*>(all)[i]; }};
}

/// One row of an outline that goes counter-clockwise or clockwise.
class AreaRow {
  public:
    AreaRow(const Outline& outline, std::int32_t row);
    bool empty() const { return edge_count_ == 0; }
    std::int32_t first() const { return first_column_; } ///< first column that the outline reaches
    std::int32_t last() const { return last_column_; }
    /// The columns between the edges that go up and the edges that go down. No edge reaches these columns, so
    /// they have one coverage. core_begin() == core_end() where there are no such columns.
    std::int32_t core_begin() const { return core_begin_; }
    std::int32_t core_end() const { return core_end_; }

    /// The largest number of columns that fill() computes at once.
    static constexpr int window = 32;
    /// Writes the coverage of each of the columns [begin, end), which are at most `window`.
    void fill(std::int32_t begin, std::int32_t end, std::uint32_t* coverage) const;

  private:
    /// The largest number of edges that are stored for a row. Each fill() computes any further edges again.
    static constexpr int stored_edges = 40;
    RowEdge edge_[stored_edges];
    int edge_count_ = 0;
    Outline outline_;
    int first_unstored_edge_; ///< edges of the outline from this one on are not kept
    std::int32_t row_;
    std::int32_t first_column_ = INT32_MAX, last_column_ = INT32_MIN;
    std::int32_t core_begin_ = 0, core_end_ = 0;
};

} // namespace spangle::raster
