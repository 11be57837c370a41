// Tests dithering on surfaces (GL 1.3, 4.1.8). The stored code depends only on a fragment's colour and its
// place in the window, and the mean over all places is the colour.
#include <algorithm>

#include <gtest/gtest.h>

#include "raster/reference/policy_double.hpp"
#include "tests/unit/stages/canvas.hpp"

namespace spangle::raster::test {
namespace {

constexpr PixelFormat formats[] = {PixelFormat::rgb565_be, PixelFormat::rgb565_le, PixelFormat::rgb666,
                                   PixelFormat::rgb444,    PixelFormat::rgb332,    PixelFormat::grey4,
                                   PixelFormat::mono};

Point of_color(int k) {
    Point p;
    p.color[0] = k / 255.0;
    p.color[1] = (255 - k) / 255.0;
    p.color[2] = (k * 7 & 255) / 255.0;
    return p;
}

/// Returns a component in steps of the format.
double steps(const Point& p, const Component& stored, std::size_t i, bool grey) {
    const double gray = std::floor((3 * p.color[0] + 6 * p.color[1] + p.color[2]) * 25.5 + 1e-9) / 255;
    return (grey ? gray : p.color[i]) * stored.max;
}

TEST(Dither, EveryByteInEveryFormat) {
    for (const PixelFormat format : formats)
        for (const Tier tier : {Tier::exact, Tier::balanced})
            for (int k = 0; k < 256; ++k) {
                Canvas canvas(format, 16, 16, DepthFormat::none);
                FragmentState state = plain_state(canvas);
                state.dither = true;
                state.tier = tier;
                const Point p = of_color(k);
                cover<FixedVertex>(state, canvas, p);
                for (std::size_t i = 0; i < 3; ++i) {
                    double sum = 0;
                    const double wanted = steps(p, canvas.at(0, 0).c[i], i, format_info(format).grey);
                    for (int y = 0; y < 16; ++y)
                        for (int x = 0; x < 16; ++x) {
                            const int code = canvas.at(x, y).c[i].k;
                            ASSERT_EQ(code, canvas.at(x & 3, y & 3).c[i].k) << int(format) << ' ' << k;
                            ASSERT_GE(code + 1e-6, std::floor(wanted + 1e-6))
                                << int(format) << ' ' << k << ' ' << i;
                            ASSERT_LE(code - 1e-6, std::ceil(wanted - 1e-6))
                                << int(format) << ' ' << k << ' ' << i;
                            sum += code;
                        }
                    ASSERT_NEAR(sum / 256, wanted, 1 / 32.0 + 1e-9) << int(format) << ' ' << k << ' ' << i;
                }
            }
}

/// A value on a threshold belongs to the step above it, also if double misses the threshold by its own error.
TEST(Dither, ThresholdsBelongToTheStepAbove) {
    for (std::uint32_t k = 1; k < 32; ++k)
        for (std::uint32_t t = 1; t < 32; t += 2) {
            ASSERT_EQ(Reference::dithered<5>((k - t / 32.0) / 31, t), k) << t;
            ASSERT_EQ(Reference::dithered<6>((2 * k - t / 32.0) / 63, t), 2 * k) << t;
            ASSERT_EQ(Reference::dithered<5>((k - t / 32.0 - 0x1p-20) / 31, t), k - 1) << t;
        }
}

/// Triangles, a line, a point, and single pixels give the same codes.
TEST(Dither, DependsOnThePlaceAlone) {
    for (const PixelFormat format : formats)
        for (const Tier tier : {Tier::exact, Tier::balanced})
            for (int k = 3; k < 256; k += 11) {
                Canvas whole(format, 16, 16, DepthFormat::none), apart = whole;
                FragmentState state = plain_state(whole);
                state.dither = true;
                state.tier = tier;
                Point p = of_color(k);
                cover<FixedVertex>(state, whole, p);
                const Surface surface = apart.surface();
                const DrawState draw = compile<FixedVertex>(state, surface);
                for (int y = 0; y < 16; ++y)
                    for (int x = 0; x < 16; ++x) {
                        Point from = p, to = p;
                        from.x = x + 0.5, from.y = to.y = y + 0.5, to.x = x + 1.5;
                        if ((x + y) % 2 == 0)
                            draw_point<FixedVertex>(draw, surface, fixed_vertex(from), 1);
                        else
                            draw_line<FixedVertex>(draw, surface, fixed_vertex(from), fixed_vertex(to),
                                                   fixed_vertex(from), 1);
                    }
                ASSERT_EQ(whole.color, apart.color) << int(format) << ' ' << k;
            }
}

/// Compares smooth shading of large and small triangles, in both tiers, with doubles, except where a colour
/// lies on a threshold. In the balanced tier the last step is too large by a 290th.
TEST(Dither, SmoothColorsAreThoseOfDoubles) {
    for (const PixelFormat format : {PixelFormat::rgb565_be, PixelFormat::rgb565_le})
        for (const Tier tier : {Tier::exact, Tier::balanced})
            for (const double size : {6.5, 11.25, 59.0}) {
                Canvas fixed(format, 64, 64, DepthFormat::none), exact = fixed;
                FragmentState state = plain_state(fixed);
                state.dither = true;
                state.tier = tier;
                Point corner[4];
                for (int i = 0; i < 4; ++i) {
                    corner[i].x = i == 1 || i == 2 ? 3 + size : 3.375;
                    corner[i].y = i >= 2 ? 2.25 + size : 2.125;
                    const double colors[4][4] = {
                        {1, 0, 0.25, 1}, {0, 1, 0.75, 1}, {0, 0, 1, 1}, {0.9, 0.7, 0.1, 1}};
                    std::copy_n(colors[i], 4, corner[i].color);
                }
                quad<FixedVertex>(state, fixed, corner);
                quad<DoubleVertex>(state, exact, corner);
                const Difference d = difference(fixed, exact);
                EXPECT_LE(d.largest, 1) << size;
                EXPECT_LE(d.pixels, tier == Tier::exact ? 2 : 2 + static_cast<int>(size * size / 200))
                    << size;
            }
}

} // namespace
} // namespace spangle::raster::test
