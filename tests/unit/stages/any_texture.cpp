// Compares textures of every kind, alone, in two units and combined, with the double reference and in the
// shadow policy: volumes, cube maps, compared depths, and levels of all of them.
#include <gtest/gtest.h>

#include "raster/reference/shadow.hpp"
#include "tests/unit/span/any_texture.hpp"
#include "tests/unit/stages/canvas.hpp"

namespace spangle::raster::test {
namespace {

constexpr int size = 24;

/// Makes corners of a plane with perspective, and coordinates that fit every shape.
void corners(Random& random, Point (&p)[4]) {
    const auto any = [&](double low, double high) {
        return low + (high - low) * random.below(10001) / 10000.0;
    };
    const double plane[4][3] = {{any(-2, 2), any(-2, 2), any(-2, 2)},
                                {any(-2, 2), any(-2, 2), any(-2, 2)},
                                {any(-2, 2), any(-2, 2), any(-1, 1)},
                                {any(0, 1), any(0, 1), any(0.6, 2)}};
    const bool projective = random.below(2) == 0;
    for (int i = 0; i < 4; ++i) {
        const double x = i == 1 || i == 2, y = i >= 2;
        const auto at = [&](int n) { return plane[n][0] * x + plane[n][1] * y + plane[n][2]; };
        p[i].x = x * size;
        p[i].y = y * size;
        p[i].w = 1 + 0.5 * x + 0.7 * y;
        p[i].z = 0.3 + 0.1 * i;
        // Coordinates are linear on the plane itself, because what is divided by w is linear in the window.
        p[i].s = at(0) * p[i].w;
        p[i].t = at(1) * p[i].w;
        p[i].r = at(2) * p[i].w;
        p[i].q = projective ? at(3) * p[i].w : 1;
        for (double& c : p[i].color)
            c = any(0, 1);
    }
}

/// Steps of a weight or level may go to the other side, and so may the texel of NEAREST, but rarely.
struct Bound {
    int steps;
    double identical; ///< share of the pixels within `steps`
};

class Pictures {
  public:
    explicit Pictures(const FragmentState& state, const Point (&p)[4])
        : fixed_(PixelFormat::rgba8888, size, size), reference_(fixed_), shadow_(fixed_) {
        quad<FixedVertex>(state, fixed_, p);
        quad<DoubleVertex>(state, reference_, p);
        ShadowReport* const old = report_shadow(&report);
        quad<ShadowVertex>(state, shadow_, p);
        report_shadow(old);
    }
    ShadowReport report;

    void expect(const Bound& bound, const std::string& what) {
        EXPECT_EQ(fixed_.color, shadow_.color) << what;
        const Difference d = difference(fixed_, reference_, bound.steps);
        EXPECT_LE(d.pixels, (1 - bound.identical) * size * size) << what;
        far_ += d.pixels;
    }
    int far() const { return far_; }

  private:
    Canvas fixed_, reference_, shadow_;
    int far_ = 0;
};

FragmentState state_of(const Canvas& canvas) {
    FragmentState state = plain_state(canvas);
    state.dither = false;
    return state;
}

TEST(AnyTexture, OfOneUnit) {
    Random random{5};
    const Canvas canvas(PixelFormat::rgba8888, size, size);
    int far = 0, shapes[4] = {};
    for (int round = 0; round < 1200; ++round) {
        AnyTexture any(random);
        FragmentState state = state_of(canvas);
        state.unit[0].texture = &any.texture;
        state.unit[0].env = TexEnv::replace;
        // The balanced tier divides three coordinates as the others do; its runs of two have tests of their
        // own.
        if (any.texture.shape >= TextureShape::volume && random.below(2) == 0)
            state.tier = Tier::balanced;
        state.unit[0].lod_bias = static_cast<std::int32_t>(random.below(1025)) - 512;
        Point p[4];
        corners(random, p);
        Pictures pictures(state, p);
        const std::string what = "round " + std::to_string(round) + " shape " +
                                 std::to_string(static_cast<int>(any.texture.shape)) + " format " +
                                 std::to_string(static_cast<int>(any.texture.format));
        pictures.expect({4, 0.98}, what);
        far += pictures.far();
        ++shapes[static_cast<int>(any.texture.shape)];
    }
    EXPECT_LE(far, 1200 * size * size / 1000);
    for (const int n : shapes)
        EXPECT_GE(n, 100);
}

/// Each level has one colour, so lambda alone decides on the colour.
TEST(AnyTexture, LevelsOfVolumesAndCubes) {
    Random random{6};
    const Canvas canvas(PixelFormat::rgba8888, size, size);
    for (int round = 0; round < 600;) {
        AnyTexture any(random);
        Texture& texture = any.texture;
        if (texture.shape < TextureShape::volume || texture.format != TexelFormat::l8)
            continue;
        ++round;
        for (auto& texel : any.texels)
            texel = 0;
        for (int level = 0; level < texture.level_count; ++level) { // levels are 40 apart
            const std::size_t begin =
                static_cast<std::size_t>(texture.level[level].texels - any.texels.data());
            const std::size_t border =
                texture.border_texels *
                (std::size_t{texture.level[level].stride} * (texture.level[level].height + 3) + 1);
            for (std::size_t at = begin - std::min(begin, border); at < any.texels.size(); ++at)
                any.texels[at] = static_cast<std::uint8_t>(40 * level);
        }
        texture.mag = texture.min = Filter::linear;
        texture.mip = MipFilter::linear;
        texture.wrap_s = texture.wrap_t = texture.wrap_r = Wrap::clamp_to_edge;
        FragmentState state = state_of(canvas);
        state.unit[0].texture = &texture;
        state.unit[0].env = TexEnv::replace;
        Point p[4];
        corners(random, p);
        Pictures pictures(state, p);
        // The colour changes by 40/256 of a step for each 256th of a level.
        pictures.expect({1, 0.99}, "round " + std::to_string(round));
    }
}

TEST(AnyTexture, OfTwoUnitsCombinedOrNot) {
    Random random{7};
    const Canvas canvas(PixelFormat::rgba8888, size, size);
    int far = 0;
    for (int round = 0; round < 1200; ++round) {
        AnyTexture a(random), b(random);
        FragmentState state = state_of(canvas);
        for (int u = 0; u < 2; ++u) {
            TextureUnit& unit = state.unit[u];
            unit.texture = u == 0 ? &a.texture : &b.texture;
            unit.env = static_cast<TexEnv>(random.below(6));
            for (Combiner* c : {&unit.rgb, &unit.alpha}) {
                c->func = static_cast<CombineFunc>(random.below(c == &unit.rgb ? 8 : 6));
                for (auto& argument : c->argument)
                    argument = {
                        static_cast<CombineSource>(random.below(6)),
                        static_cast<CombineOperand>(c == &unit.rgb ? random.below(4) : 2 + random.below(2))};
            }
            for (auto& c : unit.env_color)
                c = random.below(color_one + 1);
        }
        Point p[4];
        corners(random, p);
        Pictures pictures(state, p);
        pictures.expect({12, 0.98}, "round " + std::to_string(round)); // DOT3 makes four steps of one
        far += pictures.far();
        EXPECT_GT(pictures.report[ShadowStage::texture1].count, 0u);
    }
    EXPECT_LE(far, 1200 * size * size / 1000);
}

} // namespace
} // namespace spangle::raster::test
