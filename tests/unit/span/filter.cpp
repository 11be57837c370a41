// Tests LINEAR in the balanced tier: its bounds, its identities, and equal bits with one lane and with eight.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "raster/ops/filter.hpp"
#include "raster/ops/filter_words.hpp"
#include "raster/ops/texel.hpp"

namespace spangle::raster::test {
namespace {

using N = Balanced<1>;

/// Returns the largest error, in 255ths, of the mean of four values from 0 to `most`. mean(c00, c10, c01,
/// c11, a, b) returns the mean in 8.8.
template <class Mean> double worst_error(std::uint32_t most, Mean mean) {
    double worst = 0;
    // The error of a mean is largest where all values are extremes.
    for (std::uint32_t corners = 0; corners < 16; ++corners)
        for (std::uint32_t a = 0; a < 256; ++a)
            for (std::uint32_t b = 0; b < 256; ++b) {
                const auto c = [&](unsigned i) { return (corners >> i & 1) * most; };
                const double want =
                    ((c(0) * (256. - a) + c(1) * a) * (256. - b) + (c(2) * (256. - a) + c(3) * a) * b) /
                    65536;
                worst = std::fmax(worst,
                                  std::fabs(mean(c(0), c(1), c(2), c(3), a, b) / 256. - want * 255 / most));
            }
    return worst;
}

TEST(Filter, StepsOfTheExactTierAreNearest) {
    const auto twice_off = [](std::uint32_t value, std::int64_t k, std::int64_t most) {
        return 2 * std::abs(std::int64_t{value} * most - k * color_one);
    };
    for (std::uint32_t k = 0; k < 32; ++k)
        EXPECT_LE(twice_off(Exact::from5(k), k, 31), 31) << k;
    for (std::uint32_t k = 0; k < 64; ++k)
        EXPECT_LE(twice_off(Exact::from6(k), k, 63), 63) << k;
}

TEST(Filter, SeventhsOfTheBalancedTierAreNearest) {
    for (std::uint32_t k = 0; k < 8; ++k)
        EXPECT_EQ(N::texel3(k), static_cast<std::uint32_t>(std::lround(k * 65280.0 / 7)));
}

/// A texel, or a mean of four texels, is never less than what GL asks for, and less than two units above it.
TEST(Filter, TexelsOfTheExactTierAreRoundedUp) {
    for (std::uint32_t k = 0; k < 64; ++k) {
        EXPECT_EQ(Exact::texel5(k & 31),
                  static_cast<std::uint32_t>(std::ceil((k & 31) * 255.0 * 0x1p20 / 31)));
        EXPECT_EQ(Exact::texel6(k), static_cast<std::uint32_t>(std::ceil(k * 255.0 * 0x1p20 / 63)));
    }
    for (std::uint32_t k = 0; k < 8; ++k)
        EXPECT_EQ(Exact::texel3(k), static_cast<std::uint32_t>(std::ceil(k * 255.0 * 0x1p20 / 7)));
    std::mt19937 random(4);
    for (int round = 0; round < 300'000; ++round) {
        const auto k = static_cast<std::uint32_t>(random()), weights = static_cast<std::uint32_t>(random());
        const std::uint32_t a = weights & 255, b = weights >> 8 & 255, w11 = a * b, w10 = a * (256 - b),
                            w01 = (256 - a) * b, w00 = 65536 - w11 - w10 - w01;
        const auto six = [k](int i) { return k >> (8 * i) & 63; };
        const std::int64_t n = std::int64_t{six(0)} * w00 + six(1) * w10 + six(2) * w01 + six(3) * w11;
        const std::uint32_t mean = Exact::weighted(Exact::texel6(six(0)), w00, Exact::texel6(six(1)), w10,
                                                   Exact::texel6(six(2)), w01, Exact::texel6(six(3)), w11);
        const std::int64_t more = std::int64_t{mean} * 63 * 65536 - n * color_one;
        ASSERT_GE(more, 0) << k << ' ' << weights;
        ASSERT_LT(more, 2LL * 63 * 65536) << k << ' ' << weights;
    }
}

TEST(Filter, ErrorOf565) {
    const auto channel = [](int shift, auto member) {
        return [=](auto c00, auto c10, auto c01, auto c11, auto a, auto b) {
            return Filter565<1>(b)(c00 << shift, c10 << shift, c01 << shift, c11 << shift, a).*member;
        };
    };
    EXPECT_LE(worst_error(31, channel(11, &N::Color::r)), .35);
    EXPECT_LE(worst_error(63, channel(5, &N::Color::g)), .65);
    EXPECT_LE(worst_error(31, channel(0, &N::Color::b)), .35);
}

TEST(Filter, ErrorOfEightBits) {
    for (int byte = 0; byte < 4; ++byte)
        EXPECT_LE(worst_error(255,
                              [&](auto c00, auto c10, auto c01, auto c11, auto a, auto b) {
                                  const int up = 8 * byte;
                                  const N::Color c = Filter8<1>(b).texels<true>(c00 << up, c10 << up,
                                                                                c01 << up, c11 << up, a);
                                  return byte == 0 ? c.r : byte == 1 ? c.g : byte == 2 ? c.b : c.a;
                              }),
                  1. / 32)
            << byte;
}

/// The mean of four equal texels is that texel, dithered or not.
TEST(Filter, FourAlikeStay) {
    for (std::uint32_t a = 0; a < 256; a += 5)
        for (std::uint32_t b = 0; b < 256; ++b) {
            for (std::uint32_t k = 0; k < 64; ++k) {
                const std::uint32_t word = (k & 31) << 11 | k << 5 | (k & 31);
                const N::Color c = Filter565<1>(b)(word, word, word, word, a);
                ASSERT_EQ(N::to8(c.r), ((k & 31) * 510 + 31) / 62);
                ASSERT_EQ(N::to8(c.g), (k * 510 + 63) / 126);
                ASSERT_EQ(N::to8(c.b), ((k & 31) * 510 + 31) / 62);
                ASSERT_EQ(N::to8(c.r) >> 3, k & 31);
                ASSERT_EQ(N::to8(c.g) >> 2, k);
                ASSERT_EQ(N::to8(c.b) >> 3, k & 31);
                for (std::uint32_t t = 1; t < 32; t += 2) {
                    ASSERT_EQ(N::dithered<5>(c.r, t), k & 31);
                    ASSERT_EQ(N::dithered<6>(c.g, t), k);
                    ASSERT_EQ(N::dithered<5>(c.b, t), k & 31);
                }
            }
            for (std::uint32_t k = 0; k < 256; ++k)
                ASSERT_EQ(Filter8<1>(b).component(k, k, k, k, a), k << 8);
        }
}

/// Rounding must not push means of 15 bits past 0 or 255.
TEST(Filter, EightBitsStayInRange) {
    for (std::uint32_t near = 0; near < 256; ++near)
        for (std::uint32_t a = 0; a < 256; ++a)
            for (const std::uint32_t b : {1u, 2u, 127u, 254u, 255u}) {
                ASSERT_LE(Filter8<1>(b).component(near, 0, 0, 0, a), N::one);
                ASSERT_LE(Filter8<1>(b).component(255, 255, near, 255, a), N::one);
                ASSERT_LE(Filter8<1>(b).component(near, 255, 255, 255, a), N::one);
            }
}

TEST(Filter, EightLanesHaveTheSameBits) {
    using L = Lanes<8>;
    std::mt19937 random(5);
    for (int round = 0; round < 4000; ++round) {
        std::uint32_t word[4][8];
        std::uint16_t half[4][8], a[8], b[8];
        for (int i = 0; i < 8; ++i) {
            for (int k = 0; k < 4; ++k)
                half[k][i] = static_cast<std::uint16_t>(word[k][i] = random());
            a[i] = static_cast<std::uint16_t>(random() & 255);
            b[i] = static_cast<std::uint16_t>(random() & 255);
        }
        const Balanced<8>::Color five = Filter565<8>(L::gather(b))(L::gather(half[0]), L::gather(half[1]),
                                                                   L::gather(half[2]), L::gather(half[3]),
                                                                   L::gather(a)),
                                 eight =
                                     Filter8<8>(L::gather(b))
                                         .texels<true>(L::gather(word[0]), L::gather(word[1]),
                                                       L::gather(word[2]), L::gather(word[3]), L::gather(a));
        for (int i = 0; i < 8; ++i) {
            const N::Color f = Filter565<1>(b[i])(half[0][i], half[1][i], half[2][i], half[3][i], a[i]),
                           e = Filter8<1>(b[i]).texels<true>(word[0][i], word[1][i], word[2][i], word[3][i],
                                                             a[i]);
            ASSERT_EQ(f.r, five.r[i]);
            ASSERT_EQ(f.g, five.g[i]);
            ASSERT_EQ(f.b, five.b[i]);
            ASSERT_EQ(e.r, eight.r[i]);
            ASSERT_EQ(e.g, eight.g[i]);
            ASSERT_EQ(e.b, eight.b[i]);
            ASSERT_EQ(e.a, eight.a[i]);
        }
    }
}

/// Step j is stored from the smallest n on whose exact sum GL rounds to j. Sums of the chain may be up to two
/// units larger, so the few n where this matters are open.
template <int Bits> void check_stored_steps() {
    const inner::StoredSteps<Bits>& steps = inner::stored_steps<Bits>;
    constexpr std::int64_t most = (1 << Bits) - 1, two_units = 2 << 16;
    const auto stored = [](std::int64_t sum) { return (sum + (std::int64_t{1} << 35)) >> (44 - Bits); };
    int open = 0;
    for (std::int64_t n = 0; n <= most << 16; ++n) {
        const std::int64_t sum = n * color_one / most;
        const std::uint32_t word = static_cast<std::uint32_t>(n), step = steps.at(word);
        const auto exact = static_cast<std::uint32_t>((n * color_one + (most << 35)) / (most << (44 - Bits)));
        ASSERT_EQ(step, exact) << n;
        if (steps.open(word, step))
            ++open;
        else
            ASSERT_EQ(step, stored(sum + two_units)) << n;
    }
    EXPECT_EQ(open, Bits == 5 ? 0 : 63);
}
TEST(Filter, StoredStepsAreThoseOfEverySum) {
    check_stored_steps<5>();
    check_stored_steps<6>();
}

/// A guess gives the right step or leaves the sum open. Few sums are open, and sums that only the chain can
/// decide are among them.
template <int Bits> void check_guessed_steps() {
    using Guess = inner::GuessedSteps<Bits>;
    constexpr std::uint32_t most = (1u << Bits) - 1;
    std::uint32_t open = 0;
    for (std::uint32_t n = 0; n <= most << 16; n += 8) {
        Lanes<8>::U16 tops = Lanes<8>::splat(0);
        for (std::uint32_t i = 0; i < 8; ++i)
            tops[static_cast<int>(i)] = static_cast<std::uint16_t>((n + i) >> (Bits + 2));
        const Lanes<8>::U16 least = Guess::least(tops), over = least + Guess::range;
        for (std::uint32_t i = 0; i < 8; ++i) {
            const int lane = static_cast<int>(i), low = least[lane] >> (15 - Bits),
                      high = over[lane] >> (15 - Bits);
            open += low != high;
            if (n + i > most << 16)
                continue;
            const std::uint32_t step = inner::stored_steps<Bits>.at(n + i);
            if (inner::stored_steps<Bits>.open(n + i, step)) {
                ASSERT_NE(low, high) << n + i;
            } else if (low == high) {
                ASSERT_EQ(low, step) << n + i;
            }
        }
    }
    EXPECT_LT(open, most << (Bits == 5 ? 9 : 10)) << "more than it should leave open";
}
TEST(Filter, GuessedStepsAreThoseOfEverySumOrOpen) {
    check_guessed_steps<5>();
    check_guessed_steps<6>();
}

TEST(Filter, WordsInLanesAreThoseOfOne) {
    using L = Lanes<8>;
    std::mt19937 random(3);
    const auto check = [&](const L::U16(&c)[4], const L::U16& a, const L::U16& b) {
        L::U16 t;
        for (int i = 0; i < 8; ++i)
            t[i] = static_cast<std::uint16_t>(2 * (random() & 15) + 1);
        const L::U16 plain = FilterWords<8>(b)(c[0], c[1], c[2], c[3], a),
                     dithered = FilterWords<8>(b)(c[0], c[1], c[2], c[3], a, t);
        for (int i = 0; i < 8; ++i) {
            const FilterWords<1> one(b[i]);
            ASSERT_EQ(plain[i], one(c[0][i], c[1][i], c[2][i], c[3][i], a[i]));
            ASSERT_EQ(dithered[i], one(c[0][i], c[1][i], c[2][i], c[3][i], a[i], t[i]));
        }
    };
    for (int round = 0; round < 200'000; ++round) {
        L::U16 c[4], a, b;
        for (int i = 0; i < 8; ++i) {
            const auto weights = static_cast<std::uint32_t>(random());
            for (auto& texels : c)
                texels[i] = static_cast<std::uint16_t>(random());
            // few different weights, so that ties and whole steps occur
            a[i] = static_cast<std::uint16_t>((round & 1) != 0 ? weights & 0xC0 : weights & 255);
            b[i] = static_cast<std::uint16_t>((round & 1) != 0 ? weights >> 8 & 0xC0 : weights >> 8 & 255);
            if ((round & 2) != 0) {
                c[3][i] = static_cast<std::uint16_t>(~c[0][i]);
                c[2][i] = static_cast<std::uint16_t>(~c[1][i]);
            }
        }
        check(c, a, b);
    }
}

TEST(Filter, WordsAreThoseOfTheExactTier) {
    std::mt19937 random(2);
    const auto check = [&](std::uint32_t c00, std::uint32_t c10, std::uint32_t c01, std::uint32_t c11,
                           std::uint32_t a, std::uint32_t b) {
        ASSERT_EQ(FilterWords<1>(b)(c00, c10, c01, c11, a),
                  FilterWords<1>::add_texels(c00, c10, c01, c11, a, b))
            << c00 << ' ' << c10 << ' ' << c01 << ' ' << c11 << ' ' << a << ' ' << b;
        const auto t = static_cast<std::uint32_t>(2 * (random() & 15) + 1);
        const auto texel = [](std::uint32_t word) {
            const auto half = static_cast<std::uint16_t>(word);
            std::uint8_t bytes[2];
            std::memcpy(bytes, &half, 2);
            return read_texel<Exact, TexelFormat::rgb565>(bytes);
        };
        const Exact::Color mixed = bilinear<Exact>(texel(c00), texel(c10), texel(c01), texel(c11), a, b);
        ASSERT_EQ(FilterWords<1>(b)(c00, c10, c01, c11, a, t), Exact::dithered<5>(mixed.r, t) << 11 |
                                                                   Exact::dithered<6>(mixed.g, t) << 5 |
                                                                   Exact::dithered<5>(mixed.b, t))
            << c00 << ' ' << c10 << ' ' << c01 << ' ' << c11 << ' ' << a << ' ' << b << ' ' << t;
    };
    for (int round = 0; round < 1'000'000; ++round) {
        const auto near = static_cast<std::uint32_t>(random()), far = static_cast<std::uint32_t>(random()),
                   weights = static_cast<std::uint32_t>(random());
        check(near & 0xFFFF, near >> 16, far & 0xFFFF, far >> 16, weights & 255, weights >> 8 & 255);
    }
    for (std::uint32_t k = 0; k < 65536; ++k) // tries all ties
        for (const std::uint32_t c : {k, ~k & 0xFFFF}) {
            check(k, 0xFFFF - c, k, 0xFFFF - c, 128, k & 255);
            check(c, c, 0xFFFF - k, 0xFFFF - k, k & 255, 128);
        }
}

} // namespace
} // namespace spangle::raster::test
