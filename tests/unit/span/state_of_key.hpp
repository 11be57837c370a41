// Makes the state of a key, drawn by its fused span or in the chain, for tests and benches of fused spans.
#pragma once

#include <memory>

#include "raster/fused/table.hpp"
#include "tests/unit/span/sweep.hpp"

namespace spangle::raster::test {

/// The GL state that a key stands for.
struct StateOfKey {
    FragmentState state;
    std::vector<std::unique_ptr<TestTexture>> textures;
    StateOfKey(const Key& key, int width, int height, int log2_texels = 6, int log2_rows = 5) {
        state.tier = key.number == Number::exact || key.cubic ? Tier::exact
                     : key.coarse                             ? Tier::fast
                                                              : Tier::balanced;
        state.scissor = {0, 0, width, height};
        state.dither = key.dither;
        for (int i = 0; i < max_texture_units; ++i) {
            const UnitKey& unit = key.unit[i];
            if (!unit.on)
                continue;
            textures.push_back(std::make_unique<TestTexture>(unit.texels, unit.base, i == 0 ? log2_texels : 5,
                                                             i == 0 ? log2_rows : 6));
            textures.back()->texture.mag = textures.back()->texture.min = unit.filter;
            state.unit[i].texture = &textures.back()->texture;
            state.unit[i].env = unit.env;
            for (auto& c : state.unit[i].env_color)
                c = color_one / 3;
        }
        state.color_sum = key.color_sum;
        state.fog = key.fog;
        state.fog_mode = key.fog_mode;
        state.fog_start = 0x3F000000, state.fog_end = 0x40800000; // fog goes from 0.5 to 4
        state.fog_color[0] = color_one / 2, state.fog_color[1] = color_one / 5,
        state.fog_color[2] = color_one;
        state.alpha_test = key.alpha != Compare::always;
        state.alpha_func = key.alpha;
        state.alpha_ref = 128;
        state.depth_test = key.depth != Compare::always || key.depth_write;
        state.depth_func = key.depth;
        state.depth_write = key.depth_write;
        state.blend = key.blend;
        state.blend_rgb = state.blend_alpha = key.blending;
        state.color_mask = key.masked ? 5 : 0xF;
    }
};

/// Returns the state with the chain in place of the fused span of the key's kind.
inline DrawState in_chain(DrawState state, const Key& key) {
    Variant& variant = state.variant[static_cast<unsigned>(key.kind)];
    variant.run = chain_runner(key.number);
    variant.gray = false;
    variant.walk = nullptr;
    state.shapes = state.tiles = state.guesses = false;
    return state;
}

} // namespace spangle::raster::test
