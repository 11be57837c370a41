// Compares Real with the hardware's float: every conversion, comparison and operation, bit for bit.
#include "raster/numeric/real.hpp"

#include <cfloat>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "tests/unit/numeric/random.hpp"

namespace {

using namespace spangle::numeric;

/// Returns what GL keeps of a hardware result: neither NaN nor infinity.
float finite(float v) {
    return std::isnan(v) ? 0.0f : std::isinf(v) ? std::copysign(FLT_MAX, v) : v;
}
std::uint32_t bits_of(float v) {
    return std::bit_cast<std::uint32_t>(v);
}

/// Returns floats that meet every branch: extremes, powers, their neighbours, denormals, ties.
std::vector<Real> corner_cases() {
    std::vector<Real> out;
    for (std::uint32_t b : {0u,          1u,          2u,          0x7FFFFFu,   0x800000u,   0x800001u,
                            0x3EFFFFFFu, 0x3F000000u, 0x3F000001u, 0x3F7FFFFFu, 0x3F800000u, 0x3F800001u,
                            0x3FC00000u, 0x40200000u, 0x40400000u, 0x4B000000u, 0x4B7FFFFFu, 0x4B800000u,
                            0x4EFFFFFFu, 0x4F000000u, 0x4F7FFFFFu, 0x4F800000u, 0x7F000000u, 0x7F7FFFFFu})
        for (std::uint32_t sign : {0u, 0x80000000u})
            out.push_back({b | sign});
    return out;
}

Real random_real(Random& random) {
    // Every third number has an exponent near another's, so that additions cancel and divisions round.
    const std::uint32_t word = random.word();
    return from_float_bits(random.next() % 3 == 0 ? (word & 0x80FFFFFFu) | 0x3F000000u : word);
}

template <class F> void for_pairs(std::uint64_t seed, int count, F f) {
    const std::vector<Real> corners = corner_cases();
    for (Real a : corners)
        for (Real b : corners)
            f(a, b);
    Random random(seed);
    for (int i = 0; i < count; ++i) {
        const Real a = random_real(random), b = random_real(random);
        f(a, b);
    }
}

TEST(Real, EntersFloatsAsTheyAreButFinite) {
    EXPECT_EQ(from_float(NAN).bits, 0u);
    EXPECT_EQ(from_float_bits(0x7F800001).bits, 0u) << "signalling NaN";
    EXPECT_EQ(from_float_bits(0xFFFFFFFF).bits, 0u);
    EXPECT_EQ(to_float(from_float(INFINITY)), FLT_MAX);
    EXPECT_EQ(to_float(from_float(-INFINITY)), -FLT_MAX);
    Random random(1);
    for (int i = 0; i < 1'000'000; ++i) {
        const std::uint32_t b = random.word();
        ASSERT_EQ(from_float_bits(b).bits, bits_of(finite(std::bit_cast<float>(b)))) << std::hex << b;
    }
}

TEST(Real, EntersDoublesRoundedToNearestEven) {
    const auto check = [](std::uint64_t b) {
        const auto d = std::bit_cast<double>(b);
        ASSERT_EQ(from_double_bits(b).bits, bits_of(finite(static_cast<float>(d)))) << std::hex << b;
    };
    for (double d : {0.0, -0.0, 1.0, 1e300, -1e300, 1e-300, 5e-324, 0x1p-149, 0x1p-150, 0x1.000002p-150,
                     0x1.8p-149, 0x1.fffffep127, 0x1.ffffffp127, 0x1.000001p0, 0x1.000003p0, 0x1.fffffefp-127,
                     double(INFINITY), -double(INFINITY), double(NAN)})
        check(std::bit_cast<std::uint64_t>(d));
    Random random(2);
    for (int i = 0; i < 1'000'000; ++i) {
        const std::uint64_t b = random.next();
        check(b); // random bits, mostly out of range
        const std::uint64_t exponent = 1023u - 152u + random.next() % 284u; // around the range of float
        check((b & 0x800FFFFFFFFFFFFFu) | exponent << 52);
        // These doubles are exact values or ties.
        check((b & 0x800FFFFFE0000000u) | exponent << 52 | (random.next() & 1) << 28);
    }
}

TEST(Real, EntersIntegersAndFixedRounded) {
    const auto check = [](std::uint32_t v) {
        const auto s = static_cast<std::int32_t>(v);
        ASSERT_EQ(to_float(from_u32(v)), static_cast<float>(v));
        ASSERT_EQ(to_float(from_i32(s)), static_cast<float>(s));
        ASSERT_EQ(to_float(from_fixed16(s)), static_cast<float>(s) / 65536.0f);
    };
    for (std::uint32_t v :
         {0u, 1u, 0x7FFFFFFFu, 0x80000000u, 0x80000001u, 0xFFFFFFFFu, 0x1000001u, 0x1000003u})
        check(v);
    Random random(3);
    for (int i = 0; i < 1'000'000; ++i)
        check(random.word() >> (random.next() & 31));
    EXPECT_EQ(to_float(from_fixed(INT64_MIN, 0)), -0x1p63f);
    EXPECT_EQ(to_float(from_fixed(INT64_MAX, 63)), 1.0f);
    EXPECT_EQ(to_float(from_fixed(1, 149)), 0x1p-149f);
    EXPECT_EQ(from_fixed(1, 300).bits, 0u);
    EXPECT_EQ(from_fixed(1, -300).bits, largest.bits);
}

// GL 1.3, table 2.6. 2^32 - 1 and 2c + 1 are exact in long double, and so is the rounding of the quotient to
// float: no quotient lies within 2^-63 of a tie.
float unit_float(long double numerator, long double denominator) {
    return static_cast<float>(numerator / denominator);
}

TEST(Real, NormalisesEveryByteAndShort) {
    for (int c = 0; c < 256; ++c)
        ASSERT_EQ(to_float(normalized_ubyte(static_cast<std::uint8_t>(c))), unit_float(c, 255));
    for (int c = -128; c < 128; ++c)
        ASSERT_EQ(to_float(normalized_byte(static_cast<std::int8_t>(c))), unit_float(2 * c + 1, 255));
    for (int c = 0; c < 65536; ++c)
        ASSERT_EQ(to_float(normalized_ushort(static_cast<std::uint16_t>(c))), unit_float(c, 65535));
    for (int c = -32768; c < 32768; ++c)
        ASSERT_EQ(to_float(normalized_short(static_cast<std::int16_t>(c))), unit_float(2 * c + 1, 65535));
}

TEST(Real, NormalisesInts) {
    const auto check = [](std::uint32_t c) {
        const auto s = static_cast<std::int32_t>(c);
        ASSERT_EQ(to_float(normalized_uint(c)), unit_float(c, 4294967295.0L)) << c;
        ASSERT_EQ(to_float(normalized_int(s)), unit_float(2.0L * s + 1, 4294967295.0L)) << s;
        ASSERT_NE(normalized_int(s).bits << 1, 0u) << "0 is not representable";
    };
    for (std::uint32_t c : {0u, 1u, 0x7FFFFFFFu, 0x80000000u, 0xFFFFFFFFu})
        check(c);
    Random random(4);
    for (int i = 0; i < 1'000'000; ++i)
        check(random.word() >> (random.next() & 31));
    EXPECT_EQ(normalized_int(INT32_MIN).bits, (-one).bits);
    EXPECT_EQ(normalized_int(INT32_MAX).bits, one.bits);
}

TEST(Real, OrdersAsFloats) {
    for_pairs(5, 1'000'000, [](Real a, Real b) {
        const float x = to_float(a), y = to_float(b);
        ASSERT_EQ(a == b, x == y) << x << ' ' << y;
        ASSERT_EQ(a < b, x < y) << x << ' ' << y;
        ASSERT_EQ(a > b, x > y);
        ASSERT_EQ(a <= b, x <= y);
        ASSERT_EQ(a >= b, x >= y);
    });
    for (Real v : corner_cases()) {
        const float x = to_float(v);
        EXPECT_EQ(is_zero(v), x == 0);
        EXPECT_EQ(to_bool(v), x != 0);
        EXPECT_EQ(is_negative(v), x < 0);
        EXPECT_EQ(to_float(-v), -x);
        EXPECT_EQ(to_float(abs(v)), std::fabs(x));
        EXPECT_EQ(to_float(clamp01(v)), x < 0 ? 0 : x > 1 ? 1 : x);
    }
}

TEST(Real, AddsMultipliesDividesAsHardware) {
    for_pairs(6, 3'000'000, [](Real a, Real b) {
        const float x = to_float(a), y = to_float(b);
        ASSERT_EQ(add(a, b).bits, bits_of(finite(x + y))) << x << " + " << y;
        ASSERT_EQ(sub(a, b).bits, bits_of(finite(x - y))) << x << " - " << y;
        ASSERT_EQ(mul(a, b).bits, bits_of(finite(x * y))) << x << " * " << y;
        if (y != 0) {
            ASSERT_EQ(div(a, b).bits, bits_of(finite(x / y))) << x << " / " << y;
        }
    });
    EXPECT_EQ(div(one, zero).bits, largest.bits);
    EXPECT_EQ(div(-one, zero).bits, (-largest).bits);
    EXPECT_EQ(div(zero, zero).bits, 0u);
}

TEST(Real, LeavesAsDouble) {
    for_pairs(7, 300'000, [](Real a, Real) { ASSERT_EQ(to_double(a), static_cast<double>(to_float(a))); });
}

TEST(Real, LeavesAsIntegersRoundedAndSaturated) {
    for_pairs(8, 1'000'000, [](Real a, Real b) {
        const float x = to_float(a);
        const double nearest = std::round(static_cast<double>(x)); // halves away from zero
        ASSERT_EQ(to_i32_round(a), nearest > INT32_MAX   ? INT32_MAX
                                   : nearest < INT32_MIN ? INT32_MIN
                                                         : nearest)
            << x;
        for (int f : {0, 8, 16, 30, static_cast<int>(b.bits % 80)}) {
            const double even = std::nearbyint(std::ldexp(static_cast<double>(x), f));
            const double clamped = even > INT32_MAX ? INT32_MAX : even < INT32_MIN ? INT32_MIN : even;
            ASSERT_EQ(to_fixed(a, f), clamped) << x << " with " << f;
        }
        ASSERT_EQ(to_fixed16(a), to_fixed(a, 16));
    });
}

TEST(Real, LeavesAsUnitCodes) {
    for_pairs(9, 1'000'000, [](Real a, Real) {
        const long double clamped = std::fmin(std::fmax(static_cast<long double>(to_float(a)), 0.0L), 1.0L);
        for (int bits : {1, 5, 6, 8, 16, 24, 32}) {
            const long double codes = std::ldexp(1.0L, bits) - 1;
            ASSERT_EQ(to_unit(a, bits), static_cast<std::uint32_t>(std::floor(clamped * codes + 0.5L)))
                << to_float(a);
        }
        // ((2^32 - 1) f - 1) / 2, with halves rounded up.
        const long double f = std::fmin(std::fmax(static_cast<long double>(to_float(a)), -1.0L), 1.0L);
        const bool tiny =
            f != 0 && std::fabs(f) < 0x1p-40L; // near the tie at 0, where long double has too few bits
        const long double nearest = tiny ? (f < 0 ? -1 : 0) : std::floor((f * 4294967295.0L - 1) / 2 + 0.5L);
        ASSERT_EQ(to_normalized_int(a), static_cast<std::int64_t>(nearest)) << to_float(a);
    });
    for (int c = 0; c < 256; ++c)
        ASSERT_EQ(to_unit(normalized_ubyte(static_cast<std::uint8_t>(c)), 8), static_cast<unsigned>(c));
    for (int c = 0; c < 65536; ++c)
        ASSERT_EQ(to_unit(normalized_ushort(static_cast<std::uint16_t>(c)), 16), static_cast<unsigned>(c));
    for (int c = -32768; c < 32768; ++c) // a value that was set as a short is read back with its 16 bits
        ASSERT_EQ(to_normalized_int(normalized_short(static_cast<std::int16_t>(c))) >> 16, c);
}

} // namespace
