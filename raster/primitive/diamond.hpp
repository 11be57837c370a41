// Diamond exit (GL 1.3, 3.4.1): which fragments a line of width 1 consists of.
//
// A fragment f is produced when the segment meets the open diamond Rf = {|x - xf| + |y - yf| < 1/2} and its
// end is not in Rf. Ties are broken by moving both ends by (-e, -e^2). Along the major axis (|slope| <= 1) a
// segment that enters a diamond before its centre line stays inside up to that line, and one that is outside
// of it behind the centre line never enters. So one question about an end point decides, "has it left the
// fragment of its own column behind?", and asked of both ends alike it makes segments half open: strips share
// no fragment and leave none out.
#pragma once

#include <cstdint>

#include "raster/numeric/reciprocal.hpp"
#include "raster/primitive/edge.hpp"
#include "raster/span/path.hpp"

namespace spangle::raster {

/// Walks the fragments of one line in increasing order of their major coordinate. Major and minor are columns
/// and rows, or rows and columns.
class DiamondWalk {
  public:
    std::int32_t major, minor; ///< the fragment
    std::int32_t count;        ///< fragments left, this one included
    bool along_x;
    bool ascends; ///< from the first end point to the second

    /// Up to which near ends are placed with 32 bits.
    static constexpr std::int32_t small_length = 1 << 20;

    /// `shift`: moves the line down its minor axis (wide lines), subpixels.
    SPANGLE_INLINE DiamondWalk(std::int32_t ax, std::int32_t ay, std::int32_t bx, std::int32_t by,
                               std::int32_t shift) {
        const std::int32_t dx = bx - ax, dy = by - ay;
        along_x = (dx < 0 ? -dx : dx) >= (dy < 0 ? -dy : dy);
        const End a = along_x ? End{ax, ay - shift} : End{ay, ax - shift};
        const End b = along_x ? End{bx, by - shift} : End{by, bx - shift};
        ascends = a.major <= b.major;
        const End low = ascends ? a : b, high = ascends ? b : a;
        major = first_past(low);
        count = first_past(high) - major;
        if (count <= 0) {
            count = 0;
            return;
        }
        start_ = low;
        length_ = high.major - low.major;
        rise_ = high.minor - low.minor;
        denominator_ = length_ * subpixel_one;
        // A value on the boundary of two fragments belongs to the upper one only if the shifted line lies
        // above it: y(x + e) - e^2 on x-major lines with a rising slope. x(y + e^2) - e never does.
        lower_tie_ = !along_x || rise_ <= 0 ? 1 : 0;
        if (length_ <= small_length)
            place_first();
        else
            place();
    }

    void step() {
        ++major;
        --count;
        remainder_ += rise_ * subpixel_one;
        if (remainder_ >= denominator_) {
            ++minor;
            remainder_ -= denominator_;
        } else if (remainder_ < 0) {
            --minor;
            remainder_ += denominator_;
        }
    }

    /// What is left of the walk, where a row is `row` pixels from the one below it.
    SPANGLE_INLINE void follow(std::int32_t row, Path& path) const {
        const bool falls = rise_ < 0;
        const std::int32_t across = along_x ? row : 1;
        path.along = along_x ? 1 : row;
        path.aside = falls ? -across : across;
        path.first = major * path.along + minor * across;
        path.count = count;
        path.rest = falls ? -1 - remainder_ : remainder_ - denominator_;
        path.rise = (falls ? -rise_ : rise_) * subpixel_one;
        path.denominator = denominator_;
    }

    /// Drops fragments whose major coordinate is outside of [low, high).
    void clip(std::int32_t low, std::int32_t high) {
        const std::int32_t before = low - major, after = major + count - high;
        if (after > 0)
            count -= after;
        if (before > 0) {
            count -= before;
            major = low;
            if (count > 0)
                place();
        }
        if (count < 0)
            count = 0;
    }

  private:
    struct End {
        std::int32_t major, minor; ///< subpixels
    };

    /// The fragment a coordinate is in: floor(v - e).
    static std::int32_t own(std::int32_t v) { return (v - 1) >> subpixel_bits; }
    /// From the centre of that to it, -127 .. 128.
    static std::int32_t from_center(std::int32_t v) {
        return ((v - 1) & (subpixel_one - 1)) - (subpixel_one / 2 - 1);
    }

    /// An end is not in the diamond of its own fragment. x of a point on the diamond's edge decides which
    /// side the shift moves it to, and points on the centre line are moved below it: where x is not above the
    /// centre, the distance counts as one more.
    static bool outside(std::int32_t across_x, std::int32_t across_y) {
        const std::int32_t before = across_x - 1, x = before ^ (before >> 31);
        return x + (across_y < 0 ? -across_y : across_y) >= subpixel_one / 2;
    }

    /// The first fragment along the major axis that lies past an end: of its own column, or the next where
    /// the end has left that behind, past the centre line and outside of the diamond. Going down it is the
    /// last but one that lies before the end. Without branches: they would be taken at random.
    SPANGLE_INLINE std::int32_t first_past(const End& end) const {
        const std::int32_t f = from_center(end.major), g = from_center(end.minor);
        const bool out = outside(along_x ? f : g, along_x ? g : f), above = f > 0;
        return own(end.major) + static_cast<std::int32_t>(ascends ? out & above : !out | above);
    }

    /// minor and remainder at the centre of `major`.
    void place() {
        const std::int32_t from_start = major * subpixel_one + subpixel_one / 2 - start_.major;
        const std::int32_t inside = start_.minor & (subpixel_one - 1);
        const std::int64_t numerator =
            std::int64_t{from_start} * rise_ + std::int64_t{inside} * length_ - lower_tie_;
        const auto q = numeric::floor_divide(numerator, static_cast<std::uint32_t>(denominator_));
        remainder_ = static_cast<std::int32_t>(q.remainder);
        minor = (start_.minor >> subpixel_bits) + static_cast<std::int32_t>(q.quotient);
    }

    /// The same at the first fragment, whose centre is -128 .. 383 from the start: |rise| <= length makes the
    /// quotient more than -2 and less than 3.
    SPANGLE_INLINE void place_first() {
        constexpr std::int32_t bias = 2;
        const std::int32_t from_start = major * subpixel_one + subpixel_one / 2 - start_.major;
        const std::int32_t inside = start_.minor & (subpixel_one - 1);
        const auto numerator = static_cast<std::uint32_t>(
            from_start * rise_ + (inside + bias * subpixel_one) * length_ - lower_tie_);
        const auto denominator = static_cast<std::uint32_t>(denominator_);
        const std::uint32_t whole = numerator / denominator;
        remainder_ = static_cast<std::int32_t>(numerator - whole * denominator);
        minor = (start_.minor >> subpixel_bits) - bias + static_cast<std::int32_t>(whole);
    }

    End start_;
    std::int32_t length_, rise_, denominator_, remainder_, lower_tie_;
};

} // namespace spangle::raster
