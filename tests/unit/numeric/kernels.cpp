// Compares reciprocal, root, division and powers with their bounds.
#include "tests/unit/numeric/kernels.hpp"

#include <vector>

#include "raster/numeric/power.hpp"
#include "raster/numeric/trigonometry.hpp"
#include "tests/unit/numeric/random.hpp"

namespace {

using namespace spangle::numeric;

TEST(Kernels, ReciprocalHoldsItsBounds) {
    check_reciprocal(97);
}
TEST(Kernels, HalfReciprocalsAreHalfOfThose) {
    for (std::uint32_t a = 1; a < 1 << 12; ++a)
        for (const std::uint32_t half :
             {half_reciprocal(a, clz32(a)), detail::half_reciprocal_in_steps(a, clz32(a))})
            ASSERT_EQ(half, reciprocal(a << clz32(a)) >> 1) << a;
}
TEST(Kernels, ReciprocalsTogetherAreThoseAlone) {
    Random random(12);
    for (int round = 0; round < 200'000; ++round) {
        std::uint32_t a[16];
        Reciprocals<16> together;
        const int count = round % 17;
        for (int i = 0; i < count; ++i) {
            const std::uint32_t ends[] = {0x80000000u, 0x80000001u, 0xFFFFFFFFu, 0xFFFFFFFEu};
            a[i] = (round + i) % 9 == 0 ? ends[round & 3] : random.word() | 0x80000000u;
            together.set(i, a[i]);
        }
        together.finish(count);
        for (int i = 0; i < count; ++i)
            ASSERT_EQ(together.at(i), reciprocal(a[i])) << a[i];
    }
}
TEST(Kernels, SaturationStaysInItsBits) {
    const auto check = [](std::int32_t v) {
        const std::int64_t wide = std::int64_t{v} >> 8, most = 0xFFFF;
        const std::int64_t expected = wide < 0 ? 0 : wide > most ? most : wide;
        ASSERT_EQ((saturated_after<8, 16>(v)), static_cast<std::uint32_t>(expected)) << v;
    };
    for (const std::int32_t edge : {0, 1 << 8, 1 << 24, INT32_MAX - 2, INT32_MIN + 2})
        for (std::int32_t v = edge - 2; v < edge + 2; ++v)
            check(v);
    Random random(13);
    for (int round = 0; round < 10'000; ++round)
        check(static_cast<std::int32_t>(random.word() >> (round % 20)));
    static_assert(saturated_after<8, 16>(-1) == 0);
}
template <std::uint32_t D> void check_short_remainder() {
    for (std::uint32_t n = 0; n < 1u << 16 && detail::ShortRemainder<D>::exact; ++n)
        ASSERT_EQ(detail::ShortRemainder<D>::of(n), n % D) << n << ' ' << D;
}
TEST(Kernels, ShortRemaindersAreThoseOfDivision) {
    static_assert(detail::ShortRemainder<80>::exact); // of vertices that a board keeps
    check_short_remainder<80>();
    check_short_remainder<24>();
    check_short_remainder<7>();
    check_short_remainder<3>();
    check_short_remainder<641>();
    check_short_remainder<8191>();
}
TEST(Kernels, ZerosAreCountedAfterAnyOthers) {
    LeadingZeros<false> zeros;
    for (int before = 0; before <= 32; ++before)
        for (int i = 0; i <= 32; ++i) {
            const std::uint32_t edge = i < 32 ? std::uint32_t{1} << i : 0;
            for (const std::uint32_t v : {edge, edge - 1, edge | edge >> 1}) {
                zeros.of(before < 32 ? std::uint32_t{1} << before : 0);
                EXPECT_EQ(zeros.of(v), clz32(v)) << v << " after " << before;
                EXPECT_EQ(zeros.of(v), clz32(v)) << v << " after " << before;
            }
        }
}
TEST(Kernels, ProductsOfHalvesAreLongOnes) {
    const auto check = [](std::uint32_t u, std::uint32_t v) {
        const auto a = static_cast<std::int32_t>(u), b = static_cast<std::int32_t>(v);
        const std::uint64_t plain = std::uint64_t{u} * v,
                            mixed = static_cast<std::uint64_t>(std::int64_t{a} * v),
                            both = static_cast<std::uint64_t>(std::int64_t{a} * b);
        ASSERT_EQ(detail::mul_halves(u, v), plain) << u << ' ' << v;
        ASSERT_EQ(detail::mul_halves(a, v), mixed) << a << ' ' << v;
        ASSERT_EQ(detail::mul_halves(a, b), both) << a << ' ' << b;
        ASSERT_EQ(detail::mul_halves_high(u, v), plain >> 32) << u << ' ' << v;
        ASSERT_EQ(detail::mul_halves_high(a, v), mixed >> 32) << a << ' ' << v;
        ASSERT_EQ(detail::mul_halves_high(a, b), both >> 32) << a << ' ' << b;
        const auto rounded = static_cast<std::int32_t>((std::int64_t{a} * b + (std::int64_t{1} << 31)) >> 32);
        ASSERT_EQ(mul_high_rounded(a, b), rounded) << a << ' ' << b;
        ASSERT_EQ(add_high_rounded(-7, a, b), rounded - 7) << a << ' ' << b;
        ASSERT_EQ(detail::halves_residual(u, v), static_cast<std::uint32_t>((0 - plain) >> 14))
            << u << ' ' << v;
        const std::int32_t byte = static_cast<std::int32_t>(v & 0xFF000000);
        ASSERT_EQ(mul_high_byte(a, byte), mul_high_s32(a, byte)) << a << ' ' << v;
        ASSERT_EQ(detail::bytes_by_byte(a, byte >> 24), mul_high_s32(a, byte)) << a << ' ' << v;
        ASSERT_EQ(detail::add_halves(-3, a, b), std::int64_t{a} * b - 3) << a << ' ' << b;
        const int up = static_cast<int>(v % 32);
        ASSERT_EQ(shifted_up(a, up), a * (std::int64_t{1} << up)) << a << ' ' << b << ' ' << up;
        ASSERT_EQ(detail::shift_loses(a, v % 40), loses_bits(a, v % 40)) << a << ' ' << v % 40;
        ASSERT_EQ(detail::shift_loses(a >> up, v % 40), loses_bits(a >> up, v % 40)) << a << ' ' << up;
        ASSERT_EQ(mul_by_half(u, v >> 16), std::uint64_t{u} * (v >> 16) >> 16) << u << ' ' << v;
        ASSERT_EQ(detail::halves_by_half(u, v >> 16), mul_by_half(u, v >> 16)) << u << ' ' << v;
        const std::uint64_t wide = std::uint64_t{u} << 32 | v;
        ASSERT_EQ(detail::times_by_halves(wide, a), wide * static_cast<std::uint64_t>(std::int64_t{a}))
            << wide << ' ' << a;
        for (int n = 0; n < 64; n += 1 + static_cast<int>(u & 7))
            ASSERT_EQ(detail::high_word_by_words(wide, n), static_cast<std::uint32_t>(wide << n >> 32))
                << wide << ' ' << n;
        const auto either = static_cast<std::int64_t>(wide);
        for (int n = -70; n <= 70; n += 1 + static_cast<int>(u & 3)) {
            const int by = n < -63 ? -63 : n > 63 ? 63 : n;
            const std::int64_t times = by < 0 ? either >> -by : static_cast<std::int64_t>(wide << by);
            ASSERT_EQ(times_two_to(either, n), times) << either << ' ' << n;
        }
        ASSERT_EQ(joined_aside(u, 26, 6, v, 20), (u >> 26 << 6) + (v >> 20)) << u << ' ' << v;
    };
    std::vector<std::uint32_t> words;
    for (const std::uint32_t edge : {0u, 0x8000u, 0x10000u, 0x7FFF'0000u, 0x8000'0000u, 0xFFFF'0000u})
        for (const std::uint32_t by : {0u, 1u, 2u, 0xFFFFu, ~0u, ~1u})
            words.push_back(edge + by);
    for (const std::uint32_t a : words)
        for (const std::uint32_t b : words)
            check(a, b);
    Random random(14);
    for (int round = 0; round < 100'000; ++round) {
        const std::uint32_t a = random.word(), b = random.word();
        check(a, b);
    }
}
TEST(Kernels, RsqrtHoldsItsBounds) {
    check_rsqrt(97);
}

TEST(Kernels, DivisionIsExact) {
    Random random(11);
    const auto check = [](std::uint64_t n, std::uint32_t d) {
        const Quotient q = divide(n, d), by_words = detail::divide_by_words(n, d);
        ASSERT_EQ(q.quotient, n / d) << n << " / " << d;
        ASSERT_EQ(q.remainder, n % d) << n << " / " << d;
        ASSERT_EQ(by_words.quotient, n / d) << n << " / " << d;
        ASSERT_EQ(by_words.remainder, n % d) << n << " / " << d;
        for (const std::uint64_t by :
             {std::uint64_t{d}, ~n / d | 1, ~std::uint64_t{d}, std::uint64_t{d} << 32}) {
            const LongQuotient by_bits = detail::divide_by_bits(n, by);
            ASSERT_EQ(by_bits.quotient, n / by) << n << " / " << by;
            ASSERT_EQ(by_bits.remainder, n % by) << n << " / " << by;
        }
        const auto s = static_cast<std::int64_t>(n);
        if (s != INT64_MIN) {
            ASSERT_EQ(quotient(s, d), s / std::int64_t{d}) << s << " / " << d;
            ASSERT_EQ(detail::quotient_by_words(s, d), s / std::int64_t{d}) << s << " / " << d;
        }
        const FloorQuotient f = floor_divide(s, d);
        ASSERT_LT(f.remainder, d);
        // The check uses unsigned words, so that INT64_MIN / 1 is checked, too.
        ASSERT_EQ(static_cast<std::uint64_t>(f.quotient) * d + f.remainder, n) << s << " / " << d;
        ASSERT_EQ(f.quotient < 0, s < 0);
    };
    for (std::uint64_t n : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{0xFFFFFFFF},
                            std::uint64_t{1} << 32, std::uint64_t{1} << 63, ~std::uint64_t{0},
                            ~std::uint64_t{0} - 1, std::uint64_t{0x7FFFFFFFFFFFFFFF}})
        for (std::uint32_t d : {1u, 2u, 3u, 0x7FFFFFFFu, 0x80000000u, 0x80000001u, 0xFFFFFFFEu, 0xFFFFFFFFu})
            check(n, d);
    for (int i = 0; i < 3'000'000; ++i) {
        const std::uint32_t some = random.word() >> (random.next() & 31);
        const std::uint32_t d = some | 1u << (random.next() & 31);
        const std::uint64_t n = random.next() >> (random.next() & 63);
        check(n, d);
        check(n - n % d, d);
        check(n - n % d - 1, d);
    }
    EXPECT_EQ(divide(5, 0).quotient, 0u);
    EXPECT_EQ(floor_divide(-5, 0).quotient, 0);
}

/// x is dense near 1, where the exponent magnifies errors, and near 0.
std::int32_t power_argument(Random& random) {
    const auto x = static_cast<std::int32_t>(random.word() >> 2);
    switch (random.next() & 3) {
    case 0:
        return (1 << 30) - (x >> (random.next() % 30));
    case 1:
        return x >> (random.next() % 30);
    default:
        return x;
    }
}

TEST(Kernels, PowersHoldTheirBounds) {
    Random random(12);
    double largest = 0;
    for (int i = 0; i < 4'000'000; ++i) {
        const std::int32_t x = power_argument(random);
        const std::uint32_t n =
            (random.next() & 3) == 0 ? 128u << 24 : random.word() >> (1 + random.next() % 12);
        const double exact = std::pow(std::ldexp(x, -30), std::ldexp(n, -24));
        largest = std::max(largest, std::fabs(std::ldexp(pow_unit(x, n), -30) - exact));
        if (x > 0) {
            ASSERT_LE(pow_unit(x - 1, n), pow_unit(x, n)) << x << " ^ " << n;
        }
    }
    std::printf("x^n: 2^%.2f\n", std::log2(largest));
    EXPECT_LE(largest, std::exp2(-21));
}

TEST(Kernels, PowersAreExactAtTheirEnds) {
    for (float n : {0.0f, 0.5f, 1.0f, 2.0f, 128.0f, 1e30f, -1.0f}) {
        const std::uint32_t r = power_exponent(from_float(n));
        EXPECT_EQ(pow_unit(1 << 30, r), 1 << 30);
        EXPECT_EQ(pow_unit(INT32_MAX, r), 1 << 30) << "x is clamped";
        EXPECT_EQ(pow_unit(0, r), n > 0 ? 0 : 1 << 30) << "0^0 = 1 (GL 1.3, 2.1.1)";
        EXPECT_EQ(pow_unit(INT32_MIN, r), n > 0 ? 0 : 1 << 30);
    }
    EXPECT_EQ(power_exponent(from_float(128)), 128u << 24);
    EXPECT_EQ(power_exponent(from_float(1.5f)), 3u << 23);
    for (std::uint32_t k = 0; k <= 30; ++k)
        EXPECT_EQ(exp2_neg(k << 24), (1u << 30) >> k);
    EXPECT_EQ(exp2_neg(0xFFFFFFFF), 0u);
}

TEST(Kernels, ExponentialsHoldTheirBounds) {
    double exact = 0;
    std::uint32_t before = 1u << 30;
    for (std::uint64_t q = 0; q < std::uint64_t{1} << 32; q += 1021) {
        const auto word = static_cast<std::uint32_t>(q);
        const double t = std::exp2(-std::ldexp(word, -24));
        exact = std::max(exact, std::fabs(std::ldexp(exp2_neg(word), -30) - t));
        ASSERT_LE(exp2_neg(word), before);
        before = exp2_neg(word);
    }
    std::printf("2^-x: 2^%.2f\n", std::log2(exact));
    EXPECT_LE(exact, std::exp2(-29));
}

TEST(Kernels, SineAndCosine) {
    Random random(13);
    long double worst = 0;
    for (int i = 0; i < 500'000; ++i) {
        const auto mantissa = static_cast<float>(random.range(-(1 << 24), 1 << 24));
        const Real degrees = from_float(std::ldexp(mantissa, random.range(-40, 8)));
        const SinCos a = sincos_degrees(degrees);
        const long double x =
            std::fmod(static_cast<long double>(to_float(degrees)), 360.0L) * 0.0174532925199432957692369L;
        worst = std::max({worst, std::fabs(std::sin(x) - std::ldexp(static_cast<long double>(a.sin), -60)),
                          std::fabs(std::cos(x) - std::ldexp(static_cast<long double>(a.cos), -60))});
    }
    std::printf("sin, cos of degrees: 2^%.2Lf\n", std::log2(worst));
    EXPECT_LE(worst, std::exp2(-57.0L));
    for (int quarter = -8000; quarter <= 8000; ++quarter) {
        const SinCos a = sincos_degrees(from_i32(90 * quarter));
        const int q = quarter & 3;
        EXPECT_EQ(a.sin, q == 1 ? q60_one : q == 3 ? -q60_one : 0);
        EXPECT_EQ(a.cos, q == 0 ? q60_one : q == 2 ? -q60_one : 0);
    }
    for (std::uint32_t b : {1u, 0x7FFFFFu, 0x7F7FFFFFu, 0xFF7FFFFFu, 0x80000001u}) { // denormals, 2^128
        const SinCos a = sincos_degrees({b});
        const long double length =
            std::hypot(static_cast<long double>(a.sin), static_cast<long double>(a.cos));
        EXPECT_NEAR(static_cast<double>(std::ldexp(length, -60)), 1.0, 1e-16);
    }
}

} // namespace
