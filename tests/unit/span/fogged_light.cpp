// Tests fog around MODULATE in the balanced tier: the light times fog's factor, times the texel, plus the
// fog's share.
#include <gtest/gtest.h>

#include <cmath>

#include "raster/ops/stage_fogged_light.hpp"
#include "raster/span/fused_keys.hpp"

namespace spangle::raster::test {
namespace {

using B = Balanced<1>;

/// Returns green after the three stages. Result and `light` are in 256ths of a 255th; `f` has 24 fraction
/// bits.
std::uint32_t green(const FogShare<B>& share, std::uint32_t light, std::uint32_t texel, std::uint32_t f) {
    Px<B> p;
    p.color = {0, light, 0, 0};
    p.fog = f;
    FogLight<B>::apply_fog(p, B::clamped_fraction(f));
    p.color.g = B::scaled(p.color.g, texel_factors<B>.of6[texel]);
    EXPECT_TRUE(share(p));
    return p.color.g;
}

/// Each of four products is at most 1/256 of a 255th too small. The factors of the texel and of fog are off
/// by 6 and 1 of 65535, and the fog's colour by half a 256th. The sum is less than 1/24 of a 255th, or 1/90
/// of a step of six bits.
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

using Dithered = FoggedTexel<PixelFormat::rgb565_le, true, true, false>;
using DitheredLow = FoggedTexel<PixelFormat::rgb565_le, true, true, true>;

/// Returns what a form makes of dimmed light, a texel, fog's factor and a threshold in 32nds.
template <class Form>
std::uint32_t dithered(const Form& form, std::uint32_t light, std::uint32_t texel, std::uint32_t f,
                       std::uint32_t threshold) {
    BalancedLit::Color color{};
    color.r = color.g = color.b = light;
    color.texel = texel;
    return form.word(color, form.shares(f, threshold << (Form::threshold_bits - 5)), Form::sixths,
                     Form::fifths) &
           0xFFFF;
}

/// Both forms store what the chain's three stages store.
TEST(FoggedLight, DitheredHasOneForm) {
    DrawState state{};
    Span<Fixed> span{};
    span.state = &state;
    for (const std::uint32_t fog_color : {0u, color_one / 3, color_one}) {
        for (std::uint32_t& c : state.fragment.fog_color)
            c = fog_color;
        const Dithered high(span);
        const DitheredLow low(span);
        const FogShare<B, true> share(span, 0);
        for (std::uint32_t light = 0; light <= B::one; light += 977)
            for (std::uint32_t texel = 0; texel < 65536; texel += 991)
                for (std::uint32_t f = 0; f <= 65535; f += 4369)
                    for (std::uint32_t threshold = 1; threshold < 32; threshold += 10) {
                        const std::uint32_t dimmed = B::scaled(light, f);
                        const auto s = B::in_steps(TexelColors<B, true, false>::unpack(texel));
                        Px<B> p;
                        p.color = {B::mul(dimmed, s.r), B::mul(dimmed, s.g), B::mul(dimmed, s.b), 0};
                        ASSERT_TRUE(share.add(p, f));
                        const std::uint32_t word = steps565<B>(p.color, threshold << 5);
                        ASSERT_EQ(dithered(high, dimmed, texel, f, threshold), word);
                        ASSERT_EQ(dithered(low, dimmed, texel, f, threshold), word);
                    }
    }
}

/// A step of six bits has 512 units, and less than 1/50 of a step is lost. Every threshold is from 1/32 to
/// 31/32 of a step, so exact colours stay exact.
TEST(FoggedLight, DitheredKeepsWhatIsExact) {
    DrawState state{};
    Span<Fixed> span{};
    span.state = &state;
    const Dithered form(span);
    for (const std::uint32_t threshold : {1u, 31u}) {
        for (std::uint32_t k = 0; k < 32; ++k) {
            const std::uint32_t texel = k << 11 | (63 - k) << 5 | (31 - k);
            EXPECT_EQ(dithered(form, B::scaled(B::one, 65535), texel, 65535, threshold), texel);
            EXPECT_EQ(dithered(form, 0, texel, 65535, threshold), 0u);
        }
        for (std::uint32_t& c : state.fragment.fog_color)
            c = color_one;
        EXPECT_EQ(dithered(Dithered(span), 0, 0, 0, threshold), 0xFFFFu);
    }
}

/// Colours may be counted in steps only if the stages behind MODULATE are sums.
TEST(FoggedLight, CountsStepsWhereNothingElseFollows) {
    Key key = KeyBuilder(Number::balanced, Kind::affine)
                  .texture(TexelFormat::rgb565, BaseFormat::rgb, Filter::nearest, TexEnv::modulate)
                  .fog()
                  .key;
    key.format = PixelFormat::rgb565_le;
    EXPECT_FALSE(counts_steps(key));
    key.dither = true;
    EXPECT_TRUE(counts_steps(key));
    for (bool Key::*other : {&Key::blend, &Key::masked, &Key::logic}) {
        Key with = key;
        with.*other = true;
        EXPECT_FALSE(counts_steps(with));
    }
    key.unit[0].base = BaseFormat::alpha;
    EXPECT_FALSE(counts_steps(key));
}

/// The mean of a dither pattern is its colour within 1/50 of a step.
TEST(FoggedLight, DitheredIsWithinAFiftiethOfAStep) {
    DrawState state{};
    Span<Fixed> span{};
    span.state = &state;
    for (const std::uint32_t fog_color : {0u, color_one / 3, color_one}) {
        state.fragment.fog_color[1] = fog_color;
        const FogShare<B, true> share(span, 0);
        for (std::uint32_t light = 0; light <= B::one; light += 255)
            for (std::uint32_t texel = 0; texel < 64; ++texel)
                for (std::uint32_t f = 0; f <= 65535; f += 1285) {
                    Px<B> p;
                    p.color = {0, B::scaled(B::scaled(light, f), texel_factors<B, 1>.of6[texel]), 0, 0};
                    ASSERT_TRUE(share.add(p, f));
                    const double kept = f / 65535.0,
                                 exact = light * kept * texel / 63 + fog_color * (1 - kept) / 4096.0,
                                 off = p.color.g / 512.0 - exact * 63 / B::one;
                    ASSERT_LE(off, 0.002) << light << ' ' << texel << ' ' << f;
                    ASSERT_GE(off, -0.02) << light << ' ' << texel << ' ' << f;
                }
    }
}

} // namespace
} // namespace spangle::raster::test
