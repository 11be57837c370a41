// Tests images in constant memory (TexConstantImage2DSPANGLE). They are sampled where they are without a
// copy, and copied when they are written.
#include <array>
#include <cstring>

#include <spangle/native.hpp>

#include "tests/gl/texture/drawing.hpp"

namespace {

struct ConstantImages : spangle::test::Drawing {
    void SetUp() override {
        Drawing::SetUp();
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_NICEST);
    }
    static void refused(GLenum code) { EXPECT_EQ(glGetError(), code); }

    /// Returns texel (i, j) of a 4 x 4 image, or of any level of its chain.
    std::array<int, 4> texel(int i, int j, int side = 4, int level = 0) {
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, static_cast<float>(level));
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_LOD, static_cast<float>(level));
        std::vector<GLubyte> pixel;
        draw((static_cast<float>(i) + 0.5f) / static_cast<float>(side),
             (static_cast<float>(j) + 0.5f) / static_cast<float>(side), pixel);
        return {pixel[0], pixel[1], pixel[2], pixel[3]};
    }
};

struct Kept {
    GLenum internal_format, format, type;
    GLsizei bytes;
};
constexpr Kept kept[] = {{GL_RGB565, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 2},
                         {GL_RGB5, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 2},
                         {GL_RGBA4, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, 2},
                         {GL_RGB5_A1, GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, 2},
                         {GL_R3_G3_B2, GL_RGB, GL_UNSIGNED_BYTE_3_3_2, 1},
                         {GL_RGB8, GL_RGB, GL_UNSIGNED_BYTE, 3},
                         {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4},
                         {GL_LUMINANCE8, GL_LUMINANCE, GL_UNSIGNED_BYTE, 1},
                         {GL_INTENSITY8, GL_LUMINANCE, GL_UNSIGNED_BYTE, 1},
                         {GL_ALPHA8, GL_ALPHA, GL_UNSIGNED_BYTE, 1},
                         {GL_LUMINANCE8_ALPHA8, GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, 2}};

alignas(4) constexpr auto bytes = [] {
    std::array<GLubyte, 64> out{};
    for (unsigned i = 0; i < out.size(); ++i)
        out[i] = static_cast<GLubyte>(i * 37 + 11);
    return out;
}();

/// In every format, texels in constant memory are what TexImage makes of the same bytes.
TEST_F(ConstantImages, AreWhatTexImageKeeps) {
    for (const Kept& k : kept) {
        glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(k.internal_format), 4, 4, 0, k.format, k.type,
                     bytes.data());
        std::array<std::array<int, 4>, 16> copied;
        for (int n = 0; n < 16; ++n)
            copied[static_cast<std::size_t>(n)] = texel(n % 4, n / 4);
        glTexConstantImage2DSPANGLE(GL_TEXTURE_2D, 0, k.internal_format, 4, 4, 0, 16 * k.bytes, bytes.data());
        for (int n = 0; n < 16; ++n)
            EXPECT_EQ(texel(n % 4, n / 4), copied[static_cast<std::size_t>(n)])
                << std::hex << k.internal_format << std::dec << " texel " << n;
        GLint kept_as = 0;
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_INTERNAL_FORMAT, &kept_as);
        EXPECT_EQ(static_cast<GLenum>(kept_as), k.internal_format);
    }
}

/// The program's own memory is sampled, so a change of it shows. The arena holds only the level's block,
/// whatever the size of the image.
TEST_F(ConstantImages, TakeNoMemory) {
    static std::array<GLushort, 256 * 256> large{};
    const std::size_t before = spangle::memory_use().used;
    glTexConstantImage2DSPANGLE(GL_TEXTURE_2D, 0, GL_RGB5, 256, 256, 0, sizeof large, large.data());
    EXPECT_LE(spangle::memory_use().used - before, 64u);
    EXPECT_EQ(texel(0, 0), (std::array{0, 0, 0, 255}));
    large.fill(0xF800);
    EXPECT_EQ(texel(0, 0), (std::array{255, 0, 0, 255})) << "not a copy";
    GLushort back[4] = {};
    glTexConstantImage2DSPANGLE(GL_TEXTURE_2D, 0, GL_RGB5, 2, 2, 0, 8, large.data());
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, back);
    EXPECT_EQ(back[3], 0xF800);
}

TEST_F(ConstantImages, AChainOfLevels) {
    static constexpr GLubyte l0[16] = {}, l1[4] = {80, 80, 80, 80}, l2[1] = {200};
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTexConstantImage2DSPANGLE(GL_TEXTURE_2D, 0, GL_LUMINANCE8, 4, 4, 0, 16, l0);
    glTexConstantImage2DSPANGLE(GL_TEXTURE_2D, 1, GL_LUMINANCE8, 2, 2, 0, 4, l1);
    glTexConstantImage2DSPANGLE(GL_TEXTURE_2D, 2, GL_LUMINANCE8, 1, 1, 0, 1, l2);
    EXPECT_EQ(texel(0, 0, 4, 0)[0], 0);
    EXPECT_EQ(texel(0, 0, 2, 1)[0], 80);
    EXPECT_EQ(texel(0, 0, 1, 2)[0], 200);
}

/// TexSubImage and CopyTexSubImage write into a copy, and the program's memory does not change.
TEST_F(ConstantImages, BecomeCopiesWhenWritten) {
    for (const bool from_pixels : {false, true}) {
        static std::array<GLubyte, 16> mine{};
        mine.fill(40);
        glTexConstantImage2DSPANGLE(GL_TEXTURE_2D, 0, GL_LUMINANCE8, 4, 4, 0, 16, mine.data());
        const std::size_t before = spangle::memory_use().used;
        if (from_pixels) {
#if SPANGLE_FEATURE_COPY_TEXTURE
            glClearColor(1, 1, 1, 1);
            glClear(GL_COLOR_BUFFER_BIT);
            glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 1, 2, 0, 0, 1, 1);
#else
            break;
#endif
        } else {
            const GLubyte white = 255;
            glTexSubImage2D(GL_TEXTURE_2D, 0, 1, 2, 1, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, &white);
        }
        EXPECT_GT(spangle::memory_use().used, before);
        EXPECT_EQ(texel(1, 2)[0], 255);
        EXPECT_EQ(texel(2, 2)[0], 40);
        for (const GLubyte byte : mine)
            EXPECT_EQ(byte, 40);
        mine.fill(90);
        EXPECT_EQ(texel(2, 2)[0], 40) << "its own from now on";
    }
}

#if SPANGLE_FEATURE_MIPMAP_GENERATION
TEST_F(ConstantImages, AreWhereMipmapsComeFrom) {
    static constexpr GLubyte grey[4] = {10, 20, 30, 40};
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTexConstantImage2DSPANGLE(GL_TEXTURE_2D, 0, GL_LUMINANCE8, 2, 2, 0, 4, grey);
    glGenerateMipmap(GL_TEXTURE_2D);
    EXPECT_EQ(texel(0, 0, 1, 1)[0], 25);
}
#endif

TEST_F(ConstantImages, ErrorsChangeNothing) {
    glTexConstantImage2DSPANGLE(GL_TEXTURE_2D, 0, GL_LUMINANCE8, 4, 4, 0, 16, bytes.data());
    const std::array<int, 4> first = texel(0, 0);
    const auto image = [](GLenum format, GLsizei width, GLint border, GLsizei size, const void* data) {
        glTexConstantImage2DSPANGLE(GL_TEXTURE_2D, 0, format, width, 4, border, size, data);
    };
    for (const GLenum unsized : {GL_RGB, GL_LUMINANCE, GL_RGBA2, GL_RGBA16, GL_DEPTH_COMPONENT24}) {
        image(unsized, 4, 0, 64, bytes.data() + 1);
        refused(GL_INVALID_ENUM);
    }
    image(GL_RGB5, 4, 0, 32, bytes.data() + 1); // 16-bit texels at an odd address
    refused(GL_INVALID_VALUE);
    for (int i = 1; i < 4; ++i) { // tries words of 32 bits in the same way
        image(GL_RGBA8, 3, 0, 48, bytes.data() + i);
        refused(GL_INVALID_VALUE);
    }
    image(GL_LUMINANCE8, 4, 0, 15, bytes.data());
    refused(GL_INVALID_VALUE);
    image(GL_LUMINANCE8, 4, 0, -16, bytes.data());
    refused(GL_INVALID_VALUE);
    image(GL_LUMINANCE8, 4, 1, 16, bytes.data());
    refused(GL_INVALID_VALUE);
    image(GL_LUMINANCE8, -4, 0, -16, bytes.data());
    refused(GL_INVALID_VALUE);
    image(GL_LUMINANCE8, 4, 0, 16, nullptr);
    refused(GL_INVALID_VALUE);
    glTexConstantImage2DSPANGLE(GL_TEXTURE_3D, 0, GL_LUMINANCE8, 4, 4, 0, 16, bytes.data());
    refused(GL_INVALID_ENUM);
    EXPECT_EQ(texel(0, 0), first);
    glTexConstantImage2DSPANGLE(GL_PROXY_TEXTURE_2D, 0, GL_RGB5, 64, 32, 0, 0, nullptr);
    GLint width = 0;
    glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    EXPECT_EQ(width, 64);
}

} // namespace
