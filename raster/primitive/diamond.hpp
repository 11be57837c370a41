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

namespace spangle::raster {

/// Walks the fragments of one line in the order of the line. Major and minor are columns and rows, or rows
/// and columns.
class DiamondWalk {
  public:
    std::int32_t major, minor; ///< the fragment
    std::int32_t direction;    ///< of major: +1 or -1
    std::int32_t count;        ///< fragments left, this one included
    bool along_x;

    static constexpr std::int32_t small_length = 64 * subpixel_one; ///< up to which 32 bits are enough

    /// `shift`: moves the line down its minor axis (wide lines), subpixels.
    DiamondWalk(std::int32_t ax, std::int32_t ay, std::int32_t bx, std::int32_t by, std::int32_t shift) {
        const std::int32_t dx = bx - ax, dy = by - ay;
        along_x = (dx < 0 ? -dx : dx) >= (dy < 0 ? -dy : dy);
        (along_x ? ay : ax) -= shift;
        (along_x ? by : bx) -= shift;
        const std::int32_t along = along_x ? dx : dy, across = along_x ? dy : dx;
        direction = along < 0 ? -1 : 1;
        const std::int32_t first = own(along_x ? ax : ay) + (left(ax, ay) ? direction : 0);
        const std::int32_t end = own(along_x ? bx : by) + (left(bx, by) ? direction : 0);
        major = first;
        count = along == 0 ? 0 : (end - first) * direction;
        if (count <= 0) {
            count = 0;
            return;
        }
        length_ = along < 0 ? -along : along;
        rise_ = across * subpixel_one;
        denominator_ = length_ * subpixel_one;
        // A value on the boundary of two fragments belongs to the upper one only if the shifted line lies
        // above it: y(x + e) - e^2 on x-major lines with a rising slope. x(y + e^2) - e never does.
        lower_tie_ = !along_x || static_cast<std::int64_t>(dx) * dy <= 0 ? 1 : 0;
        start_major_ = along_x ? ax : ay;
        start_minor_ = along_x ? ay : ax;
        place();
    }

    void step() {
        major += direction;
        --count;
        remainder_ += rise_;
        if (remainder_ >= denominator_) {
            ++minor;
            remainder_ -= denominator_;
        } else if (remainder_ < 0) {
            --minor;
            remainder_ += denominator_;
        }
    }

    /// Drops fragments whose major coordinate is outside of [low, high).
    void clip(std::int32_t low, std::int32_t high) {
        const std::int32_t before = direction > 0 ? low - major : major - (high - 1);
        const std::int32_t last = major + (count - 1) * direction;
        const std::int32_t after = direction > 0 ? last - (high - 1) : low - last;
        if (after > 0)
            count -= after;
        if (before > 0) {
            count -= before;
            major += before * direction;
            if (count > 0)
                place();
        }
        if (count < 0)
            count = 0;
    }

  private:
    /// The fragment an end point is in, along the axis: floor(v - e).
    static std::int32_t own(std::int32_t v) { return (v - 1) >> subpixel_bits; }

    /// The end point is behind the fragment of its own column: past the centre line and outside of the
    /// diamond.
    bool left(std::int32_t x, std::int32_t y) const {
        const std::int32_t half = subpixel_one / 2;
        const std::int32_t fx = x - own(x) * subpixel_one - half, fy = y - own(y) * subpixel_one - half;
        const std::int32_t distance = (fx < 0 ? -fx : fx) + (fy < 0 ? -fy : fy);
        const bool inside = distance < half || (distance == half && fx > 0);
        const bool above = (along_x ? fx : fy) > 0; // the shift moves points on the centre line below it
        return !inside && above == (direction > 0);
    }

    /// minor and remainder at the centre of `major`.
    void place() {
        const std::int32_t from_start = (major * subpixel_one + subpixel_one / 2 - start_major_) * direction;
        const std::int32_t rise = rise_ / subpixel_one, inside = start_minor_ & (subpixel_one - 1);
        std::int32_t whole;
        if (length_ <= small_length) { // |from_start|, |rise| <= 2^14 + 2^8
            const std::int32_t numerator = from_start * rise + inside * length_ - lower_tie_;
            whole = numerator / denominator_;
            remainder_ = numerator - whole * denominator_;
            if (remainder_ < 0)
                --whole, remainder_ += denominator_;
        } else {
            const std::int64_t numerator =
                std::int64_t{from_start} * rise + std::int64_t{inside} * length_ - lower_tie_;
            const auto q = numeric::floor_divide(numerator, static_cast<std::uint32_t>(denominator_));
            whole = static_cast<std::int32_t>(q.quotient);
            remainder_ = static_cast<std::int32_t>(q.remainder);
        }
        minor = (start_minor_ >> subpixel_bits) + whole;
    }

    std::int32_t start_major_, start_minor_, length_, rise_, denominator_, remainder_, lower_tie_;
};

} // namespace spangle::raster
