// A list of stages as one loop: eight lanes at a time where the host has them, one lane for the rest.
#pragma once

#include <bit>
#include <cstdint>

#include "raster/span/stage.hpp"

namespace spangle::raster {

/// Lanes of fused spans in this build.
#if defined(__SSE2__) || defined(__ARM_NEON)
inline constexpr int host_lanes = std::endian::native == std::endian::little ? 8 : 1;
#else
inline constexpr int host_lanes = 1;
#endif

/// Pixels [span.begin + i, span.end), one lane.
template <class N, class List>
SPANGLE_INLINE void fused_narrow(const Span<typename N::Policy>& span, std::int32_t i) {
    static_assert(N::lanes == 1);
    const std::int32_t n = span.end - span.begin;
    List list(span, span.begin + i);
    Px<N> p;
    p.live = true;
    if constexpr (List::runs) {
        do {
            const std::int32_t next = list.begin(span.begin + i) - span.begin;
            const std::int32_t stop = next < n ? next : n;
            do {
                p.i = i;
                list(p);
                list.step();
            } while (++i != stop);
        } while (i != n);
    } else {
        do {
            p.i = i;
            list(p);
            list.step();
        } while (++i != n);
    }
}

/// Groups of eight from the begin of the span; returns the first pixel not drawn.
template <class N, class List> SPANGLE_INLINE std::int32_t fused_wide(const Span<typename N::Policy>& span) {
    static_assert(N::lanes == 8 && !List::runs);
    const std::int32_t n = (span.end - span.begin) & ~7;
    std::int32_t i = 0;
    if (n == 0)
        return 0;
    List list(span, span.begin);
    do {
        Px<N> p;
        p.live = N::L::all;
        p.i = i;
        list(p);
        list.step();
    } while ((i += 8) != n);
    return n;
}

/// Case has: template <int Lanes> using System, List; static constexpr bool wide.
template <class Case, int Wide = host_lanes> [[gnu::noinline]] void fused(const Span<Fixed>& span) {
    std::int32_t i = 0;
    if constexpr (Wide == 8 && Case::wide) {
        i = fused_wide<typename Case::template System<8>, typename Case::template List<8>>(span);
        if (i == span.end - span.begin)
            return;
    }
    fused_narrow<typename Case::template System<1>, typename Case::template List<1>>(span, i);
}

} // namespace spangle::raster
