// Tests paletted and ETC1 images: what is sampled, from copies and from constant memory, and what is refused
// (docs/features.md F07, OES_compressed_paletted_texture, OES_compressed_ETC1_RGB8_texture).
#include <array>
#include <cstring>

#include "tests/gl/texture/drawing.hpp"
#include "tests/support/random.hpp"

namespace {

#if SPANGLE_FEATURE_COMPRESSED_TEXTURES

struct Compressed : spangle::test::Drawing {
    spangle::test::Random random{5};

    void SetUp() override {
        Drawing::SetUp();
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_NICEST);
    }
    std::vector<GLubyte> bytes(std::size_t n) {
        std::vector<GLubyte> v(n);
        for (GLubyte& b : v)
            b = static_cast<GLubyte>(random.below(256));
        return v;
    }
    /// Returns a texel of the level with this number.
    std::array<int, 4> texel(int i, int j, int width, int height, int level) {
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, static_cast<float>(level));
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_LOD, static_cast<float>(level));
        std::vector<GLubyte> pixel;
        draw((static_cast<float>(i) + 0.5f) / static_cast<float>(width),
             (static_cast<float>(j) + 0.5f) / static_cast<float>(height), pixel);
        return {pixel[0], pixel[1], pixel[2], pixel[3]};
    }
};

/// Returns a field of bits as a byte, rounded to nearest.
int byte_of(unsigned word, int shift, int bits) {
    const unsigned most = (1u << bits) - 1, k = word >> shift & most;
    return static_cast<int>((k * 255 + most / 2) / most);
}

std::array<int, 4> entry(unsigned kind, const GLubyte* at) {
    const unsigned word = static_cast<unsigned>(at[0] | at[1] << 8);
    switch (kind) {
    case 0:
        return {at[0], at[1], at[2], 255};
    case 1:
        return {at[0], at[1], at[2], at[3]};
    case 2:
        return {byte_of(word, 11, 5), byte_of(word, 5, 6), byte_of(word, 0, 5), 255};
    case 3:
        return {byte_of(word, 12, 4), byte_of(word, 8, 4), byte_of(word, 4, 4), byte_of(word, 0, 4)};
    default:
        return {byte_of(word, 11, 5), byte_of(word, 6, 5), byte_of(word, 1, 5), byte_of(word, 0, 1)};
    }
}

TEST_F(Compressed, EveryPaletteAndItsLevels) {
    const std::size_t entry_bytes[5] = {3, 4, 2, 2, 2};
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    for (GLenum format = GL_PALETTE4_RGB8_OES; format <= GL_PALETTE8_RGB5_A1_OES; ++format)
        for (const bool constant : {false, true}) {
            const unsigned kind = (format - GL_PALETTE4_RGB8_OES) % 5;
            const bool small = format < GL_PALETTE8_RGB8_OES;
            const std::size_t palette = (small ? 16 : 256) * entry_bytes[kind];
            // Levels are 8 x 2, 4 x 1, 2 x 1 and 1 x 1. Indices of 4 bits share bytes, but each level starts
            // at a byte.
            const int widths[4] = {8, 4, 2, 1}, heights[4] = {2, 1, 1, 1};
            std::size_t total = palette, start[4];
            for (int l = 0; l < 4; ++l) {
                start[l] = total;
                const auto texels = static_cast<std::size_t>(widths[l] * heights[l]);
                total += small ? (texels + 1) / 2 : texels;
            }
            const std::vector<GLubyte> data = bytes(total);
            const auto load = constant ? &glCompressedTexConstantImage2DSPANGLE : &glCompressedTexImage2D;
            load(GL_TEXTURE_2D, -3, format, 8, 2, 0, static_cast<GLsizei>(total), data.data());
            ASSERT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << std::hex << format;
            for (int l = 0; l < 4; ++l)
                for (int j = 0; j < heights[l]; ++j)
                    for (int i = 0; i < widths[l]; ++i) {
                        const auto n = static_cast<std::size_t>(j * widths[l] + i);
                        const GLubyte byte = data[start[l] + (small ? n / 2 : n)];
                        const std::size_t index = !small ? byte : n % 2 == 0 ? byte >> 4 : byte & 15;
                        EXPECT_EQ(texel(i, j, widths[l], heights[l], l),
                                  entry(kind, data.data() + index * entry_bytes[kind]))
                            << std::hex << format << std::dec << " level " << l << " texel " << i << ' ' << j;
                    }
            std::vector<GLubyte> back(palette + 8 * 2);
            glGetCompressedTexImage(GL_TEXTURE_2D, 0, back.data());
            const std::size_t first = start[1];
            EXPECT_EQ(std::memcmp(back.data(), data.data(), first), 0);
            GLint size = 0;
            glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED_IMAGE_SIZE, &size);
            EXPECT_EQ(static_cast<std::size_t>(size), first);
            // One level is loaded alone, and all other levels are deleted.
            load(GL_TEXTURE_2D, 0, format, 8, 2, 0, static_cast<GLsizei>(first), data.data());
            glGetTexLevelParameteriv(GL_TEXTURE_2D, 1, GL_TEXTURE_WIDTH, &size);
            EXPECT_EQ(size, 0);
        }
}

/// Decodes one texel by the tables of the extension.
std::array<int, 4> etc1(const GLubyte* block, int x, int y) {
    static const int modifier[8][4] = {{2, 8, -2, -8},       {5, 17, -5, -17},    {9, 29, -9, -29},
                                       {13, 42, -13, -42},   {18, 60, -18, -60},  {24, 80, -24, -80},
                                       {33, 106, -33, -106}, {47, 183, -47, -183}};
    const bool flip = (block[3] & 1) != 0, differential = (block[3] & 2) != 0;
    const int half = flip ? y / 2 : x / 2, table = half == 0 ? block[3] >> 5 : block[3] >> 2 & 7;
    const int bit = 4 * x + y;
    const int msb = (block[bit < 8 ? 5 : 4] >> (bit % 8)) & 1,
              lsb = (block[bit < 8 ? 7 : 6] >> (bit % 8)) & 1;
    std::array<int, 4> out{0, 0, 0, 255};
    for (std::size_t c = 0; c < 3; ++c) {
        int base;
        if (differential) {
            int five = block[c] >> 3;
            const int d = block[c] & 7;
            if (half == 1)
                five += d < 4 ? d : d - 8;
            base = five * 8 + five / 4;
        } else {
            const int four = half == 0 ? block[c] >> 4 : block[c] & 15;
            base = four * 16 + four;
        }
        out[c] = std::min(255, std::max(0, base + modifier[table][2 * msb + lsb]));
    }
    return out;
}

TEST_F(Compressed, Etc1BlocksOfBothModesAndDirections) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    for (int round = 0; round < 40; ++round) {
        const int width = 5 + round % 4, height = 9; // blocks at the right and upper edge are not whole
        const int across = (width + 3) / 4, up = (height + 3) / 4;
        std::vector<GLubyte> data = bytes(static_cast<std::size_t>(8 * across * up));
        for (std::size_t b = 0; b < data.size(); b += 8)
            for (std::size_t c = 0; c < 3; ++c) { // the second colour must stay within five bits
                const int d = data[b + c] & 7, five = data[b + c] >> 3, sum = five + (d < 4 ? d : d - 8);
                if (sum < 0 || sum > 31)
                    data[b + c] = static_cast<GLubyte>(data[b + c] & 0xF8);
            }
        const auto load = round % 2 == 0 ? &glCompressedTexImage2D : &glCompressedTexConstantImage2DSPANGLE;
        load(GL_TEXTURE_2D, 0, GL_ETC1_RGB8_OES, width, height, 0, static_cast<GLsizei>(data.size()),
             data.data());
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i)
                ASSERT_EQ(texel(i, j, width, height, 0),
                          etc1(data.data() + 8 * (j / 4 * across + i / 4), i % 4, j % 4))
                    << round << " texel " << i << ' ' << j;
    }
}

/// A sprite of several formats is drawn with LINEAR, by fragments and by packets, in every tier.
TEST_F(Compressed, LinearFiltersThemLikeTheColoursTheyStandFor) {
    const std::vector<GLubyte> palette = bytes(16 * 3), indices = bytes(8);
    std::vector<GLubyte> data = palette, rgb;
    data.insert(data.end(), indices.begin(), indices.end());
    for (std::size_t n = 0; n < 16; ++n) {
        const std::size_t index = n % 2 == 0 ? indices[n / 2] >> 4 : indices[n / 2] & 15;
        rgb.insert(rgb.end(), palette.begin() + static_cast<std::ptrdiff_t>(3 * index),
                   palette.begin() + static_cast<std::ptrdiff_t>(3 * index + 3));
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    for (const GLenum hint : {GL_NICEST, GL_FASTEST}) {
        glHint(GL_PERSPECTIVE_CORRECTION_HINT, hint);
        std::vector<GLubyte> pixels[2];
        for (std::size_t k = 0; k < 2; ++k) {
            if (k == 0)
                glCompressedTexImage2D(GL_TEXTURE_2D, 0, GL_PALETTE4_RGB8_OES, 4, 4, 0,
                                       static_cast<GLsizei>(data.size()), data.data());
            else
                glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, 4, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
            glBegin(GL_TRIANGLE_STRIP);
            for (float y : {-1.0f, 1.0f})
                for (float x : {-1.0f, 1.0f})
                    glTexCoord2f(x * 0.4f, y * 0.3f), glVertex2f(x, y);
            glEnd();
            pixels[k].resize(64);
            glReadPixels(0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, pixels[k].data());
        }
        EXPECT_EQ(pixels[0], pixels[1]);
    }
}

TEST_F(Compressed, WhatIsRefused) {
    GLubyte data[512] = {};
    const auto load = [&](GLint level, GLenum format, GLsizei w, GLsizei h, GLint border, GLsizei size) {
        glCompressedTexImage2D(GL_TEXTURE_2D, level, format, w, h, border, size, data);
        return glGetError();
    };
    EXPECT_EQ(load(0, GL_ETC1_RGB8_OES, 4, 4, 0, 8), GLenum{GL_NO_ERROR});
    EXPECT_EQ(load(0, GL_ETC1_RGB8_OES, 4, 4, 0, 16), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(load(0, GL_ETC1_RGB8_OES, 5, 4, 0, 8), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(load(0, GL_ETC1_RGB8_OES, 4, 4, 1, 8), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(load(-1, GL_ETC1_RGB8_OES, 4, 4, 0, 8), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(load(1, GL_PALETTE4_RGB8_OES, 2, 2, 0, 50), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(load(0, GL_PALETTE4_RGB8_OES, 2, 2, 0, 50), GLenum{GL_NO_ERROR});
    EXPECT_EQ(load(-1, GL_PALETTE4_RGB8_OES, 2, 2, 0, 51), GLenum{GL_NO_ERROR});
    for (GLenum generic = GL_COMPRESSED_ALPHA; generic <= GL_COMPRESSED_RGBA; ++generic)
        EXPECT_EQ(load(0, generic, 4, 4, 0, 8), GLenum{GL_INVALID_ENUM});
    glCompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 2, 2, GL_PALETTE4_RGB8_OES, 50, data);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    EXPECT_EQ(load(0, GL_ETC1_RGB8_OES, 8, 4, 0, 16), GLenum{GL_NO_ERROR});
    data[0] = 77;
    glCompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, GL_ETC1_RGB8_OES, 8, data);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION}); // a part of a paletted image cannot be replaced
    glCompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 8, 4, GL_ETC1_RGB8_OES, 16, data);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    GLubyte back[16] = {};
    glGetCompressedTexImage(GL_TEXTURE_2D, 0, back);
    EXPECT_EQ(back[0], 77);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, data);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_UNSIGNED_BYTE, back);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    // A generic compressed format becomes its base format.
    glTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_LUMINANCE, 2, 2, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, data);
    GLint value = 0;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_INTERNAL_FORMAT, &value);
    EXPECT_EQ(value, GL_LUMINANCE);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED, &value);
    EXPECT_EQ(value, 0);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED_IMAGE_SIZE, &value);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    glGetCompressedTexImage(GL_TEXTURE_2D, 0, back);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
}

#endif

} // namespace
