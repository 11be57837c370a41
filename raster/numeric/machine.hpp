// What the machine has that code is compiled for, and whether kernels are in line.
#pragma once

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
/// For those that are an instruction or two wherever there are products of words.
#if defined(__thumb__) && !defined(__thumb2__)
#define SPANGLE_PRODUCT_INLINE SPANGLE_INLINE
#else
#define SPANGLE_PRODUCT_INLINE [[gnu::always_inline]] inline
#endif
/// For those that a run of several pixels, or three and four dimensions, share: smaller builds have one copy,
/// of code for size (cold), whatever else is built for speed.
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

/// SPANGLE_RUN_INLINE is.
inline constexpr bool runs_inline = SPANGLE_KERNELS_INLINE != 0;

/// What reciprocals and roots begin with is looked up, else it is computed: the same numbers.
inline constexpr bool has_seed_tables = SPANGLE_SEED_TABLES != 0;

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

/// The high half of a product of a word and a signed half is added to another by one instruction. Decides
/// between forms of equal results.
#if defined(__thumb2__) && defined(__ARM_FEATURE_DSP)
inline constexpr bool adds_products = true;
#else
inline constexpr bool adds_products = false;
#endif

/// An instruction puts bits of one word into another. Decides between forms of equal results.
#if defined(__thumb2__)
inline constexpr bool inserts_bits = true;
#else
inline constexpr bool inserts_bits = false;
#endif

} // namespace spangle::numeric
