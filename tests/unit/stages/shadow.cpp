// The shadow policy draws what the product draws, and its report stays within the bounds of the tiers (design
// 3).
#include <gtest/gtest.h>

#include "raster/reference/shadow.hpp"
#include "tests/unit/stages/canvas.hpp"

namespace spangle::raster::test {
namespace {

struct Scene {
    Canvas canvas{PixelFormat::rgb565_be, 48, 48};
    std::uint8_t texels[16 * 16 * 4];
    Texture texture;
    FragmentState state;
    Point corner[4];
    Scene() {
        for (std::size_t i = 0; i < sizeof texels; ++i)
            texels[i] = static_cast<std::uint8_t>(i * 37 + i / 64);
        texture.level[0] = {texels, 16, 16, 64};
        texture.level_count = 1;
        texture.format = TexelFormat::rgba8888;
        texture.base = BaseFormat::rgba;
        texture.mag = texture.min = Filter::linear;
        state = plain_state(canvas);
        state.depth_test = true;
        state.unit[0].texture = &texture;
        state.fog = true;
        state.fog_mode = FogMode::exp2;
        state.fog_density = 0x3E99999A; // 0.3
        state.color_sum = true;
        state.blend = true;
        state.blend_rgb = state.blend_alpha = blend_over;
        for (int i = 0; i < 4; ++i) {
            Point& p = corner[i];
            p.x = (i == 1 || i == 2) * 48;
            p.y = (i >= 2) * 48;
            p.w = 1 + 0.7 * i;
            p.fog = p.w;
            p.z = 0.1 + 0.2 * i;
            p.s = i * 0.6 - 0.3;
            p.t = (i & 1) * 1.3;
            for (int k = 0; k < 4; ++k)
                p.color[k] = 0.111 * (i + k + 1);
            p.secondary[i % 3] = 0.07;
        }
    }
};

ShadowReport draw(Scene& scene, const Scene& blank) {
    Canvas fixed = blank.canvas;
    quad<FixedVertex>(scene.state, fixed, scene.corner);
    ShadowReport report;
    ShadowReport* const old = report_shadow(&report);
    quad<ShadowVertex>(scene.state, scene.canvas, scene.corner);
    report_shadow(old);
    EXPECT_EQ(scene.canvas.color, fixed.color);
    EXPECT_EQ(scene.canvas.depth, fixed.depth);
    return report;
}

TEST(Shadow, ExactTierWithinItsBounds) {
    Scene scene;
    ShadowReport r = draw(scene, Scene{});
    EXPECT_EQ(r[ShadowStage::depth].count, 48u * 48u);
    EXPECT_LE(r[ShadowStage::depth].worst, 1.0 / 16777215);
    EXPECT_LE(r[ShadowStage::primary].worst, 0x1p-19);
    EXPECT_LE(r[ShadowStage::coord0].worst, 1.0 / 64);
    EXPECT_LE(r[ShadowStage::fog_factor].worst, 0x1p-21);
    EXPECT_LE(r[ShadowStage::fog].worst, 0.01); // a weight of 8 bits may go to the other side
    EXPECT_NEAR(r[ShadowStage::primary].least, 0.111, 0.02);
    EXPECT_GT(r[ShadowStage::primary].greatest, 0.7);
    EXPECT_EQ(r[ShadowStage::blend].count, 4u * 48u * 48u);
    EXPECT_EQ(r[ShadowStage::coord1].count, 0u);
}

TEST(Shadow, BalancedTierWithinItsBounds) {
    Scene scene;
    scene.state.tier = Tier::balanced;
    ShadowReport r = draw(scene, Scene{});
    EXPECT_LE(r[ShadowStage::coord0].worst, 0.25 + 1.0 / 64); // proven for each run
    EXPECT_LE(r[ShadowStage::primary].worst, 0.25 / 31);      // a quarter of a step of the target
    EXPECT_LE(r[ShadowStage::fog_factor].worst, 0x1p-11);
    EXPECT_LE(r[ShadowStage::depth].worst, 1.0 / 16777215);
}

/// The level of detail of a texture that is so far away that it repeats several times from pixel to pixel (GL
/// 1.3, 3.8.8).
TEST(Shadow, LevelsOfDetailOfManyRepeats) {
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp_to_edge})
        for (const double w : {1.0, 1.5}) // w of one corner: affine, projective
            for (const double repeats : {0.1, 0.45, 0.55, 0.97, 1.02, 3.4, 30.0}) {
                Scene scene;
                for (int level = 0; level < 5; ++level)
                    scene.texture.level[level] = {scene.texels, static_cast<std::uint16_t>(16 >> level),
                                                  static_cast<std::uint16_t>(16 >> level), 64};
                scene.texture.level_count = 5;
                scene.texture.mip = MipFilter::linear;
                scene.texture.wrap_s = scene.texture.wrap_t = wrap;
                scene.state.fog = scene.state.blend = false;
                for (int i = 0; i < 4; ++i) {
                    Point& p = scene.corner[i];
                    p.w = i == 2 ? w : 1;
                    p.s = repeats * p.x;
                    p.t = repeats / 7 * p.y;
                }
                ShadowReport r = draw(scene, scene);
                EXPECT_EQ(r[ShadowStage::lod0].count, 48u * 48u);
                EXPECT_LE(r[ShadowStage::lod0].worst, 1.0 / 64) << repeats << ' ' << w;
                if (w == 1) {
                    EXPECT_NEAR(r[ShadowStage::lod0].greatest, std::fmax(std::log2(16 * repeats), 0),
                                1.0 / 64);
                }
            }
}

TEST(Shadow, LinesPointsAndNoReport) {
    Scene scene;
    Canvas fixed = scene.canvas;
    const auto draw_all = [&]<class V>(Canvas& c, V) {
        const Surface s = c.surface();
        const DrawState state = compile<V>(scene.state, s);
        draw_line<V>(state, s, make<V>(scene.corner[0]), make<V>(scene.corner[2]), make<V>(scene.corner[0]),
                     3);
        draw_point<V>(state, s, make<V>(scene.corner[2]), 5);
    };
    draw_all(fixed, FixedVertex{});
    draw_all(scene.canvas, ShadowVertex{});
    EXPECT_EQ(scene.canvas.color, fixed.color);
    EXPECT_STREQ(name_of(ShadowStage::blend), "blend");
    ShadowReport report;
    report_shadow(&report);
    draw_all(scene.canvas, ShadowVertex{});
    EXPECT_EQ(report_shadow(nullptr), &report);
    EXPECT_GT(report[ShadowStage::primary].count, 100u);
    EXPECT_LE(report[ShadowStage::primary].worst, 0x1p-18);
}

} // namespace
} // namespace spangle::raster::test
