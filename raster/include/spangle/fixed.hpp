// A fixed-point scalar for programs without floating point: S15.16, with the bits of GLfixed. All arithmetic
// is in integers. Results round to nearest and saturate at the ends of the range. spangle/glm.hpp makes it a
// component type of GLM.
#pragma once

#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

namespace spangle {

/// A number of value bits / 65536 in [-32768, 32768). It is uninitialised by default, like the built-in
/// types, because GLM's unions need this.
struct fixed {
    /// The value times 65536.
    std::int32_t bits;

    /// Bits behind the binary point.
    static constexpr int fraction_bits = 16;
    /// The bits of 1.
    static constexpr std::int32_t one_bits = 1 << fraction_bits;

    /// Makes an undefined value, as of a variable of type int.
    fixed() = default;
    /// Makes the value of an integer, saturated.
    template <class I, std::enable_if_t<std::is_integral_v<I>, int> = 0>
    constexpr fixed(I v)
        : bits(std::cmp_greater(v, 32767) ? INT32_MAX
               : std::cmp_less(v, -32768) ? INT32_MIN
                                          : static_cast<std::int32_t>(v) * one_bits) {}
    /// Makes the nearest value of a floating-point number; NaN becomes 0. The compiler converts constants.
    template <class F, std::enable_if_t<std::is_floating_point_v<F>, long> = 0>
    constexpr fixed(F v) : bits(from_real(v)) {}

    /// The value b / 65536.
    static constexpr fixed from_bits(std::int32_t b) {
        fixed r{0};
        r.bits = b;
        return r;
    }
    /// The nearest value that 32 bits hold.
    static constexpr std::int32_t saturate(std::int64_t v) {
        return static_cast<std::int32_t>(v > INT32_MAX ? INT32_MAX : v < INT32_MIN ? INT32_MIN : v);
    }
    /// A sum of products, 32 fraction bits, as a fixed.
    static constexpr fixed from_product(std::int64_t v) {
        return from_bits(saturate((v >> 16) + ((v >> 15) & 1)));
    }

    /// Conversions to integers truncate towards zero, as those of the built-in types do.
    template <class I, std::enable_if_t<std::is_integral_v<I>, int> = 0>
    explicit constexpr operator I() const {
        return static_cast<I>(bits / one_bits);
    }
    /// The nearest float, which has 24 of the 32 bits.
    explicit constexpr operator float() const { return static_cast<float>(bits) / 65536.0f; }
    /// Converts the number to a double, which holds it exactly.
    explicit constexpr operator double() const { return static_cast<double>(bits) / 65536.0; }

    /// The sum, saturated.
    friend constexpr fixed operator+(fixed a, fixed b) {
        return from_bits(saturate(std::int64_t{a.bits} + b.bits));
    }
    /// The difference, saturated.
    friend constexpr fixed operator-(fixed a, fixed b) {
        return from_bits(saturate(std::int64_t{a.bits} - b.bits));
    }
    /// The product, rounded to nearest and saturated.
    friend constexpr fixed operator*(fixed a, fixed b) { return from_product(std::int64_t{a.bits} * b.bits); }
    /// Division by 0 gives the largest value with the sign of a, and 0 / 0 gives 0.
    friend constexpr fixed operator/(fixed a, fixed b) {
        return from_bits(quotient(std::int64_t{a.bits} * one_bits, b.bits));
    }
    /// The negative; that of the least value is the largest one.
    friend constexpr fixed operator-(fixed a) { return from_bits(saturate(-std::int64_t{a.bits})); }
    /// The value itself.
    friend constexpr fixed operator+(fixed a) { return a; }
    /// Adds, saturated.
    constexpr fixed& operator+=(fixed b) { return *this = *this + b; }
    /// Subtracts, saturated.
    constexpr fixed& operator-=(fixed b) { return *this = *this - b; }
    /// Multiplies, rounded and saturated.
    constexpr fixed& operator*=(fixed b) { return *this = *this * b; }
    /// Divides, rounded and saturated; see operator/().
    constexpr fixed& operator/=(fixed b) { return *this = *this / b; }
    /// Adds 1, saturated.
    constexpr fixed& operator++() { return *this += fixed{1}; }
    /// Subtracts 1, saturated.
    constexpr fixed& operator--() { return *this -= fixed{1}; }

    /// Whether both are equal. The order of values is that of their bits.
    friend constexpr bool operator==(fixed a, fixed b) { return a.bits == b.bits; }
    /// Whether both values differ.
    friend constexpr bool operator!=(fixed a, fixed b) { return a.bits != b.bits; }
    /// Whether `a` is less than `b`.
    friend constexpr bool operator<(fixed a, fixed b) { return a.bits < b.bits; }
    /// Whether `a` is larger than `b`.
    friend constexpr bool operator>(fixed a, fixed b) { return a.bits > b.bits; }
    /// Whether `a` is at most `b`.
    friend constexpr bool operator<=(fixed a, fixed b) { return a.bits <= b.bits; }
    /// Whether `a` is at least `b`.
    friend constexpr bool operator>=(fixed a, fixed b) { return a.bits >= b.bits; }

    /// n / d, rounded to nearest and saturated; |n| < 2^62.
    static constexpr std::int32_t quotient(std::int64_t n, std::int64_t d) {
        if (d == 0)
            return n == 0 ? 0 : n < 0 ? INT32_MIN : INT32_MAX;
        const std::int64_t half = (d < 0 ? -d : d) / 2;
        return saturate((n < 0 ? n - half : n + half) / d);
    }

  private:
    template <class F> static constexpr std::int32_t from_real(F v) {
        if (!(v == v))
            return 0;
        if (v >= F(32768))
            return INT32_MAX;
        if (v <= F(-32768))
            return INT32_MIN;
        const F scaled = v * F(65536);
        return static_cast<std::int32_t>(scaled < 0 ? static_cast<std::int64_t>(scaled - F(0.5))
                                                    : static_cast<std::int64_t>(scaled + F(0.5)));
    }
};

static_assert(std::is_trivially_default_constructible_v<fixed> && sizeof(fixed) == 4);

namespace fixed_detail {

/// Largest x with x * x <= v.
constexpr std::uint32_t integer_sqrt(std::uint64_t v) {
    std::uint32_t root = 0;
    for (std::uint32_t bit = 0x80000000u; bit != 0; bit >>= 1)
        if (std::uint64_t{root | bit} * (root | bit) <= v)
            root |= bit;
    return root;
}

inline constexpr std::int64_t pi_q30 = 3373259426;          // pi * 2^30
inline constexpr std::int64_t two_pi_q44 = 110534964875444; // 2 pi * 2^44
inline constexpr int cordic_steps = 30;
inline constexpr std::int64_t cordic_gain_q30 = 652032874; // product of cos(atan(2^-i))

/// atan(2^-i) in Q.30, by its series: every power of 2^-i is a shift.
struct Arctangents {
    std::int64_t at[cordic_steps];
    constexpr Arctangents() : at{} {
        at[0] = pi_q30 / 4;
        for (int i = 1; i < cordic_steps; ++i) {
            std::int64_t sum = 0;
            for (int k = 0; i * (2 * k + 1) < 60; ++k) {
                const std::int64_t term = (std::int64_t{1} << (60 - i * (2 * k + 1))) / (2 * k + 1);
                sum += k % 2 == 0 ? term : -term;
            }
            at[i] = (sum + (1 << 29)) >> 30;
        }
    }
};
inline constexpr Arctangents arctangents;

struct Point {
    std::int64_t x, y; ///< both in Q.30
};

/// (cos, sin) of radians with 16 fraction bits; within 2^-26.
constexpr Point circle(std::int32_t radians) {
    std::int64_t turned = (std::int64_t{radians} << 28) % two_pi_q44;
    if (turned < 0)
        turned += two_pi_q44;
    std::int64_t a = (turned + (1 << 13)) >> 14; // [0, 2 pi] in Q.30
    int quarters = 0;
    while (a > pi_q30 / 4 && quarters < 4)
        a -= pi_q30 / 2, ++quarters;
    Point p{cordic_gain_q30, 0};
    for (int i = 0; i < cordic_steps; ++i) {
        const bool up = a >= 0;
        const std::int64_t x = p.x >> i, y = p.y >> i;
        p = up ? Point{p.x - y, p.y + x} : Point{p.x + y, p.y - x};
        a += up ? -arctangents.at[i] : arctangents.at[i];
    }
    switch (quarters & 3) {
    case 1:
        return {-p.y, p.x};
    case 2:
        return {-p.x, -p.y};
    case 3:
        return {p.y, -p.x};
    default:
        return p;
    }
}

/// Angle of (x, y) in Q.30, (-pi, pi]; |x|, |y| <= 2^60.
constexpr std::int64_t angle(std::int64_t y, std::int64_t x) {
    if (x == 0 && y == 0)
        return 0;
    std::int64_t a = 0;
    if (x < 0) { // adds half a turn, so that x becomes positive
        a = y < 0 ? -pi_q30 : pi_q30;
        x = -x, y = -y;
    }
    while (x < (std::int64_t{1} << 58) && y < (std::int64_t{1} << 58) && y > -(std::int64_t{1} << 58))
        x *= 2, y *= 2;
    for (int i = 0; i < cordic_steps; ++i) {
        const bool up = y < 0;
        const std::int64_t dx = x >> i, dy = y >> i;
        x += up ? -dy : dy;
        y += up ? dx : -dx;
        a += up ? -arctangents.at[i] : arctangents.at[i];
    }
    return a;
}

constexpr fixed from_q30(std::int64_t v) {
    return fixed::from_bits(fixed::saturate((v + (1 << 13)) >> 14));
}

} // namespace fixed_detail

/// The absolute value; that of the least value is the largest one.
constexpr fixed abs(fixed v) {
    return v.bits < 0 ? -v : v;
}
/// The largest integer that is at most v.
constexpr fixed floor(fixed v) {
    return fixed::from_bits(static_cast<std::int32_t>(static_cast<std::uint32_t>(v.bits) & 0xFFFF0000u));
}
/// The least integer that is at least v, saturated.
constexpr fixed ceil(fixed v) {
    return -floor(-v);
}
/// The integer part, towards zero.
constexpr fixed trunc(fixed v) {
    return v.bits < 0 ? ceil(v) : floor(v);
}
/// The nearest integer.
constexpr fixed round(fixed v) {
    return v.bits < 0 ? -floor(-v + fixed::from_bits(1 << 15)) : floor(v + fixed::from_bits(1 << 15));
}
/// The remainder of a / b, with the sign of `a`; 0 where b is 0.
constexpr fixed fmod(fixed a, fixed b) {
    return fixed::from_bits(b.bits == 0 || b.bits == -1 ? 0 : a.bits % b.bits);
}

/// The square root; 0 for negative values.
constexpr fixed sqrt(fixed v) {
    if (v.bits <= 0)
        return fixed::from_bits(0);
    const std::uint32_t root = fixed_detail::integer_sqrt(
        static_cast<std::uint64_t>(v.bits) << 18); // the root has one bit more than the result, for rounding
    return fixed::from_bits(static_cast<std::int32_t>((root + 1) >> 1));
}
/// 1 / sqrt(v); the largest value for v <= 0.
constexpr fixed inversesqrt(fixed v) {
    if (v.bits <= 0)
        return fixed::from_bits(INT32_MAX);
    const std::uint32_t root = fixed_detail::integer_sqrt(static_cast<std::uint64_t>(v.bits) << 32); // Q.24
    return fixed::from_bits(fixed::quotient(std::int64_t{1} << 40, root));
}

/// The sine of an angle in radians.
constexpr fixed sin(fixed v) {
    return fixed_detail::from_q30(fixed_detail::circle(v.bits).y);
}
/// The cosine of an angle in radians.
constexpr fixed cos(fixed v) {
    return fixed_detail::from_q30(fixed_detail::circle(v.bits).x);
}
/// The tangent of an angle in radians, saturated at the poles.
constexpr fixed tan(fixed v) {
    const fixed_detail::Point p = fixed_detail::circle(v.bits);
    return fixed::from_bits(fixed::quotient(p.y * fixed::one_bits, p.x));
}
/// The angle of (x, y) in radians, -pi to pi.
constexpr fixed atan2(fixed y, fixed x) {
    return fixed_detail::from_q30(fixed_detail::angle(y.bits, x.bits));
}
/// The angle with this tangent, -pi/2 to pi/2.
constexpr fixed atan(fixed v) {
    return atan2(v, fixed{1});
}
/// The name that GLM gives to atan2().
constexpr fixed atan(fixed y, fixed x) {
    return atan2(y, x);
}
namespace fixed_detail {
/// Arc cosine in Q.30, the argument clamped to [-1, 1].
constexpr std::int64_t arc_cosine(fixed v) {
    constexpr std::int64_t one = fixed::one_bits;
    const std::int64_t x = v.bits > one ? one : v.bits < -one ? -one : v.bits;
    const auto square = static_cast<std::uint64_t>(one * one - x * x); // sin^2 in Q.32
    return angle(integer_sqrt(square << 28), x << 14);                 // angle() takes both in Q.30
}
} // namespace fixed_detail

/// The angle with this cosine, 0 to pi; the argument is clamped to [-1, 1].
constexpr fixed acos(fixed v) {
    return fixed_detail::from_q30(fixed_detail::arc_cosine(v));
}
/// The angle with this sine, -pi/2 to pi/2; the argument is clamped to [-1, 1].
constexpr fixed asin(fixed v) {
    return fixed_detail::from_q30(fixed_detail::pi_q30 / 2 - fixed_detail::arc_cosine(v));
}

} // namespace spangle

/// The properties of spangle::fixed, which GLM reads. Where GLM wants a floating-point type, it accepts only
/// a type whose is_iec559 is true.
template <> struct std::numeric_limits<spangle::fixed> {
    /// The members of std::numeric_limits. `is_iec559` is true for GLM's sake.
    static constexpr bool is_specialized = true, is_signed = true, is_integer = false, is_exact = false,
                          is_iec559 = true;
    /// There are neither infinities nor NaNs, and arithmetic saturates.
    static constexpr bool has_infinity = false, has_quiet_NaN = false, has_signaling_NaN = false,
                          is_bounded = true, is_modulo = false;
    /// Bits without the sign, and decimal digits.
    static constexpr int digits = 31, digits10 = 4, max_digits10 = 10, radix = 2;
    /// The least positive value, 2^-16.
    static constexpr spangle::fixed min() { return spangle::fixed::from_bits(1); }
    /// The largest value, 32768 - 2^-16.
    static constexpr spangle::fixed max() { return spangle::fixed::from_bits(INT32_MAX); }
    /// The least value, -32768.
    static constexpr spangle::fixed lowest() { return spangle::fixed::from_bits(INT32_MIN); }
    /// The distance of neighbouring values, 2^-16.
    static constexpr spangle::fixed epsilon() { return spangle::fixed::from_bits(1); }
    /// One half.
    static constexpr spangle::fixed round_error() { return spangle::fixed::from_bits(1 << 15); }
    /// The largest value: there is no infinity.
    static constexpr spangle::fixed infinity() { return max(); }
    /// 0: there is no NaN.
    static constexpr spangle::fixed quiet_NaN() { return spangle::fixed::from_bits(0); }
    /// The least positive value.
    static constexpr spangle::fixed denorm_min() { return min(); }
};
