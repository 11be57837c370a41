// Diamond exit (GL 1.3, 3.4.1): the rule that says which fragments a line of width 1 has.
//
// A fragment f is produced where the segment meets the open diamond Rf = {|x - xf| + |y - yf| < 1/2} and its
// end is not in Rf. Ties are broken by moving both ends by (-e, -e^2).
//
// Along the major axis, where |slope| <= 1, a segment that enters a diamond before its centre line stays
// inside up to that line. A segment that is outside of the diamond behind its centre line never enters it. So
// one question about an end point is enough: "has it left the fragment of its own column behind?" The same
// question for both ends makes segments half open, so strips neither share fragments nor leave any out.
#pragma once

#include <cstdint>

#include "raster/numeric/reciprocal.hpp"
#include "raster/ops/line_lanes.hpp"
#include "raster/primitive/edge.hpp"

namespace spangle::raster {

/// Finds the fragments of L::count lines side by side, from the lower to the upper end of the major axis. X
/// and Up are the types of along_x and ascends, and may be integral constants.
template <class L, class X = typename L::Mask, class Up = typename L::Mask> class Diamond {
  public:
    using Int = typename L::Int;
    using Mask = typename L::Mask;

    Int major;                        ///< major coordinate of the first fragment
    Int count;                        ///< number of fragments; may be negative, which means none
    [[no_unique_address]] X along_x;  ///< true where the major axis is x
    [[no_unique_address]] Up ascends; ///< true where the line ascends from its first end to its second
    Int low, high;                    ///< ends on the major axis, subpixels
    Int low_minor;                    ///< minor coordinate of the lower end
    Int rise;                         ///< distance from the lower to the upper end along the minor axis

    /// The length, in subpixels, up to which first() is exact. Lines on surfaces are shorter.
    static constexpr std::int32_t small_length = 1 << 20;

    /// `shift` moves the line down its minor axis, in subpixels (wide lines).
    SPANGLE_INLINE Diamond(Int ax, Int ay, Int bx, Int by, std::int32_t shift) {
        along_x = is_along_x(ax, ay, bx, by);
        const Mask along_y = L::no(along_x);
        L::exchange(along_y, ax, ay); // puts the major coordinate first
        L::exchange(along_y, bx, by);
        ascends = L::no(L::less(bx, ax));
        const Int high_minor = order(ax, ay - shift, bx, by - shift);
        major = first_past(along_x, ascends, low, low_minor);
        count = first_past(along_x, ascends, high, high_minor) - major;
    }
    /// Takes two ends by their major and minor coordinates. `past` is first_past() of the end a.
    SPANGLE_INLINE Diamond(X x, Up up, Int a, Int a_minor, Int past, Int b, Int b_minor)
        : along_x(x), ascends(up) {
        order(a, a_minor, b, b_minor);
        const Int past_b = first_past(x, up, b, b_minor);
        major = L::select(up, past, past_b);
        count = L::select(up, past_b, past) - major;
    }

    SPANGLE_INLINE static Mask is_along_x(Int ax, Int ay, Int bx, Int by) {
        return L::no(L::less(abs_value(bx - ax), abs_value(by - ay)));
    }

    /// Whether a line that advances by `along` and `aside` may have the major axis x and the direction up. A
    /// line of no length may have any axis and direction.
    SPANGLE_INLINE static Mask has_direction(X x, Up up, Int along, Int aside) {
        const Int forward = L::select(up, along, Int(-along)), sideways = abs_value(aside);
        return L::select(x, L::no(L::less(forward, sideways)), L::less(sideways, forward));
    }

    /// The first fragment along the major axis that lies past an end. It is the fragment of the end's own
    /// column, or the next fragment where the end lies past the centre line and outside of the diamond. On a
    /// descending line it is the last fragment but one before the end. Lanes use no branches, because their
    /// outcomes would be hard to predict.
    SPANGLE_INLINE static Int first_past(X x, Up up, Int end, Int end_minor) {
        const Int f = from_center(end);
        if constexpr (L::count == 1)
            if ((f > 0) != up) // only the side of the centre line decides
                return own(end) + (f > 0 ? 1 : 0);
        Int from_x = f, from_y = from_center(end_minor);
        L::exchange(L::no(x), from_x, from_y);
        const Mask out = outside(from_x, from_y);
        const Mask above = L::less(Int{}, f);
        return own(end) + L::one(L::select(up, Mask(out & above), Mask(L::no(out) | above)));
    }
    /// What first_past() gives for the second end of the line.
    SPANGLE_INLINE Int second_past() const { return L::select(ascends, major + count, major); }

    Int length() const { return high - low; }

    /// The tie-break of a minor coordinate on the boundary of two fragments: 0 if it belongs to the upper
    /// fragment, and -1 if it belongs to the lower one. It belongs to the upper fragment only if the shifted
    /// line lies above it. This holds for y(x + e) - e^2 on x-major lines with a rising slope, and never for
    /// x(y + e^2) - e.
    SPANGLE_INLINE Int break_tie() const {
        const Int not_rising = (rise - 1) >> 31;
        return L::select(along_x, not_rising, Int(~(rise ^ rise)));
    }

    /// The minor coordinate of the first fragment; `remainder` is that of the division by 256 length. The
    /// centre of this fragment is -128 .. 383 from the lower end. |rise| <= length makes the quotient more
    /// than -2 and less than 3.
    SPANGLE_INLINE Int first(Int& remainder) const {
        constexpr std::int32_t bias = 2;
        const Int inside = low_minor & (subpixel_one - 1);
        remainder = (center(major) - low) * rise + (inside + bias * subpixel_one) * length() + break_tie();
        return (low_minor >> subpixel_bits) - bias + L::divide_small(remainder, length() * subpixel_one);
    }

    /// The centre of fragment i along the major axis, subpixels.
    SPANGLE_INLINE static Int center(Int i) { return i * subpixel_one + subpixel_one / 2; }

  private:
    /// Puts the lower end first. Returns the minor coordinate of the upper end.
    SPANGLE_INLINE Int order(Int a, Int a_minor, Int b, Int b_minor) {
        const auto descends = L::no(ascends);
        L::exchange(descends, a, b);
        L::exchange(descends, a_minor, b_minor);
        low = a, high = b, low_minor = a_minor;
        rise = b_minor - a_minor;
        return b_minor;
    }
    SPANGLE_INLINE static Int abs_value(Int v) {
        const Int sign = v >> 31;
        return (v ^ sign) - sign;
    }
    /// The fragment in which a coordinate lies: floor(v - e).
    SPANGLE_INLINE static Int own(Int v) { return (v - 1) >> subpixel_bits; }
    /// The distance of v from the centre of its own fragment, -127 .. 128 subpixels.
    SPANGLE_INLINE static Int from_center(Int v) {
        return ((v - 1) & (subpixel_one - 1)) - (subpixel_one / 2 - 1);
    }

    /// Whether an end at (x, y) from the centre of its own fragment lies outside of the diamond, which is
    /// |x| + |y| < 1/2 pixel (GL 1.3, 3.4.1). Ends count as moved by e to smaller x; see own(). So a point on
    /// the diamond's edge lies inside where x > 0, and outside where x <= 0.
    SPANGLE_INLINE static Mask outside(Int x, Int y) {
        const Int before = x - 1, distance = (before ^ (before >> 31)) + abs_value(y);
        return L::less(Int{} + (subpixel_one / 2 - 1), distance);
    }
};

/// Walks the fragments of one line in increasing order of the major coordinate. `major` and `minor` are
/// column and row, or row and column.
class DiamondWalk {
  public:
    std::int32_t major, minor; ///< the current fragment
    std::int32_t count;        ///< number of fragments left, including the current one
    bool along_x;
    bool ascends; ///< true where the line ascends from its first end to its second

    DiamondWalk(std::int32_t ax, std::int32_t ay, std::int32_t bx, std::int32_t by, std::int32_t shift) {
        using SingleLane = Diamond<LineLanes<1>>;
        const SingleLane line(ax, ay, bx, by, shift);
        along_x = line.along_x;
        ascends = line.ascends;
        major = line.major;
        count = line.count;
        if (count <= 0) {
            count = 0;
            return;
        }
        low_ = line.low;
        low_minor_ = line.low_minor;
        length_ = line.length();
        rise_ = line.rise;
        tie_break_ = line.break_tie();
        denominator_ = length_ * subpixel_one;
        if (length_ <= SingleLane::small_length)
            minor = line.first(remainder_);
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
    /// Finds `minor` and the remainder at the centre of `major`.
    void place() {
        const std::int32_t from_low = major * subpixel_one + subpixel_one / 2 - low_;
        const std::int32_t inside = low_minor_ & (subpixel_one - 1);
        const std::int64_t numerator =
            numeric::mul_long(from_low, rise_) + numeric::mul_long(inside, length_) + tie_break_;
        const auto q = numeric::floor_divide(numerator, static_cast<std::uint32_t>(denominator_));
        remainder_ = static_cast<std::int32_t>(q.remainder);
        minor = (low_minor_ >> subpixel_bits) + static_cast<std::int32_t>(q.quotient);
    }

    std::int32_t low_, low_minor_, length_, rise_, denominator_, remainder_, tie_break_;
};

} // namespace spangle::raster
