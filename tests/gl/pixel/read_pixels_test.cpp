// Compares ReadPixels with values that are computed here from the text of GL 1.3, 4.3.2 (docs/features.md
// E01, E02, E07, 17.3).
#include <gtest/gtest.h>

#include <bit>
#include <climits>
#include <cmath>
#include <cstring>
#include <random>

#include "gl/api/generated/commands.hpp"
#include "tests/gl/pixel/bare_context.hpp"

namespace spangle::gl {
namespace {

using test::BareContext;
using test::SharedMemory;

void fill_random(BareContext& bare, unsigned seed) {
    std::mt19937 random(seed);
    for (auto& byte : bare.color)
        byte = static_cast<std::uint8_t>(random());
    for (auto& byte : bare.planes)
        byte = static_cast<std::uint8_t>(random());
}

/// R, G, B and A of a pixel, from 0 to 1.
struct Rgba {
    double v[4];
};
Rgba color_at(const BareContext& bare, int x, int y) {
    const raster::Surface& s = bare.context.drawable.surface;
    const unsigned bytes = format_info(s.format).bytes_per_pixel;
    const std::uint8_t* p =
        &bare.color[static_cast<std::size_t>(y) * static_cast<std::size_t>(s.width) * bytes +
                    static_cast<std::size_t>(x) * bytes];
    switch (s.format) {
    case PixelFormat::rgb565_be:
    case PixelFormat::rgb565_le: {
        const unsigned word = s.format == PixelFormat::rgb565_be ? p[0] * 256u + p[1] : p[1] * 256u + p[0];
        return {{(word >> 11) / 31.0, (word >> 5 & 63) / 63.0, (word & 31) / 31.0, 1.0}};
    }
    case PixelFormat::rgb888:
        return {{p[0] / 255.0, p[1] / 255.0, p[2] / 255.0, 1.0}};
    default:
        return {{p[0] / 255.0, p[1] / 255.0, p[2] / 255.0, p[3] / 255.0}};
    }
}

constexpr PixelFormat surfaces[] = {PixelFormat::rgb565_be, PixelFormat::rgb565_le, PixelFormat::rgb888,
                                    PixelFormat::rgba8888};

/// A format and which of R, G, B, A (0 to 3) each component is; 4 is luminance.
struct FormatCase {
    GLenum format;
    std::vector<int> components;
};
const FormatCase formats[] = {{GL_RED, {0}},           {GL_GREEN, {1}},
                              {GL_BLUE, {2}},          {GL_ALPHA, {3}},
                              {GL_RGB, {0, 1, 2}},     {GL_BGR, {2, 1, 0}},
                              {GL_RGBA, {0, 1, 2, 3}}, {GL_BGRA, {2, 1, 0, 3}},
                              {GL_LUMINANCE, {4}},     {GL_LUMINANCE_ALPHA, {4, 3}}};

double component(const Rgba& c, int which) {
    return which < 4 ? c.v[which] : std::fmin(1, c.v[0] + c.v[1] + c.v[2]);
}

template <class T> T element(const std::vector<unsigned char>& bytes, std::size_t index) {
    T v;
    std::memcpy(&v, &bytes[index * sizeof(T)], sizeof(T));
    return v;
}

/// Reads the whole surface as T, and compares each element with `wanted(f)` to within `slack`.
template <class T, class Wanted> void compare_all(GLenum type, double slack, Wanted wanted) {
    for (PixelFormat surface : surfaces) {
        SharedMemory memory(1 << 16);
        BareContext bare(memory, surface);
        fill_random(bare, static_cast<unsigned>(surface) + 7);
        bare.context.pixel_store.pack.alignment = 1;
        for (const FormatCase& f : formats) {
            const std::size_t n = f.components.size();
            std::vector<unsigned char> out(8 * 6 * n * sizeof(T) + 1, 0xCD);
            cmd::ReadPixels(bare.context, 0, 0, 8, 6, f.format, type, out.data());
            ASSERT_EQ(bare.take_error(), GLenum{GL_NO_ERROR});
            EXPECT_EQ(out.back(), 0xCD);
            for (int i = 0; i < 8 * 6; ++i)
                for (std::size_t k = 0; k < n; ++k) {
                    const double f01 = component(color_at(bare, i % 8, i / 8), f.components[k]);
                    // Luminance is summed in 32 bits, with three roundings of 2^-33.
                    const double extra = f.components[k] < 4        ? 0
                                         : std::is_same_v<T, float> ? 6e-8
                                                                    : 1.5 * (sizeof(T) == 4);
                    const T got = element<T>(out, static_cast<std::size_t>(i) * n + k);
                    ASSERT_LE(std::fabs(static_cast<double>(got) - wanted(f01)), slack + extra)
                        << std::hex << f.format << " " << type << std::dec << " pixel " << i << " f " << f01;
                }
        }
    }
}

TEST(ReadPixels, EveryFormatAndPlainType) {
    const auto nearest = [](double max) { return [max](double f) { return f * max; }; };
    const auto halved = [](double max) { return [max](double f) { return (f * max - 1) / 2; }; };
    compare_all<std::uint8_t>(GL_UNSIGNED_BYTE, 0.5001, nearest(255));
    compare_all<std::uint16_t>(GL_UNSIGNED_SHORT, 0.5001, nearest(65535));
    compare_all<std::uint32_t>(GL_UNSIGNED_INT, 0.5001, nearest(4294967295.0));
    compare_all<std::int8_t>(GL_BYTE, 0.5001, halved(255));
    compare_all<std::int16_t>(GL_SHORT, 0.5001, halved(65535));
    compare_all<std::int32_t>(GL_INT, 0.5001, halved(4294967295.0));
    compare_all<float>(GL_FLOAT, 0, [](double f) { return static_cast<double>(static_cast<float>(f)); });
}

TEST(ReadPixels, SixteenBitReadBackIsTheStoredPixel) {
    SharedMemory memory(1 << 16);
    for (PixelFormat surface : {PixelFormat::rgb565_be, PixelFormat::rgb565_le}) {
        BareContext bare(memory, surface);
        fill_random(bare, 3);
        std::uint16_t out[48];
        cmd::ReadPixels(bare.context, 0, 0, 8, 6, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, out);
        for (std::size_t i = 0; i < 48; ++i) {
            const unsigned first = bare.color[2 * i], second = bare.color[2 * i + 1];
            EXPECT_EQ(out[i], surface == PixelFormat::rgb565_be ? first << 8 | second : second << 8 | first);
        }
    }
}

TEST(ReadPixels, NegativeStridesReadBottomRowFirst) {
    SharedMemory memory(1 << 16);
    BareContext bare(memory, PixelFormat::rgba8888);
    fill_random(bare, 4);
    raster::Surface& s = bare.context.drawable.read; // stored top row first, as displays are
    s.color = &bare.color[5 * 8 * 4];
    s.color_stride = -8 * 4;
    unsigned char out[8 * 4];
    cmd::ReadPixels(bare.context, 0, 1, 8, 1, GL_RGBA, GL_UNSIGNED_BYTE, out);
    EXPECT_EQ(std::memcmp(out, &bare.color[4 * 8 * 4], sizeof out), 0);
}

TEST(ReadPixels, PackModesPlaceRows) {
    SharedMemory memory(1 << 16);
    BareContext bare(memory, PixelFormat::rgb888);
    fill_random(bare, 5);
    PixelStore& pack = bare.context.pixel_store.pack;
    pack.row_length = 7;
    pack.alignment = 8;
    pack.skip_rows = 2;
    pack.skip_pixels = 1;
    std::vector<unsigned char> out(24 * 6, 0xEE), wanted = out;
    cmd::ReadPixels(bare.context, 1, 2, 5, 3, GL_RGB, GL_UNSIGNED_BYTE, out.data());
    for (std::size_t y = 0; y < 3; ++y) // rows of 21 bytes are padded to 24
        std::memcpy(&wanted[(y + 2) * 24 + 3], &bare.color[((y + 2) * 8 + 1) * 3], 15);
    EXPECT_EQ(out, wanted);
}

TEST(ReadPixels, SwapBytesReversesElements) {
    SharedMemory memory(1 << 16);
    BareContext bare(memory);
    fill_random(bare, 6);
    std::uint32_t straight[48 * 4], swapped[48 * 4];
    for (GLenum type : {GL_FLOAT, GL_UNSIGNED_INT, GL_INT}) {
        bare.context.pixel_store.pack.swap_bytes = false;
        cmd::ReadPixels(bare.context, 0, 0, 8, 6, GL_RGBA, type, straight);
        bare.context.pixel_store.pack.swap_bytes = true;
        cmd::ReadPixels(bare.context, 0, 0, 8, 6, GL_RGBA, type, swapped);
        for (int i = 0; i < 48 * 4; ++i)
            ASSERT_EQ(swapped[i], __builtin_bswap32(straight[i]));
    }
}

TEST(ReadPixels, OutsideTheSurfaceNothingIsWritten) {
    SharedMemory memory(1 << 16);
    BareContext bare(memory);
    fill_random(bare, 8);
    std::vector<std::uint32_t> out(12 * 10, 0xDEADBEEF);
    cmd::ReadPixels(bare.context, -2, -3, 12, 10, GL_RGBA, GL_UNSIGNED_BYTE, out.data());
    ASSERT_EQ(bare.take_error(), GLenum{GL_NO_ERROR});
    for (int y = -3; y < 7; ++y)
        for (int x = -2; x < 10; ++x) {
            const bool inside = x >= 0 && x < 8 && y >= 0 && y < 6;
            std::uint32_t wanted = 0xDEADBEEF;
            if (inside)
                std::memcpy(&wanted, &bare.color[static_cast<std::size_t>(y * 8 + x) * 4], 4);
            ASSERT_EQ(out[static_cast<std::size_t>((y + 3) * 12 + x + 2)], wanted) << x << " " << y;
        }
    std::uint32_t one = 1;
    for (GLint far : {INT_MIN, INT_MAX, -1, 8}) {
        cmd::ReadPixels(bare.context, far, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &one);
        cmd::ReadPixels(bare.context, 0, far, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &one);
    }
    cmd::ReadPixels(bare.context, INT_MIN, INT_MIN, INT_MAX, INT_MAX, GL_RGBA, GL_UNSIGNED_BYTE, &one);
    cmd::ReadPixels(bare.context, INT_MAX, INT_MAX, INT_MAX, INT_MAX, GL_RGBA, GL_UNSIGNED_BYTE, &one);
    cmd::ReadPixels(bare.context, 0, 0, 0, 5, GL_RGBA, GL_UNSIGNED_BYTE, &one);
    EXPECT_EQ(one, 1u);
    EXPECT_EQ(bare.take_error(), GLenum{GL_NO_ERROR});
}

TEST(ReadPixels, DepthOfBothFormats) {
    SharedMemory memory(1 << 16);
    for (DepthFormat depth : {DepthFormat::z16, DepthFormat::z24s8}) {
        BareContext bare(memory, PixelFormat::rgb565_be, depth);
        fill_random(bare, 9);
        std::vector<float> real(48);
        std::vector<std::uint32_t> whole(48);
        std::vector<std::uint16_t> half(48);
        cmd::ReadPixels(bare.context, 0, 0, 8, 6, GL_DEPTH_COMPONENT, GL_FLOAT, real.data());
        cmd::ReadPixels(bare.context, 0, 0, 8, 6, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, whole.data());
        cmd::ReadPixels(bare.context, 0, 0, 8, 6, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, half.data());
        ASSERT_EQ(bare.take_error(), GLenum{GL_NO_ERROR});
        for (std::size_t i = 0; i < 48; ++i) {
            std::uint32_t word = 0;
            std::memcpy(&word, &bare.planes[i * (depth == DepthFormat::z16 ? 2 : 4)],
                        depth == DepthFormat::z16 ? 2 : 4);
            const double z = depth == DepthFormat::z16 ? word / 65535.0 : (word >> 8) / 16777215.0;
            EXPECT_EQ(real[i], static_cast<float>(z));
            EXPECT_LE(std::fabs(whole[i] - z * 4294967295.0), 0.5001);
            EXPECT_LE(std::fabs(half[i] - z * 65535.0), 0.5001);
        }
    }
}

TEST(ReadPixels, StencilTypesAndMasks) {
    SharedMemory memory(1 << 16);
    BareContext bare(memory);
    fill_random(bare, 10);
    const auto index = [&](std::size_t i) {
        std::uint32_t word;
        std::memcpy(&word, &bare.planes[i * 4], 4);
        return word & 0xFF;
    };
    std::vector<std::uint8_t> bytes(48);
    std::vector<std::int8_t> signed_bytes(48);
    std::vector<std::int32_t> ints(48);
    std::vector<float> floats(48);
    cmd::ReadPixels(bare.context, 0, 0, 8, 6, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, bytes.data());
    cmd::ReadPixels(bare.context, 0, 0, 8, 6, GL_STENCIL_INDEX, GL_BYTE, signed_bytes.data());
    cmd::ReadPixels(bare.context, 0, 0, 8, 6, GL_STENCIL_INDEX, GL_INT, ints.data());
    cmd::ReadPixels(bare.context, 0, 0, 8, 6, GL_STENCIL_INDEX, GL_FLOAT, floats.data());
    for (std::size_t i = 0; i < 48; ++i) {
        EXPECT_EQ(bytes[i], index(i));
        EXPECT_EQ(signed_bytes[i], static_cast<int>(index(i) & 127));
        EXPECT_EQ(ints[i], static_cast<int>(index(i)));
        EXPECT_EQ(floats[i], static_cast<float>(index(i)));
    }
    for (bool lsb_first : {false, true}) {
        PixelStore& pack = bare.context.pixel_store.pack;
        pack = {};
        pack.lsb_first = lsb_first;
        pack.alignment = 2;
        pack.skip_pixels = 5;
        std::vector<unsigned char> bits(12, 0x5A), wanted = bits;
        cmd::ReadPixels(bare.context, 0, 0, 8, 6, GL_STENCIL_INDEX, GL_BITMAP, bits.data());
        for (std::size_t i = 0; i < 48; ++i) {
            const std::size_t bit = 5 + i % 8;
            unsigned char& byte = wanted[i / 8 * 2 + bit / 8];
            const unsigned mask = lsb_first ? 1u << bit % 8 : 0x80u >> bit % 8;
            byte = static_cast<unsigned char>((index(i) & 1) != 0 ? byte | mask : byte & ~mask);
        }
        EXPECT_EQ(bits, wanted) << lsb_first;
    }
    EXPECT_EQ(bare.take_error(), GLenum{GL_NO_ERROR});
}

TEST(ReadPixels, Errors) {
    SharedMemory memory(1 << 16);
    BareContext full(memory), no_stencil(memory, PixelFormat::rgb565_be, DepthFormat::z16),
        bare_color(memory, PixelFormat::rgb565_be, DepthFormat::none);
    std::uint32_t out = 0x12345678;
    struct Case {
        BareContext* context;
        GLsizei width, height;
        GLenum format, type;
        GLenum wanted;
    };
    const Case cases[] = {
        {&full, -1, 1, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {&full, 1, -1, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {&full, 1, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, GL_INVALID_OPERATION},
        {&full, 1, 1, 0, GL_UNSIGNED_BYTE, GL_INVALID_ENUM},
        {&full, 1, 1, GL_RGBA, 0, GL_INVALID_ENUM},
        {&full, 1, 1, GL_RGBA, GL_BITMAP, GL_INVALID_ENUM},
        {&full, 1, 1, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, GL_INVALID_OPERATION},
        {&full, 1, 1, GL_RGB, GL_UNSIGNED_INT_8_8_8_8, GL_INVALID_OPERATION},
        {&full, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT_5_6_5, GL_INVALID_OPERATION},
        {&no_stencil, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, GL_INVALID_OPERATION},
        {&bare_color, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, GL_INVALID_OPERATION},
        {&bare_color, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, GL_INVALID_OPERATION},
    };
    for (const Case& c : cases) {
        cmd::ReadPixels(c.context->context, 0, 0, c.width, c.height, c.format, c.type, &out);
        EXPECT_EQ(c.context->take_error(), c.wanted) << std::hex << c.format << " " << c.type;
        EXPECT_EQ(out, 0x12345678u);
    }
    cmd::ReadPixels(full.context, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    EXPECT_EQ(full.take_error(), GLenum{GL_INVALID_VALUE});
    cmd::ReadPixels(no_stencil.context, 0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, &out);
    EXPECT_EQ(no_stencil.take_error(), GLenum{GL_NO_ERROR});
}

} // namespace
} // namespace spangle::gl
