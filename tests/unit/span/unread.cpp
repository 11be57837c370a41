// The key of a state leaves out what reaches no pixel and no test.
#include <gtest/gtest.h>

#include "raster/span/draw_state.hpp"
#include "tests/unit/span/sweep.hpp"

namespace spangle::raster::test {
namespace {

Texture texture_of(BaseFormat base) {
    static constexpr std::uint8_t texels[4] = {};
    Texture texture;
    texture.level[0] = {texels, 1, 1, 4};
    texture.level_count = 1;
    texture.format = base == BaseFormat::rgba    ? TexelFormat::rgba8888
                     : base == BaseFormat::alpha ? TexelFormat::a8
                                                 : TexelFormat::rgb888;
    texture.base = base;
    return texture;
}

/// A state with two texture units, and its key on a surface without alpha.
struct Two {
    Texture texture[2];
    FragmentState state;
    Two(BaseFormat first, TexEnv first_env, BaseFormat second, TexEnv second_env)
        : texture{texture_of(first), texture_of(second)} {
        state.unit[0].texture = &texture[0];
        state.unit[0].env = first_env;
        state.unit[1].texture = &texture[1];
        state.unit[1].env = second_env;
    }
    Key key(PixelFormat format = PixelFormat::rgb565_be) const {
        const Canvas canvas(4, 4, format, DepthFormat::z16);
        return key_of_any_kind(state, canvas.surface);
    }
};

TEST(Unread, UnitsThatALaterUnitReplaces) {
    Two two(BaseFormat::rgba, TexEnv::modulate, BaseFormat::rgb, TexEnv::replace);
    EXPECT_FALSE(two.key().unit[0].on);
    EXPECT_TRUE(two.key().unit[1].on);
    // The alpha of the first unit passes REPLACE by a texture without alpha.
    EXPECT_TRUE(two.key(PixelFormat::rgba8888).unit[0].on);
    two.state.blend = true;
    two.state.blend_rgb = blend_over;
    EXPECT_TRUE(two.key().unit[0].on);
    two.texture[1] = texture_of(BaseFormat::rgba);
    EXPECT_FALSE(two.key().unit[0].on);
    two.state.unit[1].env = TexEnv::decal;
    EXPECT_TRUE(two.key().unit[0].on);
}

TEST(Unread, AlphaThatNothingReads) {
    Two two(BaseFormat::alpha, TexEnv::modulate, BaseFormat::rgb, TexEnv::modulate);
    EXPECT_FALSE(two.key().unit[0].on);
    EXPECT_TRUE(two.key(PixelFormat::rgba8888).unit[0].on);
    // A combiner may read alpha as a colour.
    two.state.unit[1].env = TexEnv::combine;
    EXPECT_TRUE(two.key().unit[0].on);
}

TEST(Unread, ColoursWhereNoChannelIsWritten) {
    Two two(BaseFormat::rgba, TexEnv::modulate, BaseFormat::rgb, TexEnv::modulate);
    two.state.fog = two.state.blend = two.state.color_sum = true;
    for (const std::uint8_t mask : {0x0, 0x8}) { // the surface has no alpha
        two.state.color_mask = mask;
        const Key key = two.key();
        EXPECT_FALSE(key.unit[0].on || key.unit[1].on || key.color || key.fog || key.blend || key.color_sum);
        EXPECT_TRUE(key.masked);
    }
    EXPECT_TRUE(two.key(PixelFormat::rgba8888).unit[0].on);
    two.state.color_mask = 0;
    two.state.alpha_test = true;
    two.state.alpha_func = Compare::greater;
    const Key key = two.key();
    EXPECT_TRUE(key.unit[0].on && key.color_alpha);
    EXPECT_FALSE(key.unit[1].on || key.fog);
}

TEST(Unread, AlphaTestsThatEachAlphaPasses) {
    Two two(BaseFormat::rgba, TexEnv::modulate, BaseFormat::rgb, TexEnv::modulate);
    two.state.alpha_test = true;
    const auto tested = [&](Compare func, std::uint8_t ref) {
        two.state.alpha_func = func;
        two.state.alpha_ref = ref;
        return two.key().alpha;
    };
    EXPECT_EQ(tested(Compare::lequal, 255), Compare::always);
    EXPECT_EQ(tested(Compare::gequal, 0), Compare::always);
    EXPECT_EQ(tested(Compare::lequal, 254), Compare::lequal);
    EXPECT_EQ(tested(Compare::gequal, 1), Compare::gequal);
}

} // namespace
} // namespace spangle::raster::test
