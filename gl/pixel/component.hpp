// Components in [0, 1] as exact fractions, and the elements of client memory they come from and go to
// (GL 1.3, 3.6.4 and 4.3.2, tables 2.6 and 4.7). Integers only; a float is its bits.
#pragma once

#include <cstdint>
#include <cstring>

#include "gl/pixel/pixel_layout.hpp"
#include "raster/numeric/real.hpp"

namespace spangle::gl {

/// code / (2^bits - 1), 1 <= bits <= 32.
struct Component {
    std::uint32_t code = 0;
    std::uint8_t bits = 8;
};

constexpr std::uint32_t all_ones(unsigned bits) {
    return 0xFFFFFFFFu >> (32 - bits);
}

/// Nearest code of `to` bits. Exact: an odd divisor leaves no ties.
constexpr std::uint32_t rescale(std::uint32_t code, unsigned from, unsigned to) {
    if (from == to)
        return code;
    const std::uint32_t divisor = all_ones(from);
    if (from <= 16 && to <= 16)
        return (code * all_ones(to) + divisor / 2) / divisor;
    return static_cast<std::uint32_t>((std::uint64_t{code} * all_ones(to) + divisor / 2) / divisor);
}

/// The nearest Real.
constexpr Real to_real(Component c) {
    const std::uint32_t divisor = all_ones(c.bits);
    if (c.code == 0)
        return numeric::zero;
    if (c.code == divisor)
        return numeric::one;
    const int up = numeric::clz64(c.code);
    const std::uint64_t numerator = std::uint64_t{c.code}
                                    << up; // the quotient has 31 bits or more: enough to round
    const std::uint64_t quotient = numerator / divisor;
    const std::uint64_t sticky = quotient * divisor != numerator ? 1u : 0u;
    return numeric::pack_real(false, quotient << 1 | sticky, -up - 1);
}

/// One element as it lies in memory, bytes reversed when SWAP_BYTES says so. Any address.
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

/// Component of an element that holds nothing else, clamped to [0, 1], as a code of `bits` bits.
constexpr std::uint32_t decode_element(ElementKind kind, unsigned element_bits, std::uint32_t element,
                                       unsigned bits) {
    if (kind == ElementKind::real)
        return numeric::to_unit(numeric::from_float_bits(element), static_cast<int>(bits));
    if (kind ==
        ElementKind::signed_integer) { // (2c + 1) / (2^b - 1): the code of the positive half is 2c + 1
        if ((element >> (element_bits - 1) & 1) != 0)
            return 0;
        element = 2 * element + 1;
    }
    return rescale(element, element_bits, bits);
}

/// The reverse, table 4.7. Signed: ((2^b - 1) f - 1) / 2 to nearest, halves up.
constexpr std::uint32_t encode_element(ElementKind kind, unsigned element_bits, Component c) {
    if (kind == ElementKind::real)
        return numeric::to_float_bits(to_real(c));
    if (kind == ElementKind::signed_integer)
        return static_cast<std::uint32_t>(std::uint64_t{c.code} * all_ones(element_bits) /
                                          (2 * std::uint64_t{all_ones(c.bits)}));
    return rescale(c.code, c.bits, element_bits);
}

} // namespace spangle::gl
