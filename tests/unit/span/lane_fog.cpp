// Fog factors of eight fragments at once are the integers of one fragment.
#include <gtest/gtest.h>

#include "raster/ops/stage_fog.hpp"
#include "tests/support/random.hpp"

namespace spangle::raster::test {
namespace {

using spangle::test::Random;

void expect_factors_from(std::uint32_t first, std::uint32_t step) {
    for (const FogMode mode : {FogMode::linear, FogMode::exp, FogMode::exp2}) {
        const LaneWords found = lane_fog_factor(mode, LaneWords::ramp(first, step));
        for (int i = 0; i < 8; ++i) {
            const std::uint32_t coordinate = first + static_cast<std::uint32_t>(i) * step;
            ASSERT_EQ(found.lane(i), fog_factor(mode, coordinate))
                << static_cast<int>(mode) << ' ' << coordinate;
        }
    }
}

TEST(LaneFog, FactorsAreThoseOfOneFragment) {
    for (std::uint32_t first = 0; first < 1u << 25; first += 8 * 17)
        expect_factors_from(first, 17);
    Random random{97};
    for (int round = 0; round < 200000; ++round) {
        const std::uint32_t word = random.below(0x10000) << 16 | random.below(0x10000);
        expect_factors_from(random.below(2) == 0 ? word >> random.below(32) : 0 - (word >> random.below(32)),
                            random.below(1 << 20));
    }
    for (std::uint32_t bit = 0; bit < 32; ++bit)
        expect_factors_from((1u << bit) - 4, 1);
}

} // namespace
} // namespace spangle::raster::test
