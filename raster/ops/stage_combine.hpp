// All texture units of one fragment, for states in which at least one unit combines. All textures are sampled
// first, because any unit may ask for the texture colour of another.
#pragma once

#include "raster/ops/stage_texture_one.hpp"
#include "raster/ops/texture_combine.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Combines all units. The stages that find coordinates and levels of detail come before it.
template <class N> struct CombineUnits : StageBase {
    static constexpr unsigned second = max_texture_units > 1 ? field_coord << 1 | field_lod << 1 : 0;
    static constexpr unsigned in = field_color | field_coord | field_lod | second;
    static constexpr unsigned out = field_color;
    using Span = raster::Span<typename N::Policy>;
    const Span& span;
    std::int32_t x;
    CombineUnits(const Span& s, std::int32_t first) : span(s), x(first) {}
    bool operator()(Px<N>& p) const {
        const FragmentState& state = span.state->fragment;
        typename N::Color texel[max_texture_units]{};
        if (state.unit[0].texture != nullptr)
            texel[0] = texel_of<0>(p);
        if constexpr (max_texture_units > 1)
            if (state.unit[1].texture != nullptr)
                texel[1] = texel_of<1>(p);
        TextureCombine<N>::units(state, texel, p.color);
        return true;
    }
    void step() { ++x; }

  private:
    template <int Unit> typename N::Color texel_of(const Px<N>& p) const {
        const Texture& texture = *span.state->fragment.unit[Unit].texture;
        return wants_lod(texture) ? Texture2D<N, Unit, true>(span, x).texel(p)
                                  : Texture2D<N, Unit, false>(span, x).texel(p);
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
