// Components of colours and depths on their way between client memory and the framebuffer, and the elements
// of client memory they come from and go to (GL 1.3, 3.6.4 and 4.3.2, tables 2.6 and 4.7). Integers only; a
// float is its bits.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include "gl/pixel/pixel_layout.hpp"
#include "raster/numeric/real.hpp"
#include "raster/numeric/reciprocal.hpp"
#include <spangle/raster/limits.hpp>
#include <spangle/raster/units.hpp>

namespace spangle::gl {

/// code / (2^bits - 1), exactly, 1 <= bits <= 32; or with 0 bits the Real whose bits are `code`: what came as
/// a float, or below 0, or out of arithmetic.
struct Component {
    std::uint32_t code = 0;
    std::uint8_t bits = 0;
};

constexpr Component component(Real v) {
    return {v.bits, 0};
}

constexpr std::uint32_t all_ones(unsigned bits) {
    return 0xFFFFFFFFu >> (32 - bits);
}

/// Nearest code of `to` bits. Exact: an odd divisor leaves no ties.
constexpr std::uint32_t rescale(std::uint32_t code, unsigned from, unsigned to) {
    if (from == to)
        return code;
    const std::uint32_t divisor = all_ones(from);
    if (raster::has_shortcuts && from <= 16 && to <= 16)
        return (code * all_ones(to) + divisor / 2) / divisor;
    return static_cast<std::uint32_t>(
        numeric::divide(std::uint64_t{code} * all_ones(to) + divisor / 2, divisor).quotient);
}

/// Nearest code of `bits` bits to what is left of the component in [0, 1].
constexpr std::uint32_t code_of(Component c, unsigned bits) {
    return c.bits != 0 ? rescale(c.code, c.bits, bits) : numeric::to_unit({c.code}, static_cast<int>(bits));
}

/// Nearest integer to the component, clamped, times `most`.
constexpr std::uint32_t steps_of(Component c, std::uint32_t most) {
    if (c.bits == 0)
        return numeric::to_steps({c.code}, most);
    const std::uint32_t divisor = all_ones(c.bits);
    return static_cast<std::uint32_t>(
        numeric::divide(std::uint64_t{c.code} * most + divisor / 2, divisor).quotient);
}

/// Clamped, in the rasterizer's colour units; 8 bits are whole 255ths.
constexpr std::uint32_t color_units_of(Component c) {
    return c.bits == 8 ? c.code << raster::color_fraction_bits : steps_of(c, raster::color_one);
}

/// The nearest Real.
constexpr Real to_real(Component c) {
    if (c.bits == 0)
        return {c.code};
    const std::uint32_t divisor = all_ones(c.bits);
    if (c.code == 0)
        return numeric::zero;
    if (c.code == divisor)
        return numeric::one;
    const int up = numeric::clz64(c.code);
    const std::uint64_t numerator = std::uint64_t{c.code}
                                    << up; // the quotient has 31 bits or more: enough to round
    const numeric::Quotient q = numeric::divide(numerator, divisor);
    return numeric::pack_real(false, q.quotient << 1 | (q.remainder != 0 ? 1u : 0u), -up - 1);
}

/// Where byte i of an element lies, counted from the lowest.
constexpr unsigned place_of_byte(unsigned i, unsigned bytes, bool swap) {
    return swap == (std::endian::native == std::endian::little) ? bytes - 1 - i : i;
}

/// One element as it lies in memory, bytes reversed when SWAP_BYTES says so. Any address.
inline std::uint32_t load_element(const unsigned char* from, unsigned bytes, bool swap) {
    if constexpr (!raster::has_shortcuts) {
        std::uint32_t v = 0;
        for (unsigned i = 0; i < bytes; ++i)
            v |= std::uint32_t{from[place_of_byte(i, bytes, swap)]} << 8 * i;
        return v;
    }
    if (bytes == 1)
        return *from;
    if (bytes == 2) {
        std::uint16_t v;
        std::memcpy(&v, from, 2);
        return swap ? __builtin_bswap16(v) : v;
    }
    std::uint32_t v;
    std::memcpy(&v, from, 4);
    return swap ? __builtin_bswap32(v) : v;
}

inline void store_element(unsigned char* to, unsigned bytes, bool swap, std::uint32_t value) {
    if constexpr (!raster::has_shortcuts) {
        for (unsigned i = 0; i < bytes; ++i)
            to[place_of_byte(i, bytes, swap)] = static_cast<unsigned char>(value >> 8 * i);
    } else if (bytes == 1) {
        *to = static_cast<unsigned char>(value);
    } else if (bytes == 2) {
        auto v = static_cast<std::uint16_t>(value);
        if (swap)
            v = __builtin_bswap16(v);
        std::memcpy(to, &v, 2);
    } else {
        const std::uint32_t v = swap ? __builtin_bswap32(value) : value;
        std::memcpy(to, &v, 4);
    }
}

/// The component in an element of which it takes `bits` bits, all of them unless the type is packed: c / (2^b
/// - 1), or (2c + 1) / (2^b - 1) where there are signs (GL 1.3, table 2.6).
constexpr Component decode_element(ElementKind kind, unsigned bits, std::uint32_t element) {
    if (kind == ElementKind::real)
        return component(numeric::from_float_bits(element));
    if (kind == ElementKind::unsigned_integer)
        return {element, static_cast<std::uint8_t>(bits)};
    const std::uint32_t twice = 2 * element + 1; // of a positive element; it still has `bits` bits
    if ((element >> (bits - 1) & 1) == 0)
        return {twice, static_cast<std::uint8_t>(bits)};
    const Component magnitude{all_ones(bits) - (twice & all_ones(bits)) + 1, static_cast<std::uint8_t>(bits)};
    return component(-to_real(magnitude));
}

/// The reverse, clamped to [0, 1] (table 4.7). Signed: ((2^b - 1) f - 1) / 2 to nearest, halves up.
constexpr std::uint32_t encode_element(ElementKind kind, unsigned bits, Component c) {
    if (kind == ElementKind::real)
        return numeric::to_float_bits(numeric::clamp01(to_real(c)));
    if (kind != ElementKind::signed_integer)
        return code_of(c, bits);
    if (c.bits == 0)
        return static_cast<std::uint32_t>(numeric::to_half_steps({c.code}, all_ones(bits)) >> 2);
    return static_cast<std::uint32_t>(
        numeric::divide(std::uint64_t{c.code} * all_ones(bits) / 2, all_ones(c.bits)).quotient);
}

} // namespace spangle::gl
