// Draws a state in the slowest way: one fragment after the other, one stage after the other, with no mode
// known in advance.
#pragma once

#include "raster/chain/assemble.hpp"
#include "raster/fused/table.hpp"
#include "tests/unit/span/any_state.hpp"

namespace spangle::raster::test {

/// Makes a variant a chain of single fragments; its texture stage looks at the texture's modes at each
/// fragment.
template <class N> void single_fragments_of(Variant& variant, const Key& key, const FragmentState& state) {
    assemble<N>(variant, key, state);
    const auto replace = [&](ChainStage<N> packet, ChainStage<N> single) {
        for (auto& stage : variant.chain)
            if (stage == reinterpret_cast<AnyFunction>(packet))
                stage = reinterpret_cast<AnyFunction>(single);
    };
    const auto has_lod = [&](int unit) {
        const Texture* const texture = state.unit[unit].texture;
        return texture != nullptr && (texture->mip != MipFilter::none || texture->mag != texture->min);
    };
    replace(&PacketTexture<N>::combined, &chain_stage<N, CombineUnits<N>>);
    replace(&PacketTexture<N>::template run<0>,
            has_lod(0) ? &chain_stage<N, Texture2D<N, 0, true>> : &chain_stage<N, Texture2D<N, 0, false>>);
    replace(&PacketTexture<N>::template run<1>,
            has_lod(1) ? &chain_stage<N, Texture2D<N, 1, true>> : &chain_stage<N, Texture2D<N, 1, false>>);
}
/// Accepts any key but keys of raw words, which have no other arithmetic.
inline void single_fragments(Variant& variant, const Key& key, const FragmentState& state) {
    if (key.number == Number::exact)
        single_fragments_of<Exact>(variant, key, state);
    else
        single_fragments_of<Balanced<1>>(variant, key, state);
}

} // namespace spangle::raster::test
