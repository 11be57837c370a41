// Lanes beyond the last fragment of a packet hold whatever memory held before. They must change neither a
// picture nor its cost.
#include <gtest/gtest.h>

#include <cstring>

#include "raster/chain/assemble.hpp"

namespace spangle::raster::test {
namespace {

template <class N> struct PartOfAGroup {
    std::uint8_t texels[4 * 4 * 3];
    Texture texture;
    DrawState state;
    Span<Fixed> span;
    Packet<N> packet;

    /// Textures `n` fragments on the diagonal of an image with a border colour. All other memory holds bytes
    /// of value `beyond`.
    PartOfAGroup(std::int32_t n, int beyond) {
        for (int i = 0; i < 48; ++i)
            texels[i] = static_cast<std::uint8_t>(5 * i);
        texture.format = TexelFormat::rgb888;
        texture.base = BaseFormat::rgb;
        texture.wrap_s = texture.wrap_t = Wrap::clamp_to_border;
        texture.mag = texture.min = Filter::nearest;
        texture.level[0] = {};
        texture.level[0].texels = texels;
        texture.level[0].width = texture.level[0].height = 4;
        texture.level[0].stride = 12;
        state.fragment.unit[0].texture = &texture;
        state.fragment.unit[0].env = TexEnv::replace;
        span.state = &state;
        std::memset(static_cast<void*>(&packet), beyond, sizeof packet);
        packet.x = 0;
        packet.n = n;
        for (std::int32_t i = 0; i < n; ++i) {
            auto& at = packet.coord[0][i / N::lanes];
            at.s[i % N::lanes] = at.t[i % N::lanes] = place(i);
        }
        PacketTexture<N>::template run<0>(packet, span);
    }
    static std::uint32_t place(std::int32_t i) {
        return static_cast<std::uint32_t>(2 * (i % 4) + 1) << (clamped_coord_bits - 3);
    }
};

template <class N> void expect_no_difference() {
    if constexpr (N::lanes > 1)
        for (std::int32_t n = 1; n <= packet_length; ++n) {
            const PartOfAGroup<N> zeros(n, 0), far(n, 0x7E);
            for (std::int32_t i = 0; i < n; ++i) {
                typename OneLane<N>::Color a, b;
                lane_of(zeros.packet.color[i / N::lanes], i % N::lanes, a);
                lane_of(far.packet.color[i / N::lanes], i % N::lanes, b);
                ASSERT_EQ(a.r, b.r) << n << " fragments, the one of " << i;
                ASSERT_EQ(a.g, b.g);
                ASSERT_EQ(a.b, b.b);
            }
            // Dead lanes repeat the last fragment's place; places in the border would have cost time.
            for (std::int32_t i = n; i % N::lanes != 0; ++i) {
                EXPECT_EQ(far.packet.coord[0][i / N::lanes].s[i % N::lanes], PartOfAGroup<N>::place(n - 1));
                EXPECT_EQ(far.packet.coord[0][i / N::lanes].t[i % N::lanes], PartOfAGroup<N>::place(n - 1));
            }
        }
}

TEST(DeadLanes, LookWhereTheLastFragmentDoes) {
    expect_no_difference<Balanced<host_lanes>>();
}

} // namespace
} // namespace spangle::raster::test
