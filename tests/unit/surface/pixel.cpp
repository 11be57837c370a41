// Tests quantization and read-back for all values where that is possible.
#include <gtest/gtest.h>

#include <cmath>

#include "raster/surface/pixel.hpp"
#include "raster/surface/quantize.hpp"

namespace spangle::raster {
namespace {

/// Rows of gl-commands 17.3: ubyte, five bits, six bits, both read back as ubytes.
TEST(Quantize, UbytesKeepTheirTopBits) {
    constexpr int rows[][5] = {{0, 0, 0, 0, 0},         {4, 0, 1, 0, 4},         {7, 0, 1, 0, 4},
                               {8, 1, 2, 8, 8},         {15, 1, 3, 8, 12},       {100, 12, 25, 99, 101},
                               {127, 15, 31, 123, 125}, {128, 16, 32, 132, 130}, {200, 25, 50, 206, 202},
                               {247, 30, 61, 247, 247}, {248, 31, 62, 255, 251}, {255, 31, 63, 255, 255}};
    for (const auto& row : rows) {
        const auto c = static_cast<std::uint32_t>(row[0]) << color_fraction_bits;
        EXPECT_EQ(truncated<5>(c), static_cast<std::uint32_t>(row[1]));
        EXPECT_EQ(truncated<6>(c), static_cast<std::uint32_t>(row[2]));
        EXPECT_EQ((Component{static_cast<std::uint8_t>(row[1]), 31}.to_8()), row[3]);
        EXPECT_EQ((Component{static_cast<std::uint8_t>(row[2]), 63}.to_8()), row[4]);
    }
}

TEST(Quantize, MatrixIsAPermutation) {
    unsigned seen = 0;
    for (int y = -4; y < 0; ++y)
        for (int x = 0; x < 4; ++x) {
            const std::uint32_t t = dither_threshold(dither_row(y), x);
            EXPECT_EQ(t & 1, 1u);
            seen |= 1u << (t / 2);
            EXPECT_EQ(t, dither_threshold(dither_row(y + 8), x - 4));
        }
    EXPECT_EQ(seen, 0xFFFFu);
}

template <unsigned Bits> void check_dither() {
    const double max = (1 << Bits) - 1;
    for (std::uint32_t k = 0; k <= (1u << Bits) - 1; ++k)
        for (std::uint32_t t = 1; t < 32; t += 2) { // exact values stay (4.1.8)
            const std::uint64_t scaled = std::uint64_t{k} * color_one;
            if (scaled % static_cast<std::uint32_t>(max) == 0) {
                EXPECT_EQ(
                    dithered<Bits>(static_cast<std::uint32_t>(scaled / static_cast<std::uint32_t>(max)), t),
                    k);
            }
        }
    for (std::uint32_t t = 1; t < 32; t += 2)
        for (std::uint32_t c = 0; c <= color_one; c += 997) {
            const double exact = static_cast<double>(c) / color_one * max;
            const std::uint32_t k = dithered<Bits>(c, t);
            const double want = exact + t / 32.0;
            if (std::fabs(want - std::floor(want + 0.5)) > 1e-6) {
                ASSERT_EQ(k, static_cast<std::uint32_t>(want)) << c << ' ' << t;
            }
            ASSERT_GE(k + 1.0, std::ceil(exact)); // { ceil(c) - 1, ceil(c) }, or c itself if it is whole
            ASSERT_LE(k, std::ceil(exact));
        }
}
TEST(Quantize, DitherIsFloorOfColourPlusThreshold) {
    check_dither<5>();
    check_dither<6>();
}

TEST(Pixel, EveryWordOf565ReadsBackItsBits) {
    std::uint8_t bytes[2];
    Surface s;
    s.color = bytes;
    s.width = s.height = 1;
    for (const bool big : {false, true}) {
        s.format = big ? PixelFormat::rgb565_be : PixelFormat::rgb565_le;
        for (std::uint32_t word = 0; word < 0x10000; ++word) {
            bytes[big ? 0 : 1] = static_cast<std::uint8_t>(word >> 8);
            bytes[big ? 1 : 0] = static_cast<std::uint8_t>(word);
            const StoredColor c = read_color(s, 0, 0);
            ASSERT_EQ(c.c[0], (Component{static_cast<std::uint8_t>(word >> 11), 31}));
            ASSERT_EQ(c.c[1], (Component{static_cast<std::uint8_t>(word >> 5 & 63), 63}));
            ASSERT_EQ(c.c[2], (Component{static_cast<std::uint8_t>(word & 31), 31}));
            ASSERT_EQ(c.c[3], (Component{1, 1}));
            const std::uint32_t k[4] = {word >> 11, word >> 5 & 63, word & 31, 0};
            bytes[0] = bytes[1] = 0;
            write_color(s, 0, 0, k);
            ASSERT_EQ(bytes[big ? 0 : 1], word >> 8);
            ASSERT_EQ(bytes[big ? 1 : 0], word & 0xFF);
        }
    }
}

TEST(Pixel, BytesInOrderAndMasks) {
    std::uint8_t bytes[8] = {};
    Surface s;
    s.color = bytes;
    s.width = 2;
    s.height = 1;
    s.format = PixelFormat::rgba8888;
    const std::uint32_t k[4] = {1, 2, 3, 4};
    write_color(s, 1, 0, k);
    EXPECT_EQ(bytes[3], 0);
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(bytes[4 + i], i + 1);
    StoredColor row[2];
    read_color_row(s, 0, 0, 2, row);
    EXPECT_EQ(row[1].c[3].k, 4);
    EXPECT_EQ(row[0].c[0].k, 0);
}

TEST(Units, DepthCodesAreNearestAndOneIsAllOnes) {
    EXPECT_EQ(depth_to_16(depth_one), 0xFFFFu);
    EXPECT_EQ(depth_to_24(depth_one), 0xFFFFFFu);
    for (std::uint64_t z = 0; z <= depth_one; z += 1237) {
        const double d = static_cast<double>(z) / depth_one;
        const auto v = static_cast<std::uint32_t>(z);
        ASSERT_NEAR(depth_to_16(v), d * 65535, 0.5001);
        ASSERT_NEAR(depth_to_24(v), d * 16777215, 0.52);
    }
}

TEST(Pixel, DepthAndStencilShareAWord) {
    std::uint32_t word = 0xABCDEF12;
    Surface s;
    s.depth = reinterpret_cast<std::uint8_t*>(&word);
    s.width = s.height = 1;
    s.depth_format = DepthFormat::z24s8;
    EXPECT_EQ(read_depth(s, 0, 0).k, 0xABCDEFu);
    EXPECT_EQ(read_stencil(s, 0, 0), 0x12);
    write_stencil(s, 0, 0, 0x9A);
    EXPECT_EQ(word, 0xABCDEF9Au);
}

} // namespace
} // namespace spangle::raster
