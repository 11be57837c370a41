// In every state, the chain in lanes and packets stores the same bytes as the chain of single fragments.
#include <gtest/gtest.h>

#include "tests/unit/span/single_fragments.hpp"

namespace spangle::raster::test {
namespace {

constexpr int width = 72, height = 10;

TEST(Chain, LanesAndPacketsAreItsFragments) {
    RandomVertices random(41);
    Random texels{41};
    int draws = 0, shared = 0; ///< draws, and the draws whose rows may share packets
    for (int round = 0; round < 6000; ++round) {
        const AnyTexture a(texels), b(texels);
        const Extras extras(random, width);
        FragmentState state = any_fragments(random, {&a.texture, &b.texture}, width, height);
        extras.add_to(random, state);
        const PixelFormat format = all_formats[random.below(random.below(2) == 0 ? 4 : 10)];
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
        if (!is_narrow(format)) // narrow formats have no fused spans
            lanes.run = chain_runner(key.number);
        single_fragments(single, key, state);
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
            shared += lanes.shares ? 1 : 0;
        }
    }
    EXPECT_GE(draws, 12000);
    if (host_lanes > 1) {
        EXPECT_GE(shared, draws / 3); // all but narrow surfaces and volume textures share packets
    }
}

} // namespace
} // namespace spangle::raster::test
