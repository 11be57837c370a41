// Says which pixels a triangle covers, by exact integers from snapped vertices to half-open rows of columns.
//
// GL 1.3, 3.5.1: a centre on a shared edge belongs to exactly one of the two triangles. Here a fragment
// belongs to the triangle where its centre is inside, or on an edge that has the interior on its right side
// or above it. So left and bottom edges own their centres, and right and top edges do not. This is the
// top-left rule, counted in the direction in which rows grow. Two triangles with a common edge compute the
// same integers on it, for any third vertices.
#pragma once

#include <cstdint>

#include "raster/numeric/reciprocal.hpp"
#include "raster/span/rows.hpp"
#include "raster/span/trapezoids.hpp"
#include "raster/span/vertex.hpp"

namespace spangle::raster {

/// Largest |coordinate| in subpixels that callers may pass: guard band of 4 x 2048 pixels.
inline constexpr std::int32_t guard_band = 4 * 2048 * subpixel_one;
/// Bounds of Edge, whose proofs use these numbers. dy <= 2 guard_band makes denominator <= 2^30, so the sum
/// of remainder and step stays below 2^31. The numerator is at most 2^46.
inline constexpr std::int64_t edge_max_denominator = std::int64_t{2} * guard_band * subpixel_one;
static_assert(2 * edge_max_denominator <= std::int64_t{1} << 31);

/// The first pixel row or column whose centre is at or after subpixel coordinate v.
constexpr std::int32_t first_center(std::int32_t v) {
    return (v + subpixel_one / 2 - 1) >> subpixel_bits;
}

/// An edge that goes up, at the centre of one pixel row.
class Edge {
  public:
    /// The edge from (x0, y0) up to (x1, y1), y1 > y0, at row `row` >= first_center(y0).
    static Edge at(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1, std::int32_t row);

    /// The first column whose centre is on the edge or to the right of it.
    std::int32_t column() const { return column_; }

    /// Moves to the centre of the next row up, exactly, in 32 bits.
    void step() {
        column_ += columns_per_row_;
        remainder_ += remainder_step_;
        if (remainder_ > 0) {
            ++column_;
            remainder_ -= denominator_;
        }
    }

  private:
    std::int32_t column_;
    std::int32_t remainder_; ///< remainder of the ceil division for column_: -denominator < remainder <= 0
    std::int32_t columns_per_row_, remainder_step_; ///< advance per row: columns + step / denominator
    std::int32_t denominator_;
};

inline Edge Edge::at(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1, std::int32_t row) {
    const std::int32_t dx = x1 - x0, dy = y1 - y0;
    const std::int32_t above =
        row * subpixel_one + subpixel_one / 2 - y0; // distance from the vertex up to the row's centre
    const std::int32_t inside =
        (x0 & (subpixel_one - 1)) - subpixel_one / 2; // distance of the vertex from its column's centre
    Edge e;
    e.denominator_ = dy * subpixel_one;
    // column is the vertex's column + ceil(numerator / denominator). It is the floor of the negative
    // numerator, so that one kind of division is enough.
    const std::int64_t numerator = -(numeric::mul_long(above, dx) + numeric::mul_long(inside, dy));
    const auto down = numeric::floor_divide(numerator, static_cast<std::uint32_t>(e.denominator_));
    const auto slope = numeric::floor_divide(dx, static_cast<std::uint32_t>(dy));
    e.column_ = (x0 >> subpixel_bits) - static_cast<std::int32_t>(down.quotient);
    e.remainder_ = -static_cast<std::int32_t>(down.remainder);
    e.columns_per_row_ = static_cast<std::int32_t>(slope.quotient);
    e.remainder_step_ = static_cast<std::int32_t>(slope.remainder) * subpixel_one;
    return e;
}

/// An edge of at most 64 pixels in x and in y. Columns have 32 fraction bits. The edge meets a row at a
/// multiple of 1 / (256 dy) >= 2^-22. The slope is less than 2^-32 below the true slope, so within 64 rows
/// the sum is less than 2^-26 too small. A bias of 1 - 2^-24 then makes floor() the exact ceil().
class SmallEdge {
  public:
    static constexpr std::int32_t extent = 64 * subpixel_one; ///< largest |dx| and dy

    static SmallEdge at(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1, std::int32_t row);
    std::int32_t column() const { return static_cast<std::int32_t>(position_ >> 32); }
    void step() { position_ += slope_; }
    Trapezoids::Side side() const { return {position_, slope_}; }

    /// floor(v 2^32 / dy), v < 2^29, dy <= 2^14. With words of 32 bits the fraction is computed in digits of
    /// 18 and 14 bits.
    template <bool Wide = numeric::wide_words>
    static std::uint64_t divided(std::uint32_t v, std::uint32_t dy) {
        if constexpr (Wide) {
            return (std::uint64_t{v} << 32) / dy;
        } else {
            const std::uint32_t whole = v / dy, rest = v - whole * dy;
            const std::uint32_t first = (rest << 18) / dy, left = (rest << 18) - first * dy;
            const std::uint32_t second = (left << 14) / dy;
            return std::uint64_t{whole} << 32 | (first << 14 | second);
        }
    }

  private:
    std::uint64_t position_, slope_; ///< position and slope count modulo 2^64
};

inline SmallEdge SmallEdge::at(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1,
                               std::int32_t row) {
    const std::int32_t dx = x1 - x0;
    const auto dy = static_cast<std::uint32_t>(y1 - y0);
    // slope is floor(dx 2^32 / dy) plus 2^14 columns. The 2^14 columns keep the dividend from being negative,
    // because |dx| <= 2^14.
    const std::uint64_t slope = divided(static_cast<std::uint32_t>(dx) + (dy << 14), dy);
    const auto whole = static_cast<std::uint32_t>(slope >> 32), fraction = static_cast<std::uint32_t>(slope);
    SmallEdge e;
    e.slope_ = std::uint64_t{whole - (1u << 14)} << 32 | fraction;
    // The row's centre is `above` subpixels above the vertex, at most 64 rows of 256, so it is above / 256
    // steps away.
    const auto above = static_cast<std::uint32_t>(row * subpixel_one + subpixel_one / 2 - y0);
    const std::uint64_t up = std::uint64_t{fraction} * above;
    const std::uint64_t whole_up = std::uint64_t{(whole - (1u << 14)) * above} << 32;
    const std::uint64_t columns =
        static_cast<std::uint64_t>(static_cast<std::int64_t>(whole_up + up) >> subpixel_bits);
    constexpr std::uint64_t bias = (std::uint64_t{1} << 32) - (1u << 8);
    const std::uint64_t start = static_cast<std::uint64_t>(std::int64_t{x0} - subpixel_one / 2)
                                << (32 - subpixel_bits);
    e.position_ = start + columns + bias;
    return e;
}

/// An edge of at most 15 pixels in x and in y, whose x counts from a column at most 15 pixels away. A
/// position is one word with 26 fraction bits of a column.
///
/// The slope is off by less than one unit. The start lies above / 256 slopes up. Start and 15 - above / 256
/// steps together are off by less than 15 units, and the two shifts of the start by two more. An edge meets a
/// row at a multiple of 1 / (256 dy) > 2^-20, which is 64 units. So a bias of 1 minus 32 units makes floor()
/// the exact ceil().
class LowEdge {
  public:
    static constexpr std::int32_t extent = 15 * subpixel_one; ///< largest |dx| and dy

    SPANGLE_INLINE static LowEdge at(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1,
                                     std::int32_t row) {
        // dx 2^26 / dy is computed in digits of 19 and 7 bits: |slope| <= 2^19 |dx|, |fine| < 2^7 dy. Where
        // the slope is too large for the sum of both, dy is below 256, and no other row is stepped to.
        const std::int32_t dx = (x1 - x0) * (1 << 19), dy = y1 - y0;
        const std::int32_t slope = dx / dy, fine = (dx - slope * dy) * (1 << 7) / dy;
        const std::int32_t above = row * subpixel_one + subpixel_one / 2 - y0;
        constexpr std::int32_t bias = (1 << 26) - 32;
        LowEdge e;
        e.slope_ = (static_cast<std::uint32_t>(slope) << 7) + static_cast<std::uint32_t>(fine);
        e.position_ = static_cast<std::uint32_t>(x0 * (1 << (26 - subpixel_bits)) + (bias - (1 << 25))) +
                      static_cast<std::uint32_t>(slope * above >> 1) +
                      static_cast<std::uint32_t>(fine * above >> 8);
        return e;
    }
    SPANGLE_INLINE std::int32_t column() const { return static_cast<std::int32_t>(position_) >> 26; }
    SPANGLE_INLINE void step() { position_ += slope_; }

  private:
    std::uint32_t position_, slope_; ///< position and slope count modulo 2^32
};

/// An edge of at most 15 pixels, for processors whose divisions are calls (numeric::divides). It finds
/// columns by walking. Each call of at() and step() walks at most 15 columns, and all sums fit 32 bits.
class ShortEdge {
  public:
    static constexpr std::int32_t extent = 15 * subpixel_one; ///< largest |dx| and dy

    SPANGLE_INLINE static ShortEdge at(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1,
                                       std::int32_t row) {
        ShortEdge e;
        e.column_ = x0 >> subpixel_bits;
        e.denominator_ = (y1 - y0) * subpixel_one;
        e.remainder_step_ = (x1 - x0) * subpixel_one;
        const std::int32_t above = row * subpixel_one + subpixel_one / 2 - y0;
        const std::int32_t inside = (x0 & (subpixel_one - 1)) - subpixel_one / 2;
        e.remainder_ = above * (x1 - x0) + inside * (y1 - y0);
        e.walk();
        return e;
    }
    SPANGLE_INLINE std::int32_t column() const { return column_; }
    /// Moves up to the next row, which the edge must reach.
    SPANGLE_INLINE void step() {
        remainder_ += remainder_step_;
        walk();
    }

  private:
    SPANGLE_INLINE void walk() {
        while (remainder_ > 0)
            ++column_, remainder_ -= denominator_;
        while (remainder_ <= -denominator_)
            --column_, remainder_ += denominator_;
    }

    std::int32_t column_, denominator_, remainder_step_;
    std::int32_t remainder_; ///< remainder of the ceil division: -denominator < remainder <= 0
};

/// Walks upwards along the rows of a triangle that hold a centre. Vertices are sorted by y. `middle_left`
/// says that the middle vertex lies to the left of the edge from the lowest to the highest vertex. E is Edge,
/// or SmallEdge within its extent.
template <class E> class TriangleRows {
  public:
    TriangleRows(const std::int32_t xs[3], const std::int32_t ys[3], bool middle_left, std::int32_t row_begin,
                 std::int32_t row_end)
        : xs_(xs), ys_(ys), middle_is_left_(middle_left) {
        const std::int32_t low = first_center(ys[0]), high = first_center(ys[2]);
        current_row_ = low < row_begin ? row_begin : low;
        end_row_ = high < row_end ? high : row_end;
        middle_row_ = current_row_;
        if (current_row_ >= end_row_) {
            end_row_ = current_row_;
            return;
        }
        set(!middle_left, E::at(xs[0], ys[0], xs[2], ys[2], current_row_));
        const std::int32_t middle = first_center(ys[1]);
        if (current_row_ < middle) {
            set(middle_left, E::at(xs[0], ys[0], xs[1], ys[1], current_row_));
            middle_row_ = middle < end_row_ ? middle : end_row_;
        }
    }

    /// Writes rows that hold a centre, until `to` is full or the triangle ends. Returns the end of the
    /// written rows. Cut: rows are clipped to columns [begin, end).
    template <bool Cut> Row* fill(Row* to, int room, std::int32_t begin, std::int32_t end) {
        const Row* const full = to + room;
        while (to != full) {
            if (current_row_ == middle_row_) {
                if (current_row_ == end_row_)
                    break;
                set(middle_is_left_, E::at(xs_[1], ys_[1], xs_[2], ys_[2], current_row_));
                middle_row_ = end_row_;
            }
            // Local copies of the edges stay in registers.
            E left = left_, right = right_;
            std::int32_t y = current_row_;
            const std::int32_t stop = middle_row_;
            do {
                const std::int32_t l = left.column(), r = right.column();
                std::int32_t from = l, till = r;
                if constexpr (Cut) {
                    from = l < begin ? begin : l;
                    till = r < end ? r : end;
                }
                if (from < till)
                    *to++ = {y, l, r, from, till};
                left.step();
                right.step();
            } while (++y != stop && to != full);
            current_row_ = y;
            left_ = left;
            right_ = right;
        }
        return to;
    }

  private:
    void set(bool left, const E& e) { (left ? left_ : right_) = e; }

    const std::int32_t *xs_, *ys_;
    bool middle_is_left_;
    std::int32_t current_row_, middle_row_, end_row_;
    E left_{}, right_{};
};

/// A triangle of at most this height, in subpixels, has at most `packet` rows.
inline constexpr std::int32_t low_extent = (packet - 1) * subpixel_one;

namespace detail {

/// Writes rows [y, stop) between two edges, whose columns count from `base`. Returns the end of the written
/// rows.
template <bool Cut, class E>
SPANGLE_INLINE Row* rows_between(Row* to, std::int32_t y, std::int32_t stop, E& left, E& right,
                                 std::int32_t base, const Rect& clip) {
    for (;;) {
        const std::int32_t l = base + left.column(), r = base + right.column();
        std::int32_t first = l, last = r;
        if constexpr (Cut) {
            first = l < clip.x ? clip.x : l;
            last = r < clip.x + clip.w ? r : clip.x + clip.w;
        }
        if (first < last) {
            to = numeric::kept_in_register(to + 1);
            to[-1] = {y, l, r, first, last};
        }
        if (++y == stop)
            return to;
        left.step();
        right.step();
    }
}

} // namespace detail

/// Writes all rows of a triangle of at most low_extent, as TriangleRows::fill() does.
template <class E, bool Cut>
SPANGLE_INLINE Row* low_rows(Row* to, const std::int32_t (&xs)[3], const std::int32_t (&ys)[3],
                             bool middle_left, const Rect& clip) {
    std::int32_t y = first_center(ys[0]), end = first_center(ys[2]);
    y = y < clip.y ? clip.y : y;
    end = end < clip.y + clip.h ? end : clip.y + clip.h;
    if (y >= end)
        return to;
    const std::int32_t base = xs[0] >> subpixel_bits, from = base * subpixel_one;
    E across = E::at(xs[0] - from, ys[0], xs[2] - from, ys[2], y);
    std::int32_t x0 = xs[0] - from, y0 = ys[0], x1 = xs[1] - from, y1 = ys[1];
    std::int32_t stop = first_center(ys[1]);
    for (bool upper = y >= stop;; upper = true) {
        if (upper) {
            x0 = xs[1] - from, y0 = ys[1], x1 = xs[2] - from, y1 = ys[2];
            stop = end;
        }
        stop = stop < end ? stop : end;
        E beside = E::at(x0, y0, x1, y1, y);
        to = middle_left ? detail::rows_between<Cut>(to, y, stop, beside, across, base, clip)
                         : detail::rows_between<Cut>(to, y, stop, across, beside, base, clip);
        if (stop == end)
            return to;
        y = stop;
        across.step();
    }
}

} // namespace spangle::raster
