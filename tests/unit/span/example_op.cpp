// The op that docs/architecture/ops.md adds as its example, run as the chain runs any op: in lanes and one by
// one, in every number system that has colours.
#include <gtest/gtest.h>

#include <cstring>

#include "raster/chain/assemble.hpp"
#include "tests/unit/span/any_state.hpp"

namespace spangle::raster::test {
namespace {

// The example begins.
/// Replaces the colour by its negative. Alpha stays.
template <class N> struct Negative : StageBase {
    static constexpr unsigned in = field_color, out = field_color;
    static constexpr bool anywhere = true;
    typename N::T one;
    Negative(const Span<typename N::Policy>&, std::int32_t) : one(N::from_units(color_one)) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.color.r = N::subtract(one, p.color.r);
        p.color.g = N::subtract(one, p.color.g);
        p.color.b = N::subtract(one, p.color.b);
        return true;
    }
};
// The example ends.

template <class N> void draw_negatives() {
    using One = OneLane<N>;
    RandomVertices random(11);
    const DrawState state;
    Span<typename N::Policy> span;
    span.state = &state;
    Packet<N> packet;
    std::memset(static_cast<void*>(&packet), 0, sizeof packet);
    packet.n = packet_length;
    packet.alive = true;
    typename One::Color given[packet_length];
    const auto component = [&] { return One::from_units(random.below(color_one + 1)); };
    for (std::int32_t i = 0; i < packet_length; ++i) {
        given[i] = {component(), component(), component(), component()};
        set_lane(packet.color[i / N::lanes], i % N::lanes, given[i]);
    }
    for (std::int32_t g = 0; g < Packet<N>::groups; ++g)
        packet.live[g] = N::L::first(N::lanes);

    chain_stage<N, Negative<N>>(packet, span);

    const auto one = One::from_units(color_one);
    for (std::int32_t i = 0; i < packet_length; ++i) {
        typename One::Color c;
        lane_of(packet.color[i / N::lanes], i % N::lanes, c);
        ASSERT_EQ(c.r, one - given[i].r) << i;
        ASSERT_EQ(c.g, one - given[i].g) << i;
        ASSERT_EQ(c.b, one - given[i].b) << i;
        ASSERT_EQ(c.a, given[i].a) << i;
    }
}

TEST(ExampleOp, RunsInEveryNumberSystem) {
    draw_negatives<Exact>();
    draw_negatives<Balanced<1>>();
    if constexpr (host_lanes > 1) {
        draw_negatives<ExactLanes>();
        draw_negatives<Balanced<8>>();
    }
}

} // namespace
} // namespace spangle::raster::test
