// Fog around MODULATE in the balanced tier: light times fog's factor, the texel, the fog's share.
#include <gtest/gtest.h>

#include <cmath>

#include "raster/span/stage_fogged_light.hpp"

namespace spangle::raster::test {
namespace {

using B = Balanced<1>;

/// Green after the three stages, 256ths of 255ths; light likewise, f with 24 fraction bits.
std::uint32_t green(const FogShare<B>& share, std::uint32_t light, std::uint32_t texel, std::uint32_t f) {
    Px<B> p;
    p.color = {0, light, 0, 0};
    p.fog = f;
    FogLight<B>::dim(p, B::clamped_fraction(f));
    p.color.g = B::scaled(p.color.g, texel_factors<B>.of6[texel]);
    EXPECT_TRUE(share(p));
    return p.color.g;
}

/// Each of four products is at most one 256th too small, the factors of the texel and of fog 6 and 1 of
/// 65535, the fog's colour off by half a 256th: less than 1/24 of a 255th, and 1/90 of a step of six bits.
TEST(FoggedLight, IsWithinATwentiethOfA255th) {
    DrawState state{};
    Span<Fixed> span{};
    span.state = &state;
    for (const std::uint32_t fog_color : {0u, color_one / 3, color_one}) {
        state.fragment.fog_color[1] = fog_color;
        const FogShare<B> share(span, 0);
        for (std::uint32_t light = 0; light <= B::one; light += 255)
            for (std::uint32_t texel = 0; texel < 64; ++texel)
                for (std::uint32_t f = 0; f <= 1 << 24; f += 1 << 19) {
                    const double kept = f * 0x1p-24,
                                 exact = light * kept * texel / 63 + fog_color * (1 - kept) / 4096.0;
                    const double off = green(share, light, texel, f) - exact;
                    ASSERT_LE(off, 1) << light << ' ' << texel << ' ' << f;
                    ASSERT_GE(off, -10) << light << ' ' << texel << ' ' << f;
                }
    }
}

TEST(FoggedLight, IsTheFogsColorOutsideOfItsRange) {
    DrawState state{};
    Span<Fixed> span{};
    span.state = &state;
    state.fragment.fog_color[1] = color_one;
    const FogShare<B> share(span, 0);
    const std::uint32_t before = 0u - (1u << 24), behind = 3u << 24;
    EXPECT_EQ(green(share, B::one, 0, before), green(share, 0, 63, before));
    EXPECT_GE(green(share, 0, 0, before), B::one - 2);
    EXPECT_EQ(green(share, B::one, 0, behind), 0u);
    EXPECT_GE(green(share, B::one, 63, behind), B::one - 10);
}

} // namespace
} // namespace spangle::raster::test
