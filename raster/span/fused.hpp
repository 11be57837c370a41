// A list of stages as one loop: eight lanes at a time where the host has them, one lane for the rest.
#pragma once

#include <bit>
#include <cstdint>

#include "raster/span/path.hpp"
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

/// n pixels from `begin`, one lane.
template <class N, class List>
SPANGLE_INLINE void fused_narrow(const Span<typename N::Policy>& span, std::int32_t begin, std::int32_t n) {
    static_assert(N::lanes == 1);
    List list(span, begin);
    std::int32_t i = 0;
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

/// Lanes [first, last) live.
SPANGLE_INLINE Lanes<8>::Mask some_lanes(std::int32_t first, std::int32_t last) {
    constexpr std::uint16_t on = 0xFFFF;
    static constexpr std::uint16_t at[24] = {0, 0, 0, 0, 0, 0, 0, 0, on, on, on, on, on, on, on, on};
    using L = Lanes<8>;
    const auto from = [](std::int32_t lane) {
        return L::load(reinterpret_cast<const std::uint8_t*>(at + lane));
    };
    return from(8 - first) & ~from(8 - last);
}

/// n >= 8 pixels from `begin`, eight at a time. What is left of a run is a group of its own, in which other
/// lanes are dead; it stays inside of the span.
template <class N, class List>
SPANGLE_INLINE void fused_wide(const Span<typename N::Policy>& span, std::int32_t begin, std::int32_t n) {
    static_assert(N::lanes == 8);
    List list(span, begin);
    Px<N> p;
    std::int32_t i = 0, stop = n;
    do {
        if constexpr (List::runs) {
            const std::int32_t next = list.begin(begin + i) - begin;
            stop = next < n ? next : n;
        }
        p.row = List::rows && list.row(stop - i);
        for (; i + 8 <= stop; i += 8) {
            p.live = N::L::all;
            p.i = i;
            list(p);
            list.step();
        }
        if (i != stop) {
            p.i = i < n - 8 ? i : n - 8;
            p.live = some_lanes(i - p.i, stop - p.i);
            list.jump(span, begin + p.i, p.i - i);
            list(p);
            if (List::runs && stop != n)
                list.jump(span, begin + stop, stop - p.i);
            i = stop;
        }
    } while (List::runs && i != n);
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

/// n < 8 pixels from `begin`, as one group of eight that works on copies: nothing outside is touched.
template <class Case> SPANGLE_INLINE void fused_few(Span<Fixed>& span, std::int32_t begin, std::int32_t n) {
    alignas(16) std::uint8_t color[16] = {}, depth[16] = {};
    detail::copy_words(color, span.color, n);
    std::uint8_t* const color_plane = span.color;
    std::uint8_t* const depth_plane = span.depth;
    span.color = color;
    if constexpr (Case::tested) {
        detail::copy_words(depth, span.depth, n);
        span.depth = depth;
    }
    using N = typename Case::template System<8>;
    typename Case::template List<8> list(span, begin);
    Px<N> p;
    p.row = Case::template List<8>::rows && list.row(n);
    p.live = some_lanes(0, n);
    p.i = 0;
    list(p);
    span.color = color_plane;
    span.depth = depth_plane;
    detail::copy_words(span.color, color, n);
    if constexpr (Case::tested)
        detail::copy_words(span.depth, depth, n);
}

template <class Case, int Wide>
SPANGLE_INLINE void fused_row(Span<Fixed>& span, std::int32_t begin, std::int32_t n) {
    if constexpr (Wide == 8 && Case::wide) {
        using List = typename Case::template List<8>;
        if (n >= 8)
            return fused_wide<typename Case::template System<8>, List>(span, begin, n);
        if constexpr (Case::heavy && !List::runs) {
            if (n > 2)
                return fused_few<Case>(span, begin, n);
        }
    }
    fused_narrow<typename Case::template System<1>, typename Case::template List<1>>(span, begin, n);
}

/// Case has: template <int Lanes> using System, List; static constexpr key, tested, wide, heavy.
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

/// A path over planes whose rows have the same stride in pixels.
template <class Case> [[gnu::noinline]] void fused_path(Span<Fixed>& span, const Path& path) {
    constexpr int bytes = format_info(Case::key.format).bytes_per_pixel;
    static_assert(!Case::key.dither && bytes == 2 && Case::key.depth_format != DepthFormat::z24s8);
    point_at(span.color, span.depth, *span.target, path.x, path.y, bytes, 1);
    span.x = path.along_x ? path.x : path.y;
    span.y = span.anchor_y;
    const std::int32_t row = span.target->color_stride / bytes, up = path.falls ? -1 : 1;
    const std::int32_t along = path.along_x ? 1 : row, aside = path.along_x ? (path.falls ? -row : row) : up;
    const std::int32_t rise = path.rise, denominator = path.denominator;
    std::int32_t count = path.count, rest = path.remainder - denominator;
    typename Case::template List<1> list(span, 0);
    Px<typename Case::template System<1>> p;
    p.live = true;
    p.i = 0;
    do {
        list(p);
        list.step();
        p.i += along;
        rest += rise;
        if (rest >= 0) {
            rest -= denominator;
            p.i += aside;
        }
    } while (--count != 0);
}

} // namespace spangle::raster
