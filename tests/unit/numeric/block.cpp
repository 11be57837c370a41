// Compares the block form, matrices and transforms with double and long double.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <random>

#include "raster/numeric/matrix_build.hpp"
#include "tests/unit/numeric/random.hpp"

namespace {

using namespace spangle::numeric;

long double value(Block v) {
    return std::ldexp(static_cast<long double>(v.m), v.e);
}
long double value(Element v) {
    return std::ldexp(static_cast<long double>(v.m), v.e + element_bias);
}

bool is_normalised(Block v) {
    return v.m == 0 ? v.e == 0 : (abs_u32(v.m) >> 29) == 1;
}

template <class B, int N> bool is_normalised(const B& v) {
    std::uint32_t any = 0;
    for (int i = 0; i < N; ++i) {
        if (abs_u32(v.m[i]) >> 30 != 0)
            return false;
        any |= abs_u32(v.m[i]);
    }
    return any == 0 ? v.e == 0 : any >> 29 != 0;
}

/// Returns a float of random sign with an exponent within +-`span` of 1; sometimes 0.
Real random_real(Random& random, int span) {
    if ((random.next() & 31) == 0)
        return zero;
    const auto mantissa = static_cast<float>(random.range(-(1 << 24), 1 << 24));
    return from_float(std::ldexp(mantissa, random.range(-span, span) - 24));
}

TEST(Block, HoldsEveryFloatExactly) {
    Random random(21);
    for (int i = 0; i < 1'000'000; ++i) {
        const Real v = from_float_bits(random.word());
        const Block b = to_block(v);
        ASSERT_TRUE(is_normalised(b));
        ASSERT_EQ(value(b), static_cast<long double>(to_float(v)));
        ASSERT_EQ(to_real(b), v);
        const Element e = to_element(v);
        ASSERT_EQ(value(e), static_cast<long double>(to_float(v)));
        ASSERT_EQ(to_real(e), v);
    }
    for (std::uint32_t b : {0u, 1u, 0x80000001u, 0x7FFFFFu, 0x800000u, 0x7F7FFFFFu, 0xFF7FFFFFu})
        EXPECT_EQ(to_real(to_element(Real{b})).bits, b) << std::hex << b;
}

/// Shifts round to nearest, halves up, and saturate at the ends, also if one word is left.
TEST(Block, ShiftsRoundToNearest) {
    std::mt19937_64 random(11);
    for (int i = 0; i < 1000000; ++i) {
        const int n = 1 + static_cast<int>(random() % 40);
        // Bits of the value, of which at most 31 and a sign are left.
        const int bits = n + 30 < 62 ? n + 30 : 62;
        const std::int64_t v = static_cast<std::int64_t>(random()) >> (63 - bits),
                           half = std::int64_t{1} << (n - 1);
        const std::int64_t nearest = (v + half) >> n;
        if (nearest > INT32_MAX || nearest < INT32_MIN)
            continue;
        ASSERT_EQ(detail::shift_to_block(v, n), std::clamp<std::int64_t>(nearest, -block_max, block_max))
            << v << ' ' << n;
    }
}

TEST(Block, VectorsKeepTheirLargestComponentWhole) {
    Random random(22);
    for (int i = 0; i < 500'000; ++i) {
        const int span = 1 + static_cast<int>(random.next() % 120);
        const Real r[4] = {random_real(random, span), random_real(random, span), random_real(random, span),
                           random_real(random, span)};
        const Block4 v = to_block(r[0], r[1], r[2], r[3]);
        ASSERT_TRUE((is_normalised<Block4, 4>(v)));
        const Block3 v3 = to_block(r[0], r[1], r[2]);
        ASSERT_TRUE((is_normalised<Block3, 3>(v3)));
        // Floats have 24 of 30 bits, so only values far below the largest are rounded.
        for (int c = 0; c < 4; ++c) {
            const long double error = value(Block{v.m[c], v.e}) - to_float(r[c]);
            ASSERT_LE(std::fabs(error), std::ldexp(0.5L, v.e));
            if (v.m[c] >> 23 != 0 && v.m[c] >> 23 != -1) {
                ASSERT_EQ(error, 0);
            }
        }
    }
}

TEST(Block, ScalarArithmeticIsWithinAnUlp) {
    Random random(23);
    for (int i = 0; i < 1'000'000; ++i) {
        const auto any = [&random] {
            const std::int64_t m = static_cast<std::int64_t>(random.next()) >> (random.next() & 63);
            return make_block(m, random.range(-40, 40));
        };
        const Block a = any(), b = any();
        const long double x = value(a), y = value(b);
        const auto near = [](Block got, long double want, double relative) {
            ASSERT_TRUE(is_normalised(got));
            ASSERT_LE(std::fabs(value(got) - want), std::fabs(want) * relative) << want;
        };
        near(mul(a, b), x * y, std::exp2(-29));
        near(add(a, b), x + y, std::exp2(-29));
        near(sub(a, b), x - y, std::exp2(-29));
        ASSERT_EQ(compare(a, b), x < y ? -1 : x > y ? 1 : 0);
        if (b.m != 0) {
            near(div(a, b), x / y, std::exp2(-29));
            near(reciprocal(b), 1 / y, std::exp2(-29));
        }
        const Block m = {static_cast<std::int32_t>(abs_u32(a.m)), a.e};
        if (m.m != 0)
            near(rsqrt(m), 1 / std::sqrt(value(m)), std::exp2(-28.5));
        near(sqrt(m), std::sqrt(value(m)), std::exp2(-28));
        const int bits = random.range(0, 40);
        const long double fixed = std::floor(std::ldexp(x, bits) + 0.5L);
        ASSERT_EQ(to_fixed(a, bits), fixed > INT32_MAX ? INT32_MAX : fixed < INT32_MIN ? INT32_MIN : fixed);
    }
    EXPECT_EQ(value(div(to_block(from_i32(6)), to_block(from_i32(3)))), 2);
    EXPECT_EQ(reciprocal(Block{}).m, block_max) << "division by 0 does no harm";
    EXPECT_EQ(div(negate(to_block(one)), Block{}).m, -block_max);
    EXPECT_EQ(div(Block{}, Block{}).m, 0);
    EXPECT_EQ(sqrt(negate(to_block(one))).m, 0);
    EXPECT_EQ(compare(Block{1 << 29, 16384}, Block{1 << 29, 16383}), 1) << "the ends of the exponent range";
    EXPECT_EQ(mul(Block{1 << 29, 16384}, Block{1 << 29, 16384}).e, 16384);
}

TEST(Block, UnitVectorsAndDotProducts) {
    Random random(24);
    double exact = 0, product = 0;
    for (int i = 0; i < 500'000; ++i) {
        const int span = 1 + static_cast<int>(random.next() % 20);
        const Real r[3] = {random_real(random, span), random_real(random, span), random_real(random, span)};
        const long double x = to_float(r[0]), y = to_float(r[1]), z = to_float(r[2]),
                          l = std::sqrt(x * x + y * y + z * z);
        if (l == 0)
            continue;
        const Block3 v = to_block(r[0], r[1], r[2]);
        const Unit3 n = normalize(v);
        const long double want[3] = {x / l, y / l, z / l};
        for (int c = 0; c < 3; ++c)
            exact = std::max(exact, static_cast<double>(std::fabs(std::ldexp(n.m[c], -30) - want[c])));
        ASSERT_LE(dot(n, n), unit_one);
        const Block3 w = to_block(r[2], r[0], -r[1]);
        product = std::max(
            product, static_cast<double>(std::fabs(value(dot(v, w)) - (x * z + y * x - z * y)) / (l * l)));
        const Block3 c = cross(v, w);
        product = std::max(
            product, static_cast<double>(std::fabs(value(component(c, 2)) - (x * x - y * z)) / (l * l)));
        product = std::max(product, static_cast<double>(std::fabs(value(length(v)) - l) / l));
    }
    std::printf("unit vectors 2^%.2f; dot, cross, length 2^%.2f\n", std::log2(exact), std::log2(product));
    EXPECT_LE(exact, std::exp2(-28));
    EXPECT_LE(product, std::exp2(-28));
    const Unit3 none = normalize(Block3{});
    EXPECT_EQ(none.m[0] | none.m[1] | none.m[2], 0);
    for (int c = 0; c < 3; ++c) { // axes of any length are exact
        const Real r[3] = {c == 0 ? from_float(-3e7f) : zero, c == 1 ? from_float(1e-40f) : zero,
                           c == 2 ? one : zero};
        EXPECT_EQ(abs_u32(normalize(to_block(r[0], r[1], r[2])).m[c]), 1u << 30);
    }
}

struct Double4x4 {
    long double at[4][4] = {};
};

// The matrix is passed by value. gcc 12.2 from -O1 on believes that a reference is not read, and drops the
// stores to a temporary (`values(Matrix{})`). It is right with -fno-tree-dse, with noipa, under the
// sanitizers and in clang. The fault needs ldexpl() in a loop; the product has neither it nor long double.
Double4x4 values(Matrix a) {
    Double4x4 r;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            r.at[i][j] = value(a.at(i, j));
    return r;
}

Matrix random_matrix(Random& random, int span) {
    Real r[16];
    for (Real& v : r)
        v = random_real(random, span);
    return matrix_from_reals(r);
}

TEST(Matrix, ReturnsWhatWasLoaded) {
    Random random(25);
    for (int i = 0; i < 100'000; ++i) {
        Real in[16], out[16];
        for (Real& v : in)
            v = from_float_bits(random.word());
        const Matrix a = matrix_from_reals(in);
        to_reals(a, out);
        for (int k = 0; k < 16; ++k)
            ASSERT_EQ(out[k], in[k]);
        ASSERT_EQ(value(a.at(1, 2)), static_cast<long double>(to_float(in[9]))) << "column-major";
        ASSERT_EQ(value(transpose(a).at(2, 1)), static_cast<long double>(to_float(in[9])));
    }
    Real id[16];
    to_reals(Matrix{}, id);
    const Double4x4 exact = values(Matrix{});
    for (int k = 0; k < 16; ++k) {
        EXPECT_EQ(id[k].bits, k % 5 == 0 ? one.bits : 0u);
        EXPECT_EQ(exact.at[k & 3][k >> 2], k % 5 == 0 ? 1 : 0);
    }
}

TEST(Matrix, ProductsAreNearlyCorrectlyRounded) {
    Random random(26);
    for (int n = 0; n < 100'000; ++n) {
        const int span = 1 + static_cast<int>(random.next() % 30);
        const Matrix a = random_matrix(random, span), b = random_matrix(random, span), c = multiply(a, b);
        const Double4x4 x = values(a), y = values(b), z = values(c);
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j) {
                long double sum = 0, magnitude = 0;
                for (int k = 0; k < 4; ++k) {
                    sum += x.at[i][k] * y.at[k][j];
                    magnitude += std::fabs(x.at[i][k] * y.at[k][j]);
                }
                ASSERT_LE(std::fabs(z.at[i][j] - sum),
                          std::fabs(sum) * std::exp2(-31.0L) + magnitude * std::exp2(-57.0L));
            }
    }
    // Overflow and underflow stay finite and keep their sign.
    const Matrix big = scaling(largest, -largest, Real{1});
    Real r[16];
    to_reals(multiply(big, big), r);
    EXPECT_EQ(r[0].bits, largest.bits);
    EXPECT_EQ(r[5].bits, largest.bits);
    EXPECT_EQ(r[10].bits, 0u);
}

/// Returns the documented matrices of GL 1.3, 2.10.2, in long double.
Double4x4 rotation_matrix(long double degrees, long double x, long double y, long double z) {
    const long double l = std::sqrt(x * x + y * y + z * z),
                      a = std::fmod(degrees, 360.0L) * 0.0174532925199432957692369L;
    const long double u[3] = {x / l, y / l, z / l}, c = std::cos(a), s = std::sin(a);
    const long double cross[3][3] = {{0, -u[2], u[1]}, {u[2], 0, -u[0]}, {-u[1], u[0], 0}};
    Double4x4 r;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            r.at[i][j] = u[i] * u[j] * (1 - c) + (i == j ? c : 0) + s * cross[i][j];
    r.at[3][3] = 1;
    return r;
}

void expect_near(const Matrix& got, const Double4x4& want, double bound, const char* what) {
    long double most = 0;
    for (const auto& row : want.at)
        for (long double v : row)
            most = std::max(most, std::fabs(v));
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            ASSERT_LE(std::fabs(value(got.at(i, j)) - want.at[i][j]), most * bound)
                << what << ' ' << i << ' ' << j;
}
/// Returns an element of a random matrix. Half of the elements are 0 or powers of two near 1.
Element random_element(Random& random) {
    switch (random.next() & 7) {
    case 0:
    case 1:
    case 2:
        return {};
    case 3:
        return {(random.next() & 1) != 0 ? Matrix::one : -Matrix::one,
                static_cast<std::int8_t>(Matrix::one_e + random.range(-1, 1))};
    case 4:
        return make_element(static_cast<std::int32_t>(random.word()), random.range(-150, 104));
    default:
        return make_element(static_cast<std::int32_t>(random.word()), random.range(-40, 0));
    }
}

/// Hosts leave out products that are 0, and boards do not. Their bits must be those of all four terms.
TEST(Matrix, ProductsWithZerosAreSumsOfAllTerms) {
    Random random(31);
    for (int round = 0; round < 50000; ++round) {
        Matrix a, b;
        for (int i = 0; i < 16; ++i) {
            a.set(i & 3, i >> 2, random_element(random));
            b.set(i & 3, i >> 2, random_element(random));
        }
        const Matrix product = multiply(a, b);
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j) {
                Element row[4], column[4];
                for (int k = 0; k < 4; ++k) {
                    row[k] = a.at(i, k);
                    column[k] = b.at(k, j);
                }
                const Element sum = detail::sum_of_products(row, column);
                ASSERT_EQ(product.at(i, j).m, sum.m) << round;
                ASSERT_EQ(product.at(i, j).e, sum.e) << round;
            }
    }
}

/// Floats become elements, and elements blocks, as any number does.
TEST(Matrix, ShortWaysOfElementsAreThoseOfAnyNumber) {
    Random random(32);
    for (int round = 0; round < 1000000; ++round) {
        const Real v = from_float_bits(random.word());
        const auto unpacked = detail::unpack(v);
        const auto mantissa = static_cast<std::int64_t>(unpacked.mantissa);
        const Element expected = make_element(unpacked.negative ? -mantissa : mantissa, unpacked.exponent);
        const Element given = to_element(v), other = random_element(random);
        ASSERT_EQ(given.m, expected.m) << v.bits;
        ASSERT_EQ(given.e, expected.e) << v.bits;
        const Block block = to_block(other), any = make_block(other.m, other.e + element_bias);
        ASSERT_EQ(block.m, any.m);
        ASSERT_EQ(block.e, any.e);
    }
}

TEST(Matrix, RotationsAreWithin2ToMinus28) {
    Random random(27);
    for (int n = 0; n < 100'000; ++n) {
        const Real v[4] = {random_real(random, 10), random_real(random, 4), random_real(random, 4),
                           random_real(random, 4)};
        if (is_zero(v[1]) && is_zero(v[2]) && is_zero(v[3]))
            continue;
        expect_near(rotation(v[0], v[1], v[2], v[3]).matrix,
                    rotation_matrix(to_float(v[0]), to_float(v[1]), to_float(v[2]), to_float(v[3])),
                    std::exp2(-28), "rotation");
    }
    // Quarter turns about an axis are permutations, exactly.
    const Matrix q = rotation(from_i32(90), zero, zero, from_i32(5)).matrix;
    EXPECT_EQ(value(q.at(1, 0)), 1);
    EXPECT_EQ(value(q.at(0, 1)), -1);
    EXPECT_EQ(value(q.at(0, 0)), 0);
    EXPECT_EQ(value(q.at(2, 2)), 1);
    const Matrix none = rotation(from_i32(30), zero, zero, zero).matrix;
    for (int k = 0; k < 16; ++k)
        EXPECT_EQ(to_real(none.at(k & 3, k >> 2)).bits, k % 5 == 0 ? one.bits : 0u) << "zero axis";
}

TEST(Matrix, ProjectionsAreWithinOnePartInAMillionOfDouble) {
    Random random(28);
    for (int i = 0; i < 100'000; ++i) {
        const float l = std::ldexp(static_cast<float>(random.range(-1000, 1000)), -7),
                    r = l + std::ldexp(static_cast<float>(random.range(1, 1000)), -7);
        const float b = std::ldexp(static_cast<float>(random.range(-1000, 1000)), -7),
                    t = b - std::ldexp(static_cast<float>(random.range(1, 1000)), -7);
        const float n = std::ldexp(static_cast<float>(random.range(1, 1000)), -10),
                    f = n * static_cast<float>(random.range(2, 100000));
        const long double L = l, R = r, B = b, T = t, N = n, F = f;
        Double4x4 p;
        p.at[0][0] = 2 * N / (R - L), p.at[0][2] = (R + L) / (R - L);
        p.at[1][1] = 2 * N / (T - B), p.at[1][2] = (T + B) / (T - B);
        p.at[2][2] = -(F + N) / (F - N), p.at[2][3] = -2 * F * N / (F - N), p.at[3][2] = -1;
        Double4x4 o;
        o.at[0][0] = 2 / (R - L), o.at[0][3] = -(R + L) / (R - L);
        o.at[1][1] = 2 / (T - B), o.at[1][3] = -(T + B) / (T - B);
        o.at[2][2] = -2 / (F - N), o.at[2][3] = -(F + N) / (F - N), o.at[3][3] = 1;
        const Real v[6] = {from_float(l), from_float(r), from_float(b),
                           from_float(t), from_float(n), from_float(f)};
        const Matrix mp = frustum(v[0], v[1], v[2], v[3], v[4], v[5]),
                     mo = ortho(v[0], v[1], v[2], v[3], v[4], v[5]);
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column) { // each element, not only relative to the largest
                ASSERT_LE(std::fabs(value(mp.at(row, column)) - p.at[row][column]),
                          std::fabs(p.at[row][column]) * 1e-6)
                    << row << column;
                ASSERT_LE(std::fabs(value(mo.at(row, column)) - o.at[row][column]),
                          std::fabs(o.at[row][column]) * 1e-6)
                    << row << column;
            }
    }
    const Matrix bad = frustum(one, one, one, one, one, one); // GL has reported the error; nothing may break
    EXPECT_EQ(value(bad.at(3, 2)), -1);
}

TEST(Matrix, AMillionRotationsStayOrthogonal) {
    struct Case {
        const char* name;
        Real x, y, z;
    };
    constexpr double bound = 4e-6; // 2e-4 is required; one step to 31 bits would add up to 5e-4
    for (const Case& c : {Case{"z", zero, zero, one}, Case{"xyz", one, one, one},
                          Case{"oblique", one, from_float(0.3f), from_float(-0.2f)},
                          Case{"steep", from_float(0.01f), one, from_float(7)}}) {
        const Rotation step = rotation(one, c.x, c.y, c.z);
        Matrix m;
        for (int n = 0; n < 1'000'000; ++n)
            m = multiply(m, step);
        const Double4x4 v = values(m);
        long double worst = 0;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                long double d = i == j ? -1 : 0;
                for (int k = 0; k < 3; ++k)
                    d += v.at[k][i] * v.at[k][j];
                worst = std::max(worst, std::fabs(d));
            }
        std::printf("10^6 rotations about %s: orthogonal within %.2Lg\n", c.name, worst);
        EXPECT_LE(worst, bound);
    }
}

TEST(Matrix, InverseTimesMatrixIsIdentity) {
    Random random(29);
    double worst = 0;
    for (int n = 0; n < 50'000; ++n) {
        const Matrix a = random_matrix(random, 2);
        Matrix b;
        if (!inverse(a, b))
            continue;
        const Double4x4 x = values(a), y = values(b);
        long double size = 1, scale_a = 0, scale_b = 0;
        for (int k = 0; k < 16; ++k) {
            scale_a = std::max(scale_a, std::fabs(x.at[k & 3][k >> 2]));
            scale_b = std::max(scale_b, std::fabs(y.at[k & 3][k >> 2]));
        }
        size = std::max(1.0L, scale_a * scale_b); // the condition of the matrix
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j) {
                long double d = i == j ? -1 : 0;
                for (int k = 0; k < 4; ++k)
                    d += x.at[i][k] * y.at[k][j];
                worst = std::max(worst, static_cast<double>(std::fabs(d) / (size * size)));
            }
    }
    std::printf("inverse: residual 2^%.2f of the squared condition\n", std::log2(worst));
    EXPECT_LE(worst, std::exp2(-27));
    Matrix kept = translation(one, one, one);
    EXPECT_FALSE(inverse(scaling(one, zero, one), kept));
    EXPECT_EQ(value(kept.at(0, 3)), 1);
}

TEST(Matrix, InverseTransposeOfTheUpperThree) {
    Random random(30);
    for (int n = 0; n < 50'000; ++n) {
        const int span = 1 + static_cast<int>(random.next() % 20);
        // Scaled rotations stand for modelview matrices, which are well conditioned but of any size.
        const Real by[3] = {random_real(random, 9), random_real(random, 1), random_real(random, 1)};
        const Real to[3] = {random_real(random, span), random_real(random, span), random_real(random, span)};
        const Matrix a = multiply(rotation(by[0], one, by[1], by[2]).matrix, scaling(to[0], to[1], to[2]));
        const NormalMatrix m = inverse_transpose(a);
        if (m.singular)
            continue;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) { // columns of A and of A^-T are dual: a_i . b_j = 1 if i = j, else 0
                long double d = 0, size = 0;
                for (int k = 0; k < 3; ++k) {
                    d += value(a.at(k, i)) * value(m.at[3 * j + k]);
                    size = std::max(size, std::fabs(value(a.at(k, i)) * value(m.at[3 * j + k])));
                }
                ASSERT_NEAR(static_cast<double>(d), i == j ? 1 : 0,
                            std::exp2(-26) * std::max(1.0, static_cast<double>(size)));
            }
        long double row = 0; // RESCALE_NORMAL uses the third row of the inverse
        for (int k = 0; k < 3; ++k)
            row += value(m.at[6 + k]) * value(m.at[6 + k]);
        ASSERT_NEAR(static_cast<double>(value(m.row_scale()) * std::sqrt(row)), 1, std::exp2(-27));
    }
    const NormalMatrix flat = inverse_transpose(scaling(one, one, zero));
    EXPECT_TRUE(flat.singular);
    EXPECT_EQ(value(flat.at[8]), 1) << "a normal of the flattened plane survives";
    EXPECT_TRUE(inverse_transpose(scaling(zero, zero, zero)).singular);
}

/// The error of x/w, y/w and z/w of a vertex in the view volume, relative to what the terms of the sums
/// allow. If terms of size s cancel to w, the last bits of any arithmetic are worth s/w.
struct NdcError {
    double worst = 0, squares = 0;
    int count = 0;
    double rms() const { return std::sqrt(squares / count); }
};
void check_ndc(const Matrix& m, const Real (&r)[4], NdcError& out) {
    const Block4 got = transform(to_block_matrix(m), r);
    ASSERT_TRUE((is_normalised<Block4, 4>(got)));
    const Double4x4 a = values(m);
    long double sum[4] = {}, size[4] = {};
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            const long double term = a.at[i][j] * static_cast<long double>(to_float(r[j]));
            sum[i] += term;
            size[i] += std::fabs(term);
        }
    const long double w = sum[3];
    if (w <= 0)
        return;
    for (int i = 0; i < 3; ++i)
        if (std::fabs(sum[i]) > w)
            return;
    ++out.count;
    for (int i = 0; i < 3; ++i) {
        const long double error = std::fabs(static_cast<long double>(got.m[i]) / got.m[3] - sum[i] / w);
        const long double allowed = std::max(1.0L, (size[i] + size[3]) / w);
        const auto relative = static_cast<double>(error / allowed);
        out.worst = std::max(out.worst, relative);
        out.squares += relative * relative / 3;
    }
}

struct Lens {
    const char* name;
    Matrix matrix;
    int size; ///< vertices lie within 2^size
};

TEST(BlockMatrix, PositionsAfterTheDivision) {
    const auto f = [](float v) { return from_float(v); };
    const Lens lenses[] = {
        {"near 0.1, far 1000", frustum(f(-0.08f), f(0.08f), f(-0.06f), f(0.06f), f(0.1f), f(1000)), 8},
        {"near 1, far 10^6", frustum(f(-1), f(1), f(-0.75f), f(0.75f), f(1), f(1e6f)), 16},
        // x counts 100 times here, and z in pixels 160 times, so the columns' exponents must keep their bits.
        {"telephoto 1:100", frustum(f(-0.01f), f(0.01f), f(-0.01f), f(0.01f), f(1), f(1e4f)), 7},
        {"pixels", ortho(zero, from_i32(320), zero, from_i32(240), -one, one), 9},
    };
    for (const Lens& lens : lenses) {
        Random random(31);
        NdcError error;
        for (int n = 0; n < 400'000; ++n) {
            const auto any = [&](int size) {
                return f(std::ldexp(static_cast<float>(random.range(-(1 << 20), 1 << 20)), size - 20));
            };
            const bool moved = (n & 1) != 0;
            const Real narrow = lens.size == 7 && !moved ? any(lens.size - 7) : any(lens.size);
            const Real v[4] = {narrow, moved ? any(lens.size) : mul(narrow, any(0)),
                               lens.size == 9 ? any(0) : any(lens.size), one};
            Matrix model;
            if (moved) { // one random number for each statement, because the compiler may choose the order of
                         // arguments
                const Real to[3] = {any(lens.size), any(lens.size), any(lens.size)};
                const Real by[3] = {any(9), any(0), any(0)};
                model = multiply(translation(to[0], to[1], to[2]), rotation(by[0], by[1], one, by[2]));
            }
            check_ndc(multiply(lens.matrix, model), v, error);
            if (HasFatalFailure())
                return;
        }
        std::printf("x/w, y/w, z/w with %s: worst 2^%.2f, RMS 2^%.2f (%d vertices)\n", lens.name,
                    std::log2(error.worst), std::log2(error.rms()), error.count);
        // The worst vertex of a sample is one whose largest component hardly counts in the row (2^-20.6 in 60
        // samples of this size); all others are far better. 2^-20 is a quarter of a step of n.8 on a surface
        // 2048 wide.
        EXPECT_LE(error.worst, std::exp2(-20)) << lens.name;
        EXPECT_LE(error.rms(), std::exp2(-29)) << lens.name;
        EXPECT_GT(error.count, 1000) << lens.name;
    }
}

TEST(BlockMatrix, CarriesWhatIsExact) {
    Random random(32);
    const BlockMatrix identity_block = to_block_matrix(Matrix{});
    for (int n = 0; n < 200'000; ++n) {
        const Real r[4] = {random_real(random, 60), random_real(random, 60), random_real(random, 60),
                           random_real(random, 60)};
        const Block4 v = to_block(r[0], r[1], r[2], r[3]), w = transform(identity_block, v);
        // The high word keeps 29 of the 30 bits: floats within 2^5 of the largest do not change.
        for (int c = 0; c < 4; ++c)
            ASSERT_LE(std::fabs(value(component(w, c)) - value(component(v, c))), std::ldexp(2.0L, v.e));
        ASSERT_LE(std::abs(w.e - v.e), 1);
    }
    // Scaling everything by a power of two changes the exponent only.
    for (int n = 0; n < 100'000; ++n) {
        const Matrix m = random_matrix(random, 8);
        const Real r[4] = {random_real(random, 5), random_real(random, 5), random_real(random, 5), one};
        const Real k = from_float(std::ldexp(1.0f, random.range(-30, 30)));
        const Block4 a = transform(to_block_matrix(m), to_block(r[0], r[1], r[2], r[3]));
        const Block4 b =
            transform(to_block_matrix(m), to_block(mul(r[0], k), mul(r[1], k), mul(r[2], k), mul(r[3], k)));
        for (int c = 0; c < 4; ++c)
            ASSERT_EQ(a.m[c], b.m[c]);
    }
    const Block4 nothing = transform(to_block_matrix(scaling(zero, zero, zero)), Block4{});
    EXPECT_EQ(nothing.m[3], 0);
}

/// Denormals, and zeros in columns larger than all other values, work as Reals and as blocks.
TEST(BlockMatrix, SmallVerticesKeepTheirBits) {
    Random random(34);
    for (int n = 0; n < 100'000; ++n) {
        const Real large = from_float(std::ldexp(1.0f, random.range(0, 120)));
        const Matrix m = scaling(one, large, large);
        Real v[4] = {from_float_bits(random.word() & 0x80FFFFFF), zero, zero, zero};
        v[1 + n % 3] = n % 2 == 0 ? zero : from_float_bits(random.word() & 0x807FFFFF);
        const Block4 got = transform(to_block_matrix(m), v),
                     expected = transform(to_block_matrix(m), to_block(v[0], v[1], v[2], v[3]));
        for (int c = 0; c < 4; ++c)
            ASSERT_LE(std::fabs(value(component(got, c)) - value(component(expected, c))),
                      std::ldexp(4.0L, expected.e))
                << n;
    }
}

TEST(BlockMatrix, NormalsOfStretchedObjectsKeepTheirDirection) {
    // For diag(1, 1, 1024) the inverse transpose has rows of size 1 and of size 1/1024.
    const BlockMatrix3 m = to_block_matrix(inverse_transpose(scaling(one, one, from_i32(1024))));
    const Unit3 n = normalize(transform(m, to_block(from_float(0x1p-10f), zero, one)));
    EXPECT_NEAR(std::ldexp(n.m[0], -30), std::sqrt(0.5), std::exp2(-27));
    EXPECT_NEAR(std::ldexp(n.m[2], -30), std::sqrt(0.5), std::exp2(-27));
}

TEST(BlockMatrix, SurvivesEveryBitPattern) {
    Random random(33);
    for (int n = 0; n < 200'000; ++n) {
        Real r[16], v[4];
        for (Real& e : r)
            e = from_float_bits(random.word());
        for (Real& e : v)
            e = from_float_bits(random.word());
        const Matrix a = matrix_from_reals(r), b = multiply(a, a);
        const Block4 w = transform(to_block_matrix(b), to_block(v[0], v[1], v[2], v[3]));
        ASSERT_TRUE((is_normalised<Block4, 4>(w)));
        Matrix out;
        inverse(b, out);
        const NormalMatrix m = inverse_transpose(b);
        const Block3 t = transform(to_block_matrix(m), to_block(v[0], v[1], v[2]));
        ASSERT_TRUE((is_normalised<Block3, 3>(t)));
        normalize(t);
        rotation(v[0], v[1], v[2], v[3]);
        frustum(v[0], v[1], v[2], v[3], r[0], r[1]);
        ortho(v[0], v[1], v[2], v[3], r[0], r[1]);
    }
}

} // namespace
