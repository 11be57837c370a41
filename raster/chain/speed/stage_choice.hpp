// Chains of stages that do one thing each, which is fast.
#pragma once

#include "raster/chain/chain_systems.hpp"
#include "raster/ops/stage_blend_packet.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Whether depth goes through the stage that adds an offset.
SPANGLE_INLINE bool offsets_depth(const Key& key) {
    return key.depth_offset;
}

/// True where stages that differ by a parameter are separate functions.
template <class N> inline constexpr bool by_stages = true;

/// True where all fragments are stored by StoreMerged, which can do everything that the other store stages
/// do.
template <class N> inline constexpr bool stores_merged = false;

/// Adds the stages that fill pixels and store them, as one loop.
template <class N, class Fill, class Store, class Chain> SPANGLE_INLINE void add_fill(Chain& chain) {
    chain.template add<Seq<N, Fill, Store>>();
}

/// Adds the stage that blends by any function.
template <class N, PixelFormat Format, class Chain> void add_any_blending(Chain& chain) {
    if constexpr (is_fixed<N>)
        chain.add(&blend_packet<N, Format>, true);
    else
        chain.template add<Blend<N, Stored<N, Format>>>();
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
