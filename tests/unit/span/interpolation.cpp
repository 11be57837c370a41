// Compares set-up with planes in double at every fragment: depth, colours, texture coordinates. Scissor,
// order and translation must not change them.
#include <gtest/gtest.h>

#include <cmath>

#include "raster/ops/stage_coord.hpp"
#include "raster/span/rows.hpp"
#include "tests/unit/span/sweep.hpp"

namespace spangle::raster::test {
namespace {

constexpr int width = 64, height = 48;

/// Barycentric weights at a fragment's centre: a f(a) + b f(b) + c f(c) (GL 1.3, 3.5.1).
struct Barycentric {
    double a, b, c;
    Barycentric(const Triangle& t, int x, int y) {
        const auto area = [](double ax, double ay, double bx, double by, double cx, double cy) {
            return (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
        };
        const auto& v = t.v;
        const double px = x * 256. + 128, py = y * 256. + 128;
        const double whole = area(v[0].x, v[0].y, v[1].x, v[1].y, v[2].x, v[2].y);
        a = area(px, py, v[1].x, v[1].y, v[2].x, v[2].y) / whole;
        b = area(v[0].x, v[0].y, px, py, v[2].x, v[2].y) / whole;
        c = 1 - a - b;
    }
    double operator()(double fa, double fb, double fc) const { return a * fa + b * fb + c * fc; }
};

double inverse_w(const FixedVertex& v) {
    return std::ldexp(v.w_mantissa, v.w_exponent);
}
double texture_s(const FixedVertex& v) {
    return std::ldexp(v.tex[0].s, v.tex[0].exponent);
}

struct Worst {
    double depth = 0, color = 0, texel = 0;
    long fragments = 0;
};
Worst worst;
Triangle current;
int texel_size;

template <class N> void measure(const Span<Fixed>& span) {
    const auto& v = current.v;
    Coord<N, 0, false> straight(span, span.begin);
    Coord<N, 0, true> bent(span, span.begin);
    const bool projective = span.kind >= Kind::textured;
    std::int32_t next = span.begin;
    for (std::int32_t x = span.begin; x < span.end; ++x) {
        const Barycentric at(current, span.x + x, span.y);
        const double z = at(v[0].z, v[1].z, v[2].z) / depth_one;
        const double code = span.at(x, span.z) / 65536. - .5; // before rounding to nearest
        worst.depth = std::max(worst.depth, std::abs(code - z * 65535));
        if (span.kind <= Kind::affine) {
            const double red = at(v[0].color[0], v[1].color[0], v[2].color[0]) / (1 << 20);
            worst.color = std::max(
                worst.color, std::abs((span.at(x, span.color_value[0]) - double(1 << 15)) / (1 << 24) - red));
        }
        Px<N> p;
        if (projective) {
            if constexpr (decltype(bent)::runs)
                if (x == next)
                    next = bent.begin(x);
            bent(p);
            bent.step();
        } else {
            straight(p);
            straight.step();
        }
        const double q0 = inverse_w(v[0]), q1 = inverse_w(v[1]), q2 = inverse_w(v[2]);
        const double s =
            at(texture_s(v[0]) * q0, texture_s(v[1]) * q1, texture_s(v[2]) * q2) / at(q0, q1, q2);
        const double repeat = std::ldexp(double(p.coord[0].s[0]), -32);
        double off = s - repeat - std::floor(s - repeat);
        off = std::min(off, 1 - off);
        worst.texel = std::max(worst.texel, off * texel_size);
        ++worst.fragments;
    }
}

template <class N> Worst sweep(Tier tier, Kind kind, int rounds, double aspect_limit) {
    Canvas canvas(width, height, PixelFormat::rgba8888, DepthFormat::z16);
    TestTexture texture(TexelFormat::rgb888, BaseFormat::rgb);
    texel_size = 64;
    FragmentState state;
    state.scissor = {0, 0, width, height};
    state.tier = tier;
    state.unit[0].texture = &texture.texture;
    state.depth_test = true;
    DrawState draw_state = compile<FixedVertex>(state, canvas.surface);
    for (auto& variant : draw_state.variant)
        variant.run = reinterpret_cast<AnyFunction>(&by_row<Fixed, &measure<N>>);
    RandomVertices source(5);
    worst = {};
    for (int i = 0; i < rounds; ++i) {
        current = random_triangle(source, width, height, kind);
        const auto& v = current.v;
        const double area =
            std::abs(static_cast<double>(signed_area(v[0].x, v[0].y, v[1].x, v[1].y, v[2].x, v[2].y)));
        const double box =
            (std::max({v[0].x, v[1].x, v[2].x}) - std::min({v[0].x, v[1].x, v[2].x})) *
            static_cast<double>(std::max({v[0].y, v[1].y, v[2].y}) - std::min({v[0].y, v[1].y, v[2].y}));
        if (box <= aspect_limit * area)
            draw(draw_state, canvas.surface, current);
    }
    return worst;
}

TEST(Interpolation, ExactTierIsWithinItsBounds) {
    for (const Kind kind : {Kind::affine, Kind::textured}) {
        const Worst w = sweep<Exact>(Tier::exact, kind, 600, 64);
        EXPECT_GT(w.fragments, 50000);
        EXPECT_LE(w.depth, 1. / 64);
        EXPECT_LE(w.color, 1. / 4096);
        EXPECT_LE(w.texel, 1. / 256);
    }
}

TEST(Interpolation, BalancedTierKeepsAQuarterOfATexel) {
    for (const Kind kind : {Kind::affine, Kind::textured}) {
        const Worst w = sweep<Balanced<1>>(Tier::balanced, kind, 600, 64);
        EXPECT_GT(w.fragments, 50000);
        EXPECT_LE(w.texel, .25);
        if (kind == Kind::textured) {
            EXPECT_GT(w.texel, .02) << "runs are never longer than they need be";
        }
    }
}

/// Slivers beyond thin_aspect are interpolated along one axis. Their depth must not leave the range of the
/// vertices, or it would wrap.
TEST(Interpolation, DepthNeverWrapsInSlivers) {
    for (const DepthFormat format : {DepthFormat::z16, DepthFormat::z24s8}) {
        Canvas canvas(width, height, PixelFormat::rgb565_be, format);
        FragmentState state;
        state.scissor = {0, 0, width, height};
        state.depth_test = true;
        state.depth_func = Compare::always;
        const DrawState draw_state = compile<FixedVertex>(state, canvas.surface);
        RandomVertices source(6);
        for (int i = 0; i < 20000; ++i) {
            Triangle t = random_triangle(source, width, height, Kind::affine);
            const bool far = i % 2 == 0; // at one end of the depth range, or at the other
            for (auto& v : t.v)
                v.z = far ? depth_one - source.below(1 << 12) : source.below(1 << 12);
            t.v[0].z = far ? depth_one : 0;
            t.v[2].x = t.v[1].x + static_cast<std::int32_t>(source.below(7)) - 3;
            t.v[2].y = t.v[1].y + static_cast<std::int32_t>(source.below(7)) - 3;
            std::fill(canvas.depth.begin(), canvas.depth.end(), std::uint8_t(far ? 0xFF : 0));
            draw(draw_state, canvas.surface, t);
            for (std::size_t at = format == DepthFormat::z16 ? 1 : 3; at < canvas.depth.size();
                 at += at % 2 == 1 && format == DepthFormat::z16 ? 2 : 4)
                ASSERT_EQ(canvas.depth[at] < 0x80, !far) << "round " << i;
        }
    }
}

double worst_code;
void measure_depth24(const Span<Fixed>& span) {
    for (std::int32_t x = span.begin; x < span.end; ++x) {
        const Barycentric at(current, span.x + x, span.y);
        const double z = at(current.v[0].z, current.v[1].z, current.v[2].z) / depth_one;
        const double code = std::ldexp(static_cast<double>(span.at(x, span.z24)), -40) - .5;
        worst_code = std::max(worst_code, std::abs(code - z * 16777215));
    }
}

/// Planes over the whole range of depth, slivers among them. Half a code is left at both ends, so a plane may
/// not be off by half a code.
TEST(Interpolation, SteepPlanesOfTwentyFourBitsStayInTheRange) {
    Canvas canvas(width, height, PixelFormat::rgb565_be, DepthFormat::z24s8);
    FragmentState state;
    state.scissor = {0, 0, width, height};
    state.depth_test = true;
    DrawState draw_state = compile<FixedVertex>(state, canvas.surface);
    for (auto& variant : draw_state.variant)
        variant.run = reinterpret_cast<AnyFunction>(&by_row<Fixed, &measure_depth24>);
    RandomVertices source(12);
    worst_code = 0;
    for (int i = 0; i < 60000; ++i) {
        current = random_triangle(source, width, height, Kind::affine);
        auto& v = current.v;
        v[2].x = v[1].x + static_cast<std::int32_t>(source.below(120)) - 60;
        v[2].y = v[1].y + static_cast<std::int32_t>(source.below(120)) - 60;
        v[0].z = i % 2 == 0 ? 0 : depth_one;
        v[1].z = v[2].z = i % 2 == 0 ? depth_one : 0;
        const double area =
            std::abs(static_cast<double>(signed_area(v[0].x, v[0].y, v[1].x, v[1].y, v[2].x, v[2].y)));
        const double box =
            (std::max({v[0].x, v[1].x, v[2].x}) - std::min({v[0].x, v[1].x, v[2].x})) *
            static_cast<double>(std::max({v[0].y, v[1].y, v[2].y}) - std::min({v[0].y, v[1].y, v[2].y}));
        if (box < 1e6 * area)
            draw(draw_state, canvas.surface, current);
    }
    EXPECT_LT(worst_code, 1. / 256); // a wrap would be 2^24
}

struct Setting {
    Tier tier;
    Kind kind;
    bool textured;
};
constexpr Setting settings[] = {
    {Tier::exact, Kind::full, false},       {Tier::exact, Kind::full, true},
    {Tier::exact, Kind::affine, true},      {Tier::balanced, Kind::full, true},
    {Tier::balanced, Kind::textured, true}, {Tier::balanced, Kind::affine, true},
    {Tier::balanced, Kind::full, false},    {Tier::fast, Kind::full, true},
};

struct Scene {
    TestTexture texture{TexelFormat::rgb888, BaseFormat::rgb};
    FragmentState state;
    explicit Scene(const Setting& setting) {
        state.scissor = {0, 0, width, height};
        state.tier = setting.tier;
        state.depth_test = true;
        if (setting.textured) {
            state.unit[0].texture = &texture.texture;
            state.fog = true;
            state.fog_mode = FogMode::linear;
            state.fog_end = 0x40800000;
        }
    }
};

/// A scissor, and so a band, changes no byte.
TEST(Anchoring, TilesMakeTheWholePicture) {
    for (const Setting& setting : settings) {
        Scene scene(setting);
        Canvas whole(width, height, PixelFormat::rgb565_be, DepthFormat::z16);
        std::fill(whole.depth.begin(), whole.depth.end(), std::uint8_t(0xFF));
        Canvas tiles = whole;
        tiles.surface.color = tiles.color.data();
        tiles.surface.depth = tiles.depth.data();
        RandomVertices source(7);
        DrawState state = compile<FixedVertex>(scene.state, whole.surface);
        for (int i = 0; i < 60; ++i) {
            const Triangle t = random_triangle(source, width, height, setting.kind);
            state.fragment.scissor = scene.state.scissor;
            draw(state, whole.surface, t);
            for (int y = 0; y < height; y += 7)
                for (int x = 0; x < width; x += 13) {
                    state.fragment.scissor = {x, y, std::min(13, width - x), std::min(7, height - y)};
                    draw(state, tiles.surface, t);
                }
            ASSERT_EQ(whole.color, tiles.color) << i;
            ASSERT_EQ(whole.depth, tiles.depth) << i;
        }
        EXPECT_GT(std::count_if(whole.color.begin(), whole.color.end(), [](auto byte) { return byte != 0; }),
                  1000);
    }
}

/// The same vertices in another order, or translated by whole pixels, give the same bytes.
TEST(Anchoring, OrderAndTranslationChangeNothing) {
    for (const Setting& setting : settings) {
        Scene scene(setting);
        scene.state.dither = false; // the dither pattern does not move with the triangle
        RandomVertices source(8);
        long drawn = 0;
        for (int i = 0; i < 100; ++i) {
            Canvas here(width, height, PixelFormat::rgb565_be, DepthFormat::z16), there = here;
            there.surface.color = there.color.data();
            there.surface.depth = there.depth.data();
            std::fill(here.depth.begin(), here.depth.end(), std::uint8_t(0xFF));
            std::fill(there.depth.begin(), there.depth.end(), std::uint8_t(0xFF));
            const DrawState state = compile<FixedVertex>(scene.state, here.surface);
            Triangle t = random_triangle(source, width / 2, height / 2, setting.kind);
            if (i % 3 == 0)
                t.v[1].y = t.v[0].y; // x decides which vertex is the lower one
            const int dx = static_cast<int>(source.below(width / 2)),
                      dy = static_cast<int>(source.below(height / 2));
            Triangle moved{{t.v[1], t.v[2], t.v[0]}};
            if (i % 2 == 0)
                std::swap(moved.v[0], moved.v[1]);
            for (auto& v : moved.v)
                v.x += dx * 256, v.y += dy * 256;
            draw(state, here.surface, t);
            draw(state, there.surface, moved);
            for (int y = 0; y < height / 2; ++y) {
                const std::uint8_t *a = here.color.data() + y * width * 2,
                                   *b = there.color.data() + ((y + dy) * width + dx) * 2;
                ASSERT_EQ(std::memcmp(a, b, width), 0) << "round " << i << " row " << y; // the left half
                drawn += std::count_if(a, a + width, [](auto byte) { return byte != 0; });
            }
        }
        EXPECT_GT(drawn, 1000);
    }
}

TEST(Interpolation, ProjectiveColoursAreQuotientsOfAtMostOne) {
    RandomVertices source(3);
    for (int i = 0; i < 200000; ++i) {
        const auto q = static_cast<std::int32_t>(1 + source.below(1u << (1 + source.below(30))));
        const double c = source.below(4) == 0 ? color_one : source.below(color_one + 1);
        const double over_w = c * q * 0x1p-28;
        const std::uint32_t got = inner::projective_color(static_cast<std::int32_t>(over_w), Inverse(q));
        ASSERT_LE(got, color_one);
        ASSERT_NEAR(got, c, 0x1p29 / q + 1) << q;
    }
    EXPECT_EQ(inner::projective_color(-1, Inverse(1 << 29)), 0u);
    EXPECT_LE(inner::projective_color(INT32_MAX, Inverse(5)), color_one);
}

} // namespace
} // namespace spangle::raster::test
