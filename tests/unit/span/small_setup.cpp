// The set-up of triangles in small boxes must give the bits of the general set-up.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "raster/primitive/edge.hpp"
#include "raster/primitive/setup.hpp"
#include "tests/unit/span/state_of_key.hpp"

namespace spangle::raster::test {
namespace {

constexpr int size = 64;

/// Returns a triangle in a box of width x height subpixels. Every third triangle is a sliver.
Triangle small_triangle(RandomVertices& source, std::uint32_t width, std::uint32_t height) {
    Triangle t = random_triangle(source, size, size, Kind::affine);
    const auto below = [&](std::uint32_t n) { return static_cast<std::int32_t>(source.below(n)); };
    for (FixedVertex& v : t.v)
        v.x = below(width + 1), v.y = below(height + 1);
    if (source.below(3) == 0) {
        t.v[1].x = (t.v[0].x + t.v[2].x) / 2 + below(3);
        t.v[1].y = (t.v[0].y + t.v[2].y) / 2;
    }
    return t;
}

struct SmallSetup : testing::Test {
    static Key smooth() {
        Key key;
        key.number = Number::balanced;
        key.kind = Kind::affine;
        key.depth = Compare::less;
        key.depth_write = true;
        key.depth_format = DepthFormat::z16;
        return key;
    }
    Key key = smooth();
    StateOfKey of{key, size, size};
    Canvas canvas{size, size, key.format, key.depth_format};
    DrawState state = compile<FixedVertex>(of.state, canvas.surface);
    RandomVertices source{16};
};

TEST_F(SmallSetup, IsThatOfAnyTriangle) {
    int along_an_axis = 0;
    for (int round = 0; round < 30000; ++round) {
        const Triangle t =
            small_triangle(source, 1 + source.below(SmallEdge::extent), 1 + source.below(low_extent));
        const FixedVertex* v[3] = {&t.v[0], &t.v[1], &t.v[2]};
        std::sort(v, v + 3, [](auto* a, auto* b) { return a->y < b->y || (a->y == b->y && a->x < b->x); });
        const std::int64_t area = signed_area(v[0]->x, v[0]->y, v[1]->x, v[1]->y, v[2]->x, v[2]->y);
        if (area == 0)
            continue;
        const auto [least, most] = std::minmax({v[0]->x, v[1]->x, v[2]->x});
        const auto box = static_cast<std::uint32_t>((most - least) * (v[2]->y - v[0]->y));
        Span<Fixed> any, small;
        any.state = small.state = &state;
        any.target = small.target = &canvas.surface;
        raster::Setup<Fixed>(any, *v[0], *v[1], *v[2], *v[2], area);
        raster::Setup<Fixed>(small, *v[0], *v[1], *v[2], *v[2],
                             raster::Setup<Fixed>::Area::in_box(static_cast<std::int32_t>(area), box));
        along_an_axis += any.basis.v[0] == any.basis.v[2] ? 1 : 0;
        ASSERT_EQ(any.kind, small.kind);
        ASSERT_EQ(any.anchor_x, small.anchor_x);
        ASSERT_EQ(any.anchor_y, small.anchor_y);
        for (int i = 0; i < 3; ++i)
            ASSERT_EQ(any.basis.v[i], small.basis.v[i]) << "round " << round;
        const Coefficients &a = any.basis.by, &b = small.basis.by;
        ASSERT_EQ(a.exponent, b.exponent);
        for (int i = 0; i < 2; ++i) {
            ASSERT_EQ(a.dx[i], b.dx[i]) << "round " << round;
            ASSERT_EQ(a.dy[i], b.dy[i]);
            ASSERT_EQ(a.center[i], b.center[i]);
        }
        const auto same = [](const auto& p, const auto& q) {
            return p.value == q.value && p.dx == q.dx && p.dy == q.dy;
        };
        ASSERT_TRUE(same(any.z, small.z));
        for (int c = 0; c < 3 && any.kind == Kind::affine; ++c)
            ASSERT_TRUE(same(any.color_value[c], small.color_value[c]));
    }
    EXPECT_GT(along_an_axis, 100);
}

/// These triangles have areas larger than a word.
TEST_F(SmallSetup, LargeTrianglesReachTheDepthOfTheirCorners) {
    for (int round = 0; round < 1000; ++round) {
        Triangle t = random_triangle(source, size, size, Kind::affine);
        const auto any = [&] { return static_cast<std::int32_t>(source.below(100 * subpixel_one)); };
        const std::int32_t far = (200 << source.below(5)) * subpixel_one;
        t.v[0].x = any(), t.v[0].y = any();
        t.v[1].x = far + any(), t.v[1].y = 100 * subpixel_one + any();
        t.v[2].x = any(), t.v[2].y = far + 100 * subpixel_one + any();
        Span<Fixed> span;
        span.state = &state;
        span.target = &canvas.surface;
        raster::Setup<Fixed>(span, t.v[0], t.v[1], t.v[2], t.v[2],
                             signed_area(t.v[0].x, t.v[0].y, t.v[1].x, t.v[1].y, t.v[2].x, t.v[2].y));
        for (const FixedVertex& v : t.v) {
            const std::uint32_t z =
                span.z.at((v.x >> subpixel_bits) - span.anchor_x, (v.y >> subpixel_bits) - span.anchor_y);
            const double apart = 1.0 * z - 4.0 * v.z, // half a pixel from the corner to its centre
                pixel = 1.0 * std::abs(static_cast<std::int32_t>(span.z.dx)) +
                        std::abs(static_cast<std::int32_t>(span.z.dy)) + (1 << 16);
            ASSERT_LE(std::abs(apart), pixel + 65536.0 * 4) << "round " << round;
        }
    }
}

} // namespace
} // namespace spangle::raster::test
