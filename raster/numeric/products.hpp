// Products of words, and parts of products. All functions are defined for every argument.
#pragma once

#include <cstdint>
#include <type_traits>

#include "raster/numeric/registers.hpp"

namespace spangle::numeric {

namespace detail {

/// v modulo 2^16. GCC 12 makes two shifts of a cast, although there is one instruction.
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

/// a * b from products of halves, for machines without long products. It takes 22 instructions on a
/// Cortex-M0+, instead of 50 for 64 by 64 bits. No sum of two terms overflows: (2^16 - 1)^2 + 2^16 - 1 <
/// 2^32, and signed halves are smaller.
template <class A, class B> struct HalvesOf {
    std::uint32_t low; ///< product of the lower halves
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

#if defined(__thumb__) && !defined(__thumb2__)
/// Computes the four products of the halves of a and b: a = a0 b0, b = a0 b1, first = a1 b0, a1 = a1 b1. The
/// upper halves of signed factors are taken by asrs, and those of unsigned factors by lsrs.
#define SPANGLE_PRODUCTS_OF_HALVES(SHIFT_A, SHIFT_B)                                                         \
    "uxth %[b0], %[b]\n\t" SHIFT_A " %[a1], %[a], #16\n\t"                                                   \
    "uxth %[a], %[a]\n\t" SHIFT_B " %[b], %[b], #16\n\t"                                                     \
    "movs %[first], %[b0]\n\t"                                                                               \
    "muls %[first], %[a1], %[first]\n\t"                                                                     \
    "muls %[a1], %[b], %[a1]\n\t"                                                                            \
    "muls %[b], %[a], %[b]\n\t"                                                                              \
    "muls %[a], %[b0], %[a]\n\t"
/// Leaves the upper word of a * b in b and the lower word in a. It takes 17 instructions, three less than GCC
/// 12's code.
#define SPANGLE_PRODUCT_BY_HALVES(SHIFT_A, SHIFT_B)                                                          \
    asm(".syntax unified\n\t" /* NOLINT(hicpp-no-assembler) */                                               \
        SPANGLE_PRODUCTS_OF_HALVES(SHIFT_A, SHIFT_B) "lsls %[b0], %[first], #16\n\t" /**/                    \
        SHIFT_A " %[first], %[first], #16\n\t"                                                               \
                                                     "adds %[a], %[a], %[b0]\n\t"                            \
                                                     "adcs %[a1], %[first]\n\t"                              \
                                                     "lsls %[b0], %[b], #16\n\t" SHIFT_B                     \
                                                     " %[b], %[b], #16\n\t"                                  \
                                                     "adds %[a], %[a], %[b0]\n\t"                            \
                                                     "adcs %[b], %[a1]"                                      \
        : [a] "+l"(a), [b] "+l"(b), [a1] "=&l"(high_a), [b0] "=&l"(low_b), [first] "=&l"(first)              \
        :                                                                                                    \
        : "cc")
#endif

template <class A, class B> [[gnu::noinline, gnu::const]] constexpr std::uint64_t mul_halves(A a, B b) {
#if defined(__thumb__) && !defined(__thumb2__)
    if (!std::is_constant_evaluated()) {
        std::uint32_t high_a, low_b, first;
        if constexpr (std::is_signed_v<B>)
            SPANGLE_PRODUCT_BY_HALVES("asrs", "asrs");
        else if constexpr (std::is_signed_v<A>)
            SPANGLE_PRODUCT_BY_HALVES("asrs", "lsrs");
        else
            SPANGLE_PRODUCT_BY_HALVES("lsrs", "lsrs");
        return std::uint64_t{static_cast<std::uint32_t>(b)} << 32 | static_cast<std::uint32_t>(a);
    }
#endif
    return HalvesOf<A, B>(a, b).product();
}
template <class A, class B> [[gnu::noinline, gnu::const]] constexpr std::uint32_t mul_halves_high(A a, B b) {
    return HalvesOf<A, B>(a, b).high;
}

/// sum + a * b from products of halves. The sum stays in its registers from product to product.
[[gnu::noinline, gnu::const]] constexpr std::int64_t add_halves(std::int64_t sum, std::int32_t a,
                                                                std::int32_t b) {
#if defined(__thumb__) && !defined(__thumb2__)
    if (!std::is_constant_evaluated()) {
        std::uint32_t high_a, low_b, first;
        asm(".syntax unified\n\t" // NOLINT(hicpp-no-assembler)
            SPANGLE_PRODUCTS_OF_HALVES("asrs", "asrs") "adds %Q[sum], %Q[sum], %[a]\n\t"
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

#undef SPANGLE_PRODUCTS_OF_HALVES
#undef SPANGLE_PRODUCT_BY_HALVES

/// (0 - a * b) >> 14, modulo 2^32, from products of halves. The product of the lower halves produces no
/// carry.
SPANGLE_INLINE constexpr std::uint32_t halves_residual(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t a0 = low_half(a), b0 = low_half(b), a1 = a >> 16, b1 = b >> 16;
    return 0 - ((a1 * b1 << 18) + ((a1 * b0 + a0 * b1) << 2) + ((a0 * b0 + 0x3FFF) >> 14));
}

/// Whether to multiply by halves. Where a factor is constant, compilers make shifts and sums instead.
template <class A, class B> SPANGLE_PRODUCT_INLINE constexpr bool by_halves(A a, B b) {
    return !long_products && !__builtin_constant_p(a) && !__builtin_constant_p(b);
}

} // namespace detail

SPANGLE_PRODUCT_INLINE constexpr std::uint64_t mul_u32(std::uint32_t a, std::uint32_t b) {
    if (detail::by_halves(a, b))
        return detail::mul_halves(a, b);
    return std::uint64_t{factor32(a)} * factor32(b);
}
SPANGLE_PRODUCT_INLINE constexpr std::int64_t mul_s32(std::int32_t a, std::int32_t b) {
    if (detail::by_halves(a, b))
        return static_cast<std::int64_t>(detail::mul_halves(a, b));
    return std::int64_t{factor32(a)} * factor32(b);
}
/// Does what mul_s32() does, without factor32().
SPANGLE_PRODUCT_INLINE constexpr std::int64_t mul_long(std::int32_t a, std::int32_t b) {
    if (detail::by_halves(a, b))
        return static_cast<std::int64_t>(detail::mul_halves(a, b));
    return std::int64_t{a} * b;
}
SPANGLE_PRODUCT_INLINE constexpr std::int64_t mul_s32_u32(std::int32_t a, std::uint32_t b) {
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
SPANGLE_PRODUCT_INLINE constexpr std::uint32_t mul_high_u32(std::uint32_t a, std::uint32_t b) {
    if (detail::by_halves(a, b))
        return detail::mul_halves_high(a, b);
    return static_cast<std::uint32_t>(mul_u32(a, b) >> 32);
}
SPANGLE_PRODUCT_INLINE constexpr std::int32_t mul_high_s32(std::int32_t a, std::int32_t b) {
    if (detail::by_halves(a, b))
        return static_cast<std::int32_t>(detail::mul_halves_high(a, b));
    return static_cast<std::int32_t>(mul_s32(a, b) >> 32);
}
SPANGLE_PRODUCT_INLINE constexpr std::int32_t mul_high_s32_u32(std::int32_t a, std::uint32_t b) {
    if (detail::by_halves(a, b))
        return static_cast<std::int32_t>(detail::mul_halves_high(a, b));
    return static_cast<std::int32_t>(mul_s32_u32(a, b) >> 32);
}

namespace detail {

/// v * n modulo 2^64. n is a signed half-word, or 2^15 if v has no bits below 2^16.
SPANGLE_INLINE constexpr std::uint64_t times_half(std::uint64_t v, std::int32_t n) {
#if defined(__thumb__) && !defined(__thumb2__)
    if (!std::is_constant_evaluated()) { // this code has 11 instructions; GCC 12 makes 18
        std::uint32_t middle, other;
        asm(".syntax unified\n\t" // NOLINT(hicpp-no-assembler)
            "lsrs %[middle], %Q[v], #16\n\t"
            "uxth %Q[v], %Q[v]\n\t"
            "muls %Q[v], %[n], %Q[v]\n\t"
            "muls %[middle], %[n], %[middle]\n\t"
            "muls %R[v], %[n], %R[v]\n\t"
            "asrs %[other], %Q[v], #31\n\t"
            "adds %R[v], %R[v], %[other]\n\t"
            "lsls %[other], %[middle], #16\n\t"
            "asrs %[middle], %[middle], #16\n\t"
            "adds %Q[v], %Q[v], %[other]\n\t"
            "adcs %R[v], %[middle]"
            : [v] "+l"(v), [middle] "=&l"(middle), [other] "=&l"(other)
            : [n] "l"(n)
            : "cc");
        return v;
    }
#endif
    const auto low = static_cast<std::uint32_t>(v), high = static_cast<std::uint32_t>(v >> 32);
    const std::int64_t first = static_cast<std::int32_t>(low_half(low)) * n,
                       middle = static_cast<std::int32_t>(low >> 16) * n;
    return static_cast<std::uint64_t>(first) + (static_cast<std::uint64_t>(middle) << 16) +
           (std::uint64_t{high * static_cast<std::uint32_t>(n)} << 32);
}
/// v * n modulo 2^64 for any n. It is faster where n is a half-word, as columns and rows of surfaces are.
[[gnu::noinline, gnu::const]] constexpr std::uint64_t times_by_halves(std::uint64_t v, std::int32_t n) {
    const auto low = static_cast<std::int16_t>(n);
    const std::uint64_t product = times_half(v, low);
    if (n == low) [[likely]]
        return product;
    return product + times_half(v << 16, (n >> 16) + (low < 0 ? 1 : 0));
}

SPANGLE_INLINE constexpr std::uint32_t halves_by_half(std::uint32_t a, std::uint32_t b) {
    return (a >> 16) * b + (low_half(a) * b >> 16);
}

SPANGLE_INLINE constexpr std::int32_t bytes_by_byte(std::int32_t a, std::int32_t b) {
    return (a >> 8) * b + ((a & 255) * b >> 8);
}

} // namespace detail

/// floor(a * b / 2^32) for a b that has no bits below 2^24.
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

/// v * n mod 2^64.
SPANGLE_INLINE constexpr std::uint64_t times(std::uint64_t v, std::int32_t n) {
    if (detail::by_halves(static_cast<std::uint32_t>(v), n))
        return detail::times_by_halves(v, n);
    return v * static_cast<std::uint64_t>(std::int64_t{n});
}

/// The high word of v, rounded to nearest with halves up, modulo 2^32.
SPANGLE_PRODUCT_INLINE constexpr std::int32_t high_rounded(std::int64_t v) {
    const auto u = static_cast<std::uint64_t>(v);
    if constexpr (!wide_words) // on 32-bit machines this is one addition
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(u >> 32) +
                                         (static_cast<std::uint32_t>(u) >> 31));
    return static_cast<std::int32_t>((u + (1u << 31)) >> 32);
}

/// a * b / 2^32, rounded to nearest with halves up. DSP extensions have one instruction for it.
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
/// The sum `to` + mul_high_rounded(a, b), mod 2^32.
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

/// The sum `to` + a b / 2^16, for products below 2^32 and b < 2^15.
SPANGLE_INLINE constexpr std::uint32_t add_product(std::uint32_t to, std::uint32_t a, std::uint32_t b) {
#if defined(__thumb2__) && defined(__ARM_FEATURE_DSP)
    if (!std::is_constant_evaluated()) {
        std::uint32_t r;
        asm("smlawb %0, %1, %2, %3" : "=r"(r) : "r"(a), "r"(b), "r"(to)); // NOLINT(hicpp-no-assembler)
        return r;
    }
#endif
    return to + (a * b >> 16);
}

struct Product128 {
    std::uint64_t high, low;
};

/// a * b in full, from 32-bit products, because 32-bit targets have no 128-bit type.
constexpr Product128 mul_u64(std::uint64_t a, std::uint64_t b) {
    const auto a0 = static_cast<std::uint32_t>(a), a1 = static_cast<std::uint32_t>(a >> 32);
    const auto b0 = static_cast<std::uint32_t>(b), b1 = static_cast<std::uint32_t>(b >> 32);
    const std::uint64_t low = mul_u32(a0, b0);
    const std::uint64_t middle = mul_u32(a1, b0) + (low >> 32); // at most (2^32 - 1) 2^32: no carry lost
    const std::uint64_t cross = mul_u32(a0, b1) + static_cast<std::uint32_t>(middle);
    return {mul_u32(a1, b1) + (middle >> 32) + (cross >> 32), cross << 32 | static_cast<std::uint32_t>(low)};
}

} // namespace spangle::numeric
