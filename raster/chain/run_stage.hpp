// Runs one stage on fragments of a packet.
#pragma once

#include "raster/ops/packet.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

namespace inner {

/// The number system that a stage is made for. It is the packet's number system, or the one with the same
/// bits and one lane.
template <class S, class M> M system_of(bool (S::*)(Px<M>&));
template <class S, class M> M system_of(bool (S::*)(Px<M>&) const);

/// Loads or stores the fields of fragments [i, i + M::lanes). It calls move(field of Px<M>, field of the
/// packet). Where M has one lane and the packet has more, it calls one(), which gets the lane as well.
template <unsigned Fields, class M, class K, class Move, class SingleLane>
SPANGLE_INLINE void for_fields(Px<M>& p, K& k, std::int32_t i, Move move, SingleLane one) {
    const std::int32_t g = i / K::lanes, lane = i % K::lanes;
    const auto field = [&](auto& fragment, auto& stored) {
        if constexpr (M::lanes == K::lanes)
            move(fragment, stored);
        else
            one(fragment, stored, lane);
    };
    if constexpr ((Fields & field_color) != 0)
        field(p.color, k.color[g]);
    for (int unit = 0; unit < max_texture_units; ++unit) {
        if ((Fields & field_coord << unit) != 0) {
            for (int l = 0; l < M::lanes; ++l) {
                move(p.coord[unit].s[l], k.coord[unit][g].s[lane + l]);
                move(p.coord[unit].t[l], k.coord[unit][g].t[lane + l]);
            }
        }
        if ((Fields & field_lod << unit) != 0)
            for (int l = 0; l < M::lanes; ++l)
                move(p.lod[unit][l], k.lod[unit][i + l]);
    }
    if constexpr ((Fields & field_fog) != 0)
        field(p.fog, k.fog[g]);
}

/// What a stage that drops fragments has left of a packet: whether any fragment is alive, and whether one
/// died.
struct Outcome {
    bool any = false, died = false;
    template <class S, class K> SPANGLE_INLINE void tell(K& k) const {
        if constexpr (S::kill) {
            k.alive = any;
            k.some_dead = k.some_dead || died;
        }
    }
};

/// Runs a stage on fragments [i, i + M::lanes) of a packet.
template <class M, class K, class S>
SPANGLE_INLINE void run_group(K& k, S& s, std::int32_t i, Outcome& outcome) {
    using L = typename K::L;
    typename L::Mask& live = k.live[i / K::lanes];
    Px<M> p;
    p.color_plane = k.color_plane;
    p.depth_plane = k.depth_plane;
    p.go_to(i);
    if constexpr (M::lanes > 1)
        p.live = live;
    else
        p.live = true;
    for_fields<S::in>(
        p, k, i, [](auto& fragment, auto& stored) { fragment = stored; },
        [](auto& fragment, auto& stored, int lane) { lane_of(stored, lane, fragment); });
    [[maybe_unused]] const bool alive = s(p);
    for_fields<S::out>(
        p, k, i, [](auto& fragment, auto& stored) { stored = fragment; },
        [](auto& fragment, auto& stored, int lane) { set_lane(stored, lane, fragment); });
    if constexpr (S::kill) {
        outcome.any = outcome.any || alive;
        if constexpr (M::lanes > 1) {
            const typename L::Mask left = alive ? p.live : L::negate(L::all);
            outcome.died = outcome.died || L::any(L::both(live, L::negate(left)));
            live = left;
        } else if (!alive) {
            outcome.died = true;
            L::kill(live, i % K::lanes);
        }
    }
}

/// Runs a stage on fragments [from, to). Fragment i is in column x0 + i. Check: some fragments may be dead,
/// so each one is asked.
template <bool Check, class M, class K, class S>
SPANGLE_INLINE void run_stage(K& k, S& s, std::int32_t from, std::int32_t to, std::int32_t x0,
                              Outcome& outcome) {
    using L = typename K::L;
    std::int32_t next = 0;
    if constexpr (S::runs)
        next = s.begin(x0 + from);
    for (std::int32_t i = from; i < to; i += M::lanes) {
        if constexpr (S::runs) {
            if (x0 + i == next)
                next = s.begin(next);
        }
        if (!Check || L::lane(k.live[i / K::lanes], i % K::lanes))
            run_group<M>(k, s, i, outcome);
        s.step();
    }
}

} // namespace inner
} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
