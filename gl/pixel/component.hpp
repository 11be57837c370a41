// Components of colours and depths between client memory and the framebuffer, and the elements of client
// memory that they are read from or written to (GL 1.3, 3.6.4 and 4.3.2, tables 2.6 and 4.7). All arithmetic
// is on integers; a float is handled as its bits.
#pragma once

#include <cstdint>
#include <cstring>

#include "gl/pixel/pixel_layout.hpp"
#include "raster/numeric/real.hpp"
#include "raster/numeric/reciprocal.hpp"
#include <spangle/raster/units.hpp>

namespace spangle::gl {

/// The fraction code / (2^bits - 1), exactly, with 1 <= bits <= 32. If `bits` is 0, the component is the Real
/// whose bits are `code`. Values from floats, negative values and results of arithmetic have this form.
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

/// The nearest code of `to` bits. An odd divisor leaves no ties, so the result is exact.
constexpr std::uint32_t rescale(std::uint32_t code, unsigned from, unsigned to) {
    if (from == to)
        return code;
    const std::uint32_t divisor = all_ones(from);
    if (from <= 16 && to <= 16)
        return (code * all_ones(to) + divisor / 2) / divisor;
    return static_cast<std::uint32_t>(
        numeric::divide(std::uint64_t{code} * all_ones(to) + divisor / 2, divisor).quotient);
}

/// The nearest code of `bits` bits to the component, clamped to [0, 1].
constexpr std::uint32_t code_of(Component c, unsigned bits) {
    return c.bits != 0 ? rescale(c.code, c.bits, bits) : numeric::to_unit({c.code}, static_cast<int>(bits));
}

/// The nearest integer to `most` times the component, clamped to [0, 1].
constexpr std::uint32_t steps_of(Component c, std::uint32_t most) {
    if (c.bits == 0)
        return numeric::to_steps({c.code}, most);
    const std::uint32_t divisor = all_ones(c.bits);
    return static_cast<std::uint32_t>(
        numeric::divide(std::uint64_t{c.code} * most + divisor / 2, divisor).quotient);
}

/// The component clamped, in the rasterizer's colour units; codes of 8 bits are whole 255ths.
constexpr std::uint32_t color_units_of(Component c) {
    return c.bits == 8 ? c.code << raster::color_fraction_bits : steps_of(c, raster::color_one);
}

/// The Real nearest to the component.
constexpr Real to_real(Component c) {
    if (c.bits == 0)
        return {c.code};
    const std::uint32_t divisor = all_ones(c.bits);
    if (c.code == 0)
        return numeric::zero;
    if (c.code == divisor)
        return numeric::one;
    const int up = numeric::clz64(c.code);
    const std::uint64_t numerator =
        std::uint64_t{c.code} // The quotient has at least 31 bits, which are then rounded.
        << up;
    const numeric::Quotient q = numeric::divide(numerator, divisor);
    return numeric::pack_real(false, q.quotient << 1 | (q.remainder != 0 ? 1u : 0u), -up - 1);
}

/// Loads one element from any address, with its bytes reversed if `swap` (SWAP_BYTES) is set.
inline std::uint32_t load_element(const unsigned char* from, unsigned bytes, bool swap) {
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
    if (bytes == 1) {
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

/// Returns the component in the low `bits` bits of an element. Only in packed types are these fewer than all
/// bits. The value of the component is c / (2^b - 1), or (2c + 1) / (2^b - 1) for signed types (GL 1.3, table
/// 2.6).
constexpr Component decode_element(ElementKind kind, unsigned bits, std::uint32_t element) {
    if (kind == ElementKind::real)
        return component(numeric::from_float_bits(element));
    if (kind == ElementKind::unsigned_integer)
        return {element, static_cast<std::uint8_t>(bits)};
    // `twice` has at most `bits` bits if the element is positive.
    const std::uint32_t twice = 2 * element + 1;
    if ((element >> (bits - 1) & 1) == 0)
        return {twice, static_cast<std::uint8_t>(bits)};
    const Component magnitude{all_ones(bits) - (twice & all_ones(bits)) + 1, static_cast<std::uint8_t>(bits)};
    return component(-to_real(magnitude));
}

/// Encodes a component, clamped to [0, 1], as an element of `bits` bits (GL 1.3, table 4.7). Signed types get
/// ((2^b - 1) f - 1) / 2 to nearest, halves up.
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
