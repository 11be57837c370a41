// Tests blending (GL 1.4, 4.1.7): every pair of factors, with every pair of 8-bit components in every product
// of the factors, and every equation.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/unit/stages/canvas.hpp"

namespace spangle::raster::test {
namespace {

using Bytes = std::array<int, 4>;

/// Returns the source colour of column x and row y. Whichever two components are multiplied, all pairs of
/// bytes occur.
Bytes source(int x, int y) {
    return {x, y, 255 - x, y};
}
Bytes stored(int x, int y) {
    return {y, x, y ^ 0x55, x};
}
constexpr Bytes constant = {17, 200, 255, 99};

int factor(BlendFactor f, const Bytes& s, const Bytes& d, std::size_t i) {
    switch (f) {
    case BlendFactor::zero:
        return 0;
    case BlendFactor::one:
        return 255;
    case BlendFactor::src_color:
        return s[i];
    case BlendFactor::one_minus_src_color:
        return 255 - s[i];
    case BlendFactor::src_alpha:
        return s[3];
    case BlendFactor::one_minus_src_alpha:
        return 255 - s[3];
    case BlendFactor::dst_alpha:
        return d[3];
    case BlendFactor::one_minus_dst_alpha:
        return 255 - d[3];
    case BlendFactor::dst_color:
        return d[i];
    case BlendFactor::one_minus_dst_color:
        return 255 - d[i];
    case BlendFactor::src_alpha_saturate:
        return i == 3 ? 255 : std::min(s[3], 255 - d[3]);
    case BlendFactor::constant_color:
        return constant[i];
    case BlendFactor::one_minus_constant_color:
        return 255 - constant[i];
    case BlendFactor::constant_alpha:
        return constant[3];
    case BlendFactor::one_minus_constant_alpha:
        return 255 - constant[3];
    }
    return 0;
}

/// Returns the nearest 255th. 255 is odd, so there are no ties.
int blended(const Blending& by, const Bytes& s, const Bytes& d, std::size_t i) {
    if (by.equation == BlendEquation::min)
        return std::min(s[i], d[i]);
    if (by.equation == BlendEquation::max)
        return std::max(s[i], d[i]);
    const int a = s[i] * factor(by.src, s, d, i), b = d[i] * factor(by.dst, s, d, i);
    const int sum = by.equation == BlendEquation::add        ? a + b
                    : by.equation == BlendEquation::subtract ? a - b
                                                             : b - a;
    return (2 * std::clamp(sum, 0, 255 * 255) + 255) / 510;
}

/// Gives a row of fragments for each row of the window.
struct AllPairs : PixelSource {
    AllPairs() {
        emit = [](PixelSource&, PixelSink& sink) {
            static std::uint32_t pixels[256 + pixel_room][4];
            for (int y = 0; y < 256; ++y) {
                for (int x = 0; x < 256; ++x)
                    for (std::size_t i = 0; i < 4; ++i)
                        pixels[x][i] = static_cast<std::uint32_t>(source(x, y)[i]) << color_fraction_bits;
                sink.run(sink, y, 0, 256, pixels);
            }
        };
    }
};

/// Compares all pairs: components may differ by `steps` at most, and at most so many of 2^18 may differ.
void expect(const Blending& by, Tier tier, int steps, int off_at_most) {
    Canvas canvas(PixelFormat::rgba8888, 256, 256, DepthFormat::none);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            for (std::size_t i = 0; i < 4; ++i)
                canvas.color[static_cast<std::size_t>(1024 * y + 4 * x) + i] =
                    static_cast<std::uint8_t>(stored(x, y)[i]);
    FragmentState state = plain_state(canvas);
    state.colors = Colors::of_pixels;
    state.tier = tier;
    state.blend = true;
    state.blend_rgb = state.blend_alpha = by;
    for (std::size_t i = 0; i < 4; ++i)
        state.blend_color[i] = static_cast<std::uint32_t>(constant[i]) << color_fraction_bits;
    const Surface surface = canvas.surface();
    AllPairs pairs;
    draw_pixels<FixedVertex>(compile<FixedVertex>(state, surface), surface, fixed_vertex(Point{}), pairs);
    int off = 0, worst = 0;
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            for (std::size_t i = 0; i < 4; ++i) {
                const int got = canvas.color[static_cast<std::size_t>(1024 * y + 4 * x) + i];
                const int difference = std::abs(got - blended(by, source(x, y), stored(x, y), i));
                off += difference != 0 ? 1 : 0;
                worst = std::max(worst, difference);
            }
    EXPECT_LE(worst, steps) << int(by.src) << ' ' << int(by.dst) << ' ' << int(by.equation);
    EXPECT_LE(off, off_at_most) << int(by.src) << ' ' << int(by.dst) << ' ' << int(by.equation);
}

void expect_in_every_tier(const Blending& by) {
    expect(by, Tier::exact, 0, 0);
    expect(by, Tier::balanced, 1, (1 << 18) / 32);
}

TEST(BlendProducts, OfEveryPairOfFactors) {
    for (int src = 0; src < 15; ++src)
        for (int dst = 0; dst < 15; ++dst)
            // SRC_ALPHA_SATURATE is a factor of the source only.
            if (static_cast<BlendFactor>(dst) != BlendFactor::src_alpha_saturate)
                expect_in_every_tier({static_cast<BlendFactor>(src), static_cast<BlendFactor>(dst)});
}

TEST(BlendProducts, OfEveryEquation) {
    constexpr BlendFactor factors[] = {BlendFactor::one, BlendFactor::src_alpha, BlendFactor::dst_color,
                                       BlendFactor::one_minus_constant_color};
    for (const BlendFactor src : factors)
        for (const BlendFactor dst : factors)
            for (int equation = 1; equation < 5; ++equation)
                expect_in_every_tier({src, dst, static_cast<BlendEquation>(equation)});
}

} // namespace
} // namespace spangle::raster::test
