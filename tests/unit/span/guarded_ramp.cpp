// Projective interpolants along rows have the bits of their plane, whether they go by steps or by numbers.
#include <gtest/gtest.h>

#include <random>

#include "raster/ops/guarded_row.hpp"
#include "raster/ops/stage_divided.hpp"

namespace spangle::raster::test {
namespace {

template <class Ramp> void expect_plane(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Span<Fixed> span{};
    span.anchor_x = static_cast<std::int32_t>(random() % 16384) - 8192;
    span.anchor_y = static_cast<std::int32_t>(random() % 16384) - 8192;
    const auto slope = [&] { return random() >> (18 + random() % 40) << (random() % 2) * 16; };
    const Span<Fixed>::Projective plane = {random() >> 18, seed % 2 == 0 ? slope() : 0 - slope(),
                                           seed % 3 == 0 ? slope() : 0 - slope()};
    span.x = static_cast<std::int32_t>(random() % 2048);
    span.y = static_cast<std::int32_t>(random() % 2048);
    const GuardedRowOf<true> by_long_words(span, plane);
    const GuardedRowOf<false> by_words(span, plane);
    for (std::int32_t x = 0; x < 2048; ++x) {
        ASSERT_EQ(by_long_words.value(x), unguarded(span.at(x, plane))) << seed << " pixel " << x;
        ASSERT_EQ(by_words.value(x), unguarded(span.at(x, plane))) << seed << " pixel " << x;
    }
    Ramp ramp(span, 3, plane);
    for (int row = 0; row < 3; ++row, span.x += 7, ++span.y) {
        const std::int32_t first = row - 1;
        if (row != 0)
            ramp.start(span, first, plane);
        for (std::int32_t i = 0; i < 2048; ++i, ramp.step())
            ASSERT_EQ(ramp.value(i), unguarded(span.at((row == 0 ? 3 : first) + i, plane)))
                << seed << " row " << row << " fragment " << i;
    }
}

TEST(GuardedRamp, IsItsPlane) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        expect_plane<GuardedRampOf<false>>(seed);
        expect_plane<GuardedRampOf<true>>(seed);
    }
}

/// At the furthest columns and rows, with all guard bits set, no signed sum wraps.
TEST(GuardedRamp, GuardBitsReachTheCornersOfTheBand) {
    Span<Fixed> span{};
    for (const std::int32_t anchor : {-8192, 8191 + 2048}) {
        span.anchor_x = span.anchor_y = anchor;
        span.x = span.y = anchor < 0 ? 2047 : 0;
        const Span<Fixed>::Projective plane = {0xFFFF, 0xFFFF, 0xFFFF};
        ASSERT_EQ((GuardedRampOf<true>(span, 0, plane).value(0)), unguarded(span.at(0, plane)));
        const std::int32_t far = (1 << 14) - 1;
        ASSERT_EQ(GuardedRowOf<false>(span, plane).value(far), unguarded(span.at(far, plane)));
    }
}

/// A colour that is divided at each fragment is that of its planes at any pixel.
TEST(GuardedRamp, DividedColorsAreThoseOfTheirPlanes) {
    std::mt19937_64 random(98);
    for (int round = 0; round < 500; ++round) {
        Span<Fixed> span{};
        span.x = static_cast<std::int32_t>(random() % 2048);
        span.y = static_cast<std::int32_t>(random() % 2048);
        const auto plane = [&] {
            return Span<Fixed>::Projective{random() >> 18, random() >> 32, 0 - (random() >> 32)};
        };
        span.q = plane();
        for (auto& c : span.color_q)
            c = plane();
        GouraudQ<Exact, true> stage(span, 5);
        Px<Exact> p;
        for (std::int32_t x = 5; x < 70; ++x, stage.step()) {
            stage(p);
            const Inverse inverse(unguarded(span.at(x, span.q)));
            const auto expected = [&](int i) {
                return inner::projective_color(unguarded(span.at(x, span.color_q[i])), inverse);
            };
            ASSERT_EQ(p.color.r, expected(0)) << round << ' ' << x;
            ASSERT_EQ(p.color.g, expected(1)) << round << ' ' << x;
            ASSERT_EQ(p.color.b, expected(2)) << round << ' ' << x;
            ASSERT_EQ(p.color.a, expected(3)) << round << ' ' << x;
        }
    }
}

} // namespace
} // namespace spangle::raster::test
