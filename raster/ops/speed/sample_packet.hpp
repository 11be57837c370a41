// Samples and combines the texels of a packet together.
#pragma once

#include "raster/ops/texture_combine_packet.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Combines the texels of all units that are on with the colours of a packet of n fragments.
template <class N, class Color, int Groups>
SPANGLE_INLINE void combine_units(const FragmentState& state, Color (&texels)[max_texture_units][Groups],
                                  std::int32_t n, Color* color) {
    PacketCombine<N>::units(state, texels, (n + N::lanes - 1) / N::lanes, color);
}

/// Samples a texture at all fragments of a packet. `together` says that fragments may be sampled together.
template <class Stage, class Color>
SPANGLE_INLINE void sample_packet(const Stage& stage, bool together, Color* texels) {
    if (together)
        stage.sample_stretches(texels);
    else
        stage.sample_one_by_one(texels);
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
