// Compares surfaces of indices with the double policy and the shadow, in random states.
#include <gtest/gtest.h>

#include <random>

#include "raster/reference/shadow.hpp"
#include "tests/unit/stages/canvas.hpp"

namespace spangle::raster::test {
namespace {

#if SPANGLE_FEATURE_COLOR_INDEX

constexpr int side = 32;

Point corner(std::mt19937& random, int i, double w) {
    const auto unit = [&random] { return static_cast<double>(random() >> 8) / (1 << 24); };
    Point p;
    p.x = (i == 1 || i == 2) * side;
    p.y = (i >= 2) * side;
    p.z = unit();
    p.w = w;
    p.fog = 2 * unit();
    p.color[0] = random() % 4 == 0 ? static_cast<double>(random() % 256) / 255 : unit();
    return p;
}

FragmentState state_of(std::mt19937& random, const Canvas& canvas) {
    FragmentState f = plain_state(canvas);
    f.tier = Tier::exact;
    f.flat = random() % 4 == 0;
    f.dither = random() % 2 != 0;
    f.fog = random() % 2 != 0;
    f.fog_mode = static_cast<FogMode>(random() % 3);
    f.fog_color[0] = random() % (256u << color_fraction_bits);
    f.color_mask = random() % 3 == 0 ? static_cast<std::uint8_t>(random()) : std::uint8_t{0xFF};
    f.logic = random() % 3 == 0;
    f.logic_op = static_cast<LogicOp>(random() % 16);
    f.depth_test = random() % 2 != 0;
    f.depth_func = static_cast<Compare>(random() % 8);
    f.stencil_test = random() % 4 == 0;
    f.stencil.pass = static_cast<StencilOp>(random() % 8);
    f.stencil.depth_fail = static_cast<StencilOp>(random() % 8);
    // State that applies to colours only must not matter.
    f.blend = f.alpha_test = f.color_sum = true;
    f.alpha_func = Compare::never;
    f.blend_rgb = f.blend_alpha = blend_over;
    return f;
}

/// Halfway between two indices, or on a threshold, the two policies may choose differently: at most one pixel
/// in two hundred.
TEST(Indices, FixedAgainstDoubleAndShadow) {
    std::mt19937 random(4);
    int differ = 0, pixels = 0;
    for (int round = 0; round < 1500; ++round) {
        Canvas fixed(PixelFormat::index8, side, side);
        for (auto& b : fixed.color)
            b = static_cast<std::uint8_t>(random());
        Canvas twin = fixed, shadow = fixed;
        const FragmentState f = state_of(random, fixed);
        const bool perspective = random() % 2 != 0;
        Point p[4];
        for (int i = 0; i < 4; ++i)
            p[i] = corner(random, i, perspective ? 1 + 0.4 * i : 1);
        quad<FixedVertex>(f, fixed, p);
        quad<DoubleVertex>(f, twin, p);
        ShadowReport report;
        ShadowReport* const old = report_shadow(&report);
        quad<ShadowVertex>(f, shadow, p);
        report_shadow(old);
        ASSERT_EQ(shadow.color, fixed.color) << round;
        ASSERT_EQ(shadow.depth, fixed.depth) << round;
        EXPECT_LE(report[ShadowStage::primary].worst, 1.0 / (1 << 17)) << round;
        for (std::size_t i = 0; i < fixed.color.size(); ++i)
            differ += fixed.color[i] != twin.color[i] ? 1 : 0;
        pixels += side * side;
    }
    EXPECT_LE(differ, pixels / 200);
}

/// Only unmasked bits are written, and nothing outside of the scissor rectangle.
TEST(Indices, StayInsideOfMaskAndScissor) {
    std::mt19937 random(5);
    for (int round = 0; round < 300; ++round) {
        Canvas c(PixelFormat::index8, side, side);
        for (auto& b : c.color)
            b = static_cast<std::uint8_t>(random());
        const Canvas old = c;
        FragmentState f = state_of(random, c);
        f.scissor = {3, 5, 11, 17};
        cover<FixedVertex>(f, c, corner(random, 0, 1));
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const auto i = static_cast<std::size_t>(y * side + x);
                const bool inside = x >= 3 && x < 14 && y >= 5 && y < 22;
                const unsigned kept = inside ? ~unsigned{f.color_mask} & 0xFF : 0xFFu;
                ASSERT_EQ(c.color[i] & kept, old.color[i] & kept) << x << ' ' << y;
            }
    }
}

/// Alpha test, blending and colour sum apply to colours only, and change no index (GL 1.3, 4.1.4, 4.1.7).
TEST(Indices, AreNotTreatedAsColors) {
    std::mt19937 random(6);
    for (int round = 0; round < 100; ++round) {
        Canvas with(PixelFormat::index8, side, side), without = with;
        FragmentState f = state_of(random, with);
        ASSERT_TRUE(f.blend && f.alpha_test && f.color_sum);
        const Point p = corner(random, 0, 1);
        cover<FixedVertex>(f, with, p);
        f.blend = f.alpha_test = f.color_sum = false;
        cover<FixedVertex>(f, without, p);
        ASSERT_EQ(with.color, without.color) << round;
        ASSERT_EQ(with.depth, without.depth) << round;
    }
}

TEST(Indices, AreReadWhereThereAreAny) {
    Canvas c(PixelFormat::index8, 4, 4), colors(PixelFormat::rgb332, 4, 4);
    c.color[6] = colors.color[6] = 0xAB;
    EXPECT_EQ(read_index(c.surface(), 2, 1), 0xAB);
    EXPECT_EQ(read_index(c.surface(), 1, 1), 0);
    EXPECT_EQ(read_index(colors.surface(), 2, 1), 0);
}

#endif

} // namespace
} // namespace spangle::raster::test
