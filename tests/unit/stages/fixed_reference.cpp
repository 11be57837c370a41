// Compares the product's stages with the double reference, mode by mode: coverage and depth are equal,
// colours differ by a step at most.
#include <gtest/gtest.h>

#include <random>

#include "tests/unit/stages/canvas.hpp"

namespace spangle::raster::test {
namespace {

/// A square image of random texels of any format, with all smaller levels.
struct Image {
    std::vector<std::uint8_t> bytes;
    Texture texture;
    Image(TexelFormat format, BaseFormat base, int size, std::uint32_t seed) {
        static constexpr int texel[] = {1, 1, 1, 2, 2, 3, 4};
        const int each = texel[static_cast<int>(format)];
        std::mt19937 random(seed);
        bytes.resize(static_cast<std::size_t>(2 * size * size * each));
        for (auto& b : bytes)
            b = static_cast<std::uint8_t>(random());
        texture.format = format;
        texture.base = base;
        texture.mag = texture.min = Filter::nearest;
        std::size_t at = 0;
        for (int n = size; n >= 1; n /= 2) {
            texture.level[texture.level_count++] = {bytes.data() + at, static_cast<std::uint16_t>(n),
                                                    static_cast<std::uint16_t>(n),
                                                    static_cast<std::uint32_t>(n * each)};
            at += static_cast<std::size_t>(n * n * each);
        }
        const std::uint8_t border[4] = {200, 30, 90, 128};
        std::memcpy(texture.border_color, border, 4);
    }
};

/// Makes corners at different depths, of a plane with perspective to which no row is parallel.
void tilted(const Canvas& c, Point (&p)[4]) {
    const double x[4] = {0, 1, 1, 0}, y[4] = {0, 0, 1, 1}, w[4] = {1.5, 2, 4, 3};
    for (int i = 0; i < 4; ++i) {
        p[i].x = x[i] * c.width;
        p[i].y = y[i] * c.height;
        p[i].w = w[i];
        p[i].z = 0.2 + 0.15 * i;
        p[i].s = 2.3 * x[i] * w[i] / 3 - 0.4;
        p[i].t = 1.7 * y[i] * w[i] / 3 + 0.3;
        p[i].fog = w[i];
        for (int k = 0; k < 4; ++k)
            p[i].color[k] = 0.15071 + 0.79373 * ((i * 5 + k * 3) % 7) / 6.0;
        for (int k = 0; k < 3; ++k)
            p[i].secondary[k] = 0.05117 * ((i + k) % 4);
    }
}

struct Background {
    std::uint32_t seed = 7;
    void paint(Canvas& c) const {
        std::mt19937 random(seed);
        for (auto& b : c.color)
            b = static_cast<std::uint8_t>(random());
    }
};

/// Draws the tilted quad by both policies. Depth must agree to the bit, colours as stated.
void expect_same(const FragmentState& state, const Canvas& blank, int steps, double identical,
                 const char* what, int ignored = 0) {
    Canvas fixed = blank, reference = blank;
    Point p[4];
    tilted(blank, p);
    quad<FixedVertex>(state, fixed, p);
    quad<DoubleVertex>(state, reference, p);
    const Difference d = difference(fixed, reference, ignored);
    EXPECT_LE(d.largest, steps) << what;
    EXPECT_LE(d.pixels, (1 - identical) * fixed.width * fixed.height) << what;
    int depth_differs = 0;
    for (std::int32_t y = 0; y < blank.height; ++y)
        for (std::int32_t x = 0; x < blank.width; ++x) {
            const auto a = read_depth(fixed.surface(), x, y).k, b = read_depth(reference.surface(), x, y).k;
            depth_differs += a > b + 1 || b > a + 1;
            EXPECT_EQ(read_stencil(fixed.surface(), x, y), read_stencil(reference.surface(), x, y)) << what;
        }
    EXPECT_EQ(depth_differs, 0) << what;
}

constexpr PixelFormat formats[] = {PixelFormat::rgb565_be, PixelFormat::rgb565_le, PixelFormat::rgb888,
                                   PixelFormat::rgba8888,  PixelFormat::rgb666,    PixelFormat::rgb444,
                                   PixelFormat::rgb332,    PixelFormat::grey4,     PixelFormat::mono};

TEST(FixedAgainstDouble, Gouraud) {
    for (const PixelFormat format : formats)
        for (const bool dither : {false, true})
            for (const bool perspective : {false, true}) {
                Canvas c(format, 64, 64);
                FragmentState f = plain_state(c);
                f.dither = dither;
                f.perspective = perspective;
                f.depth_test = true;
                expect_same(f, c, 1, 0.998, "exact");
                f.color_sum = true;
                expect_same(f, c, 1, 0.998, "colour sum");
                f.tier = Tier::balanced;
                expect_same(f, c, 1, 0.9, "balanced");
            }
}

struct Base {
    TexelFormat format;
    BaseFormat base;
};
constexpr Base bases[] = {
    {TexelFormat::a8, BaseFormat::alpha},     {TexelFormat::l8, BaseFormat::luminance},
    {TexelFormat::i8, BaseFormat::intensity}, {TexelFormat::la88, BaseFormat::luminance_alpha},
    {TexelFormat::rgb565, BaseFormat::rgb},   {TexelFormat::rgb888, BaseFormat::rgb},
    {TexelFormat::rgba8888, BaseFormat::rgba}};

TEST(FixedAgainstDouble, EnvironmentsOfAllTexels) {
    for (const Base base : bases)
        for (int env = 0; env < 5; ++env)
            for (const Filter filter : {Filter::nearest, Filter::linear}) {
                Canvas c(PixelFormat::rgba8888, 64, 64);
                Image image(base.format, base.base, 16, 99);
                image.texture.mag = image.texture.min = filter;
                image.texture.level_count = 1;
                FragmentState f = plain_state(c);
                f.unit[0].texture = &image.texture;
                f.unit[0].env = static_cast<TexEnv>(env);
                for (int k = 0; k < 4; ++k)
                    f.unit[0].env_color[k] = color_one / 7 * static_cast<std::uint32_t>(k + 1);
                const std::string what = "texels " + std::to_string(int(base.format)) + " env " +
                                         std::to_string(env) + " filter " + std::to_string(int(filter));
                expect_same(f, c, filter == Filter::linear ? 6 : 255, 0.98, what.c_str());
            }
}

TEST(FixedAgainstDouble, WrapsAndBorders) {
    for (int s = 0; s < 4; ++s)
        for (int t = 0; t < 4; ++t)
            for (const Filter filter : {Filter::nearest, Filter::linear})
                for (const Tier tier : {Tier::exact, Tier::balanced}) {
                    Canvas c(PixelFormat::rgba8888, 64, 64);
                    Image image(TexelFormat::rgba8888, BaseFormat::rgba, 8, 5);
                    image.texture.mag = image.texture.min = filter;
                    image.texture.level_count = 1;
                    image.texture.wrap_s = static_cast<Wrap>(s);
                    image.texture.wrap_t = static_cast<Wrap>(t);
                    FragmentState f = plain_state(c);
                    f.unit[0].texture = &image.texture;
                    f.unit[0].env = TexEnv::replace;
                    f.tier = tier;
                    const std::string what = "wrap " + std::to_string(s) + " " + std::to_string(t) +
                                             " filter " + std::to_string(int(filter)) + " tier " +
                                             std::to_string(int(tier));
                    expect_same(f, c,
                                tier == Tier::balanced     ? 255
                                : filter == Filter::linear ? 3
                                                           : 255,
                                tier == Tier::balanced ? (filter == Filter::linear ? 0 : 0.9) : 0.98,
                                what.c_str());
                }
}

TEST(FixedAgainstDouble, Mipmaps) {
    for (int mip = 0; mip < 3; ++mip)
        for (const Filter min : {Filter::nearest, Filter::linear})
            for (const Filter mag : {Filter::nearest, Filter::linear}) {
                Canvas c(PixelFormat::rgba8888, 64, 64);
                Image image(TexelFormat::rgba8888, BaseFormat::rgba, 128, 17);
                image.texture.mip = static_cast<MipFilter>(mip);
                image.texture.min = min;
                image.texture.mag = mag;
                FragmentState f = plain_state(c);
                f.unit[0].texture = &image.texture;
                f.unit[0].env = TexEnv::replace;
                const std::string what = "mip " + std::to_string(mip) + " min " + std::to_string(int(min)) +
                                         " mag " + std::to_string(int(mag));
                // Weights of levels come from a logarithm that is off by up to 1/256 on both sides: up to
                // three steps.
                expect_same(f, c, 255, 0.97, what.c_str(), mip == 2 ? 3 : 1);
            }
}

TEST(FixedAgainstDouble, Fog) {
    for (int mode = 0; mode < 3; ++mode)
        for (const float density : {0.1f, 0.5f, 2.0f})
            for (const Tier tier : {Tier::exact, Tier::balanced}) {
                Canvas c(PixelFormat::rgba8888, 64, 64);
                FragmentState f = plain_state(c);
                f.fog = true;
                f.fog_mode = static_cast<FogMode>(mode);
                f.fog_density = std::bit_cast<std::uint32_t>(density);
                f.fog_start = std::bit_cast<std::uint32_t>(1.0f);
                f.fog_end = std::bit_cast<std::uint32_t>(5.0f);
                f.fog_color[1] = color_one;
                f.tier = tier;
                const std::string what =
                    "mode " + std::to_string(mode) + " density " + std::to_string(density);
                expect_same(f, c, tier == Tier::exact ? 1 : 2, tier == Tier::exact ? 0.998 : 0.6,
                            what.c_str());
            }
}

TEST(FixedAgainstDouble, Blending) {
    for (const PixelFormat format : formats)
        for (int src = 0; src < 15; ++src)
            for (int dst = 0; dst < 15; ++dst)
                for (const Tier tier : {Tier::exact, Tier::balanced}) {
                    Canvas c(format, 32, 32);
                    Background{}.paint(c);
                    FragmentState f = plain_state(c);
                    f.blend = true;
                    f.blend_rgb =
                        f.blend_alpha = {static_cast<BlendFactor>(src), static_cast<BlendFactor>(dst)};
                    f.blend_color[0] = color_one / 3, f.blend_color[2] = f.blend_color[3] = color_one / 5;
                    f.tier = tier;
                    const std::string what = "format " + std::to_string(int(format)) + " src " +
                                             std::to_string(src) + " dst " + std::to_string(dst) + " tier " +
                                             std::to_string(int(tier));
                    expect_same(f, c, 1, tier == Tier::exact ? 0.995 : 0.9, what.c_str());
                }
}

TEST(FixedAgainstDouble, TestsAndMasks) {
    for (int func = 0; func < 8; ++func)
        for (int mask = 0; mask < 16; ++mask) {
            Canvas c(PixelFormat::rgba8888, 32, 32);
            Background{}.paint(c);
            for (std::size_t i = 0; i < c.depth.size(); i += 4)
                c.depth[i] = static_cast<std::uint8_t>(i / 4 * 37);
            FragmentState f = plain_state(c);
            f.alpha_test = true;
            f.alpha_func = static_cast<Compare>(func);
            f.alpha_ref = 120;
            f.color_mask = static_cast<std::uint8_t>(mask);
            f.stencil_test = true;
            f.stencil = {static_cast<Compare>((func + mask) & 7),
                         0x47,
                         0x7F,
                         0xF3,
                         static_cast<StencilOp>(mask & 7),
                         static_cast<StencilOp>(func),
                         static_cast<StencilOp>((mask + 3) & 7)};
            f.depth_test = mask & 1;
            f.depth_func = static_cast<Compare>((func * 3 + 1) & 7);
            expect_same(f, c, 1, 0.99, "tests");
        }
}

} // namespace
} // namespace spangle::raster::test
