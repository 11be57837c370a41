// Planes of 64 bits at the fragments of eight lanes: along a row, or at places of their own.
#pragma once

#include "raster/ops/lane_products.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/span.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

namespace inner {

/// A plane at eight fragments that follow each other in a row, in as many vectors as eight lanes of 64 bits
/// take.
template <class Vector = LaneWords::Vector> class GuardedLanes {
  public:
    GuardedLanes() : at_{}, step_{} {}
    SPANGLE_INLINE GuardedLanes(const Span<Fixed>& span, std::int32_t x, const Span<Fixed>::Projective& plane)
        : step_(Long{} + 8 * plane.dx) {
        const std::uint64_t first = span.at(x, plane), two = 2 * plane.dx, four = 4 * plane.dx;
        if constexpr (vectors == 2) {
            at_[0] = Long{first, first + two, first + four, first + four + two};
            at_[1] = at_[0] + plane.dx;
        } else {
            at_[0] = Long{first, first + two};
            at_[1] = at_[0] + four;
            at_[2] = at_[0] + plane.dx;
            at_[3] = at_[1] + plane.dx;
        }
    }
    /// The signed values of a plane with guard bits, without these bits.
    SPANGLE_INLINE LaneWords value() const {
        if constexpr (vectors == 2)
            return {std::bit_cast<Vector>((at_[0] >> guard_bits & 0xFFFFFFFFu) | at_[1] >> guard_bits << 32)};
        else
            return {low_words(at_[0], at_[1]), low_words(at_[2], at_[3])};
    }
    /// The high words of the values.
    SPANGLE_INLINE LaneWords tops() const {
        if constexpr (vectors == 2)
            return {high_words<Vector>(at_[0], at_[1])};
        else
            return {odd_of(at_[0], at_[1]), odd_of(at_[2], at_[3])};
    }
    SPANGLE_INLINE void step() {
        for (Long& v : at_)
            v += step_;
    }

  private:
    using Long = Longs<Vector>;
    static constexpr int vectors = sizeof(Vector) == 32 ? 2 : 4;
    /// One half of the vectors holds lanes 0, 2, 4 and 6; the other half holds the odd lanes.
    Long at_[vectors], step_;
    SPANGLE_INLINE static Vector low_words(const Long& a, const Long& b) {
        return __builtin_shufflevector(std::bit_cast<Vector>(a >> guard_bits),
                                       std::bit_cast<Vector>(b >> guard_bits), 0, 2, 4, 6);
    }
    SPANGLE_INLINE static Vector odd_of(const Long& a, const Long& b) {
        return __builtin_shufflevector(std::bit_cast<Vector>(a), std::bit_cast<Vector>(b), 1, 3, 5, 7);
    }
};

} // namespace inner

/// A plane, evaluated at the fragments of a packet that rows share. Places are signed and count from the
/// anchor.
class PlaneInRows {
  public:
    SPANGLE_INLINE explicit PlaneInRows(const Span<Fixed>::Projective& plane)
        : value_(plane.value), dx_(plane.dx), dy_(plane.dy) {}
    /// The signed values of a plane with guard bits, without these bits.
    SPANGLE_INLINE LaneWords at(const LaneWords& x, const LaneWords& y) const {
        return each(
            x, y, [](const auto& even, const auto& odd) __attribute__((always_inline)) {
                return ((even >> guard_bits) & 0xFFFFFFFFu) | (odd >> guard_bits << 32);
            });
    }
    /// The high words of the values.
    SPANGLE_INLINE LaneWords tops(const LaneWords& x, const LaneWords& y) const {
        return each(
            x, y, [](const auto& even, const auto& odd) __attribute__((always_inline)) {
                return (even >> 32) | (odd & 0xFFFFFFFF00000000u);
            });
    }

  private:
    /// A factor of 64 bits as two words. The low word counts as signed.
    struct Factor {
        std::uint32_t low, high;
        SPANGLE_INLINE explicit Factor(std::uint64_t v)
            : low(static_cast<std::uint32_t>(v)), high(static_cast<std::uint32_t>((v + 0x80000000u) >> 32)) {}
    };
    std::uint64_t value_;
    Factor dx_, dy_;

    /// Joins the values in even lanes and in odd lanes by f.
    template <class F> SPANGLE_INLINE LaneWords each(const LaneWords& x, const LaneWords& y, F f) const {
        return LaneWords::mapped(
            [ this, f ](const auto& columns, const auto& lines) __attribute__((always_inline)) {
                using Vector = std::remove_cvref_t<decltype(columns)>;
                using Long = inner::Longs<Vector>;
                const Vector by_x = Vector{} + dx_.low, by_y = Vector{} + dy_.low;
                const auto by = [&](const Vector& column, const Vector& line) __attribute__((always_inline)) {
                    return inner::even_products_signed(column, by_x) +
                           inner::even_products_signed(line, by_y) + value_;
                };
                const auto high = std::bit_cast<Long>(columns * dx_.high + lines * dy_.high);
                const Long even = by(columns, lines) + (high << 32),
                           odd = by(inner::odd_words(columns), inner::odd_words(lines)) +
                                 (high & 0xFFFFFFFF00000000u);
                return std::bit_cast<Vector>(f(even, odd));
            },
            x, y);
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
