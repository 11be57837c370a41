// 1/a by a table and Newton steps, with the same integers on every instruction set. Exact divisions of 64 by
// 32 bits are built on it.
//
// Cost in instructions with gcc 12 -O2: reciprocal() takes about 25 on a Cortex-M4, with four long
// multiplications. A Cortex-M0+ has no long multiplication: each product is a call of __aeabi_lmul, about 24
// instructions, so reciprocal() takes about 150.
#pragma once

#include <cstdint>

#include "raster/numeric/bits.hpp"

namespace spangle::numeric {

namespace detail {

/// 1/a in Q1.15 at the middle of the i-th of the 256 intervals of [1/2, 1): 2^25 / (513 + 2i), rounded.
constexpr std::uint16_t reciprocal_near(std::uint32_t i) {
    return static_cast<std::uint16_t>(((1u << 26) / (513 + 2 * i) + 1) / 2);
}
struct ReciprocalTable {
    std::uint16_t at[256];
    constexpr ReciprocalTable() : at{} {
        for (std::uint32_t i = 0; i < 256; ++i)
            at[i] = reciprocal_near(i);
    }
};
inline constexpr ReciprocalTable reciprocal_table;

/// 1/a in Q2.30 from the table alone. The relative error is at most 2^-8.99.
SPANGLE_INLINE constexpr std::uint32_t reciprocal_seed(std::uint32_t a) {
    const std::uint32_t i = (a >> 23) & 255;
    return std::uint32_t{has_seed_tables ? reciprocal_table.at[i] : reciprocal_near(i)} << 15;
}

} // namespace detail

/// Bounds of the relative error, in tenths of a bit. Tests and proofs read these constants.
inline constexpr int reciprocal_1_accuracy = 179, reciprocal_accuracy = 308;
inline constexpr int reciprocal_ulp_percent = 54; ///< bound of the absolute error, hundredths of 2^-30

/// 1/a in Q2.30 by one Newton step. a in [2^31, 2^32) stands for [1/2, 1). The relative error is in
/// [-2^-17.9, 2^-30].
SPANGLE_INLINE constexpr std::uint32_t reciprocal_1(std::uint32_t a) {
    // The step is r = seed (2 - a seed). The product a seed has 31 fraction bits, and its last bit is
    // cleared. The 2 is 2^32 and so 0 here; r has 30 fraction bits.
    const std::uint32_t seed = detail::reciprocal_seed(a) >> 15;
    return mul_by_half(0 - (mul_by_half(a, seed) & ~1u), seed);
}

/// 1/a in Q2.30 by two Newton steps; the result in (2^30, 2^31] stands for (1, 2]. The absolute error is at
/// most 0.51 ulp, so the relative error is at most 2^-30.9. The second step uses the residual 1 - a*r, whose
/// 31 bits that count fit one word.
SPANGLE_INLINE constexpr std::uint32_t reciprocal(std::uint32_t a) {
    const std::uint32_t r = reciprocal_1(a);
    // The product a r is Q.62, in 1 - 2^-17.9 .. 1 + 2^-30. The residual 1 - a r is Q.48, and 2^62 has no bit
    // in that word.
    const auto residual = static_cast<std::int32_t>(mul_residual(a, r));
    // r < 2^31, |residual| < 2^30.2: the correction with 8 fraction bits, rounded to whole ulps.
    const std::int32_t step = (mul_high_s32(static_cast<std::int32_t>(r), residual) + (1 << 15)) >> 16;
    return r + static_cast<std::uint32_t>(step);
}

namespace detail {

/// Makes the steps of reciprocal(a << zeros). Products with a fit a word, and are shifted afterwards.
SPANGLE_INLINE constexpr std::uint32_t half_reciprocal_in_steps(std::uint32_t a, int zeros) {
    const std::uint32_t seed = reciprocal_seed(a << zeros) >> 15;
    const std::uint32_t r = mul_by_half(0 - ((a * seed) << (zeros - 16)), seed);
    const auto residual = static_cast<std::int32_t>((0 - a * r) << (zeros - 14));
    const std::int32_t step = (mul_high_s32(static_cast<std::int32_t>(r), residual) + (1 << 15)) >> 16;
    return (r + static_cast<std::uint32_t>(step)) >> 1;
}

} // namespace detail

/// reciprocal(a << zeros) / 2 for an a below 2^12 with `zeros` leading zeros. On machines with a division
/// instruction, this is a division in two digits. Its dividend is 1 plus nearly 1/4 of a unit, which gives
/// half of the value that reciprocal() rounds to nearest.
SPANGLE_INLINE constexpr std::uint32_t half_reciprocal(std::uint32_t a, int zeros) {
    if constexpr (!divides)
        return detail::half_reciprocal_in_steps(a, zeros);
    constexpr std::uint32_t one = 1u << 30;
    const std::uint32_t first = one / a;
    const int digits = 31 - zeros;
    return (first << digits) + (((one - first * a) << digits) + (a * 255 >> 10)) / a;
}

/// Says that all reciprocals will be set, so that none is initialised.
struct EachIsSet {};
inline constexpr EachIsSet each_is_set;

/// Computes N reciprocals together, so that no step waits for the step before it, as in reciprocal().
/// Compilers make vectors of them. The integers are those of reciprocal().
template <int N> class Reciprocals {
  public:
    Reciprocals() : a_{}, r_{} {}
    explicit Reciprocals(EachIsSet) {}
    /// Makes reciprocal i that of a.
    SPANGLE_INLINE void set(int i, std::uint32_t a) {
        a_[i] = a;
        r_[i] = in_words ? reciprocal(a) : detail::reciprocal_seed(a);
    }
    /// Computes the first `count` reciprocals, at most N. It must be called after the last set().
    SPANGLE_INLINE void finish(int count) {
        if constexpr (in_words)
            return;
        for (int first = 0; first < count; first += block) {
            std::uint32_t once[block];
            for (int i = 0; i < block; ++i) {
                const std::uint32_t a = a_[first + i], seed = r_[first + i], product = mul_high_u32(a, seed);
                once[i] = static_cast<std::uint32_t>(mul_u32(seed, 0x80000000u - product) >> 30);
            }
            // A signed factor is an unsigned factor minus 2^31. A shift by 48 bits is one by 32 and one by
            // 16.
            for (int i = 0; i < block; ++i) {
                const std::uint32_t r = once[i];
                const auto residual =
                    static_cast<std::uint32_t>(((std::uint64_t{1} << 62) - mul_u32(a_[first + i], r)) >> 14);
                const std::uint64_t step =
                    mul_u32(r, residual ^ 0x80000000u) + (std::uint64_t{1} << 47) - (std::uint64_t{r} << 31);
                r_[first + i] =
                    r + static_cast<std::uint32_t>(
                            static_cast<std::int32_t>(static_cast<std::uint32_t>(step >> 32)) >> 16);
            }
        }
    }
    SPANGLE_INLINE std::uint32_t at(int i) const { return r_[i]; }

  private:
    static constexpr bool in_words = cheap_branches || N == 1; ///< true: lanes are computed one by one
    static constexpr int block = N % 4 == 0 ? 4 : 1;           ///< lanes of a vector
    alignas(16) std::uint32_t a_[N];
    alignas(16) std::uint32_t r_[N];
};

struct Quotient {
    std::uint64_t quotient;
    std::uint32_t remainder;
};

namespace detail {

/// Does what divide() does, for words of 32 bits. The quotient comes from reciprocal() and is corrected by
/// its remainder, so no 64-bit division is linked.
constexpr Quotient divide_by_words(std::uint64_t n, std::uint32_t d) {
    const auto high = static_cast<std::uint32_t>(n >> 32);
    std::uint64_t quotient = 0;
    if (high >= d) { // the upper word of the quotient comes from a 32-bit division
        quotient = std::uint64_t{high / d} << 32;
        n -= quotient * d;
    }
    if ((n >> 32) == 0) {
        const auto low = static_cast<std::uint32_t>(n);
        return {quotient + low / d, low % d};
    }
    const int zeros = clz32(d);
    const std::uint32_t r = reciprocal(d << zeros);
    // n / d = (n << zeros) / 2^32 * r / 2^30, with n < d * 2^32: the top word is below 2^32.
    const auto top = static_cast<std::uint32_t>((n << zeros) >> 32);
    std::uint64_t digit = mul_u32(top, r) >> 30;
    // The digit is never too large: r is within an ulp, which counts at most 4 here.
    digit = digit < 4 ? 0 : digit - 4;
    std::uint64_t rest = n - digit * d;
    while (rest >= d)
        rest -= d, ++digit; // this loop runs at most 9 times
    return {quotient + digit, static_cast<std::uint32_t>(rest)};
}

} // namespace detail

/// n / d and n % d, exact; d = 0 gives {0, 0}.
constexpr Quotient divide(std::uint64_t n, std::uint32_t d) {
    if (d == 0)
        return {0, 0};
    if constexpr (wide_words)
        return {n / d, static_cast<std::uint32_t>(n % d)};
    else
        return detail::divide_by_words(n, d);
}

namespace detail {

/// Not inline, because with words of 32 bits the code takes some 200 bytes.
[[gnu::noinline]] constexpr std::int64_t quotient_by_words(std::int64_t n, std::uint32_t d) {
    const auto q = static_cast<std::int64_t>(divide_by_words(abs_u64(n), d).quotient);
    return n < 0 ? -q : q;
}

} // namespace detail

/// n / d, d > 0, rounded towards 0.
constexpr std::int64_t quotient(std::int64_t n, std::uint32_t d) {
    if constexpr (wide_words)
        return n / static_cast<std::int64_t>(d);
    else
        return detail::quotient_by_words(n, d);
}

struct LongQuotient {
    std::uint64_t quotient, remainder;
};

namespace detail {

constexpr LongQuotient divide_by_bits(std::uint64_t n, std::uint64_t d) {
    std::uint64_t rest = 0;
    for (int i = 0; i < 64; ++i) {
        // The upper i + 1 bits of the dividend are at least as large as `rest`, so `rest` fits.
        rest = rest << 1 | n >> 63;
        n <<= 1;
        if (rest >= d) {
            rest -= d;
            n |= 1;
        }
    }
    return {n, rest};
}

} // namespace detail

/// n / d and n % d for any d except 0. Without long words the division goes bit by bit, because it is needed
/// only once per command. The division of a compiler's library has some 900 bytes.
constexpr LongQuotient divide_long(std::uint64_t n, std::uint64_t d) {
    if constexpr (wide_words)
        return {n / d, n % d};
    else
        return detail::divide_by_bits(n, d);
}

struct FloorQuotient {
    std::int64_t quotient;
    std::uint32_t remainder; ///< 0 .. d - 1
};

/// floor(n / d) and n - d * floor(n / d), exact; d = 0 gives {0, 0}.
constexpr FloorQuotient floor_divide(std::int64_t n, std::uint32_t d) {
    const Quotient q = divide(abs_u64(n), d);
    if (n >= 0)
        return {static_cast<std::int64_t>(q.quotient), q.remainder};
    const auto down = static_cast<std::int64_t>(std::uint64_t{0} - q.quotient);
    return q.remainder == 0 ? FloorQuotient{down, 0} : FloorQuotient{down - 1, d - q.remainder};
}

} // namespace spangle::numeric
