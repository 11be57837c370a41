// Properties of the machine that code is compiled for, and whether kernels are inline.
#pragma once

#ifndef SPANGLE_KERNELS_INLINE
#define SPANGLE_KERNELS_INLINE 1
#endif
/// SPANGLE_INLINE marks kernels whose call would cost more than their body. With SPANGLE_KERNELS_INLINE=0,
/// code that is compiled for size (-Os) calls these kernels.
#if defined(__OPTIMIZE_SIZE__) && !SPANGLE_KERNELS_INLINE
#define SPANGLE_INLINE inline
#else
#define SPANGLE_INLINE [[gnu::always_inline]] inline
#endif
/// SPANGLE_PRODUCT_INLINE marks kernels of one or two instructions on machines with long products.
#if defined(__thumb__) && !defined(__thumb2__)
#define SPANGLE_PRODUCT_INLINE SPANGLE_INLINE
#else
#define SPANGLE_PRODUCT_INLINE [[gnu::always_inline]] inline
#endif
/// SPANGLE_RUN_INLINE marks kernels that several pixels of a run share, or that serve three and four
/// dimensions. Smaller builds have one copy of each, compiled for size (cold), even where all other code is
/// compiled for speed.
#if SPANGLE_KERNELS_INLINE
#define SPANGLE_RUN_INLINE SPANGLE_INLINE
#define SPANGLE_RUN_CALL
#define SPANGLE_RUN_SELDOM [[gnu::noinline]]
#define SPANGLE_RUN_LAMBDA
#define SPANGLE_RUN_INLINE_LAMBDA __attribute__((always_inline))
#else
#define SPANGLE_RUN_INLINE [[gnu::noinline, gnu::cold]] inline
#define SPANGLE_RUN_CALL [[gnu::noinline, gnu::cold]]
#define SPANGLE_RUN_SELDOM [[gnu::noinline, gnu::cold]]
#define SPANGLE_RUN_LAMBDA __attribute__((noinline, cold))
#define SPANGLE_RUN_INLINE_LAMBDA __attribute__((noinline, cold))
#endif

#ifndef SPANGLE_SEED_TABLES
#define SPANGLE_SEED_TABLES 1
#endif

namespace spangle::numeric {

/// Whether kernels marked SPANGLE_RUN_INLINE are inline.
inline constexpr bool runs_inline = SPANGLE_KERNELS_INLINE != 0;

/// Seeds of reciprocals and roots are looked up in tables. Otherwise they are computed, with the same
/// numbers.
inline constexpr bool has_seed_tables = SPANGLE_SEED_TABLES != 0;

/// Registers hold 64 bits. This constant, and those below it, only select between forms with equal results.
inline constexpr bool wide_words = sizeof(void*) > 4;

/// A branch whose outcome is hard to predict costs no more than any other, as in the short pipelines of
/// microcontrollers.
inline constexpr bool cheap_branches = !wide_words;

/// Whether the machine has an instruction that divides 32-bit words.
#if (defined(__arm__) && !defined(__ARM_FEATURE_IDIV)) || (defined(__riscv) && !defined(__riscv_div))
inline constexpr bool divides = false;
#else
inline constexpr bool divides = true;
#endif

/// An instruction multiplies two words to a product of 64 bits.
#if defined(__thumb__) && !defined(__thumb2__)
inline constexpr bool long_products = false;
#else
inline constexpr bool long_products = true;
#endif

/// An address may be a base and an index times the size of an element.
#if (defined(__thumb__) && !defined(__thumb2__)) || defined(__riscv)
inline constexpr bool scales_indices = false;
#else
inline constexpr bool scales_indices = true;
#endif

/// Instructions have three operands, which may be masks. Otherwise shifts move fields of words, and an
/// address that is a sum of two registers is computed where it is used.
#if defined(__thumb__) && !defined(__thumb2__)
inline constexpr bool three_operands = false;
#else
inline constexpr bool three_operands = true;
#endif

/// One instruction adds the high part of a product of a word and a signed half to another word.
#if defined(__thumb2__) && defined(__ARM_FEATURE_DSP)
inline constexpr bool adds_products = true;
#else
inline constexpr bool adds_products = false;
#endif

/// Whether the machine has an instruction that inserts bits of one word into another.
#if defined(__thumb2__)
inline constexpr bool inserts_bits = true;
#else
inline constexpr bool inserts_bits = false;
#endif

} // namespace spangle::numeric
