// Which pixels a triangle covers: exact integers from snapped vertices to half-open rows of columns.
//
// Rule (GL 1.3, 3.5.1: a centre on a shared edge belongs to exactly one of the two): a fragment belongs to
// the triangle when its centre is inside, or on an edge that has the interior on its right side or above it.
// So left and bottom edges own their centres, right and top edges do not: the top-left rule, counted in the
// direction in which rows grow. Two triangles with a common edge see the same integers on it, whatever their
// third vertices are.
#pragma once

#include <cstdint>

#include "raster/numeric/reciprocal.hpp"
#include "raster/span/vertex.hpp"

namespace spangle::raster {

/// Largest |coordinate| in subpixels that callers may pass: guard band of 4 x 2048 pixels.
inline constexpr std::int32_t guard_band = 4 * 2048 * subpixel_one;
/// Bounds of Edge, from which the proofs take their numbers: dy <= 2 guard_band, so denominator <= 2^30 and
/// the sum of remainder and step stays below 2^31; numerator at most 2^46.
inline constexpr std::int64_t edge_max_denominator = std::int64_t{2} * guard_band * subpixel_one;
static_assert(2 * edge_max_denominator <= std::int64_t{1} << 31);

/// Extent in subpixels up to which every intermediate of Edge fits 32 bits.
inline constexpr std::int32_t small_extent = 64 * subpixel_one;

/// First pixel row (or column) whose centre is at or after subpixel coordinate v.
constexpr std::int32_t first_center(std::int32_t v) {
    return (v + subpixel_one / 2 - 1) >> subpixel_bits;
}

/// An edge going up, at the centre of one pixel row: `x` is the first column whose centre is on or right of
/// it.
struct Edge {
    std::int32_t x;
    std::int32_t remainder;   ///< of that ceil division: -denominator < remainder <= 0
    std::int32_t whole, part; ///< advance per row: whole + part / denominator columns
    std::int32_t denominator;

    /// From (x0, y0) up to (x1, y1), y1 > y0, at row `row` >= first_center(y0).
    static Edge at(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1, std::int32_t row,
                   bool small);

    /// One row up: 32 bits, exact.
    void step() {
        x += whole;
        remainder += part;
        if (remainder > 0) {
            ++x;
            remainder -= denominator;
        }
    }
};

inline Edge Edge::at(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1, std::int32_t row,
                     bool small) {
    const std::int32_t dx = x1 - x0, dy = y1 - y0;
    const std::int32_t above =
        row * subpixel_one + subpixel_one / 2 - y0; // from the vertex up to the row's centre
    const std::int32_t inside =
        (x0 & (subpixel_one - 1)) - subpixel_one / 2; // from the centre of the vertex's column
    Edge e;
    e.denominator = dy * subpixel_one;
    // column = vertex's column + ceil(numerator / denominator); the floor of -numerator keeps one kind of
    // division.
    std::int32_t down, rest;
    if (small) {
        const std::int32_t numerator = -(above * dx + inside * dy);
        down = numerator / e.denominator;
        rest = numerator - down * e.denominator;
        if (rest < 0)
            --down, rest += e.denominator;
        e.whole = dx / dy;
        e.part = dx - e.whole * dy;
        if (e.part < 0)
            --e.whole, e.part += dy;
    } else {
        const std::int64_t numerator = -(std::int64_t{above} * dx + std::int64_t{inside} * dy);
        const auto q = numeric::floor_divide(numerator, static_cast<std::uint32_t>(e.denominator));
        const auto slope = numeric::floor_divide(dx, static_cast<std::uint32_t>(dy));
        down = static_cast<std::int32_t>(q.quotient);
        rest = static_cast<std::int32_t>(q.remainder);
        e.whole = static_cast<std::int32_t>(slope.quotient);
        e.part = static_cast<std::int32_t>(slope.remainder);
    }
    e.x = (x0 >> subpixel_bits) - down;
    e.remainder = -rest;
    e.part *= subpixel_one;
    return e;
}

/// The rows of a triangle that hold a centre, upwards, from row_begin to row_end - 1. Vertices come sorted by
/// y; `middle_left`: the middle one lies left of the edge from the lowest to the highest.
class TriangleRows {
  public:
    std::int32_t y, left, right; ///< after next(): columns [left, right) of row y, left < right

    TriangleRows(const std::int32_t xs[3], const std::int32_t ys[3], bool middle_left, bool small,
                 std::int32_t row_begin, std::int32_t row_end)
        : xs_(xs), ys_(ys), middle_left_(middle_left), small_(small) {
        const std::int32_t low = first_center(ys[0]), high = first_center(ys[2]);
        row_ = low < row_begin ? row_begin : low;
        end_ = high < row_end ? high : row_end;
        stop_ = row_;
        if (row_ >= end_) {
            end_ = row_;
            return;
        }
        const Edge across = Edge::at(xs[0], ys[0], xs[2], ys[2], row_, small);
        set(!middle_left, across);
        const std::int32_t middle = first_center(ys[1]);
        if (row_ < middle) {
            set(middle_left, Edge::at(xs[0], ys[0], xs[1], ys[1], row_, small));
            stop_ = middle < end_ ? middle : end_;
        }
    }

    bool next() {
        for (;;) {
            if (row_ == stop_) {
                if (row_ == end_)
                    return false;
                set(middle_left_, Edge::at(xs_[1], ys_[1], xs_[2], ys_[2], row_, small_));
                stop_ = end_;
            }
            left = left_.x;
            right = right_.x;
            y = row_++;
            left_.step();
            right_.step();
            if (left < right)
                return true;
        }
    }

  private:
    /// Copies, not a reference to one of the two: both stay in registers.
    void set(bool left, const Edge& e) {
        if (left)
            left_ = e;
        else
            right_ = e;
    }

    const std::int32_t *xs_, *ys_;
    bool middle_left_, small_;
    std::int32_t row_, stop_, end_;
    Edge left_{}, right_{};
};

} // namespace spangle::raster
