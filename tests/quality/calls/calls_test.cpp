#include "tests/quality/calls/calls.hpp"

#include <gtest/gtest.h>

namespace {

using namespace spangle;

TEST(Calls, KeepTheirEffects) {
    volatile std::int32_t two = 2, four = 4;
    EXPECT_EQ(calls::first_wrong(two, four), 0);
}

TEST(Calls, InverseIsReadFromTheMatrixItself) {
    volatile std::int32_t two = 2;
    const numeric::Element v = calls::inverse_of_scaling(two, 1, 1);
    EXPECT_EQ(numeric::to_real(v).bits, 0x3F000000u);
}

} // namespace
