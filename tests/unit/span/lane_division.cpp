// Dividing eight fragments at once gives the same integers as dividing them one by one.
#include <gtest/gtest.h>

#include "raster/ops/lane_division.hpp"
#include "raster/ops/stage_color.hpp"
#include "tests/support/random.hpp"

namespace spangle::raster::test {
namespace {

using L = Lanes<8>;
using spangle::test::Random;

std::uint32_t word(Random& random) {
    return random.below(0x10000) << 16 | random.below(0x10000);
}
/// Returns a random number of any size: each shift of a word is as likely as any other.
std::uint32_t of_any_size(Random& random) {
    return word(random) >> random.below(32);
}

struct Eight {
    std::uint32_t v[8];
    template <class F> explicit Eight(F f) {
        for (std::uint32_t& one : v)
            one = f();
    }
    L::U32 words() const { return L::gather(v); }
    std::int32_t at(int i) const { return static_cast<std::int32_t>(v[i]); }
};

TEST(LaneDivision, InverseIsThatOfOneFragment) {
    Random random{91};
    for (int round = 0; round < 60000; ++round) {
        const Eight q([&] {
            const std::uint32_t near = (1u << random.below(32)) + random.below(3) - 1;
            return random.below(3) == 0 ? near : random.below(8) == 0 ? word(random) : of_any_size(random);
        });
        const InverseLanes found(q.words());
        for (int i = 0; i < 8; ++i) {
            const Inverse expected(q.at(i));
            ASSERT_EQ(found.q.lane(i), expected.q) << q.at(i);
            ASSERT_EQ(found.zeros.lane(i), static_cast<std::uint32_t>(expected.zeros)) << q.at(i);
            ASSERT_EQ(found.power().lane(i), 1u << expected.zeros) << q.at(i);
            ASSERT_EQ(found.mantissa.lane(i), expected.mantissa) << q.at(i);
        }
    }
}

TEST(LaneDivision, QuotientsAreThoseOfOneFragment) {
    Random random{92};
    for (int round = 0; round < 60000; ++round) {
        const Eight q([&] { return random.below(16) == 0 ? word(random) : of_any_size(random) | 1; }),
            v([&] { return random.below(2) == 0 ? of_any_size(random) : 0 - of_any_size(random); });
        const int exponent = static_cast<int>(random.below(80)) - 40;
        const bool wraps = random.below(2) == 0;
        const auto base = static_cast<std::int32_t>(random.below(33)) - 16;
        const InverseLanes inverse(q.words());
        const L::U32 coord = inverse.coord(v.words(), exponent, wraps, base),
                     fog = inverse.fog(v.words(), exponent);
        for (int i = 0; i < 8; ++i) {
            const Inverse of(q.at(i));
            ASSERT_EQ(coord.lane(i), inner::to_coord(inner::to_repeats(v.at(i), of, exponent), wraps, base))
                << v.at(i) << " / " << q.at(i) << ' ' << exponent << wraps << base;
            if (exponent <= 38 - 31) {
                ASSERT_EQ(fog.lane(i), inner::projective_fog(v.at(i), exponent, of))
                    << v.at(i) << " / " << q.at(i) << ' ' << exponent;
            }
        }
    }
}

TEST(LaneDivision, PlanesInRowsAreThoseOfOneFragment) {
    Random random{93};
    const auto longs = [&] { return std::uint64_t{word(random)} << 32 | word(random); };
    for (int round = 0; round < 60000; ++round) {
        const Interpolant<std::uint64_t> plane = {longs(), longs(), longs()};
        const auto place = [&] { return random.below(8192) - 4096; };
        const Eight x(place), y(place);
        const L::U32 found = PlaneInRows(plane).at(x.words(), y.words());
        for (int i = 0; i < 8; ++i)
            ASSERT_EQ(static_cast<std::int32_t>(found.lane(i)), unguarded(plane.at(x.at(i), y.at(i))))
                << x.at(i) << ' ' << y.at(i);
    }
}

} // namespace
} // namespace spangle::raster::test
