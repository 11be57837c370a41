// Tests the wire pixels that a present makes of a surface: every value by the formula in doubles, every
// packing by hand.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <spangle/hal/wire.hpp>

/// GoogleTest prints formats with this function.
namespace spangle {
static void PrintTo(PixelFormat format, std::ostream* out) {
    const char* const names[] = {"rgb565_be", "rgb565_le", "rgb888", "rgba8888"};
    *out << names[static_cast<int>(format)];
}
} // namespace spangle

using namespace spangle;
using namespace spangle::hal;

namespace {

/// Returns the threshold t = (k + 1/2) / 16 of the ordered dither matrix. x and y are a column and row of the
/// window, from the bottom.
double threshold(int x, int y) {
    constexpr int k[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    return (k[y & 3][x & 3] + 0.5) / 16;
}

unsigned steps(double c, unsigned bits, double t) {
    return static_cast<unsigned>(std::floor(c * ((1u << bits) - 1) + t + 1e-9));
}

struct Surface {
    int width, height;
    PixelFormat format;
    std::vector<std::uint8_t> bytes;

    Surface(int w, int h, PixelFormat f)
        : width(w), height(h), format(f),
          bytes(static_cast<std::size_t>(w * h) * format_info(f).bytes_per_pixel) {
        unsigned noise = 7;
        for (std::uint8_t& b : bytes)
            b = static_cast<std::uint8_t>((noise = noise * 1664525u + 1013904223u) >> 24);
    }
    int stride() const { return width * format_info(format).bytes_per_pixel; }
    Picture picture(bool sideways = false) const {
        return {bytes.data(), stride(), height, format, sideways};
    }
    struct Color {
        double c[3];
    };
    Color at(int x, int y) const {
        const std::uint8_t* const p =
            &bytes[static_cast<std::size_t>(y * stride() + x * format_info(format).bytes_per_pixel)];
        if (format == PixelFormat::rgb888 || format == PixelFormat::rgba8888)
            return {{p[0] / 255.0, p[1] / 255.0, p[2] / 255.0}};
        const int word = format == PixelFormat::rgb565_be ? p[0] << 8 | p[1] : p[1] << 8 | p[0];
        return {{(word >> 11) / 31.0, (word >> 5 & 63) / 63.0, (word & 31) / 31.0}};
    }
    unsigned grey(int x, int y, unsigned bits) const {
        const Color c = at(x, y);
        const auto eight = [&](int i) { return static_cast<int>(std::floor(c.c[i] * 255 + 0.5)); };
        return steps(((3 * eight(0) + 6 * eight(1) + eight(2)) / 10) / 255.0, bits,
                     threshold(x, height - 1 - y));
    }
    std::vector<unsigned> components(int x, int y, std::initializer_list<unsigned> bits) const {
        const Color c = at(x, y);
        std::vector<unsigned> out;
        for (const unsigned b : bits)
            out.push_back(steps(c.c[out.size()], b, threshold(x, height - 1 - y)));
        return out;
    }
};

std::vector<std::uint8_t> converted(const Wire& wire, const Picture& picture, const Rect& area) {
    std::vector<std::uint8_t> out(static_cast<std::size_t>(area.w * area.h * 3 + 8), 0xEE);
    const std::size_t bytes = wire.convert(picture, area, out.data());
    EXPECT_LE(bytes, out.size() - 8);
    for (std::size_t i = bytes; i < out.size(); ++i)
        EXPECT_EQ(out[i], 0xEE) << "a byte too many";
    out.resize(bytes);
    return out;
}

class Wires : public testing::TestWithParam<PixelFormat> {};

std::vector<std::uint8_t> bytes_of(std::initializer_list<unsigned> values) {
    std::vector<std::uint8_t> out;
    for (const unsigned v : values)
        out.push_back(static_cast<std::uint8_t>(v));
    return out;
}

/// Each pixel is compared by itself, over all positions of the matrix and both ends of the range.
TEST_P(Wires, EveryPixelIsDitheredToItsSteps) {
    Surface s(67, 41, GetParam());
    for (std::size_t i = 0; i < 64; ++i)
        s.bytes[i] = i < 32 ? 0 : 255;
    for (int y = 0; y < s.height; ++y)
        for (int x = 0; x < s.width; ++x) {
            const Rect one{x, y, 1, 1};
            auto c = s.components(x, y, {5, 6, 5});
            ASSERT_EQ(converted(wires::rgb565, s.picture(), one),
                      bytes_of({c[0] << 3 | c[1] >> 3, (c[1] & 7) << 5 | c[2]}));
            c = s.components(x, y, {6, 6, 6});
            ASSERT_EQ(converted(wires::rgb666, s.picture(), one),
                      bytes_of({c[0] << 2, c[1] << 2, c[2] << 2}));
            c = s.components(x, y, {4, 4, 4});
            ASSERT_EQ(converted(wires::rgb444, s.picture(), one), bytes_of({c[0] << 4 | c[1], c[2] << 4}));
            c = s.components(x, y, {3, 3, 2});
            ASSERT_EQ(converted(wires::rgb332, s.picture(), one), bytes_of({c[0] << 5 | c[1] << 2 | c[2]}));
        }
}

TEST_P(Wires, PixelsThatShareABytePackInOrder) {
    const Surface s(16, 24, GetParam());
    for (const bool sideways : {false, true}) {
        const Rect area{8, 8, 8, 16};
        std::vector<std::uint8_t> mono, grey;
        for (int y = area.y; y < area.y + area.h; y += sideways ? 1 : 8)
            for (int x = area.x; x < area.x + area.w; x += sideways ? 8 : 1) {
                unsigned byte = 0;
                for (int i = 0; i < 8; ++i)
                    byte |= s.grey(sideways ? x + i : x, sideways ? y : y + i, 1) << i;
                mono.push_back(static_cast<std::uint8_t>(byte));
            }
        for (int y = area.y; y < area.y + area.h; y += sideways ? 2 : 1)
            for (int x = area.x; x < area.x + area.w; x += sideways ? 1 : 2)
                grey.push_back(static_cast<std::uint8_t>(
                    s.grey(x, y, 4) << 4 | s.grey(sideways ? x : x + 1, sideways ? y + 1 : y, 4)));
        EXPECT_EQ(converted(wires::mono, s.picture(sideways), area), mono);
        EXPECT_EQ(converted(wires::grey4, s.picture(sideways), area), grey);
    }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, Wires,
                         testing::Values(PixelFormat::rgb565_be, PixelFormat::rgb565_le, PixelFormat::rgb888,
                                         PixelFormat::rgba8888));

TEST(Wire, TwelveBitPixelsRunOnAcrossRows) {
    const Surface s(9, 6, PixelFormat::rgb888);
    const Rect area{2, 1, 5, 3}; // fifteen pixels take 23 bytes
    std::vector<unsigned> nibbles;
    for (int y = area.y; y < area.y + area.h; ++y)
        for (int x = area.x; x < area.x + area.w; ++x)
            for (const unsigned c : s.components(x, y, {4, 4, 4}))
                nibbles.push_back(c);
    nibbles.push_back(0);
    std::vector<std::uint8_t> expected;
    for (std::size_t i = 0; i < nibbles.size(); i += 2)
        expected.push_back(static_cast<std::uint8_t>(nibbles[i] << 4 | nibbles[i + 1]));
    EXPECT_EQ(converted(wires::rgb444, s.picture(), area), expected);
}

TEST(Wire, WhatASurfaceHoldsExactlyStays) {
    Surface s(64, 4, PixelFormat::rgb565_be);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 64; ++x) {
            const unsigned word = static_cast<unsigned>(x / 2) << 11 | static_cast<unsigned>(x) << 5 |
                                  static_cast<unsigned>(x / 2);
            s.bytes[static_cast<std::size_t>(y * 128 + 2 * x)] = static_cast<std::uint8_t>(word >> 8);
            s.bytes[static_cast<std::size_t>(y * 128 + 2 * x + 1)] = static_cast<std::uint8_t>(word);
        }
    EXPECT_EQ(converted(wires::rgb565, s.picture(), {0, 0, 64, 4}), s.bytes);
    const auto wide = converted(wires::rgb666, s.picture(), {0, 0, 64, 4});
    for (std::size_t i = 0; i < 256; ++i)
        EXPECT_EQ(wide[3 * i + 1] >> 2, static_cast<int>(i % 64));
}

/// A flat grey lights as many pixels as it is bright, in seventeen steps of a 4x4 cell.
TEST(Wire, OneBitGreysHaveSeventeenSteps) {
    Surface s(4, 8, PixelFormat::rgb888);
    for (int grey = 0; grey < 256; ++grey) {
        s.bytes.assign(s.bytes.size(), static_cast<std::uint8_t>(grey));
        int set = 0;
        for (const std::uint8_t byte : converted(wires::mono, s.picture(), {0, 0, 4, 8}))
            set += __builtin_popcount(byte);
        EXPECT_NEAR(set / 32.0, grey / 255.0, 1.0 / 32 + 1e-9) << grey;
    }
}

#if SPANGLE_FEATURE_COLOR_INDEX
/// Indices are sent as a surface of their colours would be.
TEST(Wire, IndicesAreLookedUp) {
    const Surface indices(24, 16, PixelFormat::index8);
    Surface colors(24, 16, PixelFormat::rgb888);
    Palette palette{};
    unsigned noise = 99;
    for (auto& color : palette.color)
        for (std::uint8_t& c : color)
            c = static_cast<std::uint8_t>((noise = noise * 1664525u + 1013904223u) >> 24);
    for (std::size_t i = 0; i < indices.bytes.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            colors.bytes[3 * i + c] = palette.color[indices.bytes[i]][c];
    const Rect area{4, 8, 12, 8};
    for (const Wire& wire :
         {wires::rgb565, wires::rgb666, wires::rgb444, wires::rgb332, wires::grey4, wires::mono}) {
        Picture picture = indices.picture();
        picture.palette = &palette;
        EXPECT_EQ(converted(wire, picture, area), converted(wire, colors.picture(), area))
            << int(wire.format);
    }
}

/// The initial palette is RRRGGGBB: every index has another colour, and both ends of the range occur.
TEST(Wire, InitialColoursAreTheBitsOfTheIndex) {
    for (int i = 0; i < 256; ++i) {
        const Rgb color = initial_color(i);
        const std::uint8_t* const c = color.c;
        EXPECT_EQ(c[0], static_cast<int>((i >> 5) / 7.0 * 255 + 0.5)) << i;
        EXPECT_EQ(c[1], static_cast<int>((i >> 2 & 7) / 7.0 * 255 + 0.5)) << i;
        EXPECT_EQ(c[2], static_cast<int>((i & 3) / 3.0 * 255 + 0.5)) << i;
    }
}
#endif

TEST(Wire, OnlyBytesOfEqualLayoutAreTheSame) {
    EXPECT_EQ(same_bytes(PixelFormat::rgb565_be), WireFormat::rgb565);
    EXPECT_EQ(same_bytes(PixelFormat::rgb888), WireFormat::rgb666);
    EXPECT_EQ(same_bytes(PixelFormat::rgb565_le), WireFormat::none);
    EXPECT_EQ(same_bytes(PixelFormat::rgba8888), WireFormat::none);
    EXPECT_EQ(wire_info(WireFormat::rgb444).bits, 12);
    EXPECT_EQ(wire_info(WireFormat::none).bits, 0);
}

} // namespace
