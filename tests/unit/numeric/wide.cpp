// Compares numbers of 61 bits with their own exponents with long double, where that has as many bits.
#include "raster/numeric/wide.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace spangle::numeric {
namespace {

class Wides : public testing::Test {
  protected:
    std::mt19937_64 random_{3};
    static constexpr bool compares = std::numeric_limits<long double>::digits >= 64;

    Wide any(int exponents = 40) {
        const auto bits = static_cast<std::int64_t>(random_()) >> (random_() % 60);
        return make_wide(bits, static_cast<std::int32_t>(random_() % (2 * static_cast<unsigned>(exponents))) -
                                   exponents);
    }
    static long double value(Wide v) { return std::ldexp(static_cast<long double>(v.m), v.e); }
    static void expect_sound(Wide v) {
        if (v.m == 0) {
            EXPECT_EQ(v.e, 0);
            return;
        }
        EXPECT_GE(abs_u64(v.m), std::uint64_t{1} << 60);
        EXPECT_LT(abs_u64(v.m), std::uint64_t{1} << 61);
    }
    static void expect_near(Wide v, long double expected, long double of, int bits) {
        expect_sound(v);
        if (compares) {
            EXPECT_LE(std::fabs(value(v) - expected), std::ldexp(std::fabs(of), -bits));
        }
    }
};

TEST_F(Wides, AnyWordIsOne) {
    for (const std::int64_t v : {std::int64_t{1}, std::int64_t{-1}, INT64_MAX, INT64_MIN,
                                 std::int64_t{1} << 60, (std::int64_t{1} << 61) - 1, std::int64_t{1} << 61})
        expect_near(make_wide(v, 5), std::ldexp(static_cast<long double>(v), 5),
                    std::ldexp(static_cast<long double>(v), 5), 59);
    EXPECT_EQ(make_wide(0, 7).m, 0);
    EXPECT_EQ(make_wide(0, 7).e, 0);
}

TEST_F(Wides, SumsProductsQuotients) {
    for (int i = 0; i < 100'000; ++i) {
        const Wide a = any(), b = any();
        expect_near(mul(a, b), value(a) * value(b), value(a) * value(b), 58);
        expect_near(add(a, b), value(a) + value(b), std::fmax(std::fabs(value(a)), std::fabs(value(b))), 58);
        expect_near(sub(a, b), value(a) - value(b), std::fmax(std::fabs(value(a)), std::fabs(value(b))), 58);
        if (b.m != 0)
            expect_near(reciprocal(b), 1 / value(b), 1 / value(b), 56);
        EXPECT_EQ(less(a, b), value(a) < value(b)) << value(a) << ' ' << value(b);
    }
    for (const std::int64_t m :
         {std::int64_t{1} << 60, (std::int64_t{1} << 61) - 1, -(std::int64_t{1} << 60)})
        expect_near(reciprocal(Wide{m, 3}), 1 / value(Wide{m, 3}), 1 / value(Wide{m, 3}), 56);
}

/// Terms of 60 bits that nearly cancel keep all bits of their difference.
TEST_F(Wides, NothingIsLostToCancellation) {
    for (int i = 0; i < 100'000; ++i) {
        const auto word = [&] { return static_cast<std::int32_t>(random_()) >> 2; };
        const std::int32_t a = word(), b = word(), c = a + static_cast<std::int32_t>(random_() % 5) - 2,
                           d = b + static_cast<std::int32_t>(random_() % 5) - 2;
        const Wide minor =
            sub(mul(make_wide(a, 9), make_wide(b, -70)), mul(make_wide(c, 4), make_wide(d, -65)));
        const Wide expected = make_wide(std::int64_t{a} * b - std::int64_t{c} * d, -61);
        EXPECT_EQ(minor.m, expected.m);
        EXPECT_EQ(minor.e, expected.e);
    }
}

TEST_F(Wides, AreOrderedAndTheSameFromBothSides) {
    for (int i = 0; i < 100'000; ++i) {
        const Wide a = any(3), b = random_() % 4 == 0 ? a : any(3);
        EXPECT_EQ(less(a, b), less(negate(b), negate(a)));
        EXPECT_FALSE(less(a, b) && less(b, a));
        const Wide sum = add(a, b), turned = add(negate(a), negate(b)), product = mul(a, negate(b));
        EXPECT_EQ(sum.m, -turned.m);
        EXPECT_EQ(product.m, -mul(a, b).m);
        EXPECT_EQ(add(a, b).m, add(b, a).m);
    }
}

/// A vertex may be far away in some coordinates only: each row keeps what its own terms leave.
TEST_F(Wides, RowsOfFarVertices) {
    const Real one = numeric::one, far = from_double(0x1p100), small = from_double(0.3);
    const BlockMatrix identity = to_block_matrix(numeric::identity());
    const Wide4 v = transform_wide(identity, {far, small, -small, one});
    EXPECT_EQ(value(v[0]), 0x1p100L);
    EXPECT_EQ(static_cast<float>(value(v[1])), 0.3F);
    EXPECT_EQ(value(v[1]), -value(v[2]));
    EXPECT_EQ(value(v[3]), 1);
    const Block4 plane = to_block(numeric::zero, one, numeric::zero, from_double(-0.25));
    EXPECT_NEAR(static_cast<double>(value(dot(plane, v))), 0.3 - 0.25, 1e-7);
    EXPECT_EQ(to_block(v).m[0], 1 << 29);
    EXPECT_EQ(to_block(v).m[3], 0);
}

} // namespace
} // namespace spangle::numeric
