// Samples and combines the texels of a packet one by one, where a number has one lane.
#pragma once

#include "raster/ops/texture_combine_packet.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Combines the texels of all units that are on with the colours of a packet of n fragments.
template <class N, class Color, int Groups>
SPANGLE_INLINE void combine_units(const FragmentState& state, Color (&texels)[max_texture_units][Groups],
                                  std::int32_t n, Color* color) {
    if constexpr (N::lanes > 1) {
        PacketCombine<N>::units(state, texels, (n + N::lanes - 1) / N::lanes, color);
    } else {
        for (std::int32_t i = 0; i < n; ++i) {
            Color texel[max_texture_units];
            for (int u = 0; u < max_texture_units; ++u)
                texel[u] = state.unit[u].texture != nullptr ? texels[u][i] : Color{};
            TextureCombine<N>::units(state, texel, color[i]);
        }
    }
}

/// Samples a texture at all fragments of a packet. All are sampled one by one.
template <class Stage, class Color>
SPANGLE_INLINE void sample_packet(const Stage& stage, bool, Color* texels) {
    stage.sample_one_by_one(texels);
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
