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

    static constexpr std::int32_t small_length = 64 * subpixel_one; ///< up to which 32 bits are enough

    /// `shift`: moves the line down its minor axis (wide lines), subpixels.
    DiamondWalk(std::int32_t ax, std::int32_t ay, std::int32_t bx, std::int32_t by, std::int32_t shift) {
        const std::int32_t dx = bx - ax, dy = by - ay;
        along_x = (dx < 0 ? -dx : dx) >= (dy < 0 ? -dy : dy);
        const std::int32_t along = along_x ? dx : dy, across = along_x ? dy : dx;
        ascends = along >= 0;
        const End a = along_x ? End{ax, ay - shift} : End{ay, ax - shift};
        const End b = along_x ? End{bx, by - shift} : End{by, bx - shift};
        // Fragments from `first` on in the direction of the line, `end` not among them.
        const std::int32_t first = begin(a), end = begin(b);
        major = ascends ? first : end + 1;
        count = along == 0 ? 0 : ascends ? end - first : first - end;
        if (count <= 0) {
            count = 0;
            return;
        }
        length_ = ascends ? along : -along;
        rise_ = ascends ? across : -across;
        denominator_ = length_ * subpixel_one;
        // A value on the boundary of two fragments belongs to the upper one only if the shifted line lies
        // above it: y(x + e) - e^2 on x-major lines with a rising slope. x(y + e^2) - e never does.
        lower_tie_ = !along_x || rise_ <= 0 ? 1 : 0;
        start_ = a;
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

    /// What is left of the walk.
    Path path() const {
        const bool falls = rise_ < 0;
        return {along_x ? major : minor,
                along_x ? minor : major,
                count,
                falls ? denominator_ - 1 - remainder_ : remainder_,
                (falls ? -rise_ : rise_) * subpixel_one,
                denominator_,
                along_x,
                falls};
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

    /// The first fragment along the major axis that the line produces from an end point on: the one of its
    /// own column, or the next when that one is behind, past the centre line and outside of the diamond.
    std::int32_t begin(const End& end) const {
        const std::int32_t half = subpixel_one / 2, column = own(end.major);
        const std::int32_t f = end.major - column * subpixel_one - half;
        const std::int32_t g = end.minor - own(end.minor) * subpixel_one - half;
        const std::int32_t distance = (f < 0 ? -f : f) + (g < 0 ? -g : g);
        if (numeric::cheap_branches && distance < half)
            return column;
        // Without branches: they would be taken at random. x of a point on the diamond's edge decides which
        // side the shift moves it to, and points on the centre line are moved below it.
        const bool outside = (distance > half) | ((distance == half) & ((along_x ? f : g) <= 0));
        const bool behind = outside & ((f > 0) == ascends);
        return column + (ascends ? 1 : -1) * static_cast<std::int32_t>(behind);
    }

    /// minor and remainder at the centre of `major`.
    void place() {
        const std::int32_t from_start = major * subpixel_one + subpixel_one / 2 - start_.major;
        const std::int32_t inside = start_.minor & (subpixel_one - 1);
        std::int32_t whole;
        if (length_ <= small_length) { // |from_start|, |rise| <= 2^14 + 2^8
            const std::int32_t numerator = from_start * rise_ + inside * length_ - lower_tie_;
            whole = numerator / denominator_;
            remainder_ = numerator - whole * denominator_;
            if (remainder_ < 0)
                --whole, remainder_ += denominator_;
        } else {
            const std::int64_t numerator =
                std::int64_t{from_start} * rise_ + std::int64_t{inside} * length_ - lower_tie_;
            const auto q = numeric::floor_divide(numerator, static_cast<std::uint32_t>(denominator_));
            whole = static_cast<std::int32_t>(q.quotient);
            remainder_ = static_cast<std::int32_t>(q.remainder);
        }
        minor = (start_.minor >> subpixel_bits) + whole;
    }

    End start_;
    std::int32_t length_, rise_, denominator_, remainder_, lower_tie_;
};

} // namespace spangle::raster
