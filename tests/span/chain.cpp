// The chain in lanes and packets is the chain of single fragments, whatever the state: byte for byte.
#include <gtest/gtest.h>

#include "raster/span/assemble.hpp"
#include "raster/span/fused_table.hpp"
#include "tests/span/any_state.hpp"

namespace spangle::raster::test {
namespace {

constexpr int width = 72, height = 10;

FragmentState random_state(RandomVertices& random, const Texture* const (&textures)[2]) {
    FragmentState state;
    const auto often = [&](std::uint32_t of) { return random.below(of) != 0; };
    state.tier = static_cast<Tier>(random.below(3));
    state.scissor = {static_cast<int>(random.below(8)), 0, width - 16, height};
    state.dither = often(2);
    for (int i = 0; i < 2; ++i) {
        if (random.below(3) == 0)
            continue;
        any_unit(random, state.unit[i], *textures[i]);
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
    any_stencil(random, state.stencil);
    state.depth_test = often(3);
    state.depth_func = static_cast<Compare>(random.below(8));
    state.depth_write = often(3);
    state.blend = random.below(3) == 0;
    any_blending(random, state);
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
    Random texels{41};
    int draws = 0;
    for (int round = 0; round < 6000; ++round) {
        const AnyTexture a(texels), b(texels);
        const Extras extras(random, width);
        FragmentState state = random_state(random, {&a.texture, &b.texture});
        extras.add_to(random, state);
        const PixelFormat format = all_formats[random.below(random.below(2) == 0 ? 4 : 9)];
        const DepthFormat depth = random.below(3) == 0 ? DepthFormat::z24s8 : DepthFormat::z16;
        Canvas canvas[2] = {{width, height, format, depth}, {width, height, format, depth}};
        DrawState draws_of[2] = {compile<FixedVertex>(state, canvas[0].surface),
                                 compile<FixedVertex>(state, canvas[1].surface)};
        Counters counters[2];
        for (int i = 0; i < 2; ++i)
            extras.give_to(draws_of[i], counters[i]);
        const auto kind = static_cast<Kind>(1 + random.below(3));
        Variant& lanes = draws_of[0].variant[static_cast<unsigned>(kind)];
        Variant& single = draws_of[1].variant[static_cast<unsigned>(kind)];
        const Key key = make_key(state, canvas[0].surface, kind);
        if (lanes.run == nullptr || key.number == Number::raw565)
            continue;
        if (!is_narrow(format)) // which have no fused spans
            lanes.run = chain_runner(key.number);
        if (key.number == Number::exact)
            single_fragments<Exact>(single, key, state);
        else
            single_fragments<Balanced<1>>(single, key, state);
        RandomVertices vertices(static_cast<std::uint32_t>(round));
        for (int n = 0; n < 4; ++n) {
            Triangle t = random_triangle(vertices, width, height, kind);
            if (random.below(2) == 0)
                for (FixedVertex& v : t.v)
                    v.tex[0].q = static_cast<std::int32_t>((1u << 28) + vertices.below(1u << 29)),
                    v.tex[0].q_is_one = 0;
            for (int i = 0; i < 2; ++i) {
                canvas[i].noise(static_cast<std::uint32_t>(4 * round + n));
                draw(draws_of[i], canvas[i].surface, t);
            }
            ASSERT_EQ(canvas[0].color, canvas[1].color) << round << ' ' << n;
            ASSERT_EQ(canvas[0].depth, canvas[1].depth) << round << ' ' << n;
            ASSERT_EQ(counters[0].passed, counters[1].passed) << round << ' ' << n;
            ++draws;
        }
    }
    EXPECT_GE(draws, 12000);
}

} // namespace
} // namespace spangle::raster::test
