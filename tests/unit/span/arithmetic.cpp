// Tests products, sums and interpolations of 8-bit components, and texels, for all their values.
#include <gtest/gtest.h>

#include <cmath>
#include <iterator>

#include "raster/ops/number.hpp"
#include "raster/ops/texel.hpp"
#include "tests/support/random.hpp"

namespace spangle::raster::test {
namespace {

using B = Balanced<1>;

TEST(Products, OfTwoBytesAreNearest) {
    for (std::uint32_t a = 0; a < 256; ++a)
        for (std::uint32_t b = 0; b < 256; ++b) {
            ASSERT_EQ(Exact::to8(Exact::mul(Exact::from8(a), Exact::from8(b))), (2 * a * b + 255) / 510)
                << a << ' ' << b;
            const double off = B::mul(B::from8(a), B::from8(b)) - 256.0 * a * b / 255; // in 256ths of a 255th
            ASSERT_LE(off, 0) << a << ' ' << b;
            ASSERT_GE(off, -2) << a << ' ' << b;
        }
}

TEST(Products, OfFractions) {
    for (std::uint32_t a = 0; a <= color_one; a += 255) {
        ASSERT_EQ(Exact::mul(a, Exact::one), a);
        ASSERT_EQ(Exact::mul(a, 0), 0u);
    }
    for (std::uint32_t a = 0; a <= B::one; ++a)
        ASSERT_EQ(B::mul(a, 0), 0u);
    for (std::uint32_t a = 0; a <= B::one; a += 7)
        for (std::uint32_t b = 0; b <= B::one; b += 13)
            ASSERT_NEAR(B::mul(a, b), a * static_cast<double>(b) / B::one - 1.5, 1.5) << a << ' ' << b;
}

TEST(Sums, OfTwoBytes) {
    for (std::uint32_t a = 0; a < 256; ++a)
        for (std::uint32_t b = 0; b < 256; ++b) {
            const std::uint32_t sum = std::min(a + b, 255u), rest = a > b ? a - b : 0;
            ASSERT_EQ(Exact::add(Exact::from8(a), Exact::from8(b)), Exact::from8(sum));
            ASSERT_EQ(Exact::subtract(Exact::from8(a), Exact::from8(b)), Exact::from8(rest));
            ASSERT_EQ(B::add(B::from8(a), B::from8(b)), B::from8(sum));
            ASSERT_EQ(B::subtract(B::from8(a), B::from8(b)), B::from8(rest));
        }
}

/// a (1 - k) + b k of all 2^24 combinations of three bytes is the nearest byte.
TEST(Interpolations, OfThreeBytesAreNearest) {
    double least = 0, most = 0;
    for (std::uint32_t a = 0; a < 256; ++a)
        for (std::uint32_t b = 0; b < 256; ++b)
            for (std::uint32_t k = 0; k < 256; ++k) {
                const std::uint32_t exact = a * (255 - k) + b * k; // in 65025ths
                ASSERT_EQ(Exact::to8(Exact::lerp(Exact::from8(a), Exact::from8(b), Exact::from8(k))),
                          (2 * exact + 255) / 510)
                    << a << ' ' << b << ' ' << k;
                const double off = B::lerp(B::from8(a), B::from8(b), B::from8(k)) - 256.0 * exact / 255;
                least = std::fmin(least, off);
                most = std::fmax(most, off);
            }
    EXPECT_GE(least, -3); // in 256ths: each of two products is rounded down
    EXPECT_LE(most, 0);
}

TEST(Components, ComeBackFromBothNumbers) {
    for (std::uint32_t k = 0; k < 256; ++k) {
        ASSERT_EQ(Exact::to8(Exact::from8(k)), k);
        ASSERT_EQ(B::to8(B::from8(k)), k);
        ASSERT_EQ(B::from_units(Exact::from8(k)), B::from8(k));
    }
    for (std::uint32_t k = 0; k < 64; ++k) {
        const std::uint32_t k5 = k & 31;
        ASSERT_NEAR(Exact::from5(k5), color_one * (k5 / 31.0), 0.5);
        ASSERT_NEAR(Exact::from6(k), color_one * (k / 63.0), 0.5);
        ASSERT_NEAR(B::from5(k5), B::one * (k5 / 31.0), 256 / 50.0);
        ASSERT_NEAR(B::from6(k), B::one * (k / 63.0), 256 / 50.0);
        ASSERT_EQ(Exact::to8(Exact::from5(k5)) >> 3, k5);
        ASSERT_EQ(B::to8(B::from6(k)) >> 2, k);
    }
}

/// Reads texels of every 16-bit code of every format. Each component must be within `bound` of its fraction
/// of one.
template <class N> void texels_of_words(double bound) {
    const auto near = [bound](std::uint32_t got, double k, double most) {
        ASSERT_NEAR(got, N::one * (k / most), bound) << k << " of " << most;
    };
    for (std::uint32_t w = 0; w < 0x10000; ++w) {
        std::uint8_t bytes[4] = {};
        const auto half = static_cast<std::uint16_t>(w);
        std::memcpy(bytes, &half, 2);
        const auto c565 = read_texel<N>(TexelFormat::rgb565, bytes);
        near(c565.r, w >> 11, 31), near(c565.g, w >> 5 & 63, 63), near(c565.b, w & 31, 31),
            near(c565.a, 1, 1);
        const auto c4 = read_texel<N>(TexelFormat::rgba4444, bytes);
        near(c4.r, w >> 12, 15), near(c4.g, w >> 8 & 15, 15), near(c4.b, w >> 4 & 15, 15),
            near(c4.a, w & 15, 15);
        const auto c5 = read_texel<N>(TexelFormat::rgba5551, bytes);
        near(c5.r, w >> 11, 31), near(c5.g, w >> 6 & 31, 31), near(c5.b, w >> 1 & 31, 31),
            near(c5.a, w & 1, 1);
        const auto z = read_texel<N>(TexelFormat::z16, bytes);
        near(z.r, w, 65535), near(z.a, w, 65535);
    }
    for (std::uint32_t w = 0; w < 256; ++w) {
        const std::uint8_t bytes[4] = {static_cast<std::uint8_t>(w), static_cast<std::uint8_t>(255 - w),
                                       static_cast<std::uint8_t>(w ^ 0x5A),
                                       static_cast<std::uint8_t>(w ^ 0xA5)};
        const auto c3 = read_texel<N>(TexelFormat::rgb332, bytes);
        near(c3.r, w >> 5, 7), near(c3.g, w >> 2 & 7, 7), near(c3.b, w & 3, 3), near(c3.a, 1, 1);
        const auto l = read_texel<N>(TexelFormat::la88, bytes),
                   c8 = read_texel<N>(TexelFormat::rgba8888, bytes);
        const std::uint32_t got[] = {l.r,
                                     l.g,
                                     l.a,
                                     c8.r,
                                     c8.g,
                                     c8.b,
                                     c8.a,
                                     read_texel<N>(TexelFormat::a8, bytes).a,
                                     read_texel<N>(TexelFormat::l8, bytes).b,
                                     read_texel<N>(TexelFormat::i8, bytes).a,
                                     read_texel<N>(TexelFormat::rgb888, bytes).b};
        const std::uint32_t wanted[] = {w, w, 255 - w, w, 255 - w, w ^ 0x5A, w ^ 0xA5, w, w, w, w ^ 0x5A};
        for (std::size_t i = 0; i < std::size(got); ++i)
            ASSERT_EQ(got[i], N::from8(wanted[i])) << i;
    }
}

TEST(Components, OfEveryTexel) {
    texels_of_words<Exact>(1);
    texels_of_words<B>(256 / 50.0);
}

/// Builds without shortcuts read all axes as axes of any size (is_plain_axis()); both ways must find the same
/// texels.
void same_texels(Wrap wrap, std::uint32_t s, int log2_size) {
    const std::int32_t size = 1 << log2_size;
    ASSERT_EQ(general_nearest(wrap, s, size), wrapped_nearest(wrap, s, log2_size, size))
        << static_cast<int>(wrap) << ' ' << s << ' ' << size;
    const TexelIndex any = general_linear(wrap, s, size), plain = wrapped_linear(wrap, s, log2_size, size);
    ASSERT_EQ(any.weight, plain.weight) << static_cast<int>(wrap) << ' ' << s << ' ' << size;
    for (int next = 0; next < 2; ++next)
        ASSERT_EQ(wrap_texel(wrap, any.i + next, size), wrap_texel(wrap, plain.i + next, size))
            << static_cast<int>(wrap) << ' ' << s << ' ' << size;
}

TEST(Axes, OfPowersOfTwoAreThoseOfAnySize) {
    spangle::test::Random random{7};
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::clamp_to_edge, Wrap::clamp_to_border})
        for (int log2_size = 0; log2_size <= 12; ++log2_size) {
            const int texel = (wrap == Wrap::repeat ? 32 : clamped_coord_bits) - log2_size;
            for (int i = 0; i < 4000; ++i) {
                const std::uint32_t any = random.below(1u << 16) << 16 | random.below(1u << 16);
                same_texels(wrap, any, log2_size);
                for (std::uint32_t near = 0; near < 5; ++near) { // edges and middles of texels
                    const std::uint32_t half = any & (0u - (1u << (texel - 1)));
                    same_texels(wrap, half + near - 2, log2_size);
                    same_texels(wrap, half - (1u << (texel - 13 > 0 ? texel - 13 : 0)) + near - 2, log2_size);
                }
            }
        }
}

} // namespace
} // namespace spangle::raster::test
