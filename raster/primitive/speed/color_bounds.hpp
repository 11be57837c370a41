// Loops over the colours of three vertices, and bounds of their differences. Each is written out for the
// states that programs usually draw with.
#pragma once

#include "raster/primitive/setup.hpp"
#include "raster/primitive/setup_math.hpp"

namespace spangle::raster {

/// Calls add(source, component, plane, projective plane) for all colour components that the state needs. In
/// this file, Rgb says that the state is DrawState::smooth_rgb.
template <bool Rgb, class F> SPANGLE_INLINE void Setup<Fixed>::each_color(F add) const {
    every_color<Rgb>(add);
}

/// A bound of the differences of colours: 0 where the three vertices have one colour. It is what
/// difference_bits() says, or twice the range of colours where they may be guessed.
template <bool Rgb> SPANGLE_INLINE std::uint32_t Setup<Fixed>::color_bits() {
    if (Rgb && state_.guesses)
        return 2 * (widest_color_range_ = color_range<Rgb>());
    std::uint32_t bits = 0;
    each_color<Rgb>([&](const ColorSource& from, int i, auto&, auto&) {
        bits |= difference_bits(from.difference(1, i), from.difference(2, i));
    });
    return bits;
}

/// Whether the range of colours whose color_bits() are `bits` is within a tolerance.
SPANGLE_INLINE bool Setup<Fixed>::colors_within_tolerance(std::uint32_t bits, std::uint32_t four) const {
    return is_within_tolerance(2 * bits, four) || is_within_tolerance(color_range<false>(), four);
}

/// A condition that implies colors_affine() and does not need weights(). A range is at most the sum of two
/// differences. q is at least 2^29 where all vertices have one exponent.
SPANGLE_INLINE bool Setup<Fixed>::nearly_affine(std::uint32_t bits) const {
    const Vertex &a = v(0), &b = v(1), &c = v(2);
    if (a.w_exponent != b.w_exponent || a.w_exponent != c.w_exponent)
        return false;
    const std::uint32_t q = a.w_mantissa >> 2;
    const auto difference = [&](const Vertex& v) {
        return numeric::abs_u32(static_cast<std::int32_t>((v.w_mantissa >> 2) - q));
    };
    return numeric::mul_high_u32(2 * bits, difference(b) + difference(c)) < state_.four_color_tolerances >> 3;
}

/// Loads 1/w of the reference vertices, scaled to the highest exponent.
SPANGLE_INLINE void Setup<Fixed>::load_weights() {
    if (v(0).w_exponent != v(1).w_exponent || v(0).w_exponent != v(2).w_exponent) [[unlikely]]
        return weights_of_several_exponents();
    for (int i = 0; i < 3; ++i) // mantissas have their top bit set
        q(i) = static_cast<std::int32_t>(v(i).w_mantissa >> 2);
}

/// Sets up the attributes of a triangle.
SPANGLE_INLINE void Setup<Fixed>::triangle_attributes(const Vertex& provoking) {
    if (state_.smooth_rgb)
        attributes_of<true>(provoking);
    else
        attributes(provoking);
}

} // namespace spangle::raster
