// Draws textures one texel to a pixel at whole pixels. LINEAR must store the bytes of NEAREST, whatever the
// formats of texture and surface, in every tier, dithered or not, and in the reference.
#include <gtest/gtest.h>

#include "tests/unit/span/any_texture.hpp"
#include "tests/unit/stages/canvas.hpp"

namespace spangle::raster::test {
namespace {

constexpr std::int32_t size = 48;

/// Draws the image with its lower left corner at pixel (x, y), with coordinates that are `whole` repeats
/// away.
template <class V>
Canvas blit(const Texture& texture, const FragmentState& from, PixelFormat format, std::int32_t x,
            std::int32_t y, std::int32_t whole) {
    Canvas canvas(format, size, size, DepthFormat::none);
    FragmentState state = from;
    state.scissor = {0, 0, size, size};
    state.unit[0].texture = &texture;
    state.unit[0].env = TexEnv::replace;
    const bool cube = texture.shape == TextureShape::cube;
    Point corner[4];
    for (int i = 0; i < 4; ++i) {
        const double u = i == 1 || i == 2, v = i >= 2;
        corner[i].x = x + u * texture.level[0].width;
        corner[i].y = y + v * texture.level[0].height;
        corner[i].s = cube ? 2 * u - 1 : u + whole;
        corner[i].t = cube ? 2 * v - 1 : v + whole;
        corner[i].r = cube ? 1 : 0.5 / texture.depth;
    }
    quad<V>(state, canvas, corner);
    return canvas;
}

TEST(Blits, LinearIsNearestWhereTexelsArePixels) {
    Random random{41};
    constexpr PixelFormat formats[] = {PixelFormat::rgb565_be, PixelFormat::rgb565_le, PixelFormat::rgb888,
                                       PixelFormat::rgba8888,  PixelFormat::rgb666,    PixelFormat::rgb444,
                                       PixelFormat::rgb332,    PixelFormat::grey4,     PixelFormat::mono};
    for (int n = 0; n < 300; ++n) {
        AnyTexture any(random);
        Texture nearest = any.texture;
        nearest.compares = false;
        const auto wraps = [](Wrap wrap) { return wrap == Wrap::repeat; };
        const bool repeats = wraps(nearest.wrap_s) && wraps(nearest.wrap_t);
        const auto whole = repeats ? static_cast<std::int32_t>(random.below(7)) - 3 : 0;
        const auto x = static_cast<std::int32_t>(random.below(12)) - 4,
                   y = static_cast<std::int32_t>(random.below(12)) - 4;
        nearest.mag = nearest.min = Filter::nearest;
        Texture linear = nearest;
        linear.mag = linear.min = Filter::linear;
        const PixelFormat format = formats[random.below(9)];
        for (const Tier tier : {Tier::exact, Tier::balanced, Tier::fast})
            for (const bool dither : {false, true}) {
                FragmentState state;
                state.tier = tier;
                state.dither = dither;
                Canvas a = blit<FixedVertex>(linear, state, format, x, y, whole),
                       b = blit<FixedVertex>(nearest, state, format, x, y, whole);
                const Difference d = difference(a, b);
                ASSERT_TRUE(a.color == b.color)
                    << n << ": texels " << static_cast<int>(nearest.format) << ", pixels "
                    << static_cast<int>(format) << ", tier " << static_cast<int>(tier) << ", dither "
                    << dither << ", shape " << static_cast<int>(nearest.shape) << ", size "
                    << nearest.level[0].width << 'x' << nearest.level[0].height << ", " << d.pixels
                    << " pixels by up to " << d.largest;
                ASSERT_TRUE(blit<DoubleVertex>(linear, state, format, x, y, whole).color ==
                            blit<DoubleVertex>(nearest, state, format, x, y, whole).color)
                    << n;
            }
    }
}

/// The whole drawing holds the image's values: a component k of m steps is the nearest of 255.
TEST(Blits, EveryComponentArrives) {
    std::uint8_t words[256 * 2], bytes[256];
    for (std::uint32_t k = 0; k < 256; ++k) {
        const auto word = static_cast<std::uint16_t>((k & 31) << 11 | (k & 63) << 5 | (31 - (k & 31)));
        std::memcpy(words + 2 * k, &word, 2);
        bytes[k] = static_cast<std::uint8_t>(k);
    }
    Texture texture;
    texture.level_count = 1;
    texture.mag = texture.min = Filter::linear;
    for (const TexelFormat format : {TexelFormat::rgb565, TexelFormat::l8}) {
        const bool five = format == TexelFormat::rgb565;
        texture.format = format;
        texture.base = five ? BaseFormat::rgb : BaseFormat::luminance;
        texture.level[0] = {five ? words : bytes, 16, 16, five ? 32u : 16u};
        for (const Tier tier : {Tier::exact, Tier::balanced, Tier::fast}) {
            FragmentState state;
            state.tier = tier;
            Canvas picture = blit<FixedVertex>(texture, state, PixelFormat::rgba8888, 3, 5, 0);
            for (std::uint32_t k = 0; k < 256; ++k) {
                const StoredColor color =
                    picture.at(3 + static_cast<std::int32_t>(k % 16), 5 + static_cast<std::int32_t>(k / 16));
                const std::uint32_t k5 = k & 31, k6 = k & 63;
                const auto stored = [&](int c) { return static_cast<std::uint32_t>(color.c[c].k); };
                ASSERT_EQ(stored(0), five ? (k5 * 510 + 31) / 62 : k) << k;
                ASSERT_EQ(stored(1), five ? (k6 * 510 + 63) / 126 : k) << k;
                ASSERT_EQ(stored(2), five ? ((31 - k5) * 510 + 31) / 62 : k) << k;
            }
        }
    }
}

} // namespace
} // namespace spangle::raster::test
