// Integer words: leading zeros, high products, shifts that round, values that saturate. Defined for every
// argument.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

#ifndef SPANGLE_KERNELS_INLINE
#define SPANGLE_KERNELS_INLINE 1
#endif
/// For kernels whose call would cost more than their body. Where a build says so, code for size (-Os) has
/// calls.
#if defined(__OPTIMIZE_SIZE__) && !SPANGLE_KERNELS_INLINE
#define SPANGLE_INLINE inline
#else
#define SPANGLE_INLINE [[gnu::always_inline]] inline
#endif
/// For those that a run of several pixels shares: smaller builds have one copy, whatever else is built for
/// speed.
#if SPANGLE_KERNELS_INLINE
#define SPANGLE_RUN_INLINE SPANGLE_INLINE
#define SPANGLE_RUN_CALL
#define SPANGLE_RUN_LAMBDA
#else
#define SPANGLE_RUN_INLINE [[gnu::noinline]] inline
#define SPANGLE_RUN_CALL [[gnu::noinline]]
#define SPANGLE_RUN_LAMBDA __attribute__((noinline))
#endif

namespace spangle::numeric {

/// Registers hold 64 bits. Decides between forms of equal results.
inline constexpr bool wide_words = sizeof(void*) > 4;

/// A branch that is taken at random costs no more than any other: so it is in the short pipelines of
/// microcontrollers. Decides likewise.
inline constexpr bool cheap_branches = !wide_words;

/// 32-bit words are divided by an instruction. Decides likewise.
#if (defined(__arm__) && !defined(__ARM_FEATURE_IDIV)) || (defined(__riscv) && !defined(__riscv_div))
inline constexpr bool divides = false;
#else
inline constexpr bool divides = true;
#endif

/// There are products of two words. Decides likewise.
#if defined(__thumb__) && !defined(__thumb2__)
inline constexpr bool long_products = false;
#else
inline constexpr bool long_products = true;
#endif

/// Addresses are a base and an index times the size of what lies there. Decides likewise.
#if (defined(__thumb__) && !defined(__thumb2__)) || defined(__riscv)
inline constexpr bool scales_indices = false;
#else
inline constexpr bool scales_indices = true;
#endif

/// Instructions have three operands, masks among them. Else fields of words move by shifts, and an address of
/// two registers is made where it is used. Decides likewise.
#if defined(__thumb__) && !defined(__thumb2__)
inline constexpr bool three_operands = false;
#else
inline constexpr bool three_operands = true;
#endif

/// Leading zeros; 32 for 0.
SPANGLE_INLINE constexpr int clz32(std::uint32_t v) {
    return std::countl_zero(v);
}

/// Leading zeros of values that mostly have as many as the one before them: where a call counts them, that
/// is looked at first.
template <bool Counted = long_products> class LeadingZeros {
  public:
    SPANGLE_INLINE constexpr int of(std::uint32_t v) {
        if (v >> down_ == 1)
            return 31 - down_;
        const int zeros = clz32(v);
        down_ = (31 - zeros) & 31; // 0 has 32
        return zeros;
    }

  private:
    int down_ = 31; ///< that leave 1 of the value before
};
template <> class LeadingZeros<true> {
  public:
    SPANGLE_INLINE static constexpr int of(std::uint32_t v) { return clz32(v); }
};

/// Leading zeros; 64 for 0.
SPANGLE_INLINE constexpr int clz64(std::uint64_t v) {
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

/// Bits needed for the value without its sign: |v| < 2^n for v >= 0, |v| <= 2^n for v < 0; 0 for 0 and -1.
SPANGLE_INLINE constexpr int signed_width32(std::int32_t v) {
    return 32 - clz32(static_cast<std::uint32_t>(v ^ (v >> 31)));
}

/// A factor as 32 bits and nothing else. Where words have 32 bits GCC 12 would carry a sign extension that it
/// shares among products over a branch, and then multiply 64 by 64 bits: five instructions in place of one.
template <class T> SPANGLE_INLINE constexpr T factor32(T v) {
#if __SIZEOF_POINTER__ == 4
    if (!std::is_constant_evaluated() && !__builtin_constant_p(v))
        asm("" : "+r"(v)); // NOLINT(hicpp-no-assembler): no instruction
#endif
    return v;
}

/// v, of which nothing is computed before `first` is: fewer registers, where words have 32 bits.
SPANGLE_INLINE std::uint32_t later(std::uint32_t v, [[maybe_unused]] std::uint32_t& first) {
#if __SIZEOF_POINTER__ == 4
    asm("" : "+r"(v), "+r"(first)); // NOLINT(hicpp-no-assembler): no instruction
#endif
    return v;
}

/// What follows a branch is not begun before it.
SPANGLE_INLINE void begin_here() {
    asm volatile(""); // NOLINT(hicpp-no-assembler): no instruction
}

namespace detail {

SPANGLE_INLINE constexpr bool shift_loses(std::int32_t v, std::uint32_t n) {
    return n > 31 || static_cast<std::int32_t>(static_cast<std::uint32_t>(v) << n) >> n != v;
}

} // namespace detail

/// Whether v * 2^n has bits that a word has not.
SPANGLE_INLINE constexpr bool loses(std::int32_t v, std::uint32_t n) {
    if constexpr (three_operands)
        return n >= static_cast<std::uint32_t>(clz32(static_cast<std::uint32_t>(v ^ (v >> 31))));
    return detail::shift_loses(v, n); // zeros are counted by a call
}

/// v in a register, where words have 32 bits: compilers do not make it anew at every use.
template <class T> SPANGLE_INLINE constexpr T kept_in_register(T v) {
#if __SIZEOF_POINTER__ == 4
    if (!std::is_constant_evaluated())
        asm("" : "+r"(v)); // NOLINT(hicpp-no-assembler): no instruction
#endif
    return v;
}

/// a + b mod 2^32, of words that may be in registers which nothing but moves and sums reach: the eight others
/// of Thumb are few, and compilers would have both in them.
SPANGLE_INLINE constexpr std::uint32_t sum_aside(std::uint32_t a, std::uint32_t b) {
#if defined(__thumb__) && !defined(__thumb2__)
    if (!std::is_constant_evaluated()) {
        asm("add %0, %1" : "+r"(a) : "r"(b) : "cc"); // NOLINT(hicpp-no-assembler)
        return a;
    }
#endif
    return a + b;
}
/// (u >> u_down << u_up) + (v >> v_down) of such u and v, all shifts below 32.
SPANGLE_INLINE constexpr std::uint32_t joined_aside(std::uint32_t u, int u_down, int u_up, std::uint32_t v,
                                                    int v_down) {
#if defined(__thumb__) && !defined(__thumb2__)
    if (!std::is_constant_evaluated()) {
        std::uint32_t r, low;
        asm(".syntax unified\n\t" // NOLINT(hicpp-no-assembler)
            "mov %0, %2\n\t"
            "lsrs %0, %0, %4\n\t"
            "lsls %0, %0, %5\n\t"
            "mov %1, %3\n\t"
            "lsrs %1, %1, %6\n\t"
            "adds %0, %0, %1"
            : "=&l"(r), "=&l"(low)
            : "r"(u), "r"(v), "l"(u_down), "l"(u_up), "l"(v_down)
            : "cc");
        return r;
    }
#endif
    return (u >> u_down << u_up) + (v >> v_down);
}

/// `Bits` bits of a word, from bit `At` on.
template <int At, int Bits> SPANGLE_INLINE constexpr std::uint32_t bit_field(std::uint32_t v) {
    if constexpr (three_operands)
        return v >> At & ((1u << Bits) - 1);
    return factor32(v << (32 - At - Bits)) >> (32 - Bits);
}

/// floor(v / 2^16), taken here: where a comparison shifts for nothing, a quotient that it shares with what
/// follows would take a register in each loop.
SPANGLE_INLINE constexpr std::uint32_t high_half_here(std::uint32_t v) {
#if defined(__thumb2__)
    if (!std::is_constant_evaluated()) {
        std::uint32_t half;
        asm("lsr %0, %1, #16" : "=r"(half) : "r"(v)); // NOLINT(hicpp-no-assembler)
        return half;
    }
#endif
    return v >> 16;
}

/// v without v mod 2^16. Where there is an instruction, a mask would take a register in each loop.
SPANGLE_INLINE constexpr std::uint32_t without_low_half(std::uint32_t v) {
#if defined(__thumb2__)
    if (!std::is_constant_evaluated()) {
        asm("bfc %0, #0, #16" : "+r"(v)); // NOLINT(hicpp-no-assembler)
        return v;
    }
#endif
    return v & 0xFFFF0000;
}

/// v is read where it is used, not held in registers: for loops with more words than Thumb has registers,
/// which compilers would put aside one by one.
template <class T> SPANGLE_INLINE void kept_in_memory([[maybe_unused]] T& v) {
#if defined(__thumb2__)
    asm("" : "+m"(v)); // NOLINT(hicpp-no-assembler): no instruction
#endif
}

/// What one instruction reads, where there is one that reads two words.
template <class A, class B> struct Two {
    A a;
    B b;
};
template <class A, class B> SPANGLE_INLINE Two<A, B> load_two(const Two<A, B>& from) {
#if defined(__thumb2__)
    A a;
    B b;
    asm("ldrd %0, %1, %2" : "=r"(a), "=r"(b) : "o"(from)); // NOLINT(hicpp-no-assembler)
    return {a, b};
#else
    return from;
#endif
}
/// The same, not before `first` is computed: fewer registers.
template <class A, class B>
SPANGLE_INLINE Two<A, B> load_two_after([[maybe_unused]] std::uint32_t& first, const Two<A, B>& from) {
#if defined(__thumb2__)
    A a;
    B b;
    asm("ldrd %0, %1, %3" : "=&r"(a), "=&r"(b), "+r"(first) : "o"(from)); // NOLINT(hicpp-no-assembler)
    return {a, b};
#else
    return from;
#endif
}

/// An instruction puts bits of one word into another. Decides between forms of equal results.
#if defined(__thumb2__)
inline constexpr bool inserts_bits = true;
#else
inline constexpr bool inserts_bits = false;
#endif

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

/// floor(v / 2^n) for any n < 2^31. What ARM shifts by may be up to 255, which takes a test less.
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

/// The same for n < 256.
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

/// The low word of floor(v / 2^n), 0 < n < 32: three instructions where words have 32 bits.
SPANGLE_INLINE constexpr std::uint32_t low_word_after(std::int64_t v, int n) {
    if constexpr (wide_words)
        return static_cast<std::uint32_t>(v >> n);
    return static_cast<std::uint32_t>(v) >> n | static_cast<std::uint32_t>(v >> 32) << (32 - n);
}
/// Both of its words: four.
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
/// floor(v / 2^Down), but at least 0 and at most 2^Bits - 1.
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

/// v mod 2^16. Of a cast GCC 12 makes two shifts where there is an instruction.
SPANGLE_INLINE constexpr std::uint32_t low_half(std::uint32_t v) {
#if defined(__thumb__) && !defined(__thumb2__)
    if (!std::is_constant_evaluated()) {
        std::uint32_t r;
        asm("uxth %0, %1" : "=l"(r) : "l"(v)); // NOLINT(hicpp-no-assembler)
        return r;
    }
#endif
    return v & 0xFFFF;
}

/// a * b from products of halves, where there are no long ones: 22 instructions on a Cortex-M0+, in place of
/// 50 for 64 by 64 bits. No sum of two overflows: (2^16 - 1)^2 + 2^16 - 1 < 2^32, and of signed halves they
/// are smaller.
template <class A, class B> struct HalvesOf {
    std::uint32_t low; ///< of the lower halves
    B middle;
    std::uint32_t high;
    SPANGLE_INLINE constexpr HalvesOf(A a, B b) {
        const std::uint32_t a0 = low_half(static_cast<std::uint32_t>(a)),
                            b0 = low_half(static_cast<std::uint32_t>(b));
        const A a1 = a >> 16;
        const B b1 = b >> 16;
        low = a0 * b0;
        const A first = a1 * static_cast<A>(b0) + static_cast<A>(low >> 16);
        middle = static_cast<B>(a0) * b1 + static_cast<B>(low_half(static_cast<std::uint32_t>(first)));
        high = static_cast<std::uint32_t>(a1) * static_cast<std::uint32_t>(b1) +
               static_cast<std::uint32_t>(first >> 16) + static_cast<std::uint32_t>(middle >> 16);
    }
    SPANGLE_INLINE constexpr std::uint64_t product() const {
        return std::uint64_t{high} << 32 | (static_cast<std::uint32_t>(middle) << 16 | low_half(low));
    }
};

template <class A, class B> [[gnu::noinline, gnu::const]] constexpr std::uint64_t mul_halves(A a, B b) {
#if defined(__thumb__) && !defined(__thumb2__)
    if constexpr (std::is_signed_v<A> && std::is_signed_v<B>)
        if (!std::is_constant_evaluated()) { // 17 of them: GCC 12 takes three more
            std::uint32_t high_a, low_b, first;
            asm(".syntax unified\n\t" // NOLINT(hicpp-no-assembler)
                "uxth %[b0], %[b]\n\t"
                "asrs %[a1], %[a], #16\n\t"
                "uxth %[a], %[a]\n\t"
                "asrs %[b], %[b], #16\n\t"
                "movs %[first], %[b0]\n\t"
                "muls %[first], %[a1], %[first]\n\t"
                "muls %[a1], %[b], %[a1]\n\t"
                "muls %[b], %[a], %[b]\n\t"
                "muls %[a], %[b0], %[a]\n\t"
                "lsls %[b0], %[first], #16\n\t"
                "asrs %[first], %[first], #16\n\t"
                "adds %[a], %[a], %[b0]\n\t"
                "adcs %[a1], %[first]\n\t"
                "lsls %[b0], %[b], #16\n\t"
                "asrs %[b], %[b], #16\n\t"
                "adds %[a], %[a], %[b0]\n\t"
                "adcs %[b], %[a1]"
                : [a] "+l"(a), [b] "+l"(b), [a1] "=&l"(high_a), [b0] "=&l"(low_b), [first] "=&l"(first)
                :
                : "cc");
            return std::uint64_t{static_cast<std::uint32_t>(b)} << 32 | static_cast<std::uint32_t>(a);
        }
#endif
    return HalvesOf<A, B>(a, b).product();
}
template <class A, class B> [[gnu::noinline, gnu::const]] constexpr std::uint32_t mul_halves_high(A a, B b) {
    return HalvesOf<A, B>(a, b).high;
}

/// sum + a * b, likewise: the sum stays where it is from product to product.
[[gnu::noinline, gnu::const]] constexpr std::int64_t add_halves(std::int64_t sum, std::int32_t a,
                                                                std::int32_t b) {
#if defined(__thumb__) && !defined(__thumb2__)
    if (!std::is_constant_evaluated()) {
        std::uint32_t high_a, low_b, first;
        asm(".syntax unified\n\t" // NOLINT(hicpp-no-assembler)
            "uxth %[b0], %[b]\n\t"
            "asrs %[a1], %[a], #16\n\t"
            "uxth %[a], %[a]\n\t"
            "asrs %[b], %[b], #16\n\t"
            "movs %[first], %[b0]\n\t"
            "muls %[first], %[a1], %[first]\n\t"
            "muls %[a1], %[b], %[a1]\n\t"
            "muls %[b], %[a], %[b]\n\t"
            "muls %[a], %[b0], %[a]\n\t"
            "adds %Q[sum], %Q[sum], %[a]\n\t"
            "adcs %R[sum], %[a1]\n\t"
            "lsls %[b0], %[first], #16\n\t"
            "asrs %[first], %[first], #16\n\t"
            "adds %Q[sum], %Q[sum], %[b0]\n\t"
            "adcs %R[sum], %[first]\n\t"
            "lsls %[b0], %[b], #16\n\t"
            "asrs %[b], %[b], #16\n\t"
            "adds %Q[sum], %Q[sum], %[b0]\n\t"
            "adcs %R[sum], %[b]"
            : [sum] "+l"(sum), [a] "+l"(a), [b] "+l"(b), [a1] "=&l"(high_a), [b0] "=&l"(low_b),
              [first] "=&l"(first)
            :
            : "cc");
        return sum;
    }
#endif
    return sum + static_cast<std::int64_t>(mul_halves(a, b));
}

/// (0 - a * b) >> 14, mod 2^32, by halves: no carry goes from the product of the lower ones.
SPANGLE_INLINE constexpr std::uint32_t halves_residual(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t a0 = low_half(a), b0 = low_half(b), a1 = a >> 16, b1 = b >> 16;
    return 0 - ((a1 * b1 << 18) + ((a1 * b0 + a0 * b1) << 2) + ((a0 * b0 + 0x3FFF) >> 14));
}

/// Of factors that compilers know they make shifts and sums.
template <class A, class B> SPANGLE_INLINE constexpr bool by_halves(A a, B b) {
    return !long_products && !__builtin_constant_p(a) && !__builtin_constant_p(b);
}

} // namespace detail

SPANGLE_INLINE constexpr std::uint64_t mul_u32(std::uint32_t a, std::uint32_t b) {
    if (detail::by_halves(a, b))
        return detail::mul_halves(a, b);
    return std::uint64_t{factor32(a)} * factor32(b);
}
SPANGLE_INLINE constexpr std::int64_t mul_s32(std::int32_t a, std::int32_t b) {
    if (detail::by_halves(a, b))
        return static_cast<std::int64_t>(detail::mul_halves(a, b));
    return std::int64_t{factor32(a)} * factor32(b);
}
/// The same without factor32().
SPANGLE_INLINE constexpr std::int64_t mul_long(std::int32_t a, std::int32_t b) {
    if (detail::by_halves(a, b))
        return static_cast<std::int64_t>(detail::mul_halves(a, b));
    return std::int64_t{a} * b;
}
SPANGLE_INLINE constexpr std::int64_t mul_s32_u32(std::int32_t a, std::uint32_t b) {
    if (detail::by_halves(a, b))
        return static_cast<std::int64_t>(detail::mul_halves(a, b));
    return std::int64_t{a} * b;
}

/// The low word of floor(-a * b / 2^14).
SPANGLE_INLINE constexpr std::uint32_t mul_residual(std::uint32_t a, std::uint32_t b) {
    if (detail::by_halves(a, b))
        return detail::halves_residual(a, b);
    return static_cast<std::uint32_t>((0 - mul_u32(a, b)) >> 14);
}

/// floor(a * b / 2^32).
SPANGLE_INLINE constexpr std::uint32_t mul_high_u32(std::uint32_t a, std::uint32_t b) {
    if (detail::by_halves(a, b))
        return detail::mul_halves_high(a, b);
    return static_cast<std::uint32_t>(mul_u32(a, b) >> 32);
}
SPANGLE_INLINE constexpr std::int32_t mul_high_s32(std::int32_t a, std::int32_t b) {
    if (detail::by_halves(a, b))
        return static_cast<std::int32_t>(detail::mul_halves_high(a, b));
    return static_cast<std::int32_t>(mul_s32(a, b) >> 32);
}
SPANGLE_INLINE constexpr std::int32_t mul_high_s32_u32(std::int32_t a, std::uint32_t b) {
    if (detail::by_halves(a, b))
        return static_cast<std::int32_t>(detail::mul_halves_high(a, b));
    return static_cast<std::int32_t>(mul_s32_u32(a, b) >> 32);
}

namespace detail {

[[gnu::noinline, gnu::const]] constexpr std::uint64_t times_by_words(std::uint64_t v, std::int32_t n) {
    const std::uint32_t high = static_cast<std::uint32_t>(v >> 32) * static_cast<std::uint32_t>(n);
    return HalvesOf<std::int32_t, std::uint32_t>(n, static_cast<std::uint32_t>(v)).product() +
           (std::uint64_t{high} << 32);
}

} // namespace detail

namespace detail {

SPANGLE_INLINE constexpr std::uint32_t halves_by_half(std::uint32_t a, std::uint32_t b) {
    return (a >> 16) * b + (low_half(a) * b >> 16);
}

} // namespace detail

namespace detail {

SPANGLE_INLINE constexpr std::int32_t bytes_by_byte(std::int32_t a, std::int32_t b) {
    return (a >> 8) * b + ((a & 255) * b >> 8);
}

} // namespace detail

/// floor(a * b / 2^32) of a b that has no bits below 2^24.
SPANGLE_INLINE constexpr std::int32_t mul_high_byte(std::int32_t a, std::int32_t b) {
    if (detail::by_halves(a, b))
        return detail::bytes_by_byte(a, b >> 24);
    return mul_high_s32(b, a);
}

/// floor(a * b / 2^16), b < 2^16.
SPANGLE_INLINE constexpr std::uint32_t mul_by_half(std::uint32_t a, std::uint32_t b) {
    if (detail::by_halves(a, b))
        return detail::halves_by_half(a, b);
    return mul_high_u32(a, b << 16);
}

namespace detail {

/// n mod D, n < 2^16, by 1 / D rounded up.
template <std::uint32_t D> struct ShortRemainder {
    static constexpr int bits = 15 + std::bit_width(D);
    static constexpr std::uint32_t one = 1u << bits, inverse = one / D + 1, excess = inverse * D - one;
    static constexpr bool exact = excess <= one >> 16; ///< no quotient sees what it is too large by
    SPANGLE_INLINE static constexpr std::uint32_t of(std::uint32_t n) {
        return n - (n * inverse >> bits) * D;
    }
};

} // namespace detail

/// n mod D. Where there are no long products, compilers divide.
template <std::uint32_t D> SPANGLE_INLINE constexpr std::uint32_t remainder(std::uint32_t n) {
    using Short = detail::ShortRemainder<D>;
    if (!long_products && !std::has_single_bit(D) && Short::exact && n >> 16 == 0)
        return Short::of(n);
    return n % D;
}

/// v * n mod 2^64.
SPANGLE_INLINE constexpr std::uint64_t times(std::uint64_t v, std::int32_t n) {
    if (detail::by_halves(static_cast<std::uint32_t>(v), n))
        return detail::times_by_words(v, n);
    return v * static_cast<std::uint64_t>(std::int64_t{n});
}

/// The high word of v, nearest, halves up, mod 2^32.
SPANGLE_INLINE constexpr std::int32_t high_rounded(std::int64_t v) {
    const auto u = static_cast<std::uint64_t>(v);
    if constexpr (!wide_words) // two of them: one addition
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(u >> 32) +
                                         (static_cast<std::uint32_t>(u) >> 31));
    return static_cast<std::int32_t>((u + (1u << 31)) >> 32);
}

/// a * b / 2^32, nearest, halves up: where there are DSP instructions, one of them.
SPANGLE_INLINE constexpr std::int32_t mul_high_rounded(std::int32_t a, std::int32_t b) {
#if defined(__thumb2__) && defined(__ARM_FEATURE_DSP)
    if (!std::is_constant_evaluated()) {
        std::int32_t r;
        asm("smmulr %0, %1, %2" : "=r"(r) : "r"(a), "r"(b)); // NOLINT(hicpp-no-assembler)
        return r;
    }
#endif
    return high_rounded(mul_s32(a, b));
}
/// v * 2^n, 0 <= n < 32, in two words.
SPANGLE_INLINE constexpr std::int64_t shifted_up(std::int32_t v, int n) {
    const auto high = static_cast<std::uint32_t>((v >> 1) >> (31 - n));
    return static_cast<std::int64_t>(std::uint64_t{high} << 32 | static_cast<std::uint32_t>(v) << n);
}
/// That and `to`, mod 2^32.
SPANGLE_INLINE constexpr std::int32_t add_high_rounded(std::int32_t to, std::int32_t a, std::int32_t b) {
#if defined(__thumb2__) && defined(__ARM_FEATURE_DSP)
    if (!std::is_constant_evaluated()) {
        std::int32_t r;
        asm("smmlar %0, %1, %2, %3" : "=r"(r) : "r"(a), "r"(b), "r"(to)); // NOLINT(hicpp-no-assembler)
        return r;
    }
#endif
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(to) +
                                     static_cast<std::uint32_t>(mul_high_rounded(a, b)));
}

/// Nearest to v / 2^n, halves up; n <= 0 leaves v as it is, no n overflows.
SPANGLE_INLINE constexpr std::int32_t shift_right_round(std::int32_t v, int n) {
    if (n <= 0)
        return v;
    if (n > 31)
        return 0;
    return (v >> n) + ((v >> (n - 1)) & 1);
}
SPANGLE_INLINE constexpr std::int64_t shift_right_round(std::int64_t v, int n) {
    if (n <= 0)
        return v;
    if (n > 63)
        return 0;
    return (v >> n) + ((v >> (n - 1)) & 1);
}

/// Nearest to v / 2^n, ties to even; n >= 0.
constexpr std::uint64_t shift_right_even(std::uint64_t v, int n) {
    if (n <= 0)
        return v;
    if (n > 64)
        return 0;
    constexpr std::uint64_t half = std::uint64_t{1} << 63;
    if (n == 64)
        return v > half ? 1 : 0;
    const std::uint64_t quotient = v >> n;
    const std::uint64_t rest = v << (64 - n);
    return quotient + (rest > half || (rest == half && (quotient & 1) != 0) ? 1u : 0u);
}

/// v / 2^n rounded down with every lost bit kept as one in the lowest place ("sticky"): rounding stays exact
/// later.
constexpr std::uint64_t shift_right_sticky(std::uint64_t v, int n) {
    if (n <= 0)
        return v;
    if (n > 63)
        return v != 0 ? 1u : 0u;
    return (v >> n) | ((v << (64 - n)) != 0 ? 1u : 0u);
}

struct Product128 {
    std::uint64_t high, low;
};

/// a * b in full, from 32-bit products: there is no 128-bit type on 32-bit targets.
constexpr Product128 mul_u64(std::uint64_t a, std::uint64_t b) {
    const auto a0 = static_cast<std::uint32_t>(a), a1 = static_cast<std::uint32_t>(a >> 32);
    const auto b0 = static_cast<std::uint32_t>(b), b1 = static_cast<std::uint32_t>(b >> 32);
    const std::uint64_t low = mul_u32(a0, b0);
    const std::uint64_t middle = mul_u32(a1, b0) + (low >> 32); // at most (2^32 - 1) 2^32: no carry lost
    const std::uint64_t cross = mul_u32(a0, b1) + static_cast<std::uint32_t>(middle);
    return {mul_u32(a1, b1) + (middle >> 32) + (cross >> 32), cross << 32 | static_cast<std::uint32_t>(low)};
}

SPANGLE_INLINE constexpr std::int32_t saturate_i32(std::int64_t v) {
    constexpr std::int64_t low = std::numeric_limits<std::int32_t>::min();
    constexpr std::int64_t high = std::numeric_limits<std::int32_t>::max();
    return static_cast<std::int32_t>(v < low ? low : v > high ? high : v);
}

/// v * 2^n as int32: left shifts saturate, right shifts round to nearest (halves up).
constexpr std::int32_t scale_saturate(std::int64_t v, int n) {
    if (n <= 0)
        return saturate_i32(shift_right_round(v, -n));
    const std::int32_t limit =
        v < 0 ? std::numeric_limits<std::int32_t>::min() : std::numeric_limits<std::int32_t>::max();
    if (v == 0)
        return 0;
    if (n >= 32 || v > std::numeric_limits<std::int32_t>::max() ||
        v < std::numeric_limits<std::int32_t>::min())
        return limit;
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
