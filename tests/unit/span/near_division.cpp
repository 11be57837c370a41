// Tests quotients that are guessed near a place: the true quotient must lie where NearDivisionOf says.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "raster/ops/near_division.hpp"

namespace spangle::raster::test {
namespace {

using Random = std::mt19937_64;

std::int64_t between(Random& random, std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(high - low + 1));
}

/// A span with 1/w and one more plane, and a patch of it.
struct Case {
    FixedVertex corner[3]{};
    Span<Fixed> span{};
    Span<Fixed>::Projective other{};
    Patch patch{};
    int exponent = 0;

    explicit Case(Random& random) {
        span.anchor_x = static_cast<std::int32_t>(between(random, -3000, 3000));
        span.anchor_y = static_cast<std::int32_t>(between(random, -3000, 3000));
        patch = {static_cast<std::int32_t>(between(random, 0, 2047)),
                 static_cast<std::int32_t>(between(random, 0, 2047)),
                 static_cast<std::int32_t>(between(random, 0, Patch::most_columns)),
                 static_cast<std::int32_t>(between(random, 0, Patch::most_rows))};
        exponent = static_cast<int>(between(random, -2, 6));
        // 1/w varies by up to a fifth over the patch, and the quotient by up to twice the range of 16 bits.
        const std::int64_t q = between(random, 1 << 28, 1 << 30);
        span.q = plane(random, q, static_cast<double>(q) / 5);
        const double unit = std::ldexp(static_cast<double>(q), -16 - exponent);
        const double center = unit * static_cast<double>(between(random, -200000, 200000)),
                     range = unit * 65536 * std::ldexp(1, -static_cast<int>(between(random, 0, 6)));
        other = plane(random, static_cast<std::int64_t>(center), range);
        for (int i = 0; i < 3; ++i) { // a triangle around the patch, or inside of it
            const std::int32_t far = random() % 2 == 0 ? 400 * 256 : 256 * patch.rows;
            corner[i].x = patch.x * 256 + static_cast<std::int32_t>(between(random, -far, far));
            corner[i].y = patch.y * 256 + static_cast<std::int32_t>(between(random, -far, far));
            span.basis.v[i] = &corner[i];
        }
    }
    Span<Fixed>::Projective plane(Random& random, std::int64_t center, double range) const {
        const auto slope = [&](std::int32_t over) {
            const double most = range * 65536 / (2 * over + 1);
            return static_cast<std::int64_t>(most * static_cast<double>(between(random, -1000, 1000)) / 1000);
        };
        const std::int64_t dx = slope(patch.columns), dy = slope(patch.rows);
        return {static_cast<std::uint64_t>(center * 65536 - dx * (patch.x - span.anchor_x) -
                                           dy * (patch.y - span.anchor_y)),
                static_cast<std::uint64_t>(dx), static_cast<std::uint64_t>(dy)};
    }
    bool inside(std::int32_t x, std::int32_t y) const {
        int left = 0, right = 0;
        for (int i = 0; i < 3; ++i) {
            const FixedVertex &a = corner[i], &b = corner[(i + 1) % 3];
            const std::int64_t side = std::int64_t{b.x - a.x} * (y * 256 + 128 - a.y) -
                                      std::int64_t{b.y - a.y} * (x * 256 + 128 - a.x);
            left += side >= 0;
            right += side <= 0;
        }
        return (left == 3) != (right == 3); // both are 3 if the corners lie on a line
    }
    /// The quotient in 2^-16, as the exact tier divides.
    double quotient(std::int32_t x, std::int32_t y) const {
        const auto at = [&](const Span<Fixed>::Projective& p) {
            return static_cast<double>(
                static_cast<std::int64_t>(p.at(x - span.anchor_x, y - span.anchor_y)) >> guard_bits);
        };
        return std::ldexp(at(other) / at(span.q), exponent + 16);
    }
};

struct Met {
    int cases = 0, fragments = 0;
    double least = 1e9, most = -1e9;

    /// Notes a fragment whose quotient is `above` more than the guess; it must be less than `window`.
    void note(double above, double window) {
        ASSERT_GE(above, 0) << "window " << window;
        ASSERT_LT(above, window);
        ++fragments;
        least = std::min(least, above);
        most = std::max(most, above - window);
    }
};

#if defined(__SSE2__) || defined(__ARM_NEON)
using L = Lanes<8>;

/// Calls guessed(x, y, value) with what lanes make of each fragment of a patch.
void each_guess(const Case& of, const NearDivision& division, const NearQuotient& quotient, auto guessed) {
    const std::int32_t first = of.patch.x - of.patch.columns, last = of.patch.x + of.patch.columns;
    Span<Fixed> span = of.span;
    span.x = first - 7;
    span.y = of.patch.y - of.patch.rows;
    NearPlanes<2> planes(span, 0, division.u, quotient.d);
    for (std::int32_t y = span.y; y <= of.patch.y + of.patch.rows; ++y) {
        std::int32_t x = first - (y & 7); // the last group of a scissor rectangle
        for (planes.start(x, y); x <= last; x += 8, planes.step()) {
            const L::U16 low = L::splat(0x8000), high = L::splat(0x7FFF);
            const L::U16 got =
                L::clamped_signed(NearInverse(planes.whole<0>()).of(planes.whole<1>()), low, high);
            for (int i = 0; i < 8; ++i)
                if (x + i >= first && x + i <= last)
                    guessed(x + i, y, static_cast<std::int16_t>(got[i]));
        }
    }
}
#endif

/// Calls guessed(x, y, value) with what the form in words makes of each fragment.
void each_guess(const Case& of, const NearDivisionOf<NearWords>& division, const NearQuotient& quotient,
                auto guessed) {
    for (std::int32_t y = of.patch.y - of.patch.rows; y <= of.patch.y + of.patch.rows; ++y)
        for (std::int32_t x = of.patch.x - of.patch.columns; x <= of.patch.x + of.patch.columns; ++x) {
            const auto at = [&](const Interpolant<std::uint32_t>& plane) {
                return plane.at(x - of.span.anchor_x, y - of.span.anchor_y);
            };
            guessed(x, y,
                    static_cast<std::int32_t>(
                        NearWords::of(0, at(quotient.d), NearWords::inverse(at(division.u)))));
        }
}

template <class Products> void expect_within(Random& random, Met& met) {
    const Case of(random);
    const NearDivisionOf<Products> division(of.span, of.patch);
    NearQuotient quotient;
    const std::uint32_t more = random() % 2 == 0 ? 0 : 1u << between(random, 9, 18);
    if (!division.serves || !division.quotient(quotient, of.other, of.exponent, more))
        return;
    ++met.cases;
    each_guess(of, division, quotient, [&](std::int32_t x, std::int32_t y, std::int32_t guess) {
        if (of.inside(x, y) && !testing::Test::HasFatalFailure())
            met.note(of.quotient(x, y) + more / 65536.0 - quotient.base -
                         std::ldexp(guess, -Products::fraction_bits),
                     std::ldexp(quotient.window, -Products::fraction_bits));
    });
}

template <class Products> Met met_within() {
    Random random(9);
    Met met;
    for (int i = 0; i < 20000 && !testing::Test::HasFatalFailure(); ++i)
        expect_within<Products>(random, met);
    EXPECT_GT(met.cases, 2000);
    EXPECT_GT(met.fragments, 400000);
    return met;
}

TEST(NearDivision, QuotientsOfWordsLieInTheirWindows) {
    const Met met = met_within<NearWords>();
    EXPECT_LT(met.least, 0.2);
    EXPECT_GT(met.most, -0.2);
}

#if defined(__SSE2__) || defined(__ARM_NEON)

TEST(NearDivision, QuotientsLieInTheirWindows) {
    const Met met = met_within<NearHalves>();
    EXPECT_LT(met.least, 0.5); // the bounds are nearly reached
    EXPECT_GT(met.most, -2);
}

/// A quotient that 16 bits cannot hold is refused, whatever its planes are.
TEST(NearDivision, RefusesWhatItCannotHold) {
    Random random(10);
    int refused = 0;
    for (int i = 0; i < 20000; ++i) {
        Case of(random);
        const std::uint64_t any = random();
        (i % 2 == 0 ? of.other : of.span.q).dx = i % 3 == 0 ? any : any >> 20;
        const NearDivision division(of.span, of.patch);
        NearQuotient quotient;
        refused += !division.serves || !division.quotient(quotient, of.other, of.exponent);
    }
    EXPECT_GT(refused, 15000);
}

TEST(NearDivision, LimitsAreThoseOfTheSum) {
    NearQuotient quotient;
    for (const std::int32_t base : {-40000, -300, 0, 17, 32767, 65000, 90000}) {
        quotient.base = base;
        for (std::int32_t v = -32768; v <= 32767; v += 7) {
            const L::U16 limited =
                L::splat(static_cast<std::uint32_t>(base)) +
                L::clamped_signed(L::splat(static_cast<std::uint32_t>(v)), L::splat(quotient.least()),
                                  L::splat(quotient.largest_error(65280)));
            const std::int32_t want = std::min(std::max(base + v, 0), 65280);
            if (base + 32767 >= 0 && base - 32768 <= 65280) {
                ASSERT_EQ(limited[v & 7], want) << base << " + " << v;
            }
        }
    }
}

#endif

} // namespace
} // namespace spangle::raster::test
