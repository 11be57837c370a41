// Integer words: leading zeros, fields, shifts that round, and values that saturate. All functions are
// defined for every argument.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "raster/numeric/products.hpp"

namespace spangle::numeric {

/// Reads the little-endian word at `at`: one load, on machines of either byte order.
template <class Word> SPANGLE_INLINE Word load_low_first(const std::uint8_t* at) {
    static_assert(sizeof(Word) == 2 || sizeof(Word) == 4);
    Word word;
    __builtin_memcpy(&word, at, sizeof word);
    if constexpr (std::endian::native == std::endian::little)
        return word;
    else if constexpr (sizeof(Word) == 2)
        return __builtin_bswap16(word);
    else
        return __builtin_bswap32(word);
}

/// Leading zeros; 32 for 0.
SPANGLE_INLINE constexpr int clz32(std::uint32_t v) {
    return std::countl_zero(v);
}

/// Counts leading zeros of a sequence of values, which mostly have as many as the value before them. On
/// machines where counting is a library call, this guess is tried first.
template <bool Counted = long_products> class LeadingZeros {
  public:
    SPANGLE_INLINE constexpr int of(std::uint32_t v) {
        if (v >> last_shift_ == 1) [[likely]]
            return 31 - last_shift_;
        const int zeros = clz32(v);
        last_shift_ = (31 - zeros) & 31; // 0 has 32 leading zeros
        return zeros;
    }

  private:
    int last_shift_ = 31; ///< shift that made 1 of the previous value
};
template <> class LeadingZeros<true> {
  public:
    SPANGLE_INLINE static constexpr int of(std::uint32_t v) { return clz32(v); }
};

/// Leading zeros; 64 for 0.
SPANGLE_RUN_INLINE constexpr int clz64(std::uint64_t v) {
    return std::countl_zero(v);
}

/// |v|; 2^31 for INT32_MIN.
SPANGLE_INLINE constexpr std::uint32_t abs_u32(std::int32_t v) {
    const auto u = static_cast<std::uint32_t>(v);
    return v < 0 ? 0u - u : u;
}

/// |v|; 2^63 for INT64_MIN.
SPANGLE_INLINE constexpr std::uint64_t abs_u64(std::int64_t v) {
    const auto u = static_cast<std::uint64_t>(v);
    return v < 0 ? std::uint64_t{0} - u : u;
}

namespace detail {

SPANGLE_INLINE constexpr bool shift_loses(std::int32_t v, std::uint32_t n) {
    return n > 31 || static_cast<std::int32_t>(static_cast<std::uint32_t>(v) << n) >> n != v;
}

} // namespace detail

/// Whether v * 2^n does not fit a signed word.
SPANGLE_INLINE constexpr bool loses_bits(std::int32_t v, std::uint32_t n) {
    if constexpr (three_operands)
        return n >= static_cast<std::uint32_t>(clz32(static_cast<std::uint32_t>(v ^ (v >> 31))));
    return detail::shift_loses(v, n); // here clz32() is a library call
}

/// `Bits` bits of a word, from bit `At` on.
template <int At, int Bits> SPANGLE_INLINE constexpr std::uint32_t bit_field(std::uint32_t v) {
    if constexpr (three_operands)
        return v >> At & ((1u << Bits) - 1);
    return factor32(v << (32 - At - Bits)) >> (32 - Bits);
}

/// v with `bits` in its bits At .. At + Count - 1.
template <int At, int Count>
SPANGLE_INLINE constexpr std::uint32_t with_bits(std::uint32_t v, std::uint32_t bits) {
#if defined(__thumb2__)
    if (!std::is_constant_evaluated()) {
        asm("bfi %0, %1, %2, %3" : "+r"(v) : "r"(bits), "I"(At), "I"(Count)); // NOLINT(hicpp-no-assembler)
        return v;
    }
#endif
    constexpr std::uint32_t mask = (1u << Count) - 1;
    return (v & ~(mask << At)) | (bits & mask) << At;
}

/// floor(v / 2^n) for any n < 2^31. ARM instructions shift by up to 255, which saves a test.
SPANGLE_INLINE constexpr std::uint32_t shifted_out(std::uint32_t v, std::uint32_t n) {
#if defined(__thumb2__)
    if (!std::is_constant_evaluated()) {
        std::uint32_t r;
        asm("usat %0, #8, %1\n\tlsr %0, %2, %0" : "=&r"(r) : "r"(n), "r"(v)); // NOLINT(hicpp-no-assembler)
        return r;
    }
#endif
    return n > 31 ? 0 : v >> n;
}

/// floor(v / 2^n) for n < 256.
SPANGLE_INLINE constexpr std::uint32_t shifted_some(std::uint32_t v, std::uint32_t n) {
#if defined(__thumb2__)
    if (!std::is_constant_evaluated()) {
        asm("lsr %0, %0, %1" : "+r"(v) : "r"(n)); // NOLINT(hicpp-no-assembler)
        return v;
    }
#elif defined(__thumb__)
    if (!std::is_constant_evaluated()) {
        asm(".syntax unified\n\tlsrs %0, %0, %1" : "+l"(v) : "l"(n) : "cc"); // NOLINT(hicpp-no-assembler)
        return v;
    }
#endif
    return shifted_out(v, n);
}

/// The low word of floor(v / 2^n), 0 < n < 32. It takes three instructions on machines with words of 32 bits.
SPANGLE_INLINE constexpr std::uint32_t low_word_after(std::int64_t v, int n) {
    if constexpr (wide_words)
        return static_cast<std::uint32_t>(v >> n);
    return static_cast<std::uint32_t>(v) >> n | static_cast<std::uint32_t>(v >> 32) << (32 - n);
}
/// Both words of floor(v / 2^n), 0 < n < 32. It takes four instructions on machines with words of 32 bits.
SPANGLE_INLINE constexpr std::int64_t words_after(std::int64_t v, int n) {
    if constexpr (wide_words)
        return v >> n;
    const std::int64_t high = static_cast<std::int32_t>(v >> 32) >> n;
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(high) << 32 | low_word_after(v, n));
}

namespace detail {

SPANGLE_INLINE constexpr std::uint32_t high_word_by_words(std::uint64_t v, int n) {
    const auto high = static_cast<std::uint32_t>(v >> 32), low = static_cast<std::uint32_t>(v);
    return n < 32 ? high << n | low >> 1 >> (31 - n) : low << (n - 32);
}

} // namespace detail

/// The high word of v 2^n, 0 <= n < 64.
SPANGLE_INLINE constexpr std::uint32_t high_word_before(std::uint64_t v, int n) {
    if constexpr (wide_words)
        return static_cast<std::uint32_t>(v << n >> 32);
    return detail::high_word_by_words(v, n);
}

/// floor(v / 2^Down), limited to 0 .. 2^Bits - 1.
template <int Down, int Bits> SPANGLE_INLINE constexpr std::uint32_t saturated_after(std::int32_t v) {
#if defined(__thumb2__)
    if (!std::is_constant_evaluated()) {
        std::uint32_t r;
        asm("usat %0, %2, %1, asr %3" : "=r"(r) : "r"(v), "I"(Bits), "I"(Down)); // NOLINT(hicpp-no-assembler)
        return r;
    }
#endif
    constexpr std::int32_t most = (std::int32_t{1} << Bits) - 1;
    const std::int32_t down = v >> Down;
    return static_cast<std::uint32_t>(down < 0 ? 0 : down > most ? most : down);
}

namespace detail {

/// n mod D, n < 2^16, by 1 / D rounded up.
template <std::uint32_t D> struct ShortRemainder {
    static constexpr int bits = 15 + std::bit_width(D);
    static constexpr std::uint32_t one = 1u << bits, inverse = one / D + 1, excess = inverse * D - one;
    static constexpr bool exact = excess <= one >> 16; ///< true where `excess` changes no quotient
    SPANGLE_INLINE static constexpr std::uint32_t of(std::uint32_t n) {
        return n - (n * inverse >> bits) * D;
    }
};

} // namespace detail

/// n modulo D. On machines without long products, compilers would divide even where n < 2^16.
template <std::uint32_t D> SPANGLE_INLINE constexpr std::uint32_t remainder(std::uint32_t n) {
    using Short = detail::ShortRemainder<D>;
    if (!long_products && !std::has_single_bit(D) && Short::exact && n >> 16 == 0)
        return Short::of(n);
    return n % D;
}

/// v * 2^n, 0 <= n < 32, in two words.
SPANGLE_INLINE constexpr std::int64_t shifted_up(std::int32_t v, int n) {
    const auto high = static_cast<std::uint32_t>((v >> 1) >> (31 - n));
    return static_cast<std::int64_t>(std::uint64_t{high} << 32 | static_cast<std::uint32_t>(v) << n);
}
/// floor(v 2^n) for any n, modulo 2^64. An |n| beyond 63 counts as 63. The code takes 50 bytes on machines
/// with words of 32 bits.
SPANGLE_RUN_INLINE constexpr std::int64_t times_two_to(std::int64_t v, int n) {
    if (n < 0)
        return v >> (n > -63 ? -n : 63);
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(v) << (n < 63 ? n : 63));
}
/// v / 2^n rounded to nearest, halves up. n <= 0 leaves v as it is, and no n overflows.
SPANGLE_INLINE constexpr std::int32_t shift_right_round(std::int32_t v, int n) {
    if (n <= 0)
        return v;
    if (n > 31)
        return 0;
    return (v >> n) + ((v >> (n - 1)) & 1);
}
/// v / 2^n rounded to nearest, halves up. A negative n, down to -63, shifts to the left.
SPANGLE_INLINE constexpr std::int64_t shift_right_round(std::int64_t v, int n) {
    if (n <= 0)
        // The shift count is masked, because a v of 0 may come with any n.
        return static_cast<std::int64_t>(static_cast<std::uint64_t>(v) << (-n & 63));
    if (n > 63)
        return 0;
    const std::int64_t twice = runs_inline ? v >> (n - 1) : times_two_to(v, 1 - n);
    return (twice >> 1) + (twice & 1);
}

/// v / 2^n rounded to nearest, ties to even. A negative n, down to -63, shifts to the left.
constexpr std::uint64_t shift_right_even(std::uint64_t v, int n) {
    if (n <= 0)
        return v << -n;
    if (n > 64)
        return 0;
    constexpr std::uint64_t half = std::uint64_t{1} << 63;
    if (n == 64)
        return v > half ? 1 : 0;
    const std::uint64_t quotient = v >> n;
    const std::uint64_t rest = v << (64 - n);
    return quotient + (rest > half || (rest == half && (quotient & 1) != 0) ? 1u : 0u);
}

/// v / 2^n rounded down, where the lowest bit is set if any lost bit was set ("sticky"). A later rounding is
/// then still exact.
constexpr std::uint64_t shift_right_sticky(std::uint64_t v, int n) {
    if (n <= 0)
        return v;
    if (n > 63)
        return v != 0 ? 1u : 0u;
    return (v >> n) | ((v << (64 - n)) != 0 ? 1u : 0u);
}

SPANGLE_RUN_INLINE constexpr std::int32_t saturate_i32(std::int64_t v) {
    constexpr std::int64_t low = std::numeric_limits<std::int32_t>::min();
    constexpr std::int64_t high = std::numeric_limits<std::int32_t>::max();
    return static_cast<std::int32_t>(v < low ? low : v > high ? high : v);
}

/// v * 2^n as int32. Left shifts saturate, and right shifts round to nearest with halves up.
constexpr std::int32_t scale_saturate(std::int64_t v, int n) {
    if (n <= 0)
        return saturate_i32(shift_right_round(v, -n));
    if (v == 0)
        return 0;
    if (n >= 32 || v != static_cast<std::int32_t>(v))
        return v < 0 ? std::numeric_limits<std::int32_t>::min() : std::numeric_limits<std::int32_t>::max();
    return saturate_i32(static_cast<std::int64_t>(static_cast<std::uint64_t>(v) << n));
}

/// -v, with -INT32_MIN = INT32_MAX.
SPANGLE_INLINE constexpr std::int32_t negate_saturate(std::int32_t v) {
    return saturate_i32(-std::int64_t{v});
}

/// min(max(v, low), high).
template <class T> SPANGLE_INLINE constexpr T clamp(T v, T low, T high) {
    return v < low ? low : v > high ? high : v;
}

} // namespace spangle::numeric
