// The chain in lanes and packets is the chain of single fragments, whatever the state: byte for byte.
#include <gtest/gtest.h>

#include <memory>

#include "raster/span/assemble.hpp"
#include "raster/span/fused_table.hpp"
#include "tests/span/sweep.hpp"

namespace spangle::raster::test {
namespace {

constexpr int width = 72, height = 10;

/// A texture with all its levels, and a border of texels or of a colour.
struct MipmappedTexture {
    std::vector<std::uint8_t> texels;
    Texture texture;
    MipmappedTexture(RandomVertices& random, int log2_width, int log2_height) {
        texture.format = static_cast<TexelFormat>(random.below(7));
        constexpr BaseFormat bases[] = {
            BaseFormat::alpha, BaseFormat::luminance, BaseFormat::intensity, BaseFormat::luminance_alpha,
            BaseFormat::rgb,   BaseFormat::rgb,       BaseFormat::rgba};
        texture.base = bases[static_cast<int>(texture.format)];
        texture.wrap_s = static_cast<Wrap>(random.below(4));
        texture.wrap_t = static_cast<Wrap>(random.below(4));
        texture.mag = static_cast<Filter>(random.below(2));
        texture.min = static_cast<Filter>(random.below(2));
        texture.mip = static_cast<MipFilter>(random.below(3));
        texture.border_texels = static_cast<std::uint8_t>(random.below(4) == 0);
        for (auto& c : texture.border_color)
            c = static_cast<std::uint8_t>(random.below(256));
        const int bytes = texel_bytes(texture.format), last = std::max(log2_width, log2_height);
        std::vector<std::size_t> at;
        for (int level = 0; level <= last; ++level) {
            const int w = std::max(1 << log2_width >> level, 1), h = std::max(1 << log2_height >> level, 1);
            const std::size_t stride = static_cast<std::size_t>(w + 2) * bytes;
            at.push_back(texels.size() + stride + bytes);
            texels.resize(texels.size() + stride * (h + 2) + 8);
            texture.level[level] = {nullptr, static_cast<std::uint16_t>(w), static_cast<std::uint16_t>(h),
                                    static_cast<std::uint32_t>(stride)};
        }
        for (auto& byte : texels)
            byte = static_cast<std::uint8_t>(random.word());
        texture.level_count = static_cast<std::uint8_t>(last + 1);
        for (int level = 0; level <= last; ++level)
            texture.level[level].texels = texels.data() + at[level];
    }
};

FragmentState random_state(RandomVertices& random, const Texture* const (&textures)[2]) {
    FragmentState state;
    const auto often = [&](std::uint32_t of) { return random.below(of) != 0; };
    state.tier = static_cast<Tier>(random.below(3));
    state.scissor = {static_cast<int>(random.below(8)), 0, width - 16, height};
    state.dither = often(2);
    for (int i = 0; i < 2; ++i) {
        if (random.below(3) == 0)
            continue;
        state.unit[i].texture = textures[i];
        state.unit[i].env = static_cast<TexEnv>(random.below(6));
        state.unit[i].lod_bias = static_cast<std::int32_t>(random.below(513)) - 256;
        for (Combiner* c : {&state.unit[i].rgb, &state.unit[i].alpha}) {
            c->func = static_cast<CombineFunc>(random.below(c == &state.unit[i].rgb ? 8 : 6));
            c->log2_scale = static_cast<std::uint8_t>(random.below(3));
            for (auto& argument : c->argument)
                argument = {static_cast<CombineSource>(random.below(6)),
                            static_cast<CombineOperand>(random.below(4))};
        }
        for (auto& c : state.unit[i].env_color)
            c = random.below(color_one + 1);
    }
    state.color_sum = random.below(4) == 0;
    state.fog = random.below(3) == 0;
    state.fog_mode = static_cast<FogMode>(random.below(3));
    state.fog_start = 0x3F000000, state.fog_end = 0x40800000, state.fog_density = 0x3F000000; // .5, 4, .5
    for (auto& c : state.fog_color)
        c = random.below(color_one + 1);
    state.alpha_test = random.below(4) == 0;
    state.alpha_func = static_cast<Compare>(random.below(8));
    state.alpha_ref = static_cast<std::uint8_t>(random.below(256));
    state.stencil_test = random.below(3) == 0;
    state.stencil.func = static_cast<Compare>(random.below(8));
    state.stencil.ref = 77;
    state.stencil.pass = static_cast<StencilOp>(random.below(8));
    state.depth_test = often(3);
    state.depth_func = static_cast<Compare>(random.below(8));
    state.depth_write = often(3);
    state.blend = random.below(3) == 0;
    const auto blending = [&] {
        return Blending{often(2) ? BlendFactor::src_alpha : static_cast<BlendFactor>(random.below(15)),
                        often(2) ? BlendFactor::one_minus_src_alpha
                                 : static_cast<BlendFactor>(random.below(15)),
                        often(2) ? BlendEquation::add : static_cast<BlendEquation>(random.below(5))};
    };
    state.blend_rgb = blending();
    state.blend_alpha = often(2) ? state.blend_rgb : blending();
    for (auto& c : state.blend_color)
        c = random.below(color_one + 1);
    state.logic = random.below(6) == 0;
    state.logic_op = static_cast<LogicOp>(random.below(16));
    state.color_mask = often(4) ? 0xF : static_cast<std::uint8_t>(1 + random.below(15));
    return state;
}

/// Every variant as a chain of single fragments, whose texture function looks at its modes at each.
template <class N> void single_fragments(Variant& variant, const Key& key, const FragmentState& state) {
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

TEST(Chain, LanesAndPacketsAreItsFragments) {
    RandomVertices random(41);
    int draws = 0;
    for (int round = 0; round < 1500; ++round) {
        const MipmappedTexture a(random, 5, static_cast<int>(random.below(6))), b(random, 3, 4);
        const FragmentState state = random_state(random, {&a.texture, &b.texture});
        const auto format = static_cast<PixelFormat>(random.below(4));
        const DepthFormat depth = random.below(3) == 0 ? DepthFormat::z24s8 : DepthFormat::z16;
        Canvas canvas[2] = {{width, height, format, depth}, {width, height, format, depth}};
        DrawState draws_of[2] = {compile<FixedVertex>(state, canvas[0].surface),
                                 compile<FixedVertex>(state, canvas[1].surface)};
        const auto kind = static_cast<Kind>(1 + random.below(3));
        Variant& lanes = draws_of[0].variant[static_cast<unsigned>(kind)];
        Variant& single = draws_of[1].variant[static_cast<unsigned>(kind)];
        const Key key = make_key(state, canvas[0].surface, kind);
        if (lanes.run == nullptr || key.number == Number::raw565)
            continue;
        lanes.run = chain_runner(key.number);
        if (key.number == Number::exact)
            single_fragments<Exact>(single, key, state);
        else
            single_fragments<Balanced<1>>(single, key, state);
        RandomVertices vertices(static_cast<std::uint32_t>(round));
        for (int n = 0; n < 4; ++n) {
            const Triangle t = random_triangle(vertices, width, height, kind);
            for (int i = 0; i < 2; ++i) {
                canvas[i].noise(static_cast<std::uint32_t>(4 * round + n));
                draw(draws_of[i], canvas[i].surface, t);
            }
            ASSERT_EQ(canvas[0].color, canvas[1].color) << round << ' ' << n;
            ASSERT_EQ(canvas[0].depth, canvas[1].depth) << round << ' ' << n;
            ++draws;
        }
    }
    EXPECT_GE(draws, 3000);
}

} // namespace
} // namespace spangle::raster::test
