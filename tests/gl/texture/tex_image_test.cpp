// Tests TexImage2D, TexSubImage2D and what they store (GL 1.3, 3.8.1, 3.8.2; docs/features.md F01, F04, F05,
// F15, F29).
#include <gtest/gtest.h>

#include <climits>
#include <cmath>
#include <cstring>
#include <random>

#include "gl/api/generated/commands.hpp"
#include "gl/texture/complete.hpp"
#include "tests/gl/pixel/bare_context.hpp"
#include "tests/gl/texture/client_image.hpp"

namespace spangle::gl {
namespace {

using raster::BaseFormat;
using raster::TexelFormat;
using test::BareContext;
using test::SharedMemory;

struct TexImage : testing::Test {
    SharedMemory memory{1 << 20};
    BareContext bare{memory, PixelFormat::rgba8888};
    BareContext board{memory, PixelFormat::rgb565_be};

    GLint level_parameter(BareContext& b, GLenum target, GLint level, GLenum pname) {
        Params params;
        cmd::GetTexLevelParameter(b.context, target, level, pname, params);
        EXPECT_EQ(params.count, 1u);
        return params.v[0].integer();
    }
    GLint level_parameter(GLenum pname, GLint level = 0) {
        return level_parameter(bare, GL_TEXTURE_2D, level, pname);
    }

    /// Returns the texture as the rasterizer gets it, without mipmaps.
    const raster::Texture& view(BareContext& b) {
        Params nearest;
        nearest.v[0] = Param::from_integer(GL_NEAREST);
        nearest.count = 1;
        cmd::TexParameter(b.context, GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, nearest);
        const raster::Texture* texture = complete_texture(b.context.texture.bound(0));
        EXPECT_NE(texture, nullptr);
        return *texture;
    }
};

TEST_F(TexImage, InternalFormatsKeepTheirBitsAndSayHowMany) {
    struct Case {
        GLint internal_format;
        GLint r, g, b, a, l, i; ///< bits on a surface of 8 bits a component
        bool sixteen;           ///< whether a 16-bit surface stores it as 5, 6 and 5 bits
    };
    const Case cases[] = {
        {1, 0, 0, 0, 0, 8, 0, false},
        {2, 0, 0, 0, 8, 8, 0, false},
        {3, 8, 8, 8, 0, 0, 0, true},
        {4, 8, 8, 8, 8, 0, 0, false},
        {GL_ALPHA, 0, 0, 0, 8, 0, 0, false},
        {GL_ALPHA4, 0, 0, 0, 8, 0, 0, false},
        {GL_ALPHA8, 0, 0, 0, 8, 0, 0, false},
        {GL_ALPHA12, 0, 0, 0, 8, 0, 0, false},
        {GL_ALPHA16, 0, 0, 0, 8, 0, 0, false},
        {GL_LUMINANCE, 0, 0, 0, 0, 8, 0, false},
        {GL_LUMINANCE4, 0, 0, 0, 0, 8, 0, false},
        {GL_LUMINANCE8, 0, 0, 0, 0, 8, 0, false},
        {GL_LUMINANCE12, 0, 0, 0, 0, 8, 0, false},
        {GL_LUMINANCE16, 0, 0, 0, 0, 8, 0, false},
        {GL_LUMINANCE_ALPHA, 0, 0, 0, 8, 8, 0, false},
        {GL_LUMINANCE4_ALPHA4, 0, 0, 0, 8, 8, 0, false},
        {GL_LUMINANCE6_ALPHA2, 0, 0, 0, 8, 8, 0, false},
        {GL_LUMINANCE8_ALPHA8, 0, 0, 0, 8, 8, 0, false},
        {GL_LUMINANCE12_ALPHA4, 0, 0, 0, 8, 8, 0, false},
        {GL_LUMINANCE12_ALPHA12, 0, 0, 0, 8, 8, 0, false},
        {GL_LUMINANCE16_ALPHA16, 0, 0, 0, 8, 8, 0, false},
        {GL_INTENSITY, 0, 0, 0, 0, 0, 8, false},
        {GL_INTENSITY4, 0, 0, 0, 0, 0, 8, false},
        {GL_INTENSITY8, 0, 0, 0, 0, 0, 8, false},
        {GL_INTENSITY12, 0, 0, 0, 0, 0, 8, false},
        {GL_INTENSITY16, 0, 0, 0, 0, 0, 8, false},
        {GL_RGB, 8, 8, 8, 0, 0, 0, true},
        {GL_R3_G3_B2, 3, 3, 2, 0, 0, 0, false},
        {GL_RGB4, 5, 6, 5, 0, 0, 0, false},
        {GL_RGB5, 5, 6, 5, 0, 0, 0, false},
        {GL_RGB8, 8, 8, 8, 0, 0, 0, false},
        {GL_RGB10, 8, 8, 8, 0, 0, 0, false},
        {GL_RGB12, 8, 8, 8, 0, 0, 0, false},
        {GL_RGB16, 8, 8, 8, 0, 0, 0, false},
        {GL_RGBA, 8, 8, 8, 8, 0, 0, false},
        {GL_RGBA2, 4, 4, 4, 4, 0, 0, false},
        {GL_RGBA4, 4, 4, 4, 4, 0, 0, false},
        {GL_RGB5_A1, 5, 5, 5, 1, 0, 0, false},
        {GL_RGBA8, 8, 8, 8, 8, 0, 0, false},
        {GL_RGB10_A2, 8, 8, 8, 8, 0, 0, false},
        {GL_RGBA12, 8, 8, 8, 8, 0, 0, false},
        {GL_RGBA16, 8, 8, 8, 8, 0, 0, false},
    };
    for (const Case& c : cases)
        for (BareContext* b : {&bare, &board})
            for (GLenum target : {GL_TEXTURE_2D, GL_PROXY_TEXTURE_2D}) {
                tex_image_2d(b->context, target, 0, c.internal_format, 2, 2, 0, GL_RGBA, GL_FLOAT, nullptr);
                ASSERT_EQ(b->take_error(), GLenum{GL_NO_ERROR}) << std::hex << c.internal_format;
                const bool five = c.sixteen && b == &board;
                EXPECT_EQ(level_parameter(*b, target, 0, GL_TEXTURE_INTERNAL_FORMAT), c.internal_format);
                EXPECT_EQ(level_parameter(*b, target, 0, GL_TEXTURE_RED_SIZE), five ? 5 : c.r);
                EXPECT_EQ(level_parameter(*b, target, 0, GL_TEXTURE_GREEN_SIZE), five ? 6 : c.g);
                EXPECT_EQ(level_parameter(*b, target, 0, GL_TEXTURE_BLUE_SIZE), five ? 5 : c.b);
                EXPECT_EQ(level_parameter(*b, target, 0, GL_TEXTURE_ALPHA_SIZE), c.a);
                EXPECT_EQ(level_parameter(*b, target, 0, GL_TEXTURE_LUMINANCE_SIZE), c.l);
                EXPECT_EQ(level_parameter(*b, target, 0, GL_TEXTURE_INTENSITY_SIZE), c.i);
            }
}

/// Returns texel (x, y) in 0..1, by the layout that spangle/raster/fragment_state.hpp declares.
void texel(const raster::Texture& t, int x, int y, double out[4]) {
    constexpr int bytes[] = {1, 1, 1, 2, 2, 3, 4, 2, 2, 1, 2, 4};
    const std::uint8_t* p = t.level[0].texels + y * static_cast<std::int64_t>(t.level[0].stride) +
                            x * bytes[static_cast<int>(t.format)];
    out[0] = out[1] = out[2] = out[3] = -1; // components that the format does not store
    std::uint16_t word;
    switch (t.format) {
    case TexelFormat::a8:
        out[3] = p[0] / 255.0;
        break;
    case TexelFormat::l8:
    case TexelFormat::i8:
        out[0] = p[0] / 255.0;
        break;
    case TexelFormat::la88:
        out[0] = p[0] / 255.0;
        out[3] = p[1] / 255.0;
        break;
    case TexelFormat::rgb565:
        std::memcpy(&word, p, 2);
        out[0] = (word >> 11) / 31.0;
        out[1] = (word >> 5 & 63) / 63.0;
        out[2] = (word & 31) / 31.0;
        break;
    case TexelFormat::rgba8888:
        out[3] = p[3] / 255.0;
        [[fallthrough]];
    case TexelFormat::rgb888:
        for (int c = 0; c < 3; ++c)
            out[c] = p[c] / 255.0;
        break;
    case TexelFormat::rgba4444:
        std::memcpy(&word, p, 2);
        for (int c = 0; c < 4; ++c)
            out[c] = (word >> (12 - 4 * c) & 15) / 15.0;
        break;
    case TexelFormat::rgba5551:
        std::memcpy(&word, p, 2);
        for (int c = 0; c < 3; ++c)
            out[c] = (word >> (11 - 5 * c) & 31) / 31.0;
        out[3] = word & 1;
        break;
    case TexelFormat::rgb332:
        out[0] = (p[0] >> 5) / 7.0;
        out[1] = (p[0] >> 2 & 7) / 7.0;
        out[2] = (p[0] & 3) / 3.0;
        break;
    default:
        FAIL() << "not a format of colours";
    }
}

TEST_F(TexImage, EveryFormatAndTypeArrivesRoundedToTheBitsKept) {
    const struct {
        GLint internal;
        BaseFormat base;
        int bits[4];
    } kinds[] = {{GL_ALPHA, BaseFormat::alpha, {8, 8, 8, 8}},
                 {GL_LUMINANCE, BaseFormat::luminance, {8, 8, 8, 8}},
                 {GL_INTENSITY, BaseFormat::intensity, {8, 8, 8, 8}},
                 {GL_LUMINANCE_ALPHA, BaseFormat::luminance_alpha, {8, 8, 8, 8}},
                 {GL_RGB, BaseFormat::rgb, {8, 8, 8, 8}},
                 {GL_RGBA, BaseFormat::rgba, {8, 8, 8, 8}},
                 {GL_R3_G3_B2, BaseFormat::rgb, {3, 3, 2, 8}},
                 {GL_RGB5, BaseFormat::rgb, {5, 6, 5, 8}},
                 {GL_RGBA4, BaseFormat::rgba, {4, 4, 4, 4}},
                 {GL_RGB5_A1, BaseFormat::rgba, {5, 5, 5, 1}}};
    struct Source {
        GLenum format;
        std::vector<int> place; ///< R, G, B, A as 0 to 3 of each component; 4: luminance
    };
    const Source sources[] = {{GL_RED, {0}},           {GL_GREEN, {1}},
                              {GL_BLUE, {2}},          {GL_ALPHA, {3}},
                              {GL_RGB, {0, 1, 2}},     {GL_BGR, {2, 1, 0}},
                              {GL_RGBA, {0, 1, 2, 3}}, {GL_BGRA, {2, 1, 0, 3}},
                              {GL_LUMINANCE, {4}},     {GL_LUMINANCE_ALPHA, {4, 3}}};
    std::mt19937 random(11);
    for (BareContext* b : {&bare, &board})
        for (const auto& kind : kinds)
            for (const Source& source : sources)
                for (GLenum type : {GL_UNSIGNED_BYTE, GL_BYTE, GL_UNSIGNED_SHORT, GL_FLOAT}) {
                    const std::size_t n = source.place.size();
                    std::vector<double> given(8 * 4 * n);
                    std::vector<unsigned char> bytes;
                    const auto push = [&](auto v) {
                        const auto* p = reinterpret_cast<const unsigned char*>(&v);
                        bytes.insert(bytes.end(), p, p + sizeof v);
                    };
                    for (double& f : given) {
                        const auto r = static_cast<std::uint32_t>(random());
                        if (type == GL_UNSIGNED_BYTE)
                            f = (r & 255) / 255.0, push(static_cast<std::uint8_t>(r));
                        else if (type == GL_BYTE)
                            f = (2 * static_cast<std::int8_t>(r) + 1) / 255.0,
                            push(static_cast<std::int8_t>(r));
                        else if (type == GL_UNSIGNED_SHORT)
                            f = (r & 65535) / 65535.0, push(static_cast<std::uint16_t>(r));
                        else
                            f = static_cast<float>(r / 4294967296.0 * 1.5 - 0.25),
                            push(static_cast<float>(f));
                    }
                    b->context.pixel_store.unpack.alignment = 1;
                    tex_image_2d(b->context, GL_TEXTURE_2D, 0, kind.internal, 8, 4, 0, source.format, type,
                                 bytes.data());
                    ASSERT_EQ(b->take_error(), GLenum{GL_NO_ERROR});
                    const raster::Texture& t = view(*b);
                    ASSERT_EQ(t.base, kind.base);
                    const bool five = (b == &board && kind.internal == GL_RGB) || kind.internal == GL_RGB5;
                    ASSERT_EQ(t.format == TexelFormat::rgb565, five);
                    for (int i = 0; i < 8 * 4; ++i) {
                        double rgba[4] = {0, 0, 0, 1};
                        for (std::size_t k = 0; k < n; ++k) {
                            const double f =
                                std::fmin(1, std::fmax(0, given[static_cast<std::size_t>(i) * n + k]));
                            if (source.place[k] == 4)
                                rgba[0] = rgba[1] = rgba[2] = f;
                            else
                                rgba[source.place[k]] = f;
                        }
                        double got[4];
                        texel(t, i % 8, i / 8, got);
                        const int sixteen[4] = {5, 6, 5, 8};
                        const int* const kept_bits = five ? sixteen : kind.bits;
                        for (int c = 0; c < 4; ++c)
                            if (got[c] >= 0) {
                                ASSERT_LE(std::fabs(got[c] - rgba[c]), 0.5001 / ((1 << kept_bits[c]) - 1))
                                    << std::hex << source.format << " " << type << " texel " << i << " " << c;
                            }
                    }
                }
}

TEST_F(TexImage, PackedColoursAndSwappedBytes) {
    const std::uint16_t pixels[4] = {0xF800, 0x07E0, 0x001F, 0x1234};
    for (bool swap : {false, true}) {
        std::uint16_t given[4];
        for (int i = 0; i < 4; ++i)
            given[i] = swap ? __builtin_bswap16(pixels[i]) : pixels[i];
        board.context.pixel_store.unpack.swap_bytes = swap;
        tex_image_2d(board.context, GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, GL_RGB, GL_UNSIGNED_SHORT_5_6_5,
                     given);
        const raster::Texture& t = view(board);
        for (int i = 0; i < 4; ++i) {
            std::uint16_t word;
            std::memcpy(&word, t.level[0].texels + (i / 2) * t.level[0].stride + (i % 2) * 2, 2);
            EXPECT_EQ(word, pixels[i]) << swap;
        }
    }
}

#if SPANGLE_FEATURE_PIXEL_TRANSFER
/// Images whose layout is that of their texels go through pixel transfer like others.
TEST_F(TexImage, WhatCouldBeCopiedGoesThroughTransfer) {
    const std::uint16_t word = 30 << 11 | 20 << 5 | 10;
    const std::uint8_t bytes[4] = {200, 100, 50, 30};
    for (const bool maps : {false, true}) {
        for (BareContext* const b : {&bare, &board}) {
            if (maps) {
                const float half[2] = {0, 0.5f}; // a map of two entries is looked up at c (2 - 1), rounded
                cmd::PixelMap(b->context, GL_PIXEL_MAP_R_TO_R, 2, {half, GL_FLOAT});
                b->context.pixel_mode.map_color = true;
            } else {
                b->context.pixel_mode.linear[0].scale = numeric::from_float(0.5f);
            }
        }
        tex_image_2d(board.context, GL_TEXTURE_2D, 0, GL_RGB, 1, 1, 0, GL_RGB, GL_UNSIGNED_SHORT_5_6_5,
                     &word);
        std::uint16_t stored;
        std::memcpy(&stored, view(board).level[0].texels, 2);
        EXPECT_EQ(stored, (maps ? 16 : 15) << 11 | (maps ? 0 : 20) << 5 | (maps ? 0 : 10)) << maps;
        tex_image_2d(bare.context, GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
        EXPECT_EQ(view(bare).level[0].texels[0], maps ? 128 : 100);
        for (BareContext* const b : {&bare, &board})
            b->context.pixel_mode.linear[0].scale = numeric::one;
    }
}
#endif

TEST_F(TexImage, UnpackModesChooseARectangle) {
    std::vector<std::uint8_t> image(16 * 8);
    for (std::size_t i = 0; i < image.size(); ++i)
        image[i] = static_cast<std::uint8_t>(i);
    PixelStore& unpack = bare.context.pixel_store.unpack;
    unpack.row_length = 13;
    unpack.alignment = 8; // pads rows to 16 bytes
    unpack.skip_rows = 2;
    unpack.skip_pixels = 3;
    tex_image_2d(bare.context, GL_TEXTURE_2D, 0, GL_LUMINANCE, 4, 4, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE,
                 image.data());
    const raster::Texture& t = view(bare);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            EXPECT_EQ(t.level[0].texels[y * static_cast<int>(t.level[0].stride) + x], (y + 2) * 16 + x + 3);
}

TEST_F(TexImage, ErrorsChangeNothing) {
    std::vector<std::uint8_t> image(64, 7);
    tex_image_2d(bare.context, GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
    ASSERT_EQ(bare.take_error(), GLenum{GL_NO_ERROR});
    const std::size_t used = memory.arena.used();
    struct Case {
        GLenum target;
        GLint level, internal_format;
        GLsizei width, height;
        GLint border;
        GLenum format, type, wanted;
    };
    const Case cases[] = {
        {0, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_ENUM},
        {GL_TEXTURE_ENV, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_ENUM},
        {GL_TEXTURE_2D, -1, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 12, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, INT_MAX, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, INT_MIN, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 0, 0, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 0, 5, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 0, -1, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_OPERATION},
        {GL_TEXTURE_2D, 0, GL_RGBA, -4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 0, GL_RGBA, 4, -4, 0, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 0, GL_RGBA, INT_MIN, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 0, GL_RGBA, 2049, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_RGBA, 4, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_CUBE_MAP, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_ENUM},
        {GL_TEXTURE_1D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_ENUM},
        {GL_TEXTURE_3D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_ENUM},
        {GL_TEXTURE_2D, 0, GL_RGBA, 4096, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 0, GL_RGBA, 4, 4096, 0, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 11, GL_RGBA, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 2, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, -1, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 0, GL_RGBA, 2051, 4, 1, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 1, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, GL_INVALID_ENUM},
        {GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE, GL_INVALID_OPERATION},
        {GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, 0, GL_UNSIGNED_BYTE, GL_INVALID_ENUM},
        {GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, 0, GL_INVALID_ENUM},
        {GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_BITMAP, GL_INVALID_ENUM},
        {GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, GL_INVALID_OPERATION},
        {GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGB, GL_UNSIGNED_SHORT_4_4_4_4, GL_INVALID_OPERATION},
    };
    for (const Case& c : cases)
        for (const void* pixels :
             {static_cast<const void*>(image.data()), static_cast<const void*>(nullptr)}) {
            tex_image_2d(bare.context, c.target, c.level, c.internal_format, c.width, c.height, c.border,
                         c.format, c.type, pixels);
            EXPECT_EQ(bare.take_error(), c.wanted) << &c - cases;
            EXPECT_EQ(memory.arena.used(), used);
            EXPECT_EQ(level_parameter(GL_TEXTURE_WIDTH), 4);
            EXPECT_EQ(view(bare).level[0].texels[5], 7);
        }
}

TEST_F(TexImage, LargestSizesOfEachLevel) {
    for (GLint level = 0; level < 12; ++level)
        for (GLint border : {0, 1}) {
            const GLsizei side = (2048 >> level) + 2 * border;
            tex_image_2d(bare.context, GL_PROXY_TEXTURE_2D, level, GL_ALPHA, side, 1 + 2 * border, border,
                         GL_ALPHA, GL_UNSIGNED_BYTE, nullptr);
            EXPECT_EQ(bare.take_error(), GLenum{GL_NO_ERROR});
            EXPECT_EQ(level_parameter(bare, GL_PROXY_TEXTURE_2D, level, GL_TEXTURE_WIDTH), side);
            EXPECT_EQ(level_parameter(bare, GL_PROXY_TEXTURE_2D, level, GL_TEXTURE_BORDER), border);
        }
}

TEST_F(TexImage, AProxyTooLargeIsZeroAndNoError) {
    const std::size_t used = memory.arena.used();
    tex_image_2d(bare.context, GL_PROXY_TEXTURE_2D, 0, GL_RGBA, 64, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 nullptr);
    EXPECT_EQ(level_parameter(bare, GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT), 32);
    EXPECT_EQ(level_parameter(bare, GL_PROXY_TEXTURE_2D, 1, GL_TEXTURE_HEIGHT), 0);
    for (GLsizei width : {4096, 2049, INT_MAX}) {
        tex_image_2d(bare.context, GL_PROXY_TEXTURE_2D, 0, GL_RGBA, width, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     nullptr);
        EXPECT_EQ(bare.take_error(), GLenum{GL_NO_ERROR});
        for (GLenum pname : {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_BORDER, GL_TEXTURE_RED_SIZE})
            EXPECT_EQ(level_parameter(bare, GL_PROXY_TEXTURE_2D, 0, pname), 0);
    }
    tex_image_2d(bare.context, GL_PROXY_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, 0, nullptr);
    EXPECT_EQ(bare.take_error(), GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(memory.arena.used(), used);
    EXPECT_EQ(level_parameter(GL_TEXTURE_WIDTH), 0);
}

TEST_F(TexImage, SubImageReplacesItsRectangleOnly) {
    std::vector<std::uint8_t> image(10 * 6), part(3 * 2);
    for (std::size_t i = 0; i < image.size(); ++i)
        image[i] = static_cast<std::uint8_t>(i);
    for (std::size_t i = 0; i < part.size(); ++i)
        part[i] = static_cast<std::uint8_t>(200 + i);
    bare.context.pixel_store.unpack.alignment = 1;
    tex_image_2d(bare.context, GL_TEXTURE_2D, 0, GL_ALPHA, 10, 6, 1, GL_ALPHA, GL_UNSIGNED_BYTE,
                 image.data());
    const std::uint8_t* texels = view(bare).level[0].texels;
    // The lower left and upper right corner, border included (GL 1.3, 3.8.2).
    const struct { GLint x, y; } places[] = {{-1, -1}, {6, 3}, {2, 1}};
    for (const auto& at : places) {
        tex_sub_image_2d(bare.context, GL_TEXTURE_2D, 0, at.x, at.y, 3, 2, GL_ALPHA, GL_UNSIGNED_BYTE,
                         part.data());
        ASSERT_EQ(bare.take_error(), GLenum{GL_NO_ERROR});
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 3; ++x)
                image[static_cast<std::size_t>((at.y + 1 + y) * 10 + at.x + 1 + x)] =
                    part[static_cast<std::size_t>(y * 3 + x)];
        EXPECT_EQ(std::memcmp(texels - 11, image.data(), image.size()), 0) << at.x;
    }
    EXPECT_EQ(view(bare).border_texels, 1);
    EXPECT_EQ(view(bare).level[0].width, 8);
    EXPECT_EQ(view(bare).level[0].height, 4);
}

TEST_F(TexImage, SubImageErrors) {
    std::vector<std::uint8_t> image(10 * 6 * 4);
    tex_sub_image_2d(bare.context, GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
    EXPECT_EQ(bare.take_error(), GLenum{GL_INVALID_OPERATION}); // there is no image yet
    tex_image_2d(bare.context, GL_TEXTURE_2D, 0, GL_RGBA, 10, 6, 1, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
    struct Case {
        GLenum target;
        GLint level, x, y;
        GLsizei width, height;
        GLenum format, type, wanted;
    };
    const Case cases[] = {
        {GL_PROXY_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_ENUM},
        {GL_TEXTURE_2D, -1, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 12, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 1, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_OPERATION},
        {GL_TEXTURE_2D, 0, -2, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 0, 0, -2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 0, 7, 0, 3, 1, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 0, 0, 4, 1, 2, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 0, INT_MIN, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 0, INT_MAX, 0, INT_MAX, 1, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 0, 0, 0, -1, 1, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 0, 0, 0, 1, -1, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE, GL_INVALID_OPERATION},
        {GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_BITMAP, GL_INVALID_ENUM},
        {GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_BGR, GL_UNSIGNED_SHORT_5_6_5, GL_INVALID_OPERATION},
    };
    const raster::Texture& t = view(bare);
    for (const Case& c : cases) {
        std::vector<std::uint8_t> other(10 * 6 * 4, 99);
        tex_sub_image_2d(bare.context, c.target, c.level, c.x, c.y, c.width, c.height, c.format, c.type,
                         other.data());
        EXPECT_EQ(bare.take_error(), c.wanted) << &c - cases;
        EXPECT_EQ(std::memcmp(t.level[0].texels - 11 * 4, image.data(), image.size()), 0);
    }
    tex_sub_image_2d(bare.context, GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    EXPECT_EQ(bare.take_error(), GLenum{GL_INVALID_VALUE});
    tex_sub_image_2d(bare.context, GL_TEXTURE_2D, 0, 9, 5, 0, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    EXPECT_EQ(bare.take_error(), GLenum{GL_NO_ERROR}); // an empty rectangle at the far corner is legal
}

TEST_F(TexImage, LevelQueriesRefuseWhatIsNotThere) {
    Params params;
    const struct {
        GLenum target;
        GLint level;
        GLenum pname, wanted;
    } cases[] = {
        {GL_TEXTURE_ENV, 0, GL_TEXTURE_WIDTH, GL_INVALID_ENUM},
        {GL_TEXTURE_2D, -1, GL_TEXTURE_WIDTH, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 12, GL_TEXTURE_WIDTH, GL_INVALID_VALUE},
        {GL_TEXTURE_2D, 0, GL_TEXTURE_MIN_FILTER, GL_INVALID_ENUM},
    };
    for (const auto& c : cases) {
        cmd::GetTexLevelParameter(bare.context, c.target, c.level, c.pname, params);
        EXPECT_EQ(bare.take_error(), c.wanted);
        EXPECT_EQ(params.count, 0u);
    }
    // Tests the initial state of a level (GL 1.3, 3.8.10).
    EXPECT_EQ(level_parameter(GL_TEXTURE_WIDTH, 3), 0);
    EXPECT_EQ(level_parameter(GL_TEXTURE_INTERNAL_FORMAT, 3), 1);
    EXPECT_EQ(level_parameter(GL_TEXTURE_LUMINANCE_SIZE, 3), 0);
}

TEST_F(TexImage, LevelsOfOneTextureAreKeptAlike) {
    tex_image_2d(bare.context, GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
    bare.context.drawable.surface.format = PixelFormat::rgb565_be; // another window with the same texture
    tex_image_2d(bare.context, GL_TEXTURE_2D, 1, GL_RGB, 1, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
    EXPECT_EQ(level_parameter(GL_TEXTURE_GREEN_SIZE, 1), 8);
    const raster::Texture* texture = complete_texture(bare.context.texture.bound(0));
    ASSERT_NE(texture, nullptr);
    EXPECT_EQ(texture->level_count, 2);
}

} // namespace
} // namespace spangle::gl
