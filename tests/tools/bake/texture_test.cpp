// Tests baked textures: GL samples what the baker reports, in every format and level, and the reported
// distance from the picture is right.
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <spangle/GL/gl.h>

#include "host_sim/bake/etc1.hpp"
#include "host_sim/bake/palette.hpp"
#include "host_sim/bake/texture.hpp"
#include "tests/support/headless_gl.hpp"

namespace spangle::bake {
namespace {

using Bytes = std::vector<std::uint8_t>;

cli::ModelImage smooth_picture(int width, int height, bool translucent) {
    cli::ModelImage image{width, height, {}, translucent};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int c : {x * 255 / width, y * 255 / height, 255 - (x + y) * 127 / (width + height),
                                translucent ? (x * 7 + y * 13) % 256 : 255})
                image.rgba.push_back(static_cast<std::uint8_t>(c));
    return image;
}

GLenum token_of(const char* name) {
    const std::pair<const char*, GLenum> tokens[] = {{"GL_RGB565", GL_RGB565},
                                                     {"GL_RGBA4", GL_RGBA4},
                                                     {"GL_RGB5_A1", GL_RGB5_A1},
                                                     {"GL_R3_G3_B2", GL_R3_G3_B2},
                                                     {"GL_RGB8", GL_RGB8},
                                                     {"GL_RGBA8", GL_RGBA8},
                                                     {"GL_LUMINANCE8", GL_LUMINANCE8},
                                                     {"GL_ALPHA8", GL_ALPHA8},
                                                     {"GL_LUMINANCE8_ALPHA8", GL_LUMINANCE8_ALPHA8},
                                                     {"GL_ETC1_RGB8_OES", GL_ETC1_RGB8_OES},
                                                     {"GL_PALETTE4_RGB8_OES", GL_PALETTE4_RGB8_OES},
                                                     {"GL_PALETTE4_RGBA8_OES", GL_PALETTE4_RGBA8_OES},
                                                     {"GL_PALETTE4_R5_G6_B5_OES", GL_PALETTE4_R5_G6_B5_OES},
                                                     {"GL_PALETTE4_RGBA4_OES", GL_PALETTE4_RGBA4_OES},
                                                     {"GL_PALETTE4_RGB5_A1_OES", GL_PALETTE4_RGB5_A1_OES},
                                                     {"GL_PALETTE8_RGB8_OES", GL_PALETTE8_RGB8_OES},
                                                     {"GL_PALETTE8_RGBA8_OES", GL_PALETTE8_RGBA8_OES},
                                                     {"GL_PALETTE8_R5_G6_B5_OES", GL_PALETTE8_R5_G6_B5_OES},
                                                     {"GL_PALETTE8_RGBA4_OES", GL_PALETTE8_RGBA4_OES},
                                                     {"GL_PALETTE8_RGB5_A1_OES", GL_PALETTE8_RGB5_A1_OES}};
    for (const auto& [text, token] : tokens)
        if (text == std::string(name))
            return token;
    return GL_NONE;
}

/// Gives the levels to GL as <spangle/baked.hpp> does.
void load(const BakedTexture& texture) {
    const TextureFormat& f = *texture.format;
    for (std::size_t l = 0; l < texture.levels.size(); ++l) {
        const BakedLevel& level = texture.levels[l];
        const GLint number = f.kind == TexelKind::palette ? 1 - texture.chain : static_cast<GLint>(l);
        const auto give =
            f.format == nullptr ? &glCompressedTexConstantImage2DSPANGLE : &glTexConstantImage2DSPANGLE;
        give(GL_TEXTURE_2D, number, token_of(f.internal_format), level.width, level.height, 0,
             static_cast<GLsizei>(level.bytes.size()), level.bytes.data());
    }
}

/// Returns one level, drawn one texel to a pixel.
Bytes sampled(int level, int width, int height) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, level);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LOD, level);
    glViewport(0, 0, width, height);
    glBegin(GL_TRIANGLE_STRIP);
    for (const float y : {0.0f, 1.0f})
        for (const float x : {0.0f, 1.0f}) {
            glTexCoord2f(x, y);
            glVertex2f(2 * x - 1, 2 * y - 1);
        }
    glEnd();
    Bytes pixels(static_cast<std::size_t>(width * height) * 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
}

class BakedTextures : public testing::Test {
  protected:
    test::HeadlessGl gl{64, 64};
    void SetUp() override {
        glDisable(GL_DITHER);
        glEnable(GL_TEXTURE_2D);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_NICEST);
    }
    void TearDown() override { EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}); }
};

TEST_F(BakedTextures, AreSampledAsTheyWereMeant) {
    EXPECT_EQ(texture_formats().count, 20u);
    for (const TextureFormat& format : texture_formats()) {
        const BakedTexture texture = bake_texture(smooth_picture(32, 16, true), {&format, true});
        ASSERT_EQ(texture.chain, 6) << format.name;
        load(texture);
        ASSERT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << format.name;
        glColor4ub(255, 255, 255, 255); // an alpha texture keeps these colours
        int width = 32, height = 16;
        for (int level = 0; level < texture.chain; ++level) {
            const Bytes meant = decode_level(texture, level), seen = sampled(level, width, height);
            ASSERT_EQ(meant.size(), seen.size());
            for (std::size_t i = 0; i < meant.size(); ++i)
                ASSERT_NEAR(meant[i], seen[i], 1)
                    << format.name << " level " << level << " texel " << i / 4 << " component " << i % 4;
            width = std::max(width / 2, 1);
            height = std::max(height / 2, 1);
        }
    }
}

/// The reported PSNR is right, and as good as the format allows on a smooth picture.
TEST_F(BakedTextures, SayHowFarTheyAreFromThePicture) {
    const cli::ModelImage picture = smooth_picture(64, 64, false);
    const std::pair<const char*, double> least[] = {{"rgb565", 39},    {"rgb888", 99},   {"rgb332", 21},
                                                    {"etc1", 30},      {"rgba4444", 34}, {"p8-rgb888", 34},
                                                    {"p4-rgb888", 20}, {"rgba5551", 36}};
    for (const auto& [name, db] : least) {
        const BakedTexture texture = bake_texture(picture, {find_format(name), false});
        EXPECT_GE(texture.psnr_db, db) << name;
        const Bytes kept = decode_level(texture, 0);
        double squares = 0, n = 0;
        for (std::size_t i = 0; i < kept.size(); ++i)
            if (texture.format->bits[i % 4] != 0) {
                squares += (kept[i] - picture.rgba[i]) * (kept[i] - picture.rgba[i]);
                ++n;
            }
        if (squares > 0) {
            EXPECT_NEAR(texture.psnr_db, 10 * std::log10(255 * 255 * n / squares), 1e-9) << name;
        }
    }
    EXPECT_STREQ(bake_texture(picture, {}).format->name, "rgb565");
    EXPECT_STREQ(bake_texture(smooth_picture(4, 4, true), {}).format->name, "rgba4444");
    EXPECT_EQ(find_format("rgb31"), nullptr);
}

TEST_F(BakedTextures, HaveTheBytesOfTheirFormat) {
    const std::pair<const char*, std::size_t> bytes[] = {
        {"rgb565", 32 * 16 * 2}, {"rgb332", 32 * 16},     {"rgb888", 32 * 16 * 3},
        {"etc1", 32 * 16 / 2},   {"p4-rgb565", 32 + 256}, {"p8-rgba8888", 1024 + 512}};
    for (const auto& [name, n] : bytes)
        EXPECT_EQ(bake_texture(smooth_picture(32, 16, false), {find_format(name), false}).bytes(), n) << name;
    EXPECT_EQ(bake_texture(smooth_picture(32, 16, false), {find_format("l8"), true}).bytes(),
              32u * 16 + 16 * 8 + 8 * 4 + 4 * 2 + 2 + 1);
}

/// Each level is what GENERATE_MIPMAP would make of the level above it.
TEST_F(BakedTextures, LevelsAreMeans) {
    const cli::ModelImage image{
        2, 2, {0, 10, 20, 255, 4, 10, 20, 255, 8, 10, 20, 255, 100, 10, 20, 255}, false};
    const BakedTexture texture = bake_texture(image, {find_format("rgb888"), true});
    ASSERT_EQ(texture.chain, 2);
    EXPECT_EQ(texture.levels[1].bytes, (Bytes{28, 10, 20}));
    const cli::ModelImage row{4, 1, {0, 0, 0, 255, 9, 0, 0, 255, 20, 0, 0, 255, 40, 0, 0, 255}, false};
    EXPECT_EQ(bake_texture(row, {find_format("rgb888"), true}).levels[1].bytes, (Bytes{5, 0, 0, 30, 0, 0}));
}

TEST_F(BakedTextures, LuminanceIsThatOfTheColour) {
    cli::ModelImage image{1, 1, {255, 0, 0, 255}, false};
    EXPECT_EQ(bake_texture(image, {find_format("l8"), false}).levels[0].bytes, Bytes{76});
    image.rgba = {90, 90, 90, 255};
    EXPECT_EQ(bake_texture(image, {find_format("l8"), false}).levels[0].bytes, Bytes{90}) << "greys stay";
}

TEST(Palettes, KeepAllColoursWhereThereIsRoom) {
    Bytes rgba;
    for (int i = 0; i < 16; ++i)
        for (const int c : {17 * i, 255 - 17 * i, 0, 255})
            rgba.push_back(static_cast<std::uint8_t>(c));
    constexpr std::uint8_t eight[4] = {8, 8, 8, 8};
    EXPECT_EQ(choose_palette(rgba, 16, eight).size(), 16u);
    const std::vector<Rgba> four = choose_palette(rgba, 4, eight);
    EXPECT_EQ(four.size(), 4u);
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        const Rgba color{rgba[i], rgba[i + 1], rgba[i + 2], rgba[i + 3]},
            near = four[nearest_entry(four, color)];
        EXPECT_LE(std::abs(near[0] - color[0]), 40);
    }
    constexpr std::uint8_t opaque565[4] = {5, 6, 5, 0};
    EXPECT_EQ(rounded({10, 10, 10, 7}, opaque565), (Rgba{8, 8, 8, 255}));
}

/// Blocks have one colour, two, or noise. Each decodes to what the extension's tables say, near its source.
TEST(Etc1, BlocksAreNearTheirTexels) {
    std::mt19937 random(3);
    for (int round = 0; round < 50; ++round) {
        Bytes rgba;
        const Rgba a{static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()),
                     static_cast<std::uint8_t>(random()), 255};
        const Rgba other{static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()),
                         static_cast<std::uint8_t>(random()), 255};
        const int kind = round % 4; // 0: one colour; 1, 2: two colours beside or above each other; 3: noise
        for (int i = 0; i < 8 * 8; ++i) {
            const bool second = kind == 1 ? i % 4 >= 2 : kind == 2 ? i / 8 % 4 >= 2 : false;
            for (std::size_t c = 0; c < 4; ++c)
                rgba.push_back(c == 3      ? std::uint8_t{255}
                               : kind == 3 ? static_cast<std::uint8_t>(random() % 256)
                               : second    ? other[c]
                                           : a[c]);
        }
        const Bytes blocks = encode_etc1(rgba, 8, 8);
        ASSERT_EQ(blocks.size(), 32u);
        const Bytes kept = decode_etc1(blocks, 8, 8);
        double squares = 0;
        for (std::size_t i = 0; i < kept.size(); ++i)
            squares += (kept[i] - rgba[i]) * (kept[i] - rgba[i]);
        EXPECT_LE(std::sqrt(squares / 192), kind == 0 ? 3.0 : kind < 3 ? 6.0 : 75.0) << "round " << round;
    }
    EXPECT_EQ(encode_etc1(Bytes(5 * 3 * 4, 90), 5, 3).size(), 16u) << "two blocks, their rest repeated";
}

} // namespace
} // namespace spangle::bake
