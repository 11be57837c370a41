// Functions that make compilers keep words in registers or in memory, or compute words at a certain place.
// None of these functions changes a value.
#pragma once

#include <cstdint>
#include <type_traits>

#include "raster/numeric/machine.hpp"

namespace spangle::numeric {

/// Returns v as a factor of 32 bits. With words of 32 bits, GCC 12 would carry a sign extension that several
/// products share over a branch. It would then multiply 64 by 64 bits, which takes five instructions instead
/// of one.
template <class T> SPANGLE_INLINE constexpr T factor32(T v) {
#if __SIZEOF_POINTER__ == 4
    if (!std::is_constant_evaluated() && !__builtin_constant_p(v))
        asm("" : "+r"(v)); // NOLINT(hicpp-no-assembler): no instruction
#endif
    return v;
}

/// Returns v, but nothing is computed from it before `first` is known. This takes fewer registers where words
/// have 32 bits.
SPANGLE_INLINE std::uint32_t evaluate_after(std::uint32_t v, [[maybe_unused]] std::uint32_t& first) {
#if __SIZEOF_POINTER__ == 4
    asm("" : "+r"(v), "+r"(first)); // NOLINT(hicpp-no-assembler): no instruction
#endif
    return v;
}

/// Keeps compilers from moving the code after a branch before that branch.
SPANGLE_INLINE void begin_here() {
    asm volatile(""); // NOLINT(hicpp-no-assembler): no instruction
}

/// Keeps v in a register on machines with words of 32 bits, so that compilers do not compute it again at
/// every use.
template <class T> SPANGLE_INLINE constexpr T kept_in_register(T v) {
#if __SIZEOF_POINTER__ == 4
    if (!std::is_constant_evaluated())
        asm("" : "+r"(v)); // NOLINT(hicpp-no-assembler): no instruction
#endif
    return v;
}

/// a + b mod 2^32. Both may lie in registers of Thumb that only moves and sums reach. Compilers would hold
/// both in the eight other registers, which are few.
SPANGLE_INLINE constexpr std::uint32_t sum_aside(std::uint32_t a, std::uint32_t b) {
#if defined(__thumb__) && !defined(__thumb2__)
    if (!std::is_constant_evaluated()) {
        asm("add %0, %1" : "+r"(a) : "r"(b) : "cc"); // NOLINT(hicpp-no-assembler)
        return a;
    }
#endif
    return a + b;
}
/// (u >> u_down << u_up) + (v >> v_down), all shifts below 32. u and v may lie in registers that only moves
/// and sums reach, as in sum_aside().
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

/// floor(v / 2^16), computed at this place. On machines where comparisons shift at no cost, a quotient that
/// is shared with later code would take a register in each loop.
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

/// v with its low `Bits` bits cleared. On machines with an instruction for it, a mask would take a register
/// in each loop.
template <int Bits> SPANGLE_INLINE constexpr std::uint32_t without_low(std::uint32_t v) {
#if defined(__thumb2__)
    if (!std::is_constant_evaluated()) {
        asm("bfc %0, #0, %1" : "+r"(v) : "I"(Bits)); // NOLINT(hicpp-no-assembler)
        return v;
    }
#endif
    return v >> Bits << Bits;
}

/// Makes compilers read v from memory where it is used. It serves loops that use more words than Thumb has
/// registers, which compilers would otherwise spill one by one.
template <class T> SPANGLE_INLINE void kept_in_memory([[maybe_unused]] T& v) {
#if defined(__thumb2__)
    asm("" : "+m"(v)); // NOLINT(hicpp-no-assembler): no instruction
#endif
}

/// Two words that one instruction reads, on machines with such an instruction.
template <class A, class B> struct WordPair {
    A a;
    B b;
};
template <class A, class B> SPANGLE_INLINE WordPair<A, B> load_two(const WordPair<A, B>& from) {
#if defined(__thumb2__)
    A a;
    B b;
    asm("ldrd %0, %1, %2" : "=r"(a), "=r"(b) : "o"(from)); // NOLINT(hicpp-no-assembler)
    return {a, b};
#else
    return from;
#endif
}
/// Does what load_two() does, but only after `first` is computed, which takes fewer registers.
template <class A, class B>
SPANGLE_INLINE WordPair<A, B> load_two_after([[maybe_unused]] std::uint32_t& first,
                                             const WordPair<A, B>& from) {
#if defined(__thumb2__)
    A a;
    B b;
    asm("ldrd %0, %1, %3" : "=&r"(a), "=&r"(b), "+r"(first) : "o"(from)); // NOLINT(hicpp-no-assembler)
    return {a, b};
#else
    return from;
#endif
}

} // namespace spangle::numeric
