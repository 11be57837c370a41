// Tests the accuracy promise in full: one million triangles without a mismatch.
#include <gtest/gtest.h>

#include "tests/unit/primitive/coverage_fuzz.hpp"

TEST(CoverageSlow, AMillionFuzzedTrianglesMatchTheEdgeEquations) {
    long wrong = 0;
    for (std::uint32_t seed = 100; seed < 110; ++seed)
        wrong += spangle::raster::test::coverage_mismatches(seed, 90000, 40, 24);
    wrong += spangle::raster::test::coverage_mismatches(200, 100000, 96, 70);
    EXPECT_EQ(wrong, 0);
}
