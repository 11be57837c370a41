// The chain: any list of stages, run over packets of 16 fragments through one function pointer per stage. It
// is what a state draws with when no fused span exists, and what every fused span is compared with.
#pragma once

#include <cstdint>

#include "raster/span/draw_state.hpp"
#include "raster/span/stage.hpp"

namespace spangle::raster {

inline constexpr std::int32_t packet_length = 16;

/// Fragments between two stages. Packets start at multiples of their length from the anchor.
template <class N> struct Packet {
    std::int32_t x;    ///< first pixel, counted from the anchor of the span
    std::int32_t i;    ///< the same, counted from the span's `begin`
    std::int32_t n;    ///< fragments, 1 .. packet_length
    std::int32_t dead; ///< how many of them were dropped; `live` is valid when not 0
    bool live[packet_length];
    typename N::Color color[packet_length];
    typename N::Coord coord[max_texture_units][packet_length];
    std::int32_t lod[max_texture_units][packet_length];
    typename N::Fog fog[packet_length];
};

template <class N> using ChainStage = void (*)(Packet<N>&, const Span<typename N::Policy>&);

namespace detail {

/// Calls one(true, field pointer in Px, array in Packet) for every field of `Fields`.
template <unsigned Fields, class N, class Move>
SPANGLE_INLINE void for_fields(Px<N>& p, Packet<N>& k, std::int32_t i, Move move) {
    if constexpr ((Fields & field_color) != 0)
        move(p.color, k.color[i]);
    if constexpr ((Fields & field_coord) != 0)
        move(p.coord[0], k.coord[0][i]);
    if constexpr ((Fields & (field_coord << 1)) != 0)
        move(p.coord[1], k.coord[1][i]);
    if constexpr ((Fields & field_lod) != 0)
        move(p.lod[0][0], k.lod[0][i]);
    if constexpr ((Fields & (field_lod << 1)) != 0)
        move(p.lod[1][0], k.lod[1][i]);
    if constexpr ((Fields & field_fog) != 0)
        move(p.fog, k.fog[i]);
}

/// `Check`: some fragment may be dead.
template <bool Check, class N, class S>
SPANGLE_INLINE void run_stage(Packet<N>& k, const Span<typename N::Policy>& span, S& s, std::int32_t next) {
    const std::int32_t n = k.n, i0 = k.i, x0 = k.x;
    for (std::int32_t i = 0; i < n; ++i) {
        if constexpr (S::runs) {
            if (x0 + i == next)
                next = s.begin(next);
        }
        if (!Check || k.live[i]) {
            Px<N> p(span);
            p.i = i0 + i;
            p.live = true;
            for_fields<S::in>(p, k, i, [](auto& field, auto& stored) { field = stored; });
            [[maybe_unused]] const bool alive = s(p);
            for_fields<S::out>(p, k, i, [](auto& field, auto& stored) { stored = field; });
            if constexpr (S::kill) {
                k.live[i] = alive;
                k.dead += alive ? 0 : 1;
            }
        }
        s.step();
    }
}

} // namespace detail

/// One stage (or a Seq of them) over a packet.
template <class N, class S> void chain_stage(Packet<N>& k, const Span<typename N::Policy>& span) {
    static_assert(N::lanes == 1);
    S s(span, k.x);
    std::int32_t next = 0;
    if constexpr (S::runs)
        next = s.begin(k.x);
    // Until something died, everything lives, and stages before the first test never ask.
    if ((S::kill || S::effect) && k.dead != 0)
        detail::run_stage<true>(k, span, s, next);
    else
        detail::run_stage<false>(k, span, s, next);
}

/// Runs the chain of the span's kind.
template <class N> void chain_span(const Span<typename N::Policy>& span) {
    const AnyFunction* const stages = span.state->variant[static_cast<unsigned>(span.kind)].chain;
    Packet<N> k;
    for (k.x = span.begin; k.x < span.end; k.x += k.n) {
        const std::int32_t boundary = (k.x & -packet_length) + packet_length;
        k.n = (boundary < span.end ? boundary : span.end) - k.x;
        k.i = k.x - span.begin;
        k.dead = 0;
        for (const AnyFunction* f = stages; *f != nullptr && k.dead < k.n; ++f)
            reinterpret_cast<ChainStage<N>> (*f)(k, span);
    }
}

} // namespace spangle::raster
