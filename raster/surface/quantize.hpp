// Rounds colours to stored bits, with and without dithering (docs/architecture/numbers.md, "Colours").
#pragma once

#include <cstdint>

#include <spangle/dither.hpp>

#include "raster/surface/units.hpp"

namespace spangle::raster {

/// Rounds to 8 bits (GL 1.3, 2.13.9 with m = 8). `c` is in colour units, 0 .. color_one.
constexpr std::uint32_t color_to_8(std::uint32_t c) {
    return (c + (1u << (color_fraction_bits - 1))) >> color_fraction_bits;
}

/// The stored component without dithering: the top bits of the 8-bit value (GL 1.3, 4.1.8; 2.13.9 asks for
/// the top m bits).
template <unsigned Bits> constexpr std::uint32_t truncated(std::uint32_t c) {
    return color_to_8(c) >> (8 - Bits);
}

/// Converts colour units to steps of a component of `Bits` bits, with 23 fraction bits: c (2^Bits - 1).
/// Colours of whole steps are never rounded down. The factor is rounded up by less than 1, so the result is
/// at most 2^-4 of its last bit too large.
template <unsigned Bits> constexpr std::uint32_t color_to_steps(std::uint32_t c) {
    static_assert(Bits == 5 || Bits == 6);
    // (2^Bits - 1) / 255 * 2^(32 + 23 - 20), halved for six bits so that it stays below 2^32.
    constexpr std::uint64_t scaled = ((1ull << Bits) - 1) << (Bits == 5 ? 35 : 34);
    constexpr std::uint32_t factor = static_cast<std::uint32_t>((scaled + 254) / 255);
    return static_cast<std::uint32_t>((static_cast<std::uint64_t>(c) * factor) >> (Bits == 5 ? 32 : 31));
}

/// The stored component with dithering: floor(c (2^Bits - 1) + t). Colours of whole steps do not change,
/// because t is 1/32 .. 31/32.
template <unsigned Bits> constexpr std::uint32_t dithered(std::uint32_t c, std::uint32_t threshold) {
    return (color_to_steps<Bits>(c) + (threshold << 18)) >> 23;
}

/// Components of eight bits are the rounded value itself. Dithering changes nothing.
template <> constexpr std::uint32_t dithered<8>(std::uint32_t c, std::uint32_t) {
    return color_to_8(c);
}

/// A colour index with 20 fraction bits, as a surface of 8-bit indices stores it. It is the nearest index, or
/// with dithering one of its two neighbours (GL 1.3, 4.1.8). Larger indices are stored as 255.
constexpr std::uint32_t stored_index(std::uint32_t index, bool dither, std::uint32_t threshold) {
    const std::uint32_t c = index < color_one ? index : color_one;
    return dither ? (c + (threshold << (color_fraction_bits - 5))) >> color_fraction_bits : color_to_8(c);
}

/// A component as a format of `bits` bits stores it.
constexpr std::uint32_t stored_component(std::uint32_t c, unsigned bits, bool dither,
                                         std::uint32_t threshold) {
    if (bits == 8)
        return color_to_8(c);
    if (bits == 5)
        return dither ? dithered<5>(c, threshold) : truncated<5>(c);
    return dither ? dithered<6>(c, threshold) : truncated<6>(c);
}

} // namespace spangle::raster
