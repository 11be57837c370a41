// The LINEAR filter of the balanced tier (GL 1.3, 3.8.8): four texels become one colour. Each format has the
// cheapest integers that keep its bits. Weights have 8 bits by definition (docs/architecture/numbers.md,
// "Texture coordinates and filters").
#pragma once

#include "raster/ops/number.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Weights of two rows of texels. The weights of all four texels sum to `Sum`.
template <class L, std::uint32_t Sum> struct RowWeights {
    typename L::U16 near, far;
    /// b is the weight of row j + 1, in 256ths.
    SPANGLE_INLINE explicit RowWeights(typename L::U16 b)
        : near(L::splat(Sum) - L::mul_256(b, L::splat(Sum))), far(L::mul_256(b, L::splat(Sum))) {}
    /// Returns the sum of weight * value plus `less`. The sum is at most Sum times the largest value. a is
    /// the weight of column i + 1, in 256ths.
    template <class V> SPANGLE_INLINE V mix(V c00, V c10, V c01, V c11, typename L::U16 a, V less) const {
        const typename L::U16 w10 = L::mul_256(a, near), w11 = L::mul_256(a, far);
        return less + c00 * (near - w10) + c10 * w10 + c01 * (far - w11) + c11 * w11;
    }
};

/// Filters words R5 G6 B5 to 255ths with 8 fraction bits. The weights also convert: in 256ths, 31 * 2105 is a
/// 10th of a 255th less than 255, and 63 * 1036 is a 20th less. Half of this lack is added to every sum. 16
/// bits hold the sum, and four equal texels keep their value, also as 8 bits. With one lane red and blue
/// share a word.
template <int Count> struct Filter565 {
    using L = Lanes<Count>;
    using N = Balanced<Count>;
    using U16 = typename L::U16;
    static constexpr std::uint32_t sum5 = 2105, sum6 = 1036, less5 = (N::one - 31 * sum5) / 2,
                                   less6 = (N::one - 63 * sum6) / 2;
    RowWeights<L, sum5> five;
    RowWeights<L, sum6> six;
    SPANGLE_INLINE explicit Filter565(U16 b) : five(b), six(b) {}

    SPANGLE_INLINE typename N::Color operator()(U16 c00, U16 c10, U16 c01, U16 c11, U16 a) const {
        const auto green = [](U16 c) { return (c >> 5) & 63; };
        if constexpr (Count == 1 && numeric::three_operands) // all four texels are read first
            numeric::begin_here();
        U16 g = six.mix(green(c00), green(c10), green(c01), green(c11), a, L::splat(less6));
        if constexpr (Count == 1) {
            // Registers are few, so red and blue do not begin before green is done.
            if constexpr (!numeric::three_operands)
                g = numeric::factor32(g);
            const auto both = [](U16 c) { return numeric::with_bits<16, 5>(c >> 11, c); };
            const std::uint32_t rb = numeric::factor32(
                five.mix(both(c00), both(c10), both(c01), both(c11), a, less5 << 16 | less5));
            return {rb & 0xFFFF, g, rb >> 16, N::one};
        } else {
            return {five.mix(c00 >> 11, c10 >> 11, c01 >> 11, c11 >> 11, a, L::splat(less5)), g,
                    five.mix(c00 & 31, c10 & 31, c01 & 31, c11 & 31, a, L::splat(less5)), L::splat(N::one)};
        }
    }
};

/// Filters texels of 8-bit components, with R in the lowest byte. The filter along t is exact and keeps 7
/// fraction bits. The filter along s keeps 6. With one lane two components share a word along t.
template <int Count> struct Filter8 {
    using L = Lanes<Count>;
    using N = Balanced<Count>;
    using U16 = typename L::U16;
    U16 b;
    SPANGLE_INLINE explicit Filter8(U16 weight) : b(weight) {}

    template <bool Alpha, class Words>
    SPANGLE_INLINE typename N::Color texels(const Words& c00, const Words& c10, const Words& c01,
                                            const Words& c11, U16 a) const {
        const U16 opaque = L::splat(N::one);
        if constexpr (Count == 1) {
            constexpr std::uint32_t pair = 0x00FF00FF;
            const auto column = [&](std::uint32_t near, std::uint32_t far) {
                return (near * (256 - b) + far * b) >> 1 & 0x7FFF7FFF;
            };
            const std::uint32_t rb0 = column(c00 & pair, c01 & pair), rb1 = column(c10 & pair, c11 & pair);
            const auto high = [](std::uint32_t c) { return Alpha ? c >> 8 & pair : c >> 8 & 0xFF; };
            const std::uint32_t ga0 = column(high(c00), high(c01)), ga1 = column(high(c10), high(c11));
            return {across(rb0 & 0xFFFF, rb1 & 0xFFFF, a), across(ga0 & 0xFFFF, ga1 & 0xFFFF, a),
                    across(rb0 >> 16, rb1 >> 16, a), Alpha ? across(ga0 >> 16, ga1 >> 16, a) : opaque};
        } else {
            const auto at = [&](int n) {
                return component(L::byte(c00, n), L::byte(c10, n), L::byte(c01, n), L::byte(c11, n), a);
            };
            return {at(0), at(1), at(2), Alpha ? at(3) : opaque};
        }
    }
    /// Filters one component of four texels, 8 bits each.
    SPANGLE_INLINE U16 component(U16 c00, U16 c10, U16 c01, U16 c11, U16 a) const {
        return across((c00 * (256 - b) + c01 * b) >> 1, (c10 * (256 - b) + c11 * b) >> 1, a);
    }

  private:
    /// Filters along s. The result is never below 0 or above one, because (v0 + 1) / 2 outweighs what
    /// rounding takes off.
    SPANGLE_INLINE static U16 across(U16 v0, U16 v1, U16 a) {
        return (((v0 + 1) >> 1) + L::mul_signed_512(v1 - v0, a)) << 2;
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
