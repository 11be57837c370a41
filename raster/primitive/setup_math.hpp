// Small integer forms that several files of set-up use.
#pragma once

#include <cstdint>

#include "raster/numeric/reciprocal.hpp"
#include "raster/ops/number.hpp"
#include "raster/primitive/scaled_words.hpp"
#include "raster/span/draw_state.hpp"
#include "raster/span/of_tier.hpp"
#include "raster/span/vertex.hpp"

namespace spangle::raster {

/// The least and the largest of three numbers.
struct Ends {
    std::int32_t low, high;
    SPANGLE_INLINE Ends(std::int32_t a, std::int32_t b, std::int32_t c)
        : low(a < b ? a : b), high(a < b ? b : a) {
        low = c < low ? c : low;
        high = c < high ? high : c;
    }
    SPANGLE_INLINE std::uint32_t range() const {
        return static_cast<std::uint32_t>(high) - static_cast<std::uint32_t>(low);
    }
};
SPANGLE_RUN_INLINE std::uint32_t range_of(std::int32_t a, std::int32_t b, std::int32_t c) {
    return Ends(a, b, c).range();
}

/// Sets out to product 2^-(down + 1), rounded to nearest, where that is below 2^29. Returns false where it
/// may not be.
SPANGLE_INLINE bool half_below(std::int64_t product, int down, std::int32_t& out) {
    const auto n = static_cast<std::uint32_t>(down + 1);
    if (n - 3 > 28) [[unlikely]]
        return false;
    const auto sign = static_cast<std::uint32_t>(product >> 63); // halves are rounded towards 0
    const std::int64_t sum = product + ((1u << down) - sign);
    out = static_cast<std::int32_t>(numeric::low_word_after(sum, static_cast<int>(n)));
    return (static_cast<std::uint32_t>(sum >> 32) ^ sign) >> (n - 3) == 0;
}

/// z (2^bits - 1) 2^(32 - bits) of the z of a vertex, for a depth buffer of `bits` bits. 1 becomes 2^32 minus
/// one code. T is a word without sign, or a vector of such words.
template <class T> SPANGLE_INLINE T depth_code(T z, int bits) {
    return (z << 2) - (z >> (bits - 2));
}

/// A colour as a 16-bit surface stores it.
SPANGLE_INLINE std::uint32_t word565(const std::uint32_t (&color)[4]) {
    const auto to8 = [&](int i) {
        return (color[i] + (1u << (color_fraction_bits - 1))) >> color_fraction_bits;
    };
    return (to8(0) >> 3) << 11 | (to8(1) >> 2) << 5 | to8(2) >> 3;
}

/// A colour in the form that is dithered to 16 bits (DitheredWord), in the number system N of the tier.
template <class N> [[gnu::noinline]] inline std::uint32_t dithered_word(const std::uint32_t (&color)[4]) {
    return N::template steps32<5>(N::from_units(color[0])) << 21 |
           N::template steps32<6>(N::from_units(color[1])) << 10 |
           N::template steps32<5>(N::from_units(color[2]));
}

/// The colour word that Kind::flat hands to the stages.
SPANGLE_INLINE std::uint32_t flat_word(const DrawState& state, const std::uint32_t (&color)[4]) {
    if (!state.fragment.dither)
        return word565(color);
    return of_tier<has_exact_colors>(state) ? dithered_word<Exact>(color) : dithered_word<Balanced<1>>(color);
}

/// Converts a difference between two ends to a step per pixel, along the axis on which the ends lie apart.
struct PerPixel {
    std::int32_t coefficient = 0; ///< has at most 30 bits
    int exponent = 32;            ///< the coefficient counts 2^-exponent
    /// The ends are at subpixels `begin` and `end`. The coefficient is 0 where both are the same.
    SPANGLE_INLINE PerPixel(std::int32_t begin, std::int32_t end) {
        if (const std::uint32_t length = numeric::abs_u32(end - begin); length != 0)
            *this = PerPixel(numeric::reciprocal(length << numeric::clz32(length)), numeric::clz32(length),
                             end < begin);
    }
    /// Takes the reciprocal of a length with `zeros` leading zeros. `back` says that the end lies before the
    /// beginning.
    SPANGLE_INLINE PerPixel(std::uint32_t reciprocal, int zeros, bool back) {
        // 256 / length = mantissa 2^-(53 - zeros)
        const auto mantissa = static_cast<std::int32_t>(reciprocal >> 1);
        coefficient = back ? -mantissa : mantissa;
        exponent = 53 - zeros;
    }
    /// The coefficient for the way from subpixel v to the centre of its pixel.
    SPANGLE_INLINE std::int32_t to_center(std::int32_t v) const {
        return static_cast<std::int32_t>(
            numeric::mul_s32(coefficient, subpixel_one / 2 - (v & (subpixel_one - 1))) >> subpixel_bits);
    }
};

/// a * b / 2^30, rounded.
SPANGLE_INLINE std::int32_t mul30(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>((numeric::mul_long(a, b) + (1 << 29)) >> 30);
}

/// Bounds two differences: |d| <= bits, and d 2^n fits a word for n <= clz(bits). The bitwise or of several
/// bounds holds for all of their differences. 0 means that both differences are 0.
SPANGLE_INLINE std::uint32_t difference_bits(std::int32_t d1, std::int32_t d2) {
    const auto a = static_cast<std::uint32_t>(d1), b = static_cast<std::uint32_t>(d2);
    return (a ^ a << 1) | (b ^ b << 1);
}

/// A difference 2^lift times as large, for which fits_lifted() holds.
SPANGLE_INLINE std::int32_t shift_by_lift(std::int32_t d, std::uint32_t lift) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(d) << lift);
}
SPANGLE_INLINE std::uint32_t lifted_word(std::int32_t d1, std::int32_t d2, const std::int32_t (&c)[2]) {
    return static_cast<std::uint32_t>((numeric::mul_long(d1, c[0]) + numeric::mul_long(d2, c[1])) >> 32);
}

} // namespace spangle::raster
