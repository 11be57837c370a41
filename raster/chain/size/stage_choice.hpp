// Chains of stages that several states share, which is small.
#pragma once

#include "raster/chain/chain_systems.hpp"
#include "raster/ops/stage_blend.hpp"
#include "raster/ops/stage_blend_packet.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Whether depth goes through the stage that adds an offset. Every depth does, with an offset of 0 where GL
/// sets none.
SPANGLE_INLINE bool offsets_depth(const Key&) {
    return true;
}

/// True where stages that differ by a parameter are separate functions. Here one function takes all values of
/// the parameter.
template <class N> inline constexpr bool by_stages = !is_fixed<N>;

/// True where all fragments are stored by StoreMerged, which can do everything that the other store stages
/// do.
template <class N> inline constexpr bool stores_merged = is_fixed<N> && !has_tier(Tier::fast);

/// Adds the stages that fill pixels and store them. Other chains have the same two stages.
template <class N, class Fill, class Store, class Chain> SPANGLE_INLINE void add_fill(Chain& chain) {
    chain.template add<Fill>();
    chain.template add<Store>();
}

/// Adds the stage that blends by any function.
template <class N, PixelFormat Format, class Chain> void add_any_blending(Chain& chain) {
    if constexpr (by_lanes<N>)
        chain.add(&blend_packet<N, Format>, true);
    else
        chain.template add<Blend<N, Stored<N, Format>>>();
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
