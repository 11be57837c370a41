// Block form: int32 mantissas with one exponent, normalised by the largest mantissa; a value is m * 2^e. A
// vertex, a normal or a clip position is one block. It has the range of a float and the arithmetic of
// integers, and depends on no other vertex.
#pragma once

#include <cstdint>

#include "raster/numeric/bits.hpp"
#include "raster/numeric/real.hpp"
#include "raster/numeric/reciprocal.hpp"
#include "raster/numeric/rsqrt.hpp"

namespace spangle::numeric {

/// |m| < 2^30, and >= 2^29 unless the value is 0; 0 is {0, 0}. e stays within +-16384 (clamped).
struct Block {
    std::int32_t m = 0;
    std::int32_t e = 0;
};

/// Each |m[i]| < 2^30, the largest >= 2^29 unless all are 0 ({0, 0, 0}, 0).
struct Block3 {
    std::int32_t m[3] = {0, 0, 0};
    std::int32_t e = 0;
};
struct Block4 {
    std::int32_t m[4] = {0, 0, 0, 0};
    std::int32_t e = 0;
};

inline constexpr int block_bits = 30;
inline constexpr std::int32_t block_max = (1 << block_bits) - 1;

namespace detail {

SPANGLE_INLINE constexpr std::int32_t block_exponent(std::int32_t e) {
    return clamp<std::int32_t>(e, -16384, 16384);
}

/// The integer nearest to v * 2^-n for 1 <= n <= 31. A carry that would need bit 30 is dropped, which is an
/// error of one ulp instead of half an ulp.
SPANGLE_INLINE constexpr std::int32_t narrow(std::int32_t v, int n) {
    const std::int32_t r = ((v >> (n - 1)) + 1) >> 1;
    return r > block_max ? block_max : r;
}

/// v * 2^-n as the mantissa of a block, rounded; an n below 0 shifts to the left.
SPANGLE_INLINE constexpr std::int32_t shift_to_block(std::int32_t v, int n) {
    if (n <= 0)
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(v) << -n);
    return n > 31 ? 0 : narrow(v, n);
}

/// v * 2^-n as the mantissa of a block. Before it is clamped, the result must fit a word.
constexpr std::int32_t shift_to_block(std::int64_t v, int n) {
    if (runs_inline && n > 0 && n < 32) [[likely]] { // this branch only saves time
        const auto r = static_cast<std::int32_t>(low_word_after(v + (std::int32_t{1} << (n - 1)), n));
        return clamp(r, -block_max, block_max);
    }
    if (runs_inline && n <= 0)
        return static_cast<std::int32_t>(static_cast<std::uint64_t>(v) << -n);
    const std::int64_t r = shift_right_round(v, n);
    return static_cast<std::int32_t>(clamp<std::int64_t>(r, -block_max, block_max));
}

/// A Real as a mantissa with sign, shifted up to 2^29 <= |m| < 2^30, and its exponent e.
struct Scaled {
    std::int32_t m;
    std::int32_t e;
};

SPANGLE_INLINE constexpr Scaled scaled(Real v) {
    const Unpacked u = unpack(v);
    const auto m = static_cast<std::int32_t>(u.mantissa << 6);
    return {u.negative ? -m : m, u.exponent - 6};
}

} // namespace detail

// --- making blocks
// -------------------------------------------------------------------------------------------------

/// v * 2^e, nearest.
constexpr Block make_block(std::int64_t v, std::int32_t e) {
    if (v == 0)
        return {};
    const int n = 34 - clz64(abs_u64(v)); // the width of v in bits, less 30
    return {detail::shift_to_block(v, n), detail::block_exponent(e + n)};
}

constexpr Block to_block(Real v) {
    const detail::Scaled s = detail::scaled(v);
    return make_block(s.m, s.e);
}

namespace detail {

/// Brings n values m[i] * 2^e[i] to one exponent, which is returned. Values with m = 0 do not affect the
/// exponent.
SPANGLE_RUN_INLINE constexpr std::int32_t under_one(int n, const std::int32_t* m, const std::int32_t* e,
                                                    std::int32_t* out) {
    constexpr std::int32_t none = -0x10000;
    std::int32_t top = none;
    for (int i = 0; i < n; ++i) {
        const std::int32_t own = m[i] == 0 ? none : e[i] - clz32(abs_u32(m[i]));
        if (own > top)
            top = own;
    }
    if (top == none)
        return 0;
    top += 2; // `top` leaves 30 bits for each value, below a sign and a zero bit
    for (int i = 0; i < n; ++i)
        out[i] = m[i] == 0 ? 0 : shift_to_block(m[i], top - e[i]);
    return block_exponent(top);
}
template <int N, class B>
SPANGLE_INLINE constexpr B common_exponent(const std::int32_t (&m)[N], const std::int32_t (&e)[N]) {
    B out{};
    out.e = under_one(N, m, e, out.m);
    return out;
}

} // namespace detail

namespace detail {

inline constexpr std::int32_t no_column[4] = {};

/// Does what under_one() does, for floats that are each multiplied by 2^column[i].
SPANGLE_RUN_INLINE constexpr std::int32_t reals_under_one(int n, const Real* v, const std::int32_t* column,
                                                          std::int32_t* out) {
    std::int32_t m[4], e[4];
    for (int i = 0; i < n; ++i) {
        const Scaled s = scaled(v[i]);
        m[i] = s.m;
        e[i] = s.e + column[i];
    }
    return under_one(n, m, e, out);
}

} // namespace detail

constexpr Block3 to_block(const Real (&v)[3]) {
    Block3 out;
    out.e = detail::reals_under_one(3, v, detail::no_column, out.m);
    return out;
}
constexpr Block4 to_block(const Real (&v)[4]) {
    Block4 out;
    out.e = detail::reals_under_one(4, v, detail::no_column, out.m);
    return out;
}
constexpr Block3 to_block(Real x, Real y, Real z) {
    return to_block({x, y, z});
}
constexpr Block4 to_block(Real x, Real y, Real z, Real w) {
    return to_block({x, y, z, w});
}

/// Four blocks, or three, brought to one exponent.
constexpr Block3 to_block(Block x, Block y, Block z) {
    return detail::common_exponent<3, Block3>({x.m, y.m, z.m}, {x.e, y.e, z.e});
}
constexpr Block4 to_block(Block x, Block y, Block z, Block w) {
    return detail::common_exponent<4, Block4>({x.m, y.m, z.m, w.m}, {x.e, y.e, z.e, w.e});
}

constexpr Block component(const Block3& v, int i) {
    return make_block(v.m[i], v.e);
}
constexpr Block component(const Block4& v, int i) {
    return make_block(v.m[i], v.e);
}

// --- leaving blocks
// ------------------------------------------------------------------------------------------------

/// v * 2^fraction_bits, rounded to nearest with halves up, saturated.
constexpr std::int32_t to_fixed(Block v, int fraction_bits) {
    return scale_saturate(v.m, v.e + fraction_bits);
}

constexpr Real to_real(Block v) {
    return pack_real(v.m < 0, abs_u32(v.m), v.e);
}

// --- scalar arithmetic: relative error <= 2^-29 each
// ---------------------------------------------------------------------

constexpr Block negate(Block v) {
    return {-v.m, v.e};
}

constexpr Block mul(Block a, Block b) {
    return make_block(mul_s32(a.m, b.m), a.e + b.e);
}

namespace detail {

/// a * 2^e_a + b * 2^e_b, where magnitudes are below 2^62. The term with the larger exponent keeps its bits.
SPANGLE_RUN_INLINE constexpr Block sum(std::int64_t a, std::int32_t e_a, std::int64_t b, std::int32_t e_b) {
    if (b == 0 || (a != 0 && e_a >= e_b))
        return make_block(a + (b == 0 ? 0 : shift_right_round(b, e_a - e_b)), e_a);
    return make_block(b + (a == 0 ? 0 : shift_right_round(a, e_b - e_a)), e_b);
}

} // namespace detail

constexpr Block add(Block a, Block b) {
    constexpr std::int64_t up = std::int64_t{1} << 32;
    if (runs_inline && (a.m == 0 || b.m == 0)) // this branch only saves time
        return a.m == 0 ? b : a;
    return detail::sum(a.m * up, a.e - 32, b.m * up, b.e - 32);
}

constexpr Block sub(Block a, Block b) {
    return add(a, negate(b));
}

/// -1, 0 or 1 as a < b, a == b, a > b.
constexpr int compare(Block a, Block b) {
    const Block d = sub(a, b);
    return d.m < 0 ? -1 : d.m > 0 ? 1 : 0;
}
constexpr int sign(Block v) {
    return v.m < 0 ? -1 : v.m > 0 ? 1 : 0;
}

/// 1/v. For 0 it is the largest block, because a division by zero must not interrupt (GL 1.3, 2.1.1).
constexpr Block reciprocal(Block v) {
    if (v.m == 0)
        return {block_max, 16384};
    const std::uint32_t magnitude = abs_u32(v.m);
    const int zeros = clz32(magnitude); // leading zeros, which are 2 in a normalised block
    const std::int64_t r = reciprocal(magnitude << zeros);
    return make_block(v.m < 0 ? -r : r, zeros - 62 - v.e); // 1/v = r * 2^-30 * 2^(zeros - 32) * 2^-e
}

/// a / b within half a unit, exact where the quotient is exact. a / 0 is as large as reciprocal(0). The
/// function is a long division, for state and not for vertices.
constexpr Block div(Block a, Block b) {
    if (b.m == 0 || a.m == 0)
        return a.m == 0 ? Block{} : Block{a.m < 0 ? -block_max : block_max, 16384};
    // The quotient has 32 or 33 bits.
    const std::uint64_t q = divide(std::uint64_t{abs_u32(a.m)} << 32, abs_u32(b.m)).quotient;
    const auto v = static_cast<std::int64_t>(q);
    return make_block((a.m < 0) != (b.m < 0) ? -v : v, a.e - b.e - 32);
}

/// 1/sqrt(v); for v <= 0 the largest block.
constexpr Block rsqrt(Block v) {
    if (v.m <= 0)
        return {block_max, 16384};
    const auto magnitude = static_cast<std::uint32_t>(v.m);
    int zeros = clz32(magnitude);
    if (((v.e - zeros) & 1) != 0)
        --zeros; // the exponent that remains must be even, because it is halved
    const std::uint32_t r = rsqrt(magnitude << zeros);
    return make_block(r, -30 - (v.e - zeros + 32) / 2);
}

/// sqrt(v); 0 for v <= 0.
constexpr Block sqrt(Block v) {
    return v.m <= 0 ? Block{} : mul(v, rsqrt(v));
}

// --- vectors
// -------------------------------------------------------------------------------------------------------

constexpr Block3 negate(const Block3& v) {
    return {{-v.m[0], -v.m[1], -v.m[2]}, v.e};
}

/// The dot product: three products of 2^60, |sum| < 2^61.6. The error is at most 2^-30 of |a| |b|.
constexpr Block dot(const Block3& a, const Block3& b) {
    return make_block(mul_s32(a.m[0], b.m[0]) + mul_s32(a.m[1], b.m[1]) + mul_s32(a.m[2], b.m[2]), a.e + b.e);
}
constexpr Block dot(const Block4& a, const Block4& b) {
    return make_block(mul_s32(a.m[0], b.m[0]) + mul_s32(a.m[1], b.m[1]) + mul_s32(a.m[2], b.m[2]) +
                          mul_s32(a.m[3], b.m[3]),
                      a.e + b.e);
}

namespace detail {

/// Makes a block of N sums under one exponent.
template <int N, class B> constexpr B from_sums(const std::int64_t (&sum)[N], std::int32_t e) {
    std::uint64_t any = 0;
    for (const std::int64_t s : sum)
        any |= abs_u64(s);
    if (any == 0)
        return {};
    const int n = 34 - clz64(any);
    B out;
    for (int i = 0; i < N; ++i)
        out.m[i] = shift_to_block(sum[i], n);
    out.e = block_exponent(e + n);
    return out;
}

/// Makes a block of three words that already share an exponent.
SPANGLE_RUN_CALL constexpr Block3 from_words(const std::int32_t* m, std::int32_t e) {
    return common_exponent<3, Block3>({m[0], m[1], m[2]}, {e, e, e});
}

} // namespace detail

constexpr Block3 xyz(const Block4& v) {
    return detail::from_words(v.m, v.e);
}

constexpr Block3 add(const Block3& a, const Block3& b) {
    const bool a_is_large = b.m[0] == 0 && b.m[1] == 0 && b.m[2] == 0   ? true
                            : a.m[0] == 0 && a.m[1] == 0 && a.m[2] == 0 ? false
                                                                        : a.e >= b.e;
    const Block3 &large = a_is_large ? a : b, &small = a_is_large ? b : a;
    std::int64_t sum[3] = {};
    for (int i = 0; i < 3; ++i)
        sum[i] = std::int64_t{large.m[i]} * (std::int64_t{1} << 32) +
                 shift_right_round(std::int64_t{small.m[i]} * (std::int64_t{1} << 32), large.e - small.e);
    return detail::from_sums<3, Block3>(sum, large.e - 32);
}
constexpr Block3 sub(const Block3& a, const Block3& b) {
    return add(a, negate(b));
}

constexpr Block3 mul(const Block3& v, Block s) {
    const std::int64_t sum[3] = {mul_s32(v.m[0], s.m), mul_s32(v.m[1], s.m), mul_s32(v.m[2], s.m)};
    return detail::from_sums<3, Block3>(sum, v.e + s.e);
}

constexpr Block3 cross(const Block3& a, const Block3& b) {
    const std::int64_t sum[3] = {mul_s32(a.m[1], b.m[2]) - mul_s32(a.m[2], b.m[1]),
                                 mul_s32(a.m[2], b.m[0]) - mul_s32(a.m[0], b.m[2]),
                                 mul_s32(a.m[0], b.m[1]) - mul_s32(a.m[1], b.m[0])};
    return detail::from_sums<3, Block3>(sum, a.e + b.e);
}

constexpr Block length(const Block3& v) {
    return sqrt(dot(v, v));
}

/// A vector of length 1 in Q2.30, or (0, 0, 0).
struct Unit3 {
    std::int32_t m[3] = {0, 0, 0};
};

inline constexpr std::int32_t unit_one = 1 << 30;

/// v / |v|. Each component, and the length, is within 2^-28 of 1.
SPANGLE_INLINE constexpr Unit3 normalize(const Block3& v) {
    const std::uint64_t square = static_cast<std::uint64_t>(
        mul_s32(v.m[0], v.m[0]) + mul_s32(v.m[1], v.m[1]) + mul_s32(v.m[2], v.m[2])); // 0, or 2^58 .. 2^61.6
    if (square == 0)
        return {};
    const int zeros = clz64(square) & ~1; // 2 or 4: square << zeros is in [2^62, 2^64)
    const std::uint32_t r = rsqrt(low_word_after(static_cast<std::int64_t>(square), 32 - zeros));
    // v / sqrt(square) = v * (r * 2^-30) * 2^((zeros - 64) / 2); in Q2.30 that is v * r >> (32 - zeros / 2).
    const int shift = 32 - zeros / 2; // the shift is 30 or 31
    const std::int64_t half = std::int32_t{1} << (shift - 1);
    Unit3 out;
#pragma GCC unroll runs_inline ? 3 : 1
    for (int i = 0; i < 3; ++i)
        out.m[i] = static_cast<std::int32_t>(low_word_after(mul_s32_u32(v.m[i], r) + half, shift));
    return out;
}

/// The dot product of unit vectors in Q2.30, rounded. It is within 2^-29 of the exact product, and never
/// outside of -1 to 1.
SPANGLE_INLINE constexpr std::int32_t dot(const Unit3& a, const Unit3& b) {
    const std::int64_t sum = mul_s32(a.m[0], b.m[0]) + mul_s32(a.m[1], b.m[1]) + mul_s32(a.m[2], b.m[2]);
    const auto d = static_cast<std::int32_t>((sum + (1 << 29)) >> 30); // |sum| <= 2^60 (1 + 2^-27)
    return clamp(d, -unit_one, unit_one);
}

constexpr Block3 to_block(const Unit3& v) {
    return detail::from_words(v.m, -30);
}

} // namespace spangle::numeric
