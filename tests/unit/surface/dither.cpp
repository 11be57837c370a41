// Tests dithering (GL 1.3, 4.1.8) of every value at every threshold: floor(steps + t) is one of the two codes
// around the value, and a value that is a code stays.
#include <gtest/gtest.h>

#include "raster/surface/narrow.hpp"
#include "raster/surface/quantize.hpp"

namespace spangle::raster {
namespace {

template <unsigned Bits> void of_bytes() {
    constexpr std::uint32_t most = (1u << Bits) - 1;
    for (std::uint32_t k = 0; k < 256; ++k)
        for (std::uint32_t t = 1; t < 32; t += 2) {
            const std::uint32_t got = dithered_step<Bits, 255>(k, t);
            ASSERT_EQ(got, (32 * k * most + t * 255) / (32 * 255)) << Bits << ' ' << k << ' ' << t;
            const std::uint32_t low = k * most / 255;
            ASSERT_TRUE(got == low || (got == low + 1 && k * most % 255 != 0))
                << Bits << ' ' << k << ' ' << t;
        }
}

TEST(Dither, OfBytesToOneUpToFourBits) {
    of_bytes<1>();
    of_bytes<2>();
    of_bytes<3>();
    of_bytes<4>();
}

/// A product and a sum are monotonic: if two colours have the same code, so has every colour between them. So
/// the borders stand for all 2^28 colours.
template <unsigned Bits> void of_colors() {
    constexpr std::uint64_t most = (1u << Bits) - 1;
    for (std::uint32_t t = 1; t < 32; t += 2) {
        ASSERT_EQ(dithered<Bits>(0, t), 0u);
        ASSERT_EQ(dithered<Bits>(color_one, t), most);
        for (std::uint64_t code = 1; code <= most; ++code) {
            // The least colour with this code satisfies c most / one + t / 32 >= code.
            const std::uint64_t c = ((32 * code - t) * color_one + 32 * most - 1) / (32 * most);
            ASSERT_EQ(dithered<Bits>(static_cast<std::uint32_t>(c), t), code) << t;
            // Rounding the factor up may change one unit of 2^-28.
            ASSERT_EQ(dithered<Bits>(static_cast<std::uint32_t>(c - 2), t), code - 1) << t;
        }
    }
}

TEST(Dither, OfColorsToFiveAndSixBits) {
    of_colors<5>();
    of_colors<6>();
}

/// Tests each component alone, and grey by its luma in whole tenths. Without dithering the top bits are
/// stored.
TEST(Dither, EveryColorOfTheNarrowFormats) {
    for (std::uint32_t n = 0; n < 1u << 24; ++n) {
        const Rgb8 c = {n & 255, n >> 8 & 255, n >> 16};
        const std::uint32_t gray = (3 * c.r + 6 * c.g + c.b) / 10, t = (n * 7 & 15) * 2 + 1;
        const auto step = [t](std::uint32_t k, std::uint32_t most) {
            return (32 * k * most + t * 255) / (32 * 255);
        };
        ASSERT_EQ(narrow_word(PixelFormat::grey4, c, true, t), step(gray, 15)) << n;
        ASSERT_EQ(narrow_word(PixelFormat::mono, c, true, t), step(gray, 1)) << n;
        ASSERT_EQ(narrow_word(PixelFormat::grey4, c, false, t), gray >> 4) << n;
        ASSERT_EQ(narrow_word(PixelFormat::mono, c, false, t), gray >> 7) << n;
        if ((n & 15) != 0)
            continue;
        ASSERT_EQ(narrow_word(PixelFormat::rgb444, c, true, t),
                  step(c.r, 15) << 8 | step(c.g, 15) << 4 | step(c.b, 15));
        ASSERT_EQ(narrow_word(PixelFormat::rgb332, c, true, t),
                  step(c.r, 7) << 5 | step(c.g, 7) << 2 | step(c.b, 3));
        ASSERT_EQ(narrow_word(PixelFormat::rgb444, c, false, t),
                  (c.r >> 4) << 8 | (c.g >> 4) << 4 | c.b >> 4);
        ASSERT_EQ(narrow_word(PixelFormat::rgb332, c, false, t),
                  (c.r >> 5) << 5 | (c.g >> 5) << 2 | c.b >> 6);
    }
}

} // namespace
} // namespace spangle::raster
