// What is divided by w, near a place, in words of 16 bits: quotients of planes of which so many bits are
// enough.
//
// With q = m (1 - u), where m is 1/w at the place, a/q = A + d (1 + u + u^2 + ...): d = (a - A q) / m is a
// plane, u is one, and both are small where A is about a/q there. Two multiplications of 16 bits make the
// quotient of d and u.
#pragma once

#include <cstdint>

#include "raster/numeric/reciprocal.hpp"
#include "raster/span/lanes.hpp"
#include "raster/span/span.hpp"

namespace spangle::raster {

/// Fragments within so many columns and rows of a place in the window.
struct Patch {
    std::int32_t x, y, columns, rows;
    static constexpr std::int32_t most_columns = 128, most_rows = 16;
};

/// One quotient: what NearInverse::of() gives is at most the true one, which is less than `window` more.
struct NearQuotient {
    Interpolant<std::uint32_t> d; ///< 16 fraction bits
    std::int32_t base = 0;        ///< A
    std::uint32_t window = 0;

    /// What of(), limited to it, adds to the base so that the sum is in [0, most]; the base is at most 2^15 -
    /// 1 less than 0 and 2^15 more than `most`.
    SPANGLE_INLINE std::uint32_t least() const { return static_cast<std::uint32_t>(within(0)); }
    SPANGLE_INLINE std::uint32_t largest(std::int32_t most) const {
        return static_cast<std::uint32_t>(within(most));
    }

  private:
    SPANGLE_INLINE std::int32_t within(std::int32_t v) const {
        return numeric::clamp<std::int32_t>(v - base, INT16_MIN, INT16_MAX);
    }
};

/// 1/w near a place.
class NearDivision {
  public:
    using Projective = Span<Fixed>::Projective;
    Interpolant<std::uint32_t> u{}; ///< of 2^-16, 16 fraction bits
    bool serves = false;            ///< 1/w is not too small, and differs by an eighth at most

    SPANGLE_INLINE NearDivision(const Span<Fixed>& span, const Patch& patch)
        : patch_(patch), column_(patch.x - span.anchor_x), row_(patch.y - span.anchor_y),
          q_(span.q, column_, row_), vertices_(span.basis.v) {
        const std::int64_t m = q_.center >> (guard_bits - dropped);
        if (!q_.fit() || m < 1 << 28 || m > INT32_MAX)
            return;
        zeros_ = numeric::clz32(static_cast<std::uint32_t>(m));
        mantissa_ = numeric::reciprocal(static_cast<std::uint32_t>(m) << zeros_);
        const std::int64_t dx = over_m(-q_.dx * 65536), dy = over_m(-q_.dy * 65536);
        const std::uint64_t most = spread(0, dx, dy, 1u << 29);
        u = plane(0, dx, dy);
        serves = most <= 1u << 29;
        // What the series leaves out is below 8/7 u^4; u is rounded down twice, its powers once each.
        const std::uint64_t size = (most >> 16) + 1, square = (size * size >> 16) + 1,
                            fourth = (square * square >> 16) + 1;
        inaccuracy_ = 4 + fourth + (fourth >> 2);
    }

    /// a/q 2^(exponent + 16), and `more` / 2^16. False where 16 bits do not hold it.
    ///
    /// Lanes round d down twice and its product once, which makes up to 3, and multiply by a factor that is
    /// off by `inaccuracy_` 2^-16. An eighth is for what planes lose over a patch, for what the bits that
    /// divided values are made of lose (2^-6), and for `more`, of which below 1 is multiplied. All of it is
    /// taken off d: a fourth more than it is, because that is multiplied, too.
    SPANGLE_INLINE bool quotient(NearQuotient& to, const Projective& plane_of, int exponent,
                                 std::uint32_t more = 0) const {
        constexpr std::int64_t most_base = 1 << 19;
        constexpr std::uint64_t most_d = (7u << 28) - (1 << 20);
        const Halves a(plane_of, column_, row_);
        if (!a.fit() || exponent < -8 || exponent > 6)
            return false;
        const std::int64_t base =
            (a.center >> (guard_bits - dropped)) * std::int64_t{mantissa_} >> (46 - zeros_ - exponent);
        if (base < -most_base || base > most_base)
            return false;
        const auto less = [&](std::int64_t v, std::int64_t by) {
            return over_m(v * (std::int64_t{1} << (exponent + 16)) - base * by);
        };
        const std::int64_t dx = less(a.dx, q_.dx), dy = less(a.dy, q_.dy), center = less(a.center, q_.center);
        const std::uint64_t most = spread(center, dx, dy, most_d);
        if (most > most_d)
            return false;
        const std::uint64_t size = (most >> 16) + 1;
        std::uint64_t off = size * inaccuracy_ + (1u << 13);
        off += off >> 2;
        to.d = plane(center - static_cast<std::int64_t>(off) + (more & 0xFFFF), dx, dy);
        to.base = static_cast<std::int32_t>(base) + static_cast<std::int32_t>(more >> 16);
        to.window = static_cast<std::uint32_t>((2 * off + 0xFFFF) >> 16) + 3;
        return to.window <= 16;
    }

  private:
    /// A plane with half of its guard bits, signed, at the place: below 2^31 but for them.
    struct Halves {
        std::int64_t center, dx, dy;
        SPANGLE_INLINE Halves(const Projective& p, std::int32_t column, std::int32_t row)
            : center(half(p.at(column, row))), dx(half(p.dx)), dy(half(p.dy)) {}
        SPANGLE_INLINE static std::int64_t half(std::uint64_t v) {
            return static_cast<std::int64_t>(v) >> dropped;
        }
        SPANGLE_INLINE bool fit() const { return fits(center) && fits(dx) && fits(dy); }
        SPANGLE_INLINE static bool fits(std::int64_t v) {
            constexpr std::uint64_t most = std::uint64_t{1} << 39;
            return static_cast<std::uint64_t>(v) + most < 2 * most;
        }
    };
    static constexpr int dropped = guard_bits / 2;

    /// v 2^8 / m.
    SPANGLE_INLINE std::int64_t over_m(std::int64_t v) const {
        const std::int64_t high = (v >> 32) * std::int64_t{mantissa_};
        const std::uint64_t low = numeric::mul_u32(static_cast<std::uint32_t>(v), mantissa_) >> 32;
        return (high + static_cast<std::int64_t>(low)) >> (22 - zeros_);
    }
    /// How far from 0 a plane is at most: all over the patch, or, where that is more than `enough`, between
    /// the corners of the primitive. The centres of a line's fragments lie up to a pixel beyond those.
    SPANGLE_INLINE std::uint64_t spread(std::int64_t center, std::int64_t dx, std::int64_t dy,
                                        std::uint64_t enough) const {
        const std::uint64_t x = numeric::abs_u64(dx), y = numeric::abs_u64(dy),
                            over_patch = numeric::abs_u64(center) +
                                         x * static_cast<std::uint32_t>(patch_.columns) +
                                         y * static_cast<std::uint32_t>(patch_.rows);
        if (over_patch <= enough || (x | y) >> 38 != 0) [[likely]] // corners are within 2^22
            return over_patch;
        return between_corners(center, dx, dy) + x + y;
    }
    [[gnu::noinline]] std::uint64_t between_corners(std::int64_t center, std::int64_t dx,
                                                    std::int64_t dy) const {
        std::uint64_t most = 0;
        for (const FixedVertex* const v : vertices_) {
            const std::int64_t x = v->x - patch_.x * subpixel_one - subpixel_one / 2,
                               y = v->y - patch_.y * subpixel_one - subpixel_one / 2;
            const std::uint64_t at = numeric::abs_u64(center + ((dx * x + dy * y) >> subpixel_bits));
            most = at > most ? at : most;
        }
        return most + 1;
    }
    /// From the value at the place.
    SPANGLE_INLINE Interpolant<std::uint32_t> plane(std::int64_t center, std::int64_t dx,
                                                    std::int64_t dy) const {
        const auto x = static_cast<std::uint32_t>(dx), y = static_cast<std::uint32_t>(dy);
        return {static_cast<std::uint32_t>(center) - x * static_cast<std::uint32_t>(column_) -
                    y * static_cast<std::uint32_t>(row_),
                x, y};
    }

    const Patch& patch_;
    std::int32_t column_, row_;
    Halves q_;
    const FixedVertex* const (&vertices_)[3]; ///< of the primitive
    int zeros_ = 1;
    std::uint32_t mantissa_ = 0;
    std::uint64_t inaccuracy_ = 0; ///< of 1/q, in 2^-16
};

/// A plane of these along rows, whole parts in eight lanes, up to 2 less than they are. What is constant lies
/// in lanes: a store to the surface might change anything else.
class NearRamp {
  public:
    using L = Lanes<8>;
    template <class S>
    SPANGLE_INLINE NearRamp(const S& row, std::int32_t x, const Interpolant<std::uint32_t>& plane)
        : offset_(L::high_half(L::ramp(0, plane.dx))), by_(8 * plane.dx) {
        start(row, x, plane);
    }
    template <class S>
    SPANGLE_INLINE void start(const S& row, std::int32_t x, const Interpolant<std::uint32_t>& plane) {
        at_ = row.at(x, plane);
    }
    SPANGLE_INLINE void step() { at_ += by_; }
    SPANGLE_INLINE L::U16 whole() const { return L::splat(at_ >> 16) + offset_; }

  private:
    L::U16 offset_;
    std::uint32_t at_, by_;
};

/// Eight fragments: u + u^2 + u^3.
class NearInverse {
  public:
    using L = Lanes<8>;
    SPANGLE_INLINE explicit NearInverse(const L::U16& u)
        : more_(u + L::mul_high_signed(u, u + L::mul_high_signed(u, u))) {}
    /// The quotient less its base.
    SPANGLE_INLINE L::U16 of(const L::U16& d) const { return d + L::mul_high_signed(d, more_); }

  private:
    L::U16 more_;
};

} // namespace spangle::raster
