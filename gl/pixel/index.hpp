// Colour and stencil indices between client memory and the framebuffer, as numbers with 16 fraction bits,
// modulo 2^48 (GL 1.3, 3.6.4: "fixed-point ... with an unspecified number of bits to the right of the binary
// point").
#pragma once

#include <cstdint>

#include "gl/pixel/pixel_layout.hpp"
#include "raster/numeric/real.hpp"
#include <spangle/raster/units.hpp>

namespace spangle::gl {

struct Index {
    std::uint64_t bits = 0;
};

inline constexpr int index_fraction_bits = 16, index_bits = 48;
inline constexpr std::uint64_t index_mask = (std::uint64_t{1} << index_bits) - 1;

constexpr Index whole_index(std::int64_t v) {
    return {static_cast<std::uint64_t>(v) << index_fraction_bits & index_mask};
}

/// Returns the index nearest to v. A value that needs more bits becomes the index with the largest magnitude
/// and the same sign.
constexpr Index index_of(numeric::Real v) {
    const numeric::detail::Unpacked u = numeric::detail::unpack(v);
    const std::int32_t up = u.exponent + index_fraction_bits;
    const std::uint64_t magnitude = up > index_bits - 24 ? (u.mantissa != 0 ? index_mask >> 1 : 0)
                                                         : numeric::shift_right_even(u.mantissa, -up);
    return {(u.negative ? 0 - magnitude : magnitude) & index_mask};
}

/// An index in the rasterizer's units, with 20 fraction bits. The integer part is masked to `bits` bits (GL
/// 1.3, 2.13.6, 3.6.4, 3.10, 4.2.3).
constexpr std::uint32_t index_units(numeric::Real v, unsigned bits) {
    const numeric::detail::Unpacked u = numeric::detail::unpack(v);
    const std::int32_t up = u.exponent + raster::color_fraction_bits;
    const std::uint64_t magnitude = up >= 32 ? 0 : numeric::shift_right_even(u.mantissa, -up);
    return static_cast<std::uint32_t>(u.negative ? 0 - magnitude : magnitude) &
           ((1u << (bits + raster::color_fraction_bits)) - 1);
}
constexpr std::uint32_t index_units(Index index, unsigned bits) {
    return static_cast<std::uint32_t>(index.bits << (raster::color_fraction_bits - index_fraction_bits)) &
           ((1u << (bits + raster::color_fraction_bits)) - 1);
}

/// The index in an element of `bits` bits.
constexpr Index decode_index(ElementKind kind, unsigned bits, std::uint32_t element) {
    if (kind == ElementKind::real)
        return index_of(numeric::from_float_bits(element));
    const bool negative = kind == ElementKind::signed_integer && (element >> (bits - 1) & 1) != 0;
    return whole_index(static_cast<std::int64_t>(element) - (negative ? std::int64_t{1} << bits : 0));
}

/// Shifts an index left by `shift` bits, or right by -`shift` bits if that is negative, filling with zeros;
/// then adds `offset` (GL 1.3, 3.6.5).
constexpr Index shifted(Index index, std::int32_t shift, std::int32_t offset) {
    const std::uint64_t moved = shift >= index_bits || shift <= -index_bits ? 0
                                : shift >= 0                                ? index.bits << shift
                                                                            : index.bits >> -shift;
    return {(moved + whole_index(offset).bits) & index_mask};
}

/// The nearest integer to an index, modulo 2^32.
constexpr std::uint32_t rounded(Index index) {
    return static_cast<std::uint32_t>((index.bits + (1u << (index_fraction_bits - 1))) >>
                                      index_fraction_bits);
}

/// Returns an index as a Real. Indices in the upper half of the range stand for negative numbers.
constexpr numeric::Real to_real(Index index) {
    return numeric::from_fixed(
        static_cast<std::int64_t>(index.bits << (64 - index_bits)) >> (64 - index_bits), index_fraction_bits);
}

} // namespace spangle::gl
