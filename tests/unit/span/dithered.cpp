// Tests dithered smooth colours: set-up counts them in steps of the format, and one sum with the threshold
// stores them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "raster/ops/stage_dithered.hpp"
#include "raster/primitive/setup_math.hpp"

namespace spangle::raster::test {
namespace {

constexpr int components[] = {0, 1, 2};

std::uint32_t levels(int component) {
    return component == 1 ? 63 : 31;
}
/// Number of fraction bits in a step of the component.
int step_bits(int component) {
    return color_fraction_bits + (component == 1 ? 2 : 3);
}

/// Colours in steps lose their last bit, and the factor adds at most a sixteenth of that bit.
TEST(Dithered, ColorsInStepsAreTheirFloor) {
    std::mt19937 random(4);
    for (const int component : components)
        for (int i = 0; i < 1000000; ++i) {
            const std::uint32_t c = i == 0 ? color_one : random() % (color_one + 1);
            const double exact = static_cast<double>(c) / color_one * levels(component);
            const double steps = std::ldexp(color_in_steps(c, component), -step_bits(component));
            ASSERT_LE(steps - exact, std::ldexp(0.0625, -step_bits(component))) << c;
            ASSERT_LE(exact - steps, std::ldexp(1, -step_bits(component))) << c;
        }
}

TEST(Dithered, StepsFromHalvesAreTheSame) {
    std::mt19937 random(7);
    for (const int component : components)
        for (int i = 0; i < 1000000; ++i) {
            const std::uint32_t c =
                i < 100 ? color_one - static_cast<std::uint32_t>(i) : random() >> (1 + random() % 31);
            ASSERT_EQ(color_in_steps<false>(c, component), color_in_steps<true>(c, component)) << c;
        }
}

/// Tests the steps that the balanced and fast tiers count in, and the guessed steps of processors without
/// long products.
TEST(Dithered, NearAndGuessedSteps) {
    std::mt19937 random(8);
    for (const int component : components) {
        const double most = std::ldexp(1.0 / 290, step_bits(component));
        for (int i = 0; i < 1000000; ++i) {
            const std::uint32_t c =
                i < 100 ? color_one - static_cast<std::uint32_t>(i) : random() >> (4 + random() % 28);
            const std::uint32_t near = color_in_near_steps<false>(c, component);
            ASSERT_EQ(near, color_in_near_steps<true>(c, component)) << c;
            const auto more = [&](std::uint32_t steps) {
                return static_cast<double>(steps) - static_cast<double>(color_in_steps(c, component));
            };
            ASSERT_GE(more(near), -1) << c;
            ASSERT_LE(more(near), most) << c;
            ASSERT_GE(more(color_in_guessed_steps(c, component)), 0) << c;
            ASSERT_LE(more(color_in_guessed_steps(c, component)), 1 << 8) << c;
        }
    }
}

/// In the exact tier a step has 27 bits (red, blue) or 26 bits (green): the whole product, without the bits
/// below.
TEST(Dithered, StepsOfTheExactTier) {
    const auto expect_floor = [](std::uint32_t c) {
        const auto floor32 = [&](std::uint64_t levels, int up) {
            const std::uint64_t factor = ((levels << up) + 254) / 255; // a product of up to 36 bits
            return static_cast<std::uint32_t>(c * factor >> 32);
        };
        ASSERT_EQ(Exact::steps32<5>(c), floor32(31, 39) >> 22) << c;
        ASSERT_EQ(Exact::steps32<6>(c), floor32(63, 38) >> 21) << c;
    };
    std::mt19937 random(9);
    for (int i = 0; i < 1000000; ++i)
        ASSERT_NO_FATAL_FAILURE(expect_floor(random() % (color_one + 1)));
    for (const std::uint32_t levels : {31 * 32, 63 * 32}) // where a 32nd of a step begins
        for (std::uint32_t n = 0; n <= levels; ++n) {
            const auto c = static_cast<std::uint32_t>(std::uint64_t{color_one} * n / levels);
            for (const std::uint32_t near : {c - (n != 0), c, c + 1})
                ASSERT_NO_FATAL_FAILURE(expect_floor(std::min(near, color_one)));
        }
}

TEST(Dithered, DifferencesTakeNoMoreBits) {
    std::mt19937 random(5);
    for (const int component : components)
        for (int i = 0; i < 1000000; ++i) {
            const std::uint32_t a = random() % (color_one + 1), d = random() >> (random() % 32);
            if (d > color_one - a)
                continue;
            ASSERT_LE(color_in_steps(a + d, component) - color_in_steps(a, component), d) << a;
        }
}

/// The stored value is floor(step + t) of 31 or 63 steps, also where set-up goes beyond both ends by its
/// error.
TEST(Dithered, SumsAreStepsAndThresholds) {
    std::mt19937 random(6);
    using One = Raw565<1>;
    for (std::uint32_t t = 1; t < 32; t += 2)
        for (int i = 0; i < 20000; ++i) {
            const std::uint32_t off = random() & 0x3FFF;
            const auto word = [&](int component) {
                const std::uint32_t top = levels(component) << (component == 1 ? 26 : 27);
                return i < 100 ? (i & 1 ? top + off : 0u - off) : random() % top;
            };
            const std::uint32_t r = word(0), g = word(1), b = word(2);
            const auto step = [&](std::uint32_t v, int bits) {
                return static_cast<std::uint32_t>(static_cast<std::int64_t>(
                    std::floor((v > 0xFFFF0000u ? static_cast<double>(v) - 0x1p32 : static_cast<double>(v)) *
                                   std::ldexp(1, -bits) +
                               t / 32.0)));
            };
            const One::Tops sums = One::dithered(One::tops(r, g, b), One::fraction5(t));
            const std::uint32_t steps = step(r, 27) << 11 | step(g, 26) << 5 | step(b, 27);
            ASSERT_EQ(One::word(sums).word, steps) << r << ' ' << g << ' ' << b << ' ' << t;
            ASSERT_EQ(One::joined(sums).word, steps) << r << ' ' << g << ' ' << b << ' ' << t;
        }
}

/// Colours that the format can hold stay unchanged by every threshold.
TEST(Dithered, StepsStay) {
    for (const int component : components)
        for (std::uint32_t k = 0; k <= levels(component); ++k) {
            const auto c = static_cast<std::uint32_t>((std::uint64_t{k} * color_one + levels(component) / 2) /
                                                      levels(component));
            for (const std::uint32_t steps :
                 {color_in_steps(c, component), color_in_near_steps(c, component)}) {
                const std::uint32_t v = steps << (24 - color_fraction_bits);
                for (std::uint32_t t = 1; t < 32; t += 2) {
                    const std::uint32_t word =
                        Raw565<1>::word(Raw565<1>::dithered({v, v, v}, Raw565<1>::fraction5(t))).word;
                    const std::uint32_t of[] = {word >> 11, (word >> 5) & 63, word & 31};
                    ASSERT_EQ(of[component], k) << component << ' ' << t;
                }
            }
        }
}

/// Spans may count fragments from the end of their row; each fragment must still get the threshold of its
/// place.
TEST(Dithered, FractionsByNumber) {
    Span<Fixed> span{};
    Px<Raw565<1>> p;
    for (std::int32_t y = -5; y < 5; ++y)
        for (std::int32_t end = -5; end < 5; ++end) {
            const auto& numbered = inner::dither_numbered<27>;
            ASSERT_EQ(numbered.from<false>(end, y), numbered.from<true>(end, y));
            const NumberedFractions<Raw565<1>> fractions(PlaneRow{span, nullptr, nullptr, end - 8, y, end},
                                                         0);
            for (std::int32_t i = -8; i < 0; ++i) {
                p.twice = 2 * i;
                ASSERT_EQ(fractions.of(p), Raw565<1>::fraction5(dither_threshold(dither_row(y), end + i)))
                    << end << ' ' << y << ' ' << i;
            }
        }
}

TEST(Dithered, EightColumnsFromAnyPlace) {
    for (std::int32_t y = -5; y < 5; ++y)
        for (std::int32_t x = -5; x < 5; ++x) {
            inner::DitherRow<Lanes<1>> one(x, y);
            const inner::DitherRow<Lanes<8>> eight(x, y);
            for (int i = 0; i < 8; ++i, one.step()) {
                ASSERT_EQ(one.threshold(), dither_threshold(dither_row(y), x + i));
                ASSERT_EQ(eight.threshold()[i], one.threshold());
            }
        }
}

} // namespace
} // namespace spangle::raster::test
