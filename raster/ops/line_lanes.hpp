// Lines side by side, in signed words of 32 bits, one word per line. Processors without vectors handle one
// line at a time. Processors with vectors handle four, by the vector extensions of gcc and clang.
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>

#include "raster/numeric/bits.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

template <int Count> struct LineLanes;

template <> struct LineLanes<1> {
    static constexpr int count = 1;
    using Int = std::int32_t;
    using Word = std::uint32_t;
    using Mask = bool;
    SPANGLE_INLINE static Int load(const std::int32_t* at) { return *at; }
    SPANGLE_INLINE static void store(std::int32_t* at, Int v) { *at = v; }
    SPANGLE_INLINE static std::int32_t first(Int v) { return v; }
    SPANGLE_INLINE static Mask less(Int a, Int b) { return a < b; }
    SPANGLE_INLINE static Mask no(Mask m) { return !m; }
    SPANGLE_INLINE static bool any(Mask m) { return m; }
    SPANGLE_INLINE static Int one(Mask m) { return static_cast<Int>(m); }
    template <class T> SPANGLE_INLINE static T select(Mask m, T a, T b) { return m ? a : b; }
    /// Exchanges a and b where m is true.
    SPANGLE_INLINE static void exchange(Mask m, Int& a, Int& b) {
        const Int first = m ? b : a;
        b = m ? a : b;
        a = first;
    }
    SPANGLE_INLINE static Int negate(Mask m, Int v) { return m ? -v : v; }
    /// Divides n by d, 0 <= n < 5 d. Returns the quotient and leaves the remainder in n.
    SPANGLE_INLINE static Int divide_small(Int& n, Int d) {
        Int whole = 0;
        if constexpr (numeric::divides) {
            whole = static_cast<Int>(static_cast<std::uint32_t>(n) / static_cast<std::uint32_t>(d));
            n -= whole * d;
        } else {
            for (; n >= d; ++whole)
                n -= d;
        }
        return whole;
    }
};

template <> struct LineLanes<4> {
    static constexpr int count = 4;
    using Int [[gnu::vector_size(16)]] = std::int32_t;
    using Word [[gnu::vector_size(16)]] = std::uint32_t;
    using Mask = Int; ///< all ones where the mask is true
    SPANGLE_INLINE static Int load(const std::int32_t* at) {
        Int v;
        __builtin_memcpy(&v, at, sizeof v);
        return v;
    }
    SPANGLE_INLINE static void store(std::int32_t* at, Int v) { __builtin_memcpy(at, &v, sizeof v); }
    SPANGLE_INLINE static std::int32_t first(Int v) { return v[0]; }
    SPANGLE_INLINE static Mask less(Int a, Int b) { return a < b; }
    SPANGLE_INLINE static Mask no(Mask m) { return ~m; }
    /// The next functions take masks whose value is known to the compiler and the same in all lanes.
    template <bool Known> SPANGLE_INLINE static std::bool_constant<!Known> no(std::bool_constant<Known>) {
        return {};
    }
    template <bool Known> SPANGLE_INLINE static Int select(std::bool_constant<Known>, Int a, Int b) {
        return Known ? a : b;
    }
    template <bool Known> SPANGLE_INLINE static void exchange(std::bool_constant<Known>, Int& a, Int& b) {
        if constexpr (Known) {
            const Int first = a;
            a = b;
            b = first;
        }
    }
    /// Whether masks have the same value in all lanes. Bit 0 is the value of a, and bit 1 that of b. The
    /// result is 4 where the lanes of a or of b differ.
    SPANGLE_INLINE static unsigned alike(Mask a, Mask b) {
        using Halves [[gnu::vector_size(16)]] = std::uint64_t;
        const auto halves = std::bit_cast<Halves>((a & 1) | (b & 2));
        if (halves[0] != halves[1] || halves[0] >> 32 != (halves[0] & 3))
            return 4;
        return static_cast<unsigned>(halves[0] & 3);
    }
    SPANGLE_INLINE static bool any(Mask m) {
        using Halves [[gnu::vector_size(16)]] = std::uint64_t;
        const auto halves = std::bit_cast<Halves>(m);
        return (halves[0] | halves[1]) != 0;
    }
    SPANGLE_INLINE static Int one(Mask m) { return -m; }
    SPANGLE_INLINE static Int select(Mask m, Int a, Int b) { return (m & a) | (~m & b); }
    /// Exchanges a and b in lanes where m is true.
    SPANGLE_INLINE static void exchange(Mask m, Int& a, Int& b) {
        const Int difference = (a ^ b) & m;
        a ^= difference;
        b ^= difference;
    }
    /// Negates v in lanes where m is true.
    SPANGLE_INLINE static Int negate(Mask m, Int v) { return (v ^ m) - m; }
    /// Divides n by d, 0 <= n < 5 d. Returns the quotient and leaves the remainder in n. The results are
    /// undefined where d is 0.
    SPANGLE_INLINE static Int divide_small(Int& n, Int d) {
        Int whole = n ^ n;
#pragma GCC unroll 4
        for (int i = 0; i < 4; ++i) {
            const Mask fits = ~(n < d);
            n -= d & fits;
            whole -= fits;
        }
        return whole;
    }
};

/// The lanes of lines in this build.
#if defined(__SSE2__) || defined(__ARM_NEON)
using HostLines = std::conditional_t<numeric::cheap_branches, LineLanes<1>, LineLanes<4>>;
#else
using HostLines = LineLanes<1>;
#endif

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
