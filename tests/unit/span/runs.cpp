// Compares coordinates along runs with a division per fragment: each tier must keep its bound in every row.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "raster/ops/cubic_runs.hpp"
#include "raster/ops/stage_coord.hpp"

namespace spangle::raster::test {
namespace {

/// A row in which s, t and q go from one value to another.
struct RandomRow {
    DrawState state;
    Span<Fixed> span{};
    std::mt19937 random;
    void draw_in(Tier tier) {
        state.tier = tier;
#if SPANGLE_OWN_TIERS
        state.knobs = knobs_of(tier);
#endif
    }
    explicit RandomRow(std::uint32_t seed, int log2_size, bool wraps) : random(seed) {
        span.state = &state;
        draw_in(Tier::exact);
        state.log2_width[0] = state.log2_height[0] = static_cast<std::uint8_t>(log2_size);
        state.wraps[0] = {wraps, wraps};
        span.length = 2 + static_cast<std::int32_t>(random() % (seed % 2 == 0 ? 320 : 40));
        span.kind = Kind::textured;
        auto& unit = span.unit[0];
        unit.exponent = -2 + static_cast<int>(random() % 8);
        const auto plane = [&](std::int32_t least) {
            const auto end = [&] { return least + static_cast<std::int64_t>(random() % (1 << 29)); };
            const std::int64_t first = end() << guard_bits;
            return Interpolant<std::uint64_t>{
                static_cast<std::uint64_t>(first),
                static_cast<std::uint64_t>(((end() << guard_bits) - first) / (span.length - 1)), 0};
        };
        unit.s = plane(-(1 << 28));
        unit.t = plane(0);
        span.q = plane(1 << (20 + random() % 10));
        if (random() % 4 == 0)
            span.q.dx = random() % 2 == 0 ? 0 : 40; // S4 has 0, or what rounding leaves
    }
    /// Error bound of a division, in texels: S and Q are whole numbers, and 1 / Q has 31 bits.
    double division(int log2_size) const {
        const auto last = static_cast<double>(span.q.at(span.length - 1, 0));
        const double least = std::fmin(static_cast<double>(span.q.value), last) * 0x1p-16;
        const double most = 0x1p30 / least;
        return std::ldexp((1 + most) / least + most * 0x1p-30, log2_size + span.unit[0].exponent) +
               std::ldexp(1., log2_size - 22);
    }
    double divided(const Interpolant<std::uint64_t>& v, std::int32_t x) const {
        const auto at = [&](const Interpolant<std::uint64_t>& p) {
            return static_cast<double>(static_cast<std::int64_t>(p.at(x, 0)));
        };
        return std::ldexp(at(v) / at(span.q), span.unit[0].exponent);
    }
};

struct Found {
    double worst = 0; ///< largest error in texels
    long runs = 0, fragments = 0;
};

template <class Runs> Found follow(const RandomRow& row, int log2_size) {
    Found found;
    Runs run(row.span, 0, 0);
    std::int32_t next = 0;
    for (std::int32_t x = 0; x < row.span.length; ++x, run.step(), ++found.fragments) {
        if (x == next) {
            next = run.begin(x);
            ++found.runs;
        }
        const auto off = [&](std::uint32_t got, const Interpolant<std::uint64_t>& v) {
            const double d = row.divided(v, x) - std::ldexp(double(got), -32);
            return std::ldexp(std::fabs(d - std::floor(d + .5)), log2_size);
        };
        found.worst =
            std::fmax(found.worst, std::fmax(off(run.s, row.span.unit[0].s), off(run.t, row.span.unit[0].t)));
        Runs other(row.span, x, 0); // a span may begin at any pixel
        EXPECT_EQ(other.begin(x), next);
        EXPECT_EQ(other.s, run.s);
        EXPECT_EQ(other.t, run.t);
    }
    return found;
}

TEST(Runs, CubicsKeepWhatNearestLeavesOpen) {
    long runs = 0, fragments = 0;
    for (const int log2_size : {4, 6, 9})
        for (std::uint32_t seed = 0; seed < 300; ++seed) {
            const RandomRow row(seed, log2_size, true);
            const Found f = follow<CubicRuns>(row, log2_size);
            ASSERT_LE(f.worst, std::ldexp(1., -13) + row.division(log2_size)) << seed;
            runs += f.runs;
            fragments += f.fragments;
        }
    EXPECT_GT(fragments, 3 * runs);
}

/// A span that begins inside a run has the coordinates of the rest of that run, to the bit.
TEST(Runs, AJumpIsThatManySteps) {
    std::mt19937 random(7);
    const auto word = [&random] { return static_cast<std::uint32_t>(random()); };
    for (int n = 0; n < 1000; ++n) {
        const Differences start{word(), word(), word()};
        const std::uint32_t from = word();
        Differences stepped = start;
        std::uint32_t at = from;
        for (std::uint32_t count = 0; count < 16; ++count) {
            Differences jumped = start;
            std::uint32_t v = from;
            jumped.jump(v, count);
            ASSERT_EQ(v, at) << count;
            ASSERT_EQ(jumped.first, stepped.first) << count;
            ASSERT_EQ(jumped.second, stepped.second) << count;
            stepped.step(at);
        }
    }
}

/// A row that is one run may be as wide as the largest surface and begin at the left end of the guard band.
/// Its products are larger than a word.
TEST(Runs, AJumpOverAWideRowIsThatManySteps) {
    constexpr Differences start{0x9E3779B1u, 0x7F4A7C15u, 0x85EBCA6Bu};
    Differences stepped = start;
    std::uint32_t at = 12345;
    for (std::int32_t n = 0; n <= 5 * 2048; ++n) {
        Differences jumped = start;
        std::uint32_t v = 12345;
        jumped.jump(v, n);
        ASSERT_EQ(v, at) << n;
        ASSERT_EQ(start.value_after(12345, n), at) << n;
        ASSERT_EQ(jumped.first, stepped.first) << n;
        ASSERT_EQ(jumped.second, stepped.second) << n;
        stepped.step(at);
    }
    // These are constants, because a compiler refuses a constant whose computation overflows.
    constexpr std::uint32_t wide = start.value_after(12345, 2047), back = start.value_after(12345, -2047);
    EXPECT_NE(wide, back);
}

TEST(Runs, LinesKeepAQuarterOfATexel) {
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        RandomRow row(seed, 6, true);
        row.draw_in(Tier::balanced);
        ASSERT_LE(follow<CoordRuns>(row, 6).worst, .25 + row.division(6)) << seed;
    }
}

/// The logarithm never falls, so one logarithm serves both axes of a square texture.
TEST(Runs, LogarithmsDoNotFall) {
    std::int32_t before = log2_fraction8((std::uint64_t{1} << 40) - 1);
    for (std::uint64_t x = 0; x <= 1 << 16; ++x) {
        const std::int32_t log2 = log2_fraction8((std::uint64_t{1} << 40) + (x << 24));
        ASSERT_LE(before, log2) << x;
        before = log2;
    }
}

TEST(Runs, AreBoundByTheAxisThatChangesMore) {
    for (const auto& [width, height] : {std::pair{6, 6}, {6, 9}, {9, 4}})
        for (std::uint32_t seed = 0; seed < 300; ++seed) {
            RandomRow row(seed, width, true);
            row.state.log2_height[0] = static_cast<std::uint8_t>(height);
            const inner::HomogeneousRow at(row.span, 0);
            const inner::RunBound bound(row.span, 0, at);
            const auto log = [&](std::uint64_t dv, std::int32_t v) {
                const double n = double(unguarded(dv)) * at.q(0) - double(v) * unguarded(at.dq);
                return 256 * std::log2(std::fabs(n) + 0x1p31);
            };
            const double s = log(at.ds, at.s(0)), t = log(at.dt, at.t(0));
            ASSERT_NEAR(bound.repeats, std::fmax(s, t), 2) << seed;
            ASSERT_NEAR(bound.n, std::fmax(s + 256 * width, t + 256 * height), 2) << seed;
        }
}

/// The fast tier has runs of 16 fragments, or longer runs whose error is proven.
TEST(Runs, LongLinesOfTheFastTierKeepHalfATexel) {
    int longer = 0;
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        RandomRow row(seed, 6, true);
        row.draw_in(Tier::fast);
        const Found f = follow<CoordRuns>(row, 6);
        const long sixteens = (row.span.length + 15) / 16;
        ASSERT_LE(f.runs, sixteens) << seed;
        if (f.runs == sixteens)
            continue;
        ASSERT_LE(f.worst, .5 + row.division(6)) << seed;
        ++longer;
    }
    EXPECT_GT(longer, 30);
}

/// Coordinates that do not wrap are divided at every fragment.
TEST(Runs, ClampedCoordinatesDivide) {
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        const RandomRow row(seed, 6, false);
        CubicRuns run(row.span, 0, 0);
        for (std::int32_t x = 0; x < row.span.length; ++x) {
            ASSERT_EQ(run.begin(x), x + 1);
            const double want = std::fmin(row.divided(row.span.unit[0].s, x), 7.9999999);
            ASSERT_NEAR(static_cast<std::int32_t>(run.s) * std::ldexp(1., -28), std::fmax(want, -8), 1e-6)
                << seed;
        }
    }
}

} // namespace
} // namespace spangle::raster::test
