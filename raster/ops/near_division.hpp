// Divides by w near a place in the window, for planes whose quotients need no more than 16 bits.
//
// Let m be the value of q at the place, and q = m (1 - u). Then a/q = A + d (1 + u + u^2 + ...). Both u and
// d = (a - A q) / m are planes, and both are small where A is about a/q at the place. Two multiplications of
// few bits make the quotient from d and u.
#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>

#include "raster/numeric/reciprocal.hpp"
#include "raster/ops/lanes.hpp"
#include "raster/ops/row_planes.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/span.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// A place (x, y) in the window, and the fragments within `columns` and `rows` of it.
struct Patch {
    std::int32_t x, y, columns, rows;
    static constexpr std::int32_t most_columns = 128, most_rows = 16;
};

/// One quotient. The guess of NearInverse::of() or NearWords::of() is at most the true quotient. The true
/// quotient is less than `window` above the guess.
struct NearQuotient {
    Interpolant<std::uint32_t> d; ///< the plane of d, with 16 fraction bits
    std::int32_t base = 0;        ///< the whole number A of the guess
    /// The largest error of the guess, not included. It has the fraction bits of the products.
    std::uint32_t window = 0;

    /// Limits for what of() adds to the base. With these limits the sum lies in [0, most]. The base is at
    /// least 1 - 2^15 and at most `most` + 2^15.
    SPANGLE_INLINE std::uint32_t least() const { return static_cast<std::uint32_t>(within(0)); }
    SPANGLE_INLINE std::uint32_t largest_error(std::int32_t most) const {
        return static_cast<std::uint32_t>(within(most));
    }

  private:
    SPANGLE_INLINE std::int32_t within(std::int32_t v) const {
        return numeric::clamp<std::int32_t>(v - base, INT16_MIN, INT16_MAX);
    }
};

/// Products of 16 bits. They serve lanes, and single fragments on processors whose products have only one
/// word.
struct NearHalves {
    static constexpr int fraction_bits = 0; ///< fraction bits of quotients
    /// The inaccuracy of 1/q in 2^-16, where |u| is at most `most` 2^-32, which is below 1/4. The terms that
    /// the series leaves out sum to less than 8/7 u^4. u is rounded down twice, and each of its powers once.
    SPANGLE_INLINE static std::uint32_t reciprocal_error(std::uint32_t most) {
        const std::uint32_t size = (most >> 16) + 1, square = (size * size >> 16) + 1,
                            fourth = (square * square >> 16) + 1;
        return 4 + fourth + (fourth >> 2);
    }
    /// The inaccuracy, in 2^-16, of a quotient whose whole part is at most `size`.
    SPANGLE_INLINE static std::uint32_t of_quotient(std::uint32_t size, std::uint32_t error) {
        return size * error;
    }
    /// The window of a quotient that is off by `off`. Lanes round d down twice and its product once, which
    /// makes up to 3.
    SPANGLE_INLINE static std::uint32_t window(std::uint32_t off) { return ((2 * off + 0xFFFF) >> 16) + 3; }
    /// Makes u + u^2 + u^3 for one fragment. NearInverse does so for eight fragments.
    SPANGLE_INLINE static std::int32_t inverse(std::uint32_t plane) {
        const std::int32_t u = static_cast<std::int32_t>(plane) >> 16;
        return u + (u * (u + (u * u >> 16)) >> 16);
    }
    SPANGLE_INLINE static std::uint32_t of(std::uint32_t base, std::uint32_t plane, std::int32_t inverse) {
        const std::int32_t d = static_cast<std::int32_t>(plane) >> 16;
        return base + static_cast<std::uint32_t>(d + (d * inverse >> 16));
    }
};

/// Products of 32 bits, for one fragment at a time.
struct NearWords {
    static constexpr int fraction_bits = 14;
    /// The inaccuracy of 1/q in 2^-32. Over a patch the plane of u is off by less than 2^8, and 1/q by a
    /// third more than that. Each power of u is rounded down once, and the sum is rounded to 30 bits.
    SPANGLE_INLINE static std::uint32_t reciprocal_error(std::uint32_t most) {
        const std::uint32_t square = numeric::mul_high_u32(most, most) + 1,
                            fourth = numeric::mul_high_u32(square, square) + 1;
        return 352 + fourth + (fourth >> 2);
    }
    SPANGLE_INLINE static std::uint32_t of_quotient(std::uint32_t size, std::uint32_t error) {
        return static_cast<std::uint32_t>(numeric::mul_u32(size, error) >> 16) + 1 +
               (1u << (16 - fraction_bits)); // the last term stands for the bits that of() drops
    }
    SPANGLE_INLINE static std::uint32_t window(std::uint32_t off) { return (2 * off >> 2) + 3; }
    /// 1 + u + u^2 + u^3 with 30 fraction bits.
    SPANGLE_INLINE static std::int32_t inverse(std::uint32_t plane) {
        const auto u = static_cast<std::int32_t>(plane);
        const std::int32_t more = u + numeric::mul_high_s32(u, u + numeric::mul_high_s32(u, u));
        return (1 << 30) + (more >> 2);
    }
    /// The quotient, with the fraction bits of `base`. The low word of the sum of long products may hold
    /// anything. It adds less than one, and clearing it is not worth an instruction.
    SPANGLE_INLINE static std::uint32_t of(std::uint32_t base, std::uint32_t d, std::int32_t inverse) {
        const std::int64_t product = numeric::mul_long(static_cast<std::int32_t>(d), inverse);
        return static_cast<std::uint32_t>(
            ((std::uint64_t{base} << 32 | d) + static_cast<std::uint64_t>(product)) >> 32);
    }
};

/// The products that guess single fragments.
using NearProducts = std::conditional_t<numeric::long_products, NearWords, NearHalves>;

/// Divides planes by w near a place.
template <class Products> class NearDivisionOf {
  public:
    using Projective = Span<Fixed>::Projective;
    Interpolant<std::uint32_t> u{}; ///< the plane of u in units of 2^-16, with 16 fraction bits
    bool serves = false; ///< true where 1/w is not too small, and differs by at most an eighth over the patch

    SPANGLE_INLINE NearDivisionOf(const Span<Fixed>& span, const Patch& patch)
        : patch_(patch), column_(patch.x - span.anchor_x), row_(patch.y - span.anchor_y),
          vertices_(span.basis.v) {
        const std::int64_t m = static_cast<std::int64_t>(span.q.at(column_, row_)) >> guard_bits;
        if (m < 1 << 28 || m > INT32_MAX)
            return;
        leading_zeros_ = numeric::clz32(static_cast<std::uint32_t>(m));
        mantissa_ = numeric::reciprocal(static_cast<std::uint32_t>(m) << leading_zeros_);
        const Slopes of(-over_m(span.q.dx, 0), -over_m(span.q.dy, 0));
        if (!of.fit)
            return;
        const std::uint64_t most = plane_range(0, of.dx, of.dy, 1u << 29);
        u = plane(0, of.dx, of.dy);
        serves = most <= 1u << 29;
        reciprocal_error_ = Products::reciprocal_error(static_cast<std::uint32_t>(most));
    }

    /// Makes the quotient a/q 2^(exponent + 16) plus `more` / 2^16. Returns false where 16 bits do not hold
    /// it.
    ///
    /// A is a/m rounded down. So d = a/m - A + A u begins with what the rounding left, and changes by the
    /// slopes of a/m plus A times the slopes of u. Over a patch these slopes lose less than 2^8 2^-32 of A. d
    /// is multiplied by a factor that is off by `reciprocal_error_`. An eighth is reserved for three more
    /// losses: those of planes, those of the bits of which divided values are made (2^-6), and that of
    /// `more`, whose part below 1 is multiplied. All losses are taken off d, and a fourth more, because d is
    /// multiplied with them.
    SPANGLE_INLINE bool quotient(NearQuotient& to, const Projective& plane_of, int exponent,
                                 std::uint32_t more = 0) const {
        constexpr std::int64_t most_base = 1 << 19;
        constexpr std::uint32_t most_d = (7u << 28) - (1 << 20);
        if (exponent < -8 || exponent > 6)
            return false;
        const std::int64_t center = over_m(plane_of.at(column_, row_), exponent);
        const Slopes a(over_m(plane_of.dx, exponent), over_m(plane_of.dy, exponent));
        if (center < -most_base << 16 || center >= most_base << 16 || !a.fit)
            return false;
        const auto base = static_cast<std::int32_t>(center >> 16);
        const auto rest = static_cast<std::int32_t>(center & 0xFFFF);
        const auto with_base = [&](std::int32_t slope, std::uint32_t slope_of_u) {
            return slope + (numeric::mul_long(base, static_cast<std::int32_t>(slope_of_u)) >> 16);
        };
        const Slopes d(with_base(a.dx, u.dx), with_base(a.dy, u.dy));
        if (!d.fit)
            return false;
        const std::uint64_t most = plane_range(rest, d.dx, d.dy, most_d);
        if (most > most_d)
            return false;
        const std::uint32_t size = (static_cast<std::uint32_t>(most) >> 16) + 1;
        std::uint32_t off =
            Products::of_quotient(size, reciprocal_error_) + (numeric::abs_u32(base) >> 8) + (1u << 13);
        off += off >> 2;
        to.d = plane(rest - static_cast<std::int32_t>(off) + static_cast<std::int32_t>(more & 0xFFFF), d.dx,
                     d.dy);
        to.base = base + static_cast<std::int32_t>(more >> 16);
        to.window = Products::window(off);
        return to.window <= 16u << Products::fraction_bits;
    }

  private:
    struct Slopes {
        std::int32_t dx, dy;
        bool fit;
        SPANGLE_INLINE Slopes(std::int64_t x, std::int64_t y)
            : dx(static_cast<std::int32_t>(x)), dy(static_cast<std::int32_t>(y)), fit(dx == x && dy == y) {}
    };
    /// Returns v 2^(exponent + 32) / m, where v is a value of a plane with its guard bits.
    SPANGLE_INLINE std::int64_t over_m(std::uint64_t v, int exponent) const {
        const auto top = static_cast<std::int32_t>(static_cast<std::uint32_t>(v >> 32));
        const std::uint32_t low = numeric::mul_high_u32(static_cast<std::uint32_t>(v), mantissa_);
        return numeric::words_after(numeric::mul_s32_u32(top, mantissa_) + low,
                                    14 - leading_zeros_ - exponent); // the shift is 5 .. 21
    }
    /// The largest distance of a plane from 0 over the whole patch. Where that is more than `enough`, the
    /// vertices of the primitive bound the distance instead. The centres of a line's fragments lie up to a
    /// pixel beyond the vertices.
    SPANGLE_INLINE std::uint64_t plane_range(std::int32_t center, std::int32_t dx, std::int32_t dy,
                                             std::uint32_t enough) const {
        const std::uint32_t x = numeric::abs_u32(dx), y = numeric::abs_u32(dy);
        const std::uint64_t over_patch = numeric::mul_u32(x, static_cast<std::uint32_t>(patch_.columns)) +
                                         numeric::mul_u32(y, static_cast<std::uint32_t>(patch_.rows)) +
                                         numeric::abs_u32(center);
        if (over_patch <= enough) [[likely]]
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
    /// The plane that has the value `center` at the place.
    SPANGLE_INLINE Interpolant<std::uint32_t> plane(std::int32_t center, std::int32_t dx,
                                                    std::int32_t dy) const {
        const auto x = static_cast<std::uint32_t>(dx), y = static_cast<std::uint32_t>(dy);
        return {static_cast<std::uint32_t>(center) - x * static_cast<std::uint32_t>(column_) -
                    y * static_cast<std::uint32_t>(row_),
                x, y};
    }

    const Patch& patch_;
    std::int32_t column_, row_;
    const FixedVertex* const (&vertices_)[3]; ///< vertices of the primitive whose planes are divided
    int leading_zeros_ = 1;
    std::uint32_t mantissa_ = 0;
    std::uint32_t reciprocal_error_ = 0; ///< inaccuracy of 1/q, in the unit of Products::reciprocal_error()
};
using NearDivision = NearDivisionOf<NearHalves>;

/// Planes in eight lanes, as exact as 16 bits are.
template <int Count> class NearPlanes : public RowPlanes<Count> {
    static_assert(Count <= 4);

  public:
    using L = Lanes<8>;
    template <class S, class... Plane>
    SPANGLE_INLINE explicit NearPlanes(const S& row, std::int32_t x, const Plane&... of)
        : RowPlanes<Count>(row, x, of...) {
        this->at_[0] = this->row_[0];
        set_offsets(std::make_integer_sequence<int, Count>{});
    }
    SPANGLE_INLINE void start(std::int32_t x, std::int32_t y) {
        this->to_row(y);
        RowPlanes<Count>::start(x);
    }
    SPANGLE_INLINE void step() { this->at_[0] += this->dx_[0] << 3; }
    /// The whole part of plane I in each lane; it is at most 2 too small.
    template <int I> SPANGLE_INLINE L::U16 whole() const {
        return L::splat_half<2 * I + 1>(this->at_[0]) + offset_[I];
    }

  private:
    /// Sets the difference of each plane between each lane and the first lane, in whole parts.
    template <int... I> SPANGLE_INLINE void set_offsets(std::integer_sequence<int, I...>) {
        const L::U16 columns = L::offsets16(L::splat(1), L::splat(0));
        const auto offset = [&](auto whole, auto fraction) __attribute__((always_inline)) {
            return whole * columns + L::mul_high(fraction, columns);
        };
        ((offset_[I] = offset(L::splat_half<2 * I + 1>(this->dx_[0]), L::splat_half<2 * I>(this->dx_[0]))),
         ...);
    }

    L::U16 offset_[Count];
};

/// Divides by w near a place, for eight fragments at once. 1/q is 1/m times 1 + u + u^2 + u^3, where u is the
/// plane of NearDivisionOf.
class NearInverse {
  public:
    using L = Lanes<8>;
    SPANGLE_INLINE explicit NearInverse(const L::U16& u)
        : correction_(u + L::mul_high_signed(u, u + L::mul_high_signed(u, u))) {}
    /// What the quotient has above its whole number NearQuotient::base.
    SPANGLE_INLINE L::U16 of(const L::U16& d) const { return d + L::mul_high_signed(d, correction_); }

  private:
    L::U16 correction_;
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
