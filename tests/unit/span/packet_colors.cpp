// Colours that packets blend and combine, in lanes or one by one, are those of one fragment after the other.
#include <gtest/gtest.h>

#include "raster/ops/stage_blend_packet.hpp"
#include "raster/ops/texture_combine_packet.hpp"
#include "tests/unit/span/any_state.hpp"

namespace spangle::raster::test {
namespace {

/// The colours of the fragments of a packet, in groups of lanes.
template <class N> struct Colors {
    static constexpr int groups = PlacesOf<N>::groups, fragments = groups * N::lanes;
    using One = typename OneLane<N>::Color;
    typename N::Color of[groups];

    /// Each component is 0, 1, or anything between.
    explicit Colors(RandomVertices& random) {
        const auto component = [&] {
            const std::uint32_t units =
                random.below(4) == 0 ? (random.below(2) == 0 ? 0 : color_one) : random.below(color_one + 1);
            return OneLane<N>::from_units(units);
        };
        for (int i = 0; i < fragments; ++i)
            set(i, {component(), component(), component(), component()});
    }
    void set(int i, const One& c) { set_lane(of[i / N::lanes], i % N::lanes, c); }
    One at(int i) const {
        One c;
        lane_of(of[i / N::lanes], i % N::lanes, c);
        return c;
    }
};

template <class Color> void expect_equal(const Color& found, const Color& expected, const char* what, int i) {
    ASSERT_EQ(found.r, expected.r) << what << ' ' << i;
    ASSERT_EQ(found.g, expected.g) << what << ' ' << i;
    ASSERT_EQ(found.b, expected.b) << what << ' ' << i;
    ASSERT_EQ(found.a, expected.a) << what << ' ' << i;
}

template <class N> void blend_everything() {
    RandomVertices random(95);
    for (std::uint32_t factors = 0; factors < 15 * 15; ++factors)
        for (int equation = 0; equation < 5; ++equation) {
            FragmentState state;
            any_blending(random, state);
            state.blend_rgb = {static_cast<BlendFactor>(factors % 15), static_cast<BlendFactor>(factors / 15),
                               static_cast<BlendEquation>(equation)};
            state.blend_alpha = {static_cast<BlendFactor>(factors / 15),
                                 static_cast<BlendFactor>(factors % 15),
                                 static_cast<BlendEquation>((equation + 1) % 5)};
            const Colors<N> source(random), stored(random);
            Colors<N> found = source;
            const auto groups = static_cast<std::int32_t>(1 + random.below(Colors<N>::groups));
            PacketBlend<N>::blend(state, groups, stored.of, true, found.of);
            const BlendEquations<OneLane<N>> of_one(state);
            for (int i = 0; i < groups * N::lanes; ++i)
                expect_equal(found.at(i), of_one.blend(source.at(i), stored.at(i)), "factors",
                             static_cast<int>(factors));
        }
}
TEST(PacketColors, BlendAsOneFragment) {
    blend_everything<ExactLanes>();
    blend_everything<Balanced<8>>();
    blend_everything<Exact>();
    blend_everything<Balanced<1>>();
}

template <class N> void combine_anything() {
    RandomVertices random(96);
    int combined = 0, crossed = 0;
    for (int round = 0; round < 20000; ++round) {
        Texture texture[2];
        FragmentState state;
        for (int u = 0; u < 2; ++u) {
            texture[u].base = static_cast<BaseFormat>(random.below(6));
            any_unit(random, state.unit[u], texture[u]);
            if (random.below(2) == 0)
                state.unit[u].env = TexEnv::combine;
            if (random.below(5) == 0)
                state.unit[u].texture = nullptr;
        }
        const Colors<N> primary(random), texel[2] = {Colors<N>(random), Colors<N>(random)};
        typename N::Color texels[2][Colors<N>::groups];
        for (int u = 0; u < 2; ++u)
            std::copy_n(texel[u].of, Colors<N>::groups, texels[u]);
        Colors<N> found = primary;
        const auto groups = static_cast<std::int32_t>(1 + random.below(Colors<N>::groups));
        PacketCombine<N>::units(state, texels, groups, found.of);
        for (int i = 0; i < groups * N::lanes; ++i) {
            using One = OneLane<N>;
            const typename One::Color of_units[2] = {texel[0].at(i), texel[1].at(i)};
            typename One::Color expected = primary.at(i);
            TextureCombine<One>::units(state, of_units, expected);
            expect_equal(found.at(i), expected, "round", round);
        }
        combined += uses_combiners(state) ? 1 : 0;
        crossed += state.unit[0].texture != nullptr && state.unit[1].texture == nullptr ? 1 : 0;
        if (testing::Test::HasFatalFailure())
            return;
    }
    EXPECT_GT(combined, 10000);
    EXPECT_GT(crossed, 1000);
}
TEST(PacketColors, CombineAsOneFragment) {
    combine_anything<ExactLanes>();
    combine_anything<Balanced<8>>();
    combine_anything<Exact>();
    combine_anything<Balanced<1>>();
}

TEST(MergedWords, AreThoseOfTheTable) {
    RandomVertices random(97);
    const auto word = [&] { return random.below(1u << 16) << 16 | random.below(1u << 16); };
    for (int op = 0; op < 16; ++op)
        for (int n = 0; n < 100; ++n) {
            FragmentState state;
            state.logic = true;
            state.logic_op = static_cast<LogicOp>(op);
            const LogicTable logic(state);
            const std::uint32_t bits = word(), s = word(), d = word();
            ASSERT_EQ(MergedWords(logic, bits).of(s, d), logic.merged(s, d, bits)) << op;
        }
}

} // namespace
} // namespace spangle::raster::test
