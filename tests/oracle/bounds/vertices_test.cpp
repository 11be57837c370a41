// Measures sums of products, 1/a, 1/sqrt(a), and unit vectors.
#include <algorithm>

#include "raster/numeric/block_matrix.hpp"
#include "raster/numeric/matrix.hpp"
#include "tests/oracle/bounds/bounds.hpp"
#include "tests/unit/numeric/kernels.hpp"

namespace spangle::test {
namespace {

using namespace numeric;

/// Returns a float of either sign between 2^-power and 2^power.
Real real(Random& random, std::uint32_t power) {
    return {(word(random) & 0x807FFFFF) | (127 - power + random.below(2 * power)) << 23};
}

Matrix matrix(Random& random, std::uint32_t power) {
    Real v[16];
    for (Real& element : v)
        element = real(random, power);
    return matrix_from_reals(v);
}

TEST(Bounds, SumOfARow) {
    Random random{1};
    double most = 0;
    for (int n = 0; n < 20'000; ++n) {
        const BlockMatrix m = to_block_matrix(matrix(random, 1 + random.below(40)));
        Real v[4];
        for (Real& component : v)
            component = real(random, 1 + random.below(40));
        const auto loaded = load(m.column, v);
        for (int i = 0; i < 4; ++i)
            most = std::fmax(most, std::fabs(static_cast<double>(row_sum<4>(m.m + 4 * i, loaded.m, 0))));
    }
    EXPECT_LE(most, 0x1p61);
    row({"row of a matrix times a vertex", "int64 of int32 x int32",
         "magnitudes of a row below 2^31, of a vertex below 2^30",
         "sum below 2^61; below 2^63 where each of four is 2^31", "accumulators"},
        "2^%.2f", std::log2(most));
}

long double value(Element e) {
    return std::ldexp(static_cast<long double>(e.m), e.e + element_bias);
}

TEST(Bounds, ProductOfMatrices) {
    Random random{2};
    double worst = 0;
    for (int n = 0; n < 5'000; ++n) {
        const std::uint32_t power = 1 + random.below(30);
        const Matrix a = matrix(random, power), b = matrix(random, power), c = multiply(a, b);
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j) {
                long double exact = 0, largest = 0;
                for (int k = 0; k < 4; ++k) {
                    const long double term = value(a.at(i, k)) * value(b.at(k, j));
                    exact += term;
                    largest = std::max(largest, std::fabs(term));
                }
                const long double bound = std::fabs(exact) * 0x1p-31L + largest * 0x1p-58L;
                worst = std::max(worst, static_cast<double>(std::fabs(value(c.at(i, j)) - exact) / bound));
            }
    }
    EXPECT_LE(worst, 1);
    row({"product of matrices", "31-bit mantissas, each with its exponent; sums in int64", "2^-149 to 2^135",
         "2^-31 of the element and 2^-58 of its largest term; sum below 2^63", "matrix_sum"},
        "%.3f of the bound", worst);
}

TEST(Bounds, Reciprocals) {
    const KernelError e = sweep(
        std::uint64_t{1} << 31, 1'511, [](std::uint32_t a) { return reciprocal_1(a); },
        [](std::uint32_t a) { return reciprocal(a); }, [](double a) { return 0x1p62 / a; });
    EXPECT_GE(e.low_1, -bound(reciprocal_1_accuracy));
    EXPECT_LE(e.ulps, reciprocal_ulp_percent / 100.0);
    row({"1/a, one Newton step", "Q2.30 from 9 bits", "[1/2, 1)", "-2^-17.9 to 2^-29 of the value",
         "reciprocal_first"},
        "-2^%.2f", std::log2(-e.low_1));
    row({"1/a, two steps", "Q2.30", "[1/2, 1)", "0.54 2^-30", "reciprocal_second"}, "%.4f 2^-30", e.ulps);
}

TEST(Bounds, Roots) {
    const KernelError e = sweep(
        std::uint64_t{1} << 30, 1'511, [](std::uint32_t a) { return rsqrt_1(a); },
        [](std::uint32_t a) { return rsqrt(a); }, [](double a) { return 0x1p46 / std::sqrt(a); });
    EXPECT_GE(e.low_1, -bound(rsqrt_1_accuracy));
    EXPECT_LE(e.relative, bound(rsqrt_accuracy));
    row({"1/sqrt(a), one Newton step", "Q2.30 from 9 bits", "[1/4, 1)", "-2^-17.3 to 2^-29 of the value",
         "rsqrt_first"},
        "-2^%.2f", std::log2(-e.low_1));
    row({"1/sqrt(a), two steps", "Q2.30", "[1/4, 1)", "2^-29.9 of the value", "rsqrt_second"}, "2^%.2f",
        std::log2(e.relative));
}

TEST(Bounds, UnitVectors) {
    Random random{3};
    double worst = 0, dots = 0;
    Unit3 before;
    for (int n = 0; n < 200'000; ++n) {
        // Each random number has a statement of its own, because compilers may choose the order of a call's
        // arguments.
        const Real first = word(random) % 8 == 0 ? Real{0} : real(random, 9);
        const Real second = real(random, 9);
        const Block3 v = to_block(first, second, real(random, 9));
        const Unit3 unit = normalize(v);
        const double x = v.m[0], y = v.m[1], z = v.m[2], length = std::sqrt(x * x + y * y + z * z);
        for (int i = 0; i < 3; ++i)
            worst = std::fmax(worst, std::fabs(unit.m[i] * 0x1p-30 - v.m[i] / length));
        double exact = 0;
        for (int i = 0; i < 3; ++i)
            exact += unit.m[i] * 0x1p-30 * (before.m[i] * 0x1p-30);
        dots = std::fmax(dots, std::fabs(dot(unit, before) * 0x1p-30 - exact));
        before = unit;
    }
    EXPECT_LE(worst, 0x1p-28);
    EXPECT_LE(dots, 0x1p-28);
    row({"unit vector of v", "Q2.30", "any v but 0", "2^-28 each component", "normalize"}, "2^%.2f",
        std::log2(worst));
    row({"dot product of unit vectors", "int64 of Q2.30", "[-1, 1]", "2^-28; sum below 2^62", "dot_units"},
        "2^%.2f", std::log2(dots));
}

} // namespace
} // namespace spangle::test
