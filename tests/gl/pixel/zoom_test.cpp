// Compares which group covers which fragment with the rule of GL 1.3, 3.6.4 in exact integers.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "gl/pixel/zoom.hpp"

namespace spangle::gl {
namespace {

using numeric::from_float;

/// Returns the group that covers fragment x, or -1. The centre must be in [at + z n, at + z (n + 1)), or in
/// the mirrored range. Numbers have 20 fraction bits.
int covering(long long at, long long zoom, int x, int first, int last) {
    const long long center = (static_cast<long long>(x) << 20) + (1 << 19);
    for (int n = first; n < last; ++n) {
        const long long a = at + zoom * n, b = at + zoom * (n + 1);
        if (center >= std::min(a, b) && center < std::max(a, b))
            return n;
    }
    return -1;
}

void check(long long at, long long zoom, int first, int last, int low, int high) {
    const ZoomAxis axis(from_float(static_cast<float>(std::ldexp(static_cast<double>(at), -20))),
                        from_float(static_cast<float>(std::ldexp(static_cast<double>(zoom), -20))));
    ASSERT_EQ(axis.is_empty(), zoom == 0);
    if (zoom == 0)
        return;
    const ZoomAxis::Range range = axis.covered_fragments(first, last, low, high);
    ZoomAxis::GroupWalk walk = axis.from(range.begin < range.end ? range.begin : low);
    for (int x = low; x < high; ++x) {
        const int wanted = covering(at, zoom, x, first, last);
        ASSERT_EQ(x >= range.begin && x < range.end, wanted >= 0) << at << ' ' << zoom << ' ' << x;
        if (wanted < 0)
            continue;
        ASSERT_EQ(walk.group(), wanted) << at << ' ' << zoom << ' ' << x;
        ASSERT_EQ(axis.from(x).group(), wanted);
        walk.step();
    }
}

TEST(PixelZoom, TheNamedCases) { // docs/features.md E05
    for (const double zoom : {1.0, 2.0, -1.0, 0.5, -0.5, 0.25, 3.0, 0.0, 1.5, -2.75})
        for (const double at : {0.0, 5.0, 5.5, 5.25, -3.5, -0.5, 20.999})
            check(static_cast<long long>(std::floor(at * (1 << 20))),
                  static_cast<long long>(zoom * (1 << 20)), 0, 9, -8, 40);
}

TEST(PixelZoom, AnyPositionAndFactor) {
    std::mt19937 random(1);
    const auto number = [&](int bits) { // numbers that a float holds exactly
        const int digits = 1 + static_cast<int>(random() % static_cast<unsigned>(std::min(bits, 24)));
        const auto v = static_cast<long long>(random() >> (32 - digits))
                       << random() % static_cast<unsigned>(bits - digits + 1);
        return random() % 2 != 0 ? -v : v;
    };
    for (int i = 0; i < 40000; ++i) {
        const int first = static_cast<int>(random() % 4), last = first + static_cast<int>(random() % 40);
        check(number(26), number(5 + random() % 20), first, last, static_cast<int>(random() % 20), 60);
    }
}

TEST(PixelZoom, NumbersBeyondEverySurface) {
    const float large[] = {1e10f, 3e38f, 1e30f, -1e10f, -3e38f, 134217728.0f, 67108864.0f, -67108864.0f};
    for (const float at : large)
        for (const float zoom : large) {
            const ZoomAxis axis(from_float(at), from_float(zoom));
            const ZoomAxis::Range range = axis.covered_fragments(0, INT32_MAX, 0, 2048);
            EXPECT_TRUE(range.begin >= range.end || (range.begin == 0 && range.end == 2048))
                << at << ' ' << zoom;
        }
    for (const float zoom : {1e-45f, 1e-30f, 2.3e-10f, -2.3e-10f, -1e-20f, 1e-9f}) {
        const ZoomAxis axis(from_float(3.5f), from_float(zoom));
        const ZoomAxis::Range range = axis.covered_fragments(0, INT32_MAX, 0, 2048);
        if (axis.is_empty())
            continue; // less than 2^-33 is 0
        ASSERT_LE(range.begin, range.end + 2048);
        if (range.begin < range.end) {
            ZoomAxis::GroupWalk walk = axis.from(range.begin);
            for (int x = range.begin; x < range.end; ++x, walk.step())
                ASSERT_GE(walk.group(), 0);
        }
    }
}

TEST(PixelZoom, CornersOfBitmapsAreRoundedDown) {
    const auto corner = [](float at, float origin) {
        return whole_pixels(from_float(at), from_float(origin));
    };
    EXPECT_EQ(corner(10, 0), 10);
    EXPECT_EQ(corner(10.75f, 0.75f), 10);
    EXPECT_EQ(corner(10.75f, 1), 9);
    EXPECT_EQ(corner(0.25f, 0.5f), -1);
    EXPECT_EQ(corner(-3.5f, -3.5f), 0);
    EXPECT_EQ(corner(16777216.0f, 0.0078125f), 16777215); // no float lies between
    EXPECT_EQ(corner(67108872.0f, 67108864.0f), 8);
    EXPECT_EQ(corner(3e38f, 2e9f), 1 << 26);
    EXPECT_EQ(corner(-3e38f, 3e38f), -(1 << 26));
}

} // namespace
} // namespace spangle::gl
