// A list of stages as one loop: eight lanes at a time where the host has them, one lane for the rest.
#pragma once

#include <bit>
#include <cstdint>

#include "raster/span/rows.hpp"
#include "raster/span/stage.hpp"

namespace spangle::raster {

/// Lanes of fused spans in this build.
#if defined(__SSE2__) || defined(__ARM_NEON)
inline constexpr int host_lanes = std::endian::native == std::endian::little ? 8 : 1;
#else
inline constexpr int host_lanes = 1;
#endif

/// Fragments [i, stop), i < stop, one by one.
template <bool Row, class N, class List>
SPANGLE_INLINE void fused_loop(List& list, std::int32_t i, std::int32_t stop) {
    Px<N> p;
    p.live = true;
    p.row = Row;
    do {
        p.i = i;
        list(p);
        if constexpr (Row)
            list.step_row();
        else
            list.step();
    } while (++i != stop);
}

/// Pixels i to n - 1 counted from `begin`, one lane.
template <class N, class List>
SPANGLE_INLINE void fused_narrow(const Span<typename N::Policy>& span, std::int32_t begin, std::int32_t i,
                                 std::int32_t n) {
    static_assert(N::lanes == 1);
    List list(span, begin + i);
    do {
        std::int32_t stop = n;
        if constexpr (List::runs) {
            const std::int32_t next = list.begin(begin + i) - begin;
            stop = next < n ? next : n;
        }
        if (List::rows && list.row(stop - i))
            fused_loop<true, N>(list, i, stop);
        else
            fused_loop<false, N>(list, i, stop);
        i = stop;
    } while (List::runs && i != n);
}

/// Groups of eight of n pixels from `begin`; returns how many are drawn.
template <class N, class List>
SPANGLE_INLINE std::int32_t fused_wide(const Span<typename N::Policy>& span, std::int32_t begin,
                                       std::int32_t n) {
    static_assert(N::lanes == 8 && !List::runs);
    n &= ~7;
    std::int32_t i = 0;
    if (n == 0)
        return 0;
    List list(span, begin);
    const bool row = List::rows && list.row(n);
    do {
        Px<N> p;
        p.row = row;
        p.live = N::L::all;
        p.i = i;
        list(p);
        list.step();
    } while ((i += 8) != n);
    return n;
}

namespace detail {

/// n < 8 words of 16 bits.
SPANGLE_INLINE void copy_words(std::uint8_t* to, const std::uint8_t* from, std::int32_t n) {
    if ((n & 4) != 0) {
        __builtin_memcpy(to, from, 8);
        to += 8, from += 8;
    }
    if ((n & 2) != 0) {
        __builtin_memcpy(to, from, 4);
        to += 4, from += 4;
    }
    if ((n & 1) != 0)
        __builtin_memcpy(to, from, 2);
}

} // namespace detail

/// Pixels [i, i + n) counted from `begin`, n < 8, as one group of eight that works on copies: nothing outside
/// is touched.
template <class Case>
SPANGLE_INLINE void fused_tail(Span<Fixed>& span, std::int32_t begin, std::int32_t i, std::int32_t n) {
    using N = typename Case::template System<8>;
    static constexpr std::uint16_t lives[16] = {0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF,
                                                0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF};
    alignas(16) std::uint8_t color[16] = {}, depth[16] = {};
    detail::copy_words(color, span.color + 2 * i, n);
    std::uint8_t* const color_plane = span.color;
    std::uint8_t* const depth_plane = span.depth;
    span.color = color;
    if constexpr (Case::tested) {
        detail::copy_words(depth, span.depth + 2 * i, n);
        span.depth = depth;
    }
    typename Case::template List<8> list(span, begin + i);
    Px<N> p;
    p.row = Case::template List<8>::rows && list.row(n);
    __builtin_memcpy(&p.live, lives + 8 - n, 16);
    p.i = 0;
    list(p);
    span.color = color_plane;
    span.depth = depth_plane;
    detail::copy_words(span.color + 2 * i, color, n);
    if constexpr (Case::tested)
        detail::copy_words(span.depth + 2 * i, depth, n);
}

template <class Case, int Wide>
SPANGLE_INLINE void fused_row(Span<Fixed>& span, std::int32_t begin, std::int32_t n) {
    std::int32_t i = 0;
    if constexpr (Wide == 8 && Case::wide) {
        i = fused_wide<typename Case::template System<8>, typename Case::template List<8>>(span, begin, n);
        const std::int32_t rest = n - i;
        if (rest == 0)
            return;
        if constexpr (Case::heavy) {
            if (rest > 2)
                return fused_tail<Case>(span, begin, i, rest);
        }
    }
    fused_narrow<typename Case::template System<1>, typename Case::template List<1>>(span, begin, i, n);
}

/// Case has: template <int Lanes> using System, List; static constexpr key, needs, tested, wide, heavy.
template <class Case, int Wide = host_lanes>
[[gnu::noinline]] void fused(Span<Fixed>& span, const Row* row, const Row* end) {
    do {
        const std::int32_t first = row->first, n = row->last - first;
        // Where no run is anchored, pixel 0 is the first one drawn.
        std::int32_t left = first;
        if constexpr (Case::template List<1>::runs) {
            left = row->left;
            span.length = row->right - left;
        }
        span.x = left;
        span.y = row->y;
        point_at(span.color, span.depth, *span.target, first, row->y,
                 format_info(Case::key.format).bytes_per_pixel, 1);
        fused_row<Case, Wide>(span, first - left, n);
    } while (++row != end);
}

} // namespace spangle::raster
