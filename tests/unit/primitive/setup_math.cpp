// Set-up has forms for processors with words of 32 bits, without long shifts. They must give the same words.
#include "raster/primitive/setup_math.hpp"

#include <random>

#include <gtest/gtest.h>

namespace spangle::raster {
namespace {

TEST(SetupMath, BitsBoundDifferences) {
    std::mt19937 random(1);
    for (int i = 0; i < 200'000; ++i) {
        const auto any = [&] { return static_cast<std::int32_t>(random()) >> (random() % 32); };
        const std::int32_t a = any(), b = any();
        const std::uint32_t bits = difference_bits(a, b);
        ASSERT_EQ(bits == 0, a == 0 && b == 0);
        for (const std::int32_t d : {a, b}) {
            ASSERT_LE(numeric::abs_u32(d), bits);
            for (int n = 0; n <= numeric::clz32(bits) && n < 32; ++n) {
                ASSERT_TRUE(fits_lifted(bits, static_cast<std::uint32_t>(n)));
                ASSERT_EQ(std::int64_t{shift_by_lift(d, static_cast<std::uint32_t>(n))},
                          std::int64_t{d} << n);
            }
        }
        if (const int room = numeric::clz32(bits); bits != 0) {
            ASSERT_FALSE(fits_lifted(bits, static_cast<std::uint32_t>(room + 1)));
        }
    }
    EXPECT_FALSE(fits_lifted(1, 0u - 1)) << "coefficients that must be shifted up";
    EXPECT_FALSE(fits_lifted(0, 32)) << "no shift of a word is that long";
}

TEST(SetupMath, LiftedDifferencesGiveTheWordsOfTheShiftedSum) {
    std::mt19937 random(2);
    constexpr std::int32_t most = 1 << 30;
    for (int i = 0; i < 200'000; ++i) {
        const auto coefficient = [&] { return static_cast<std::int32_t>(random()) >> 1; };
        const std::int32_t c[2] = {i % 7 == 0 ? most : coefficient(), i % 11 == 0 ? -most : coefficient()};
        const auto difference = [&] { return static_cast<std::int32_t>(random()) >> (random() % 31); };
        const std::int32_t d1 = difference(), d2 = difference();
        const auto room = static_cast<std::uint32_t>(numeric::clz32(difference_bits(d1, d2) | 1));
        for (std::uint32_t lift = 0; lift <= room; ++lift) {
            const std::int64_t sum = std::int64_t{d1} * c[0] + std::int64_t{d2} * c[1];
            ASSERT_EQ(lifted_word(shift_by_lift(d1, lift), shift_by_lift(d2, lift), c),
                      static_cast<std::uint32_t>(sum >> (32 - lift)));
        }
    }
}

TEST(SetupMath, HalvesFitTheirWordOrSaySo) {
    std::mt19937_64 random(5);
    int fits = 0;
    for (int round = 0; round < 1000000; ++round) {
        const int down = static_cast<int>(random() % 36) - 2;
        // Half of the products lie around the limit.
        const std::int64_t limit =
            round % 2 == 0 && down > 0 && down < 32 ? std::int64_t{1} << (30 + down) : 0;
        const std::int64_t any = static_cast<std::int64_t>(random()) >> (2 + random() % 60);
        const std::int64_t product = (round % 4 == 0 ? -limit : limit) + (limit != 0 ? any % (1 << 20) : any);
        std::int32_t out = 0;
        if (!half_below(product, down, out)) {
            // Refused are shifts at the ends of a word, and products that may be too large.
            const std::uint64_t enough =
                down < 2 || down > 30 ? 0 : (std::uint64_t{1} << (30 + down)) - (std::uint64_t{2} << down);
            ASSERT_TRUE(numeric::abs_u64(product) >= enough || (product < 0 && -product <= (1 << down) + 1))
                << product << " " << down;
            continue;
        }
        ++fits;
        const std::int64_t wanted = (product / 2 + (std::int64_t{1} << (down - 1))) >> down;
        ASSERT_EQ(out, wanted) << product << " " << down;
        ASSERT_LE(numeric::abs_u64(wanted), 1u << 29);
    }
    EXPECT_GT(fits, 300000);
}

} // namespace
} // namespace spangle::raster
