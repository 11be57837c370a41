// A scalar of GL's API: the 32 bits of a float, with arithmetic in integers only. Conversions and arithmetic
// round to nearest even. NaN is read as 0. Infinities and overflow become the largest finite value, because
// no input may do harm (GL 1.3, 2.1.1).
#pragma once

#include <cstdint>

#include "raster/numeric/bits.hpp"

namespace spangle::numeric {

/// A real number, as the bits of a float. It is always finite: every function below keeps it so. Denormals
/// and -0 are kept.
struct Real {
    std::uint32_t bits = 0;
};

inline constexpr Real zero{0};
inline constexpr Real one{0x3F800000};     // exponent 0 by the bias of 127
inline constexpr Real largest{0x7F7FFFFF}; // (2 - 2^-23) 2^127

namespace detail {

/// |v| = mantissa * 2^exponent; mantissa < 2^24.
struct Unpacked {
    std::uint32_t mantissa;
    std::int32_t exponent;
    bool negative;
};

SPANGLE_INLINE constexpr Unpacked unpack(Real v) {
    const std::uint32_t biased = (v.bits >> 23) & 0xFF;
    const std::uint32_t fraction = v.bits & 0x7FFFFF;
    return {biased == 0 ? fraction : fraction | 0x800000,
            static_cast<std::int32_t>(biased == 0 ? 1 : biased) - 150, (v.bits >> 31) != 0};
}

} // namespace detail

/// The Real nearest to +-magnitude * 2^exponent. In a magnitude of 26 bits or more, the lowest bit may stand
/// for all lost bits (sticky).
constexpr Real pack_real(bool negative, std::uint64_t magnitude, std::int32_t exponent) {
    const std::uint32_t sign = negative ? 0x80000000u : 0u;
    if (magnitude == 0)
        return {sign};
    const int zeros = clz64(magnitude);
    const std::int32_t top = exponent + 63 - zeros; // 2^top <= |v| < 2^(top+1)
    if (top > 127)
        return {sign | largest.bits};
    const std::int32_t least = top < -126 ? -149 : top - 23; // exponent of the result's last bit
    const std::uint64_t mantissa = shift_right_even(magnitude << zeros, least - (exponent - zeros));
    // A normal mantissa adds 1 to the exponent field, and a carry out of the mantissa adds one more.
    const std::uint32_t bits =
        (static_cast<std::uint32_t>(least + 149) << 23) + static_cast<std::uint32_t>(mantissa);
    return {sign | (bits > largest.bits ? largest.bits : bits)};
}

// --- entry
// ---------------------------------------------------------------------------------------------------------

constexpr Real from_float_bits(std::uint32_t bits) {
    const std::uint32_t magnitude = bits & 0x7FFFFFFF;
    if (magnitude > 0x7F800000)
        return zero;
    return {magnitude == 0x7F800000 ? (bits & 0x80000000) | largest.bits : bits};
}

constexpr Real from_double_bits(std::uint64_t bits) {
    const bool negative = (bits >> 63) != 0;
    const auto biased = static_cast<std::int32_t>((bits >> 52) & 0x7FF);
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
    if (biased == 0x7FF)
        return fraction != 0 ? zero : Real{(negative ? 0x80000000u : 0u) | largest.bits};
    return pack_real(negative, biased == 0 ? fraction : fraction | std::uint64_t{1} << 52,
                     (biased == 0 ? 1 : biased) - 1075);
}

/// Takes the bits of a float, which is only moved between registers.
constexpr Real from_float(float v) {
    return from_float_bits(std::bit_cast<std::uint32_t>(v));
}
constexpr Real from_double(double v) {
    return from_double_bits(std::bit_cast<std::uint64_t>(v));
}

constexpr Real from_u32(std::uint32_t v) {
    return pack_real(false, v, 0);
}
constexpr Real from_i32(std::int32_t v) {
    const std::uint32_t magnitude = abs_u32(v);
    if (!runs_inline || magnitude - 1 >= (1u << 24) - 1) // what follows is a faster way for small numbers
        return pack_real(v < 0, magnitude, 0);
    const int zeros = clz32(magnitude); // 8 .. 31: all of its bits fit the mantissa, so nothing is rounded
    // The mantissa's top bit adds 1 to the exponent field, so the field begins one too low.
    const std::uint32_t exponent = static_cast<std::uint32_t>(157 - zeros) << 23;
    return {(static_cast<std::uint32_t>(v) & 0x80000000u) + exponent + (magnitude << (zeros - 8))};
}
/// v / 2^fraction_bits.
constexpr Real from_fixed(std::int64_t v, int fraction_bits) {
    return pack_real(v < 0, abs_u64(v), -fraction_bits);
}
/// v / 2^16: GLfixed is S15.16.
constexpr Real from_fixed16(std::int32_t v) {
    return from_fixed(v, 16);
}

namespace detail {

/// The Real nearest to +-c / (2^bits - 1), 0 <= c <= 2^bits - 1; `bits` is 8, 16 or 32. The quotient is c
/// repeated for ever. So one word of it with a sticky bit rounds correctly, and all ones round to 1.
constexpr Real unit_fraction(bool negative, std::uint32_t c, int bits) {
    const std::uint64_t ones = bits == 8    ? 0x0101010101010101 // (2^64 - 1) / (2^bits - 1)
                               : bits == 16 ? 0x0001000100010001
                                            : 0x0000000100000001,
                        repeated = c * ones;
    return pack_real(negative && c != 0, c == 0 ? 0 : repeated | 1, -64);
}

constexpr Real signed_unit(std::int32_t c, int bits) {
    const std::int64_t v = 2 * std::int64_t{c} + 1;
    return unit_fraction(v < 0, static_cast<std::uint32_t>(abs_u64(v)), bits);
}

} // namespace detail

/// Components from integers (GL 1.3, table 2.6): c / (2^b - 1) and (2c + 1) / (2^b - 1).
constexpr Real normalized_ubyte(std::uint8_t c) {
    return detail::unit_fraction(false, c, 8);
}
constexpr Real normalized_ushort(std::uint16_t c) {
    return detail::unit_fraction(false, c, 16);
}
constexpr Real normalized_uint(std::uint32_t c) {
    return detail::unit_fraction(false, c, 32);
}
constexpr Real normalized_byte(std::int8_t c) {
    return detail::signed_unit(c, 8);
}
constexpr Real normalized_short(std::int16_t c) {
    return detail::signed_unit(c, 16);
}
constexpr Real normalized_int(std::int32_t c) {
    return detail::signed_unit(c, 32);
}
/// Components from integers of 8, 16 or 32 bits.
constexpr Real normalized_unsigned(std::uint32_t c, int bits) {
    return detail::unit_fraction(false, c, bits);
}
constexpr Real normalized_signed(std::int32_t c, int bits) {
    return detail::signed_unit(c, bits);
}

// --- order
// ---------------------------------------------------------------------------------------------------------

constexpr bool is_zero(Real v) {
    return (v.bits << 1) == 0;
}
constexpr bool is_negative(Real v) {
    return (v.bits >> 31) != 0 && !is_zero(v);
}
constexpr bool to_bool(Real v) {
    return !is_zero(v);
}

namespace detail {
/// Integers in the order of the values. +0 and -0 become equal.
constexpr std::int32_t order(Real v) {
    const auto magnitude = static_cast<std::int32_t>(v.bits & 0x7FFFFFFF);
    return (v.bits >> 31) != 0 ? -magnitude : magnitude;
}
} // namespace detail

constexpr bool operator==(Real a, Real b) {
    return detail::order(a) == detail::order(b);
}
constexpr bool operator<(Real a, Real b) {
    return detail::order(a) < detail::order(b);
}
constexpr bool operator>(Real a, Real b) {
    return b < a;
}
constexpr bool operator<=(Real a, Real b) {
    return !(b < a);
}
constexpr bool operator>=(Real a, Real b) {
    return !(a < b);
}

constexpr Real operator-(Real v) {
    return {v.bits ^ 0x80000000};
}
constexpr Real abs(Real v) {
    return {v.bits & 0x7FFFFFFF};
}
constexpr Real clamp01(Real v) {
    return v < zero ? zero : one < v ? one : v;
}

// --- arithmetic: IEEE 754 results, overflow to the largest finite value
// ------------------------------------------------

constexpr Real add(Real a, Real b) {
    if (detail::order(abs(a)) < detail::order(abs(b))) {
        const Real larger = b;
        b = a;
        a = larger;
    }
    const detail::Unpacked x = detail::unpack(a), y = detail::unpack(b);
    constexpr int guard = 38; // 24 + 38 bits leave one bit for the carry; lost bits are sticky
    const std::uint64_t large = std::uint64_t{x.mantissa} << guard;
    const std::uint64_t small =
        shift_right_sticky(std::uint64_t{y.mantissa} << guard, x.exponent - y.exponent);
    const std::uint64_t sum = x.negative == y.negative ? large + small : large - small;
    // x - x is +0 in round to nearest, and -0 + -0 is -0.
    const bool negative = sum == 0 ? x.negative && y.negative : x.negative;
    return pack_real(negative, sum, x.exponent - guard);
}

constexpr Real sub(Real a, Real b) {
    return add(a, -b);
}

constexpr Real mul(Real a, Real b) {
    const detail::Unpacked x = detail::unpack(a), y = detail::unpack(b);
    return pack_real(x.negative != y.negative, mul_u32(x.mantissa, y.mantissa), x.exponent + y.exponent);
}

/// a / b. v / 0 is the largest finite value with the sign of v, and 0 / 0 is 0.
constexpr Real div(Real a, Real b) {
    const detail::Unpacked x = detail::unpack(a), y = detail::unpack(b);
    const bool negative = x.negative != y.negative;
    if (x.mantissa == 0)
        return {negative ? 0x80000000u : 0u};
    if (y.mantissa == 0)
        return {(negative ? 0x80000000u : 0u) | largest.bits};
    const int up_x = clz32(x.mantissa), up_y = clz32(y.mantissa);
    // `rest` is in [2^30, 2^31), as is the divisor, so doubling fits.
    std::uint32_t rest = x.mantissa << up_x >> 1;
    const std::uint32_t divisor = y.mantissa << up_y >> 1;
    std::uint32_t quotient = 0;
    for (int i = 0; i < 27; ++i) { // one bit of the quotient at a time, in 32-bit words
        const bool bit = rest >= divisor;
        quotient = quotient << 1 | (bit ? 1u : 0u);
        rest = (bit ? rest - divisor : rest) << 1;
    }
    return pack_real(negative, quotient << 1 | (rest != 0 ? 1u : 0u),
                     x.exponent - up_x - y.exponent + up_y - 27);
}

// --- exit
// ----------------------------------------------------------------------------------------------------------

constexpr std::uint32_t to_float_bits(Real v) {
    return v.bits;
}
constexpr float to_float(Real v) {
    return std::bit_cast<float>(v.bits);
}

constexpr std::uint64_t to_double_bits(Real v) {
    const detail::Unpacked u = detail::unpack(v);
    const std::uint64_t sign = std::uint64_t{v.bits >> 31} << 63;
    if (u.mantissa == 0)
        return sign;
    // Shifts the mantissa to 24 bits, so that denormals become normal doubles.
    const int up = clz32(u.mantissa) - 8;
    const std::uint64_t fraction = std::uint64_t{(u.mantissa << up) & 0x7FFFFF} << 29;
    return sign | static_cast<std::uint64_t>(u.exponent - up + 23 + 1023) << 52 | fraction;
}
constexpr double to_double(Real v) {
    return std::bit_cast<double>(to_double_bits(v));
}

namespace detail {
SPANGLE_RUN_CALL constexpr std::int32_t with_sign(bool negative, std::uint64_t magnitude) {
    constexpr std::uint64_t limit = 0x80000000u;
    if (negative)
        return static_cast<std::int32_t>(-static_cast<std::int64_t>(magnitude > limit ? limit : magnitude));
    return static_cast<std::int32_t>(magnitude >= limit ? limit - 1 : magnitude);
}
} // namespace detail

/// v * 2^fraction_bits, rounded to nearest even and saturated (D3D11.3 functional specification, 3.2.4.1,
/// floats to fixed).
constexpr std::int32_t to_fixed(Real v, int fraction_bits) {
    const detail::Unpacked u = detail::unpack(v);
    const std::int32_t shift = u.exponent + fraction_bits;
    if (shift > 31)
        return detail::with_sign(u.negative, u.mantissa == 0 ? 0 : ~std::uint64_t{0});
    return detail::with_sign(u.negative, runs_inline && shift >= 0 ? std::uint64_t{u.mantissa} << shift
                                                                   : shift_right_even(u.mantissa, -shift));
}
constexpr std::int32_t to_fixed16(Real v) {
    return to_fixed(v, 16);
}

/// The nearest integer, halves away from zero, saturated. GetIntegerv of a float returns it (GL 1.3, 6.1.2).
constexpr std::int32_t to_i32_round(Real v) {
    const detail::Unpacked u = detail::unpack(v);
    if (u.exponent > 31)
        return detail::with_sign(u.negative, u.mantissa == 0 ? 0 : ~std::uint64_t{0});
    const std::int64_t rounded = shift_right_round(std::int64_t{u.mantissa}, -u.exponent);
    return detail::with_sign(u.negative, static_cast<std::uint64_t>(rounded));
}

/// floor(clamp01(v) * most * 2), most < 2^32. It has one bit more than to_steps() returns, for rounding.
constexpr std::uint64_t to_half_steps(Real v, std::uint32_t most) {
    const detail::Unpacked u = detail::unpack(clamp01(v));
    const std::int32_t drop = -u.exponent; // `drop` is 23 or more, because |v| <= 1
    return static_cast<std::uint64_t>(
        times_two_to(static_cast<std::int64_t>(u.mantissa * std::uint64_t{most}), 1 - drop));
}

/// The integer nearest to clamp01(v) * most, halves up.
constexpr std::uint32_t to_steps(Real v, std::uint32_t most) {
    return static_cast<std::uint32_t>((to_half_steps(v, most) + 1) >> 1);
}

/// The integer nearest to clamp01(v) * (2^bits - 1), bits <= 32, halves up (GL 1.3, 2.13.9 and 2.10.1).
constexpr std::uint32_t to_unit(Real v, int bits) {
    return to_steps(v, static_cast<std::uint32_t>((std::uint64_t{1} << bits) - 1));
}

/// A colour, normal or depth range as an integer: ((2^32 - 1) v - 1) / 2, where v is clamped to [-1, 1] (GL
/// 1.3, table 4.7).
constexpr std::int32_t to_normalized_int(Real v) {
    const bool negative = (v.bits >> 31) != 0;
    const std::uint32_t magnitude = v.bits & 0x7FFFFFFF;
    const detail::Unpacked u = detail::unpack({magnitude < one.bits ? magnitude : one.bits});
    const std::int32_t drop = 1 - u.exponent; // >= 24
    // ((2^32 - 1) v - 1) / 2 rounded to nearest, halves up, is floor((2^32 - 1) v / 2).
    // The product has at most 56 bits.
    const auto product = static_cast<std::int64_t>(u.mantissa * std::uint64_t{0xFFFFFFFF});
    const std::int64_t below = (product - (negative ? 1 : 0)) >> (drop < 63 ? drop : 63);
    return static_cast<std::int32_t>(negative ? ~below : below);
}

} // namespace spangle::numeric
