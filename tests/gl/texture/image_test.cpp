// Tests images from the framebuffer, derived levels, read-back, residency, and compared depths
// (docs/features.md F02, F03, F06, F13 to F17, F21, F29).
#include <climits>
#include <cmath>

#include "tests/gl/texture/drawing.hpp"
#include "tests/support/random.hpp"

namespace {

struct Images : spangle::test::Drawing {
    spangle::test::Random random{23};

    std::vector<GLubyte> bytes(std::size_t n) {
        std::vector<GLubyte> v(n);
        for (GLubyte& b : v)
            b = static_cast<GLubyte>(random.below(256));
        return v;
    }
    std::vector<GLubyte> read(GLenum target, GLint level, GLenum format, std::size_t n) {
        std::vector<GLubyte> v(n);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glGetTexImage(target, level, format, GL_UNSIGNED_BYTE, v.data());
        return v;
    }
    GLint level(GLenum target, GLint level, GLenum pname) {
        GLint v = -1;
        glGetTexLevelParameteriv(target, level, pname, &v);
        return v;
    }
    /// Fills the surface so that every pixel has another colour.
    std::vector<GLubyte> paint() {
        const std::vector<GLubyte> pixels = bytes(64);
        glDisable(GL_TEXTURE_2D);
        glDisable(GL_DITHER);
        for (int n = 0; n < 16; ++n) {
            glColor4ubv(pixels.data() + 4 * n);
            glEnable(GL_SCISSOR_TEST);
            glScissor(n % 4, n / 4, 1, 1);
            glRecti(-1, -1, 1, 1);
        }
        glDisable(GL_SCISSOR_TEST);
        return pixels;
    }
};

TEST_F(Images, AreReadBackAsTheyAreKept) {
    const std::vector<GLubyte> pixels = bytes(4 * 6 * 5);
    const struct {
        GLint internal;
        int from[4]; ///< component of the pixel; -1: 0, -2: 1 (table 6.1)
    } cases[] = {{GL_ALPHA8, {-1, -1, -1, 3}},
                 {GL_LUMINANCE8, {0, -1, -1, -2}},
                 {GL_LUMINANCE8_ALPHA8, {0, -1, -1, 3}},
                 {GL_INTENSITY8, {0, -1, -1, -2}},
                 {GL_RGB8, {0, 1, 2, -2}},
                 {GL_RGBA8, {0, 1, 2, 3}}};
    for (const auto& c : cases) {
        glTexImage2D(GL_TEXTURE_2D, 0, c.internal, 6, 5, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        const std::vector<GLubyte> got = read(GL_TEXTURE_2D, 0, GL_RGBA, pixels.size());
        for (std::size_t n = 0; n < got.size(); ++n) {
            const int from = c.from[n % 4];
            const int wanted = from == -1   ? 0
                               : from == -2 ? 255
                                            : pixels[n / 4 * 4 + static_cast<std::size_t>(from)];
            ASSERT_EQ(got[n], wanted) << std::hex << c.internal << std::dec << ' ' << n;
        }
    }
    // A volume is read in slices, as the pack state says.
    const std::vector<GLubyte> volume = bytes(2 * 3 * 2);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_LUMINANCE8, 2, 3, 2, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, volume.data());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_PACK_ROW_LENGTH, 4);
    glPixelStorei(GL_PACK_IMAGE_HEIGHT, 5);
    glPixelStorei(GL_PACK_SKIP_IMAGES, 1);
    std::vector<GLubyte> got(3 * 5 * 4, 9);
    glGetTexImage(GL_TEXTURE_3D, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, got.data());
    for (std::size_t z = 0; z < 2; ++z)
        for (std::size_t y = 0; y < 3; ++y)
            for (std::size_t x = 0; x < 2; ++x)
                EXPECT_EQ(got[(z + 1) * 20 + y * 4 + x], volume[z * 6 + y * 2 + x]);
    EXPECT_EQ(got[19], 9);
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    glPixelStorei(GL_PACK_IMAGE_HEIGHT, 0);
    glPixelStorei(GL_PACK_SKIP_IMAGES, 0);
    const struct {
        GLenum target;
        GLint level;
        GLenum format, wanted;
    } refused[] = {{GL_TEXTURE_2D, -1, GL_RGBA, GL_INVALID_VALUE},
                   {GL_TEXTURE_2D, 12, GL_RGBA, GL_INVALID_VALUE},
                   {GL_PROXY_TEXTURE_2D, 0, GL_RGBA, GL_INVALID_ENUM},
                   {GL_TEXTURE_CUBE_MAP, 0, GL_RGBA, GL_INVALID_ENUM},
                   {GL_TEXTURE_2D, 0, GL_COLOR_INDEX, GL_INVALID_ENUM},
                   {GL_TEXTURE_2D, 0, GL_STENCIL_INDEX, GL_INVALID_ENUM},
                   {GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_INVALID_OPERATION}};
    for (const auto& r : refused) {
        glGetTexImage(r.target, r.level, r.format, GL_UNSIGNED_BYTE, got.data());
        EXPECT_EQ(glGetError(), r.wanted) << &r - refused;
    }
}

/// Every base format is made from each of GetTexImage's formats and read in each of them. By table 6.1
/// luminance is read as red only. Images of the framebuffer are the same: CopyTexImage takes the red of a
/// pixel as luminance and intensity (GL 1.3, 3.8.1 and 3.8.2).
TEST_F(Images, EveryFormatOfEveryBaseFormat) {
    const struct {
        GLenum internal;
        int from[4]; ///< component of the pixel; -1: 0, -2: 1 (table 6.1)
    } bases[] = {{GL_ALPHA8, {-1, -1, -1, 3}},
                 {GL_LUMINANCE8, {0, -1, -1, -2}},
                 {GL_LUMINANCE8_ALPHA8, {0, -1, -1, 3}},
                 {GL_INTENSITY8, {0, -1, -1, -2}},
                 {GL_RGB8, {0, 1, 2, -2}},
                 {GL_RGBA8, {0, 1, 2, 3}}};
    const struct {
        GLenum format;
        std::vector<int> parts; ///< components in the order R, G, B, A
    } formats[] = {{GL_RED, {0}},           {GL_GREEN, {1}},
                   {GL_BLUE, {2}},          {GL_ALPHA, {3}},
                   {GL_RGB, {0, 1, 2}},     {GL_BGR, {2, 1, 0}},
                   {GL_RGBA, {0, 1, 2, 3}}, {GL_BGRA, {2, 1, 0, 3}},
                   {GL_LUMINANCE, {0}},     {GL_LUMINANCE_ALPHA, {0, 3}}};
    const auto verify = [&](const auto& base, const std::vector<GLubyte>& pixels, const char* how) {
        for (const auto& format : formats) {
            const std::size_t count = pixels.size() / 4;
            std::vector<GLfloat> reals(count * format.parts.size(), -1);
            const std::vector<GLubyte> got = read(GL_TEXTURE_2D, 0, format.format, reals.size());
            glGetTexImage(GL_TEXTURE_2D, 0, format.format, GL_FLOAT, reals.data());
            for (std::size_t n = 0; n < got.size(); ++n) {
                const int part = format.parts[n % format.parts.size()], from = base.from[part];
                const int wanted = from == -1 ? 0
                                   : from == -2
                                       ? 255
                                       : pixels[n / format.parts.size() * 4 + static_cast<std::size_t>(from)];
                ASSERT_EQ(got[n], wanted) << how << std::hex << ' ' << base.internal << ' ' << format.format;
                ASSERT_FLOAT_EQ(reals[n], static_cast<GLfloat>(wanted) / 255)
                    << how << std::hex << ' ' << base.internal << ' ' << format.format;
            }
        }
    };
    std::vector<GLubyte> pixels = bytes(64);
    for (const auto& base : bases) {
        glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(base.internal), 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     pixels.data());
        verify(base, pixels, "TexImage");
    }
    pixels = paint();
    for (const auto& base : bases) {
        glCopyTexImage2D(GL_TEXTURE_2D, 0, base.internal, 0, 0, 4, 4, 0);
        verify(base, pixels, "CopyTexImage");
        glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(base.internal), 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     nullptr);
        glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 4, 4);
        verify(base, pixels, "CopyTexSubImage");
    }
    // Only ReadPixels makes luminance the sum of R, G and B, clamped to 1 (GL 1.3, 4.3.2).
    std::vector<GLubyte> sums(32);
    glReadPixels(0, 0, 4, 4, GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, sums.data());
    for (std::size_t n = 0; n < 16; ++n) {
        EXPECT_EQ(sums[2 * n], std::min(255, pixels[4 * n] + pixels[4 * n + 1] + pixels[4 * n + 2]));
        EXPECT_EQ(sums[2 * n + 1], pixels[4 * n + 3]);
    }
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(Images, SubImagesOfLinesAndVolumes) {
    std::vector<GLubyte> line = bytes(10), volume = bytes(6 * 4 * 4);
    glTexImage1D(GL_TEXTURE_1D, 0, GL_ALPHA, 10, 1, GL_ALPHA, GL_UNSIGNED_BYTE, line.data());
    const GLubyte part[2] = {1, 2};
    glTexSubImage1D(GL_TEXTURE_1D, 0, -1, 2, GL_ALPHA, GL_UNSIGNED_BYTE, part);
    line[0] = 1, line[1] = 2;
    EXPECT_EQ(read(GL_TEXTURE_1D, 0, GL_ALPHA, 10), line);
    glTexSubImage1D(GL_TEXTURE_1D, 0, 8, 2, GL_ALPHA, GL_UNSIGNED_BYTE, part);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    glTexSubImage1D(GL_TEXTURE_1D, 0, -2, 2, GL_ALPHA, GL_UNSIGNED_BYTE, part);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    glTexImage3D(GL_TEXTURE_3D, 0, GL_ALPHA, 6, 4, 4, 1, GL_ALPHA, GL_UNSIGNED_BYTE, volume.data());
    // A box of 2 x 1 x 2 is taken from images of 3 rows of 4, the second image first.
    const std::vector<GLubyte> from = bytes(3 * 3 * 4);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 4);
    glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, 3);
    glPixelStorei(GL_UNPACK_SKIP_IMAGES, 1);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 2);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 1);
    glTexSubImage3D(GL_TEXTURE_3D, 0, 3, -1, 1, 2, 1, 2, GL_ALPHA, GL_UNSIGNED_BYTE, from.data());
    for (std::size_t z = 0; z < 2; ++z)
        for (std::size_t x = 0; x < 2; ++x)
            volume[(z + 2) * 24 + x + 4] = from[(z + 1) * 12 + 2 * 4 + x + 1];
    EXPECT_EQ(read(GL_TEXTURE_3D, 0, GL_ALPHA, volume.size()), volume);
    glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 2, 1, 1, 2, GL_ALPHA, GL_UNSIGNED_BYTE, from.data());
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    for (const GLenum mode : {GL_UNPACK_ROW_LENGTH, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES,
                              GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS})
        glPixelStorei(mode, 0);
}

TEST_F(Images, CopiesAreWhatReadPixelsAndTexImageMake) {
    const std::vector<GLubyte> pixels = paint();
    for (const GLenum internal : {GL_RGBA8, GL_RGB5, GL_ALPHA8, GL_LUMINANCE8, GL_INTENSITY8, GL_RGBA4}) {
        glCopyTexImage2D(GL_TEXTURE_2D, 0, internal, 1, 0, 3, 4, 0);
        const std::vector<GLubyte> copied = read(GL_TEXTURE_2D, 0, GL_RGBA, 48);
        std::vector<GLubyte> direct;
        for (std::size_t n = 0; n < 48; ++n)
            direct.push_back(pixels[n / 12 * 16 + 4 + n % 12]);
        glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal), 3, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     direct.data());
        EXPECT_EQ(copied, read(GL_TEXTURE_2D, 0, GL_RGBA, 48)) << std::hex << internal;
    }
    // Texels outside of the framebuffer are zero in a new image, and unchanged in an old one. Pixel transfer
    // applies.
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, -1, -1, 2, 2, 0);
    std::vector<GLubyte> got = read(GL_TEXTURE_2D, 0, GL_RGBA, 16);
    EXPECT_EQ(got[0], 0);
    EXPECT_EQ(got[12], pixels[0]);
    // These distances outside of the framebuffer do not fit 32 bits. Nothing is copied, and a new image is
    // zero.
    for (const GLint far : {INT_MIN, INT_MIN + 1, -100, 100, INT_MAX}) {
        glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, far, 0, 2, 2, 0);
        EXPECT_EQ(read(GL_TEXTURE_2D, 0, GL_RGBA, 16), std::vector<GLubyte>(16, 0)) << far;
        glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, far, 2, 2, 0);
        EXPECT_EQ(read(GL_TEXTURE_2D, 0, GL_RGBA, 16), std::vector<GLubyte>(16, 0)) << far;
        glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, -1, -1, 2, 2, 0);
        glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, far, far, 2, 2);
        EXPECT_EQ(read(GL_TEXTURE_2D, 0, GL_RGBA, 16), got) << far;
    }
    glPixelTransferf(GL_RED_BIAS, 1);
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 1, 3, 3, 2, 1);
    glPixelTransferf(GL_RED_BIAS, 0);
    got = read(GL_TEXTURE_2D, 0, GL_RGBA, 16);
    EXPECT_EQ(got[8], 255);
    EXPECT_EQ(got[9], pixels[61]);
    EXPECT_EQ(got[13], pixels[1]); // this texel lies beyond the surface, and is unchanged
    glCopyTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA8, 0, 2, 4, 0);
    EXPECT_EQ(read(GL_TEXTURE_1D, 0, GL_RGBA, 16),
              std::vector<GLubyte>(pixels.begin() + 32, pixels.begin() + 48));
    glCopyTexSubImage1D(GL_TEXTURE_1D, 0, 1, 0, 0, 1);
    EXPECT_EQ(read(GL_TEXTURE_1D, 0, GL_RGBA, 16)[4], pixels[0]);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, 2, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glCopyTexSubImage3D(GL_TEXTURE_3D, 0, 1, 0, 1, 2, 1, 1, 2);
    got = read(GL_TEXTURE_3D, 0, GL_RGBA, 32);
    EXPECT_EQ(got[20], pixels[4 * 4 + 8]);
    EXPECT_EQ(got[28], pixels[8 * 4 + 8]);
    EXPECT_EQ(got[16], 0);
    glCopyTexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, 0, GL_RGB8, 0, 0, 2, 2, 0);
    EXPECT_EQ(read(GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, 0, GL_RGB, 12)[3], pixels[4]);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    for (const GLenum none : {1, 2, 3, 4, 0, 5, GL_BGRA}) { // TexImage takes the first four
        glCopyTexImage2D(GL_TEXTURE_2D, 0, none, 0, 0, 2, 2, 0);
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    }
    glCopyTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGB, 0, 0, 2, 2, 0);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 1, 1, 0, 0, 2, 1);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
}

TEST_F(Images, LevelsFollowTheBaseLevel) {
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    for (int round = 0; round < 30; ++round) {
        const int w = 1 + static_cast<int>(random.below(9)), h = 1 + static_cast<int>(random.below(9)),
                  border = static_cast<int>(random.below(2));
        const std::size_t n = static_cast<std::size_t>((w + 2 * border) * (h + 2 * border));
        std::vector<GLubyte> up = bytes(n * 4);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, w + 2 * border, h + 2 * border, border, GL_RGBA,
                     GL_UNSIGNED_BYTE, up.data());
        int uw = w, uh = h;
        for (GLint l = 1; uw > 1 || uh > 1; ++l) {
            const int dw = std::max(uw / 2, 1), dh = std::max(uh / 2, 1);
            ASSERT_EQ(level(GL_TEXTURE_2D, l, GL_TEXTURE_WIDTH), dw + 2 * border);
            ASSERT_EQ(level(GL_TEXTURE_2D, l, GL_TEXTURE_HEIGHT), dh + 2 * border);
            const std::vector<GLubyte> got =
                read(GL_TEXTURE_2D, l, GL_RGBA,
                     static_cast<std::size_t>((dw + 2 * border) * (dh + 2 * border) * 4));
            const auto source = [&](int i, int size, int next, int k) {
                return i < 0 ? -1 : i >= next ? size : std::min(2 * i + k, size - 1);
            };
            for (int j = -border; j < dh + border; ++j)
                for (int i = -border; i < dw + border; ++i)
                    for (int c = 0; c < 4; ++c) {
                        double sum = 0;
                        for (int k = 0; k < 4; ++k) {
                            const int x = source(i, uw, dw, k & 1), y = source(j, uh, dh, k >> 1);
                            sum += up[static_cast<std::size_t>(
                                ((y + border) * (uw + 2 * border) + x + border) * 4 + c)];
                        }
                        ASSERT_NEAR(got[static_cast<std::size_t>(
                                        ((j + border) * (dw + 2 * border) + i + border) * 4 + c)],
                                    sum / 4, 0.5)
                            << w << 'x' << h << " level " << l << " at " << i << ' ' << j;
                    }
            up = got, uw = dw, uh = dh;
        }
    }
    // Levels are derived again when a part of the base level changes, after a copy, and by a command.
    const GLubyte white[4] = {255, 255, 255, 255};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE8, 2, 2, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, nullptr);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, white);
    EXPECT_EQ(read(GL_TEXTURE_2D, 1, GL_LUMINANCE, 1)[0], 64);
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_FALSE);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 2, 2, GL_LUMINANCE, GL_UNSIGNED_BYTE, white);
    EXPECT_EQ(read(GL_TEXTURE_2D, 1, GL_LUMINANCE, 1)[0], 64);
    glGenerateMipmap(GL_TEXTURE_2D);
    EXPECT_EQ(read(GL_TEXTURE_2D, 1, GL_LUMINANCE, 1)[0], 255);
    const std::vector<GLubyte> volume = bytes(8);
    int sum = 4;
    for (const GLubyte b : volume)
        sum += b;
    glTexImage3D(GL_TEXTURE_3D, 0, GL_ALPHA8, 2, 2, 2, 0, GL_ALPHA, GL_UNSIGNED_BYTE, volume.data());
    glGenerateMipmap(GL_TEXTURE_3D);
    EXPECT_EQ(read(GL_TEXTURE_3D, 1, GL_ALPHA, 1)[0], sum / 8);
    glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_ALPHA8, 2, 2, 0, GL_ALPHA, GL_UNSIGNED_BYTE, nullptr);
    glGenerateMipmap(GL_TEXTURE_CUBE_MAP);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION}); // five faces are missing
}

/// A mean halfway between two codes is rounded up, in every dimension and format.
TEST_F(Images, MeansOfTexelsRoundHalfUp) {
    const struct {
        GLenum target;
        GLsizei w, h, d;
    } shapes[] = {{GL_TEXTURE_1D, 2, 1, 1}, {GL_TEXTURE_2D, 2, 1, 1}, {GL_TEXTURE_2D, 1, 2, 1},
                  {GL_TEXTURE_2D, 2, 2, 1}, {GL_TEXTURE_3D, 2, 2, 2}, {GL_TEXTURE_3D, 1, 1, 2}};
    for (const auto& s : shapes) {
        const int texels = s.w * s.h * s.d;
        for (int more = 0; more <= texels; ++more) { // so many texels are larger by one
            std::vector<GLubyte> image(static_cast<std::size_t>(texels), 6);
            std::fill_n(image.begin(), more, GLubyte{7});
            if (s.target == GL_TEXTURE_1D)
                glTexImage1D(s.target, 0, GL_LUMINANCE8, s.w, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE,
                             image.data());
            else if (s.target == GL_TEXTURE_2D)
                glTexImage2D(s.target, 0, GL_LUMINANCE8, s.w, s.h, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE,
                             image.data());
            else
                glTexImage3D(s.target, 0, GL_LUMINANCE8, s.w, s.h, s.d, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE,
                             image.data());
            glGenerateMipmap(s.target);
            EXPECT_EQ(read(s.target, 1, GL_LUMINANCE, 1)[0], 2 * more < texels ? 6 : 7)
                << s.w << 'x' << s.h << 'x' << s.d << ", " << more;
        }
    }
    const GLubyte colors[2][4] = {{1, 2, 3, 4}, {2, 3, 4, 5}};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, colors);
    glGenerateMipmap(GL_TEXTURE_2D);
    EXPECT_EQ(read(GL_TEXTURE_2D, 1, GL_RGBA, 4), (std::vector<GLubyte>{2, 3, 4, 5}));
}

TEST_F(Images, ObjectsKeepTheirTarget) {
    GLint value = -1;
    const GLenum targets[] = {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP};
    const GLenum bindings[] = {GL_TEXTURE_BINDING_1D, GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_3D,
                               GL_TEXTURE_BINDING_CUBE_MAP};
    for (GLuint i = 0; i < 4; ++i)
        glBindTexture(targets[i], 40 + i);
    for (GLuint i = 0; i < 4; ++i) {
        glGetIntegerv(bindings[i], &value);
        EXPECT_EQ(value, static_cast<GLint>(40 + i));
        glBindTexture(targets[i], 40 + (i + 1) % 4);
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
        glTexParameteri(targets[i], GL_TEXTURE_WRAP_R, GL_CLAMP);
    }
    const GLuint all[4] = {40, 41, 42, 43}, unknown[2] = {40, 99}, zero[1] = {0};
    GLboolean resident[4] = {7, 7, 7, 7};
    EXPECT_EQ(glAreTexturesResident(4, all, resident), GL_TRUE);
    EXPECT_EQ(resident[0], 7); // all are resident, so the array does not change
    for (const GLuint* const names : {unknown, zero}) {
        EXPECT_EQ(glAreTexturesResident(names == zero ? 1 : 2, names, resident), GL_FALSE);
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    }
    EXPECT_EQ(glAreTexturesResident(-1, all, resident), GL_FALSE);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    const GLuint some[3] = {0, 99, 41};
    const GLclampf priorities[3] = {0.5f, 0.5f, 7};
    glPrioritizeTextures(3, some, priorities);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    GLfloat priority = 0;
    glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_PRIORITY, &priority);
    EXPECT_EQ(priority, 1);
    const GLclampf quarter = 0.25f;
    glPrioritizeTextures(1, all + 2, &quarter);
    glGetTexParameterfv(GL_TEXTURE_3D, GL_TEXTURE_PRIORITY, &priority);
    EXPECT_EQ(priority, 0.25f);
    glDeleteTextures(4, all);
    for (const GLenum binding : bindings) {
        glGetIntegerv(binding, &value);
        EXPECT_EQ(value, 0);
    }
}

TEST_F(Images, ProxiesOfEveryTargetAnswer) {
    glTexImage1D(GL_PROXY_TEXTURE_1D, 1, GL_RGBA4, 514, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    EXPECT_EQ(level(GL_PROXY_TEXTURE_1D, 1, GL_TEXTURE_WIDTH), 514);
    EXPECT_EQ(level(GL_PROXY_TEXTURE_1D, 1, GL_TEXTURE_HEIGHT), 1);
    EXPECT_EQ(level(GL_PROXY_TEXTURE_1D, 1, GL_TEXTURE_ALPHA_SIZE), 4);
    glTexImage3D(GL_PROXY_TEXTURE_3D, 0, GL_RGB5, 16, 8, 256, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    EXPECT_EQ(level(GL_PROXY_TEXTURE_3D, 0, GL_TEXTURE_DEPTH), 256);
    glTexImage3D(GL_PROXY_TEXTURE_3D, 0, GL_RGB5, 16, 8, 257, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    EXPECT_EQ(level(GL_PROXY_TEXTURE_3D, 0, GL_TEXTURE_WIDTH), 0);
    glTexImage2D(GL_PROXY_TEXTURE_CUBE_MAP, 0, GL_RGB5, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    EXPECT_EQ(level(GL_PROXY_TEXTURE_CUBE_MAP, 0, GL_TEXTURE_GREEN_SIZE), 6);
    glTexImage2D(GL_PROXY_TEXTURE_CUBE_MAP, 0, GL_RGB5, 8, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    EXPECT_EQ(level(GL_PROXY_TEXTURE_CUBE_MAP, 0, GL_TEXTURE_GREEN_SIZE), 0);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(Images, ACubeIsCompleteWithSixFacesThatAreAlike) {
    glDisable(GL_TEXTURE_2D);
    glEnable(GL_TEXTURE_CUBE_MAP);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    const GLubyte grey[16] = {50, 50, 50, 50, 50, 50, 50, 50, 50, 50, 50, 50, 50, 50, 50, 50};
    const auto face = [&](GLenum n, GLint internal, GLsizei size) {
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + n, 0, internal, size, size, 0, GL_LUMINANCE,
                     GL_UNSIGNED_BYTE, grey);
    };
    const auto seen = [&] {
        glColor4ub(9, 9, 9, 9);
        glTexCoord3f(1, 0, 0);
        std::vector<GLubyte> pixel(4);
        glRecti(-1, -1, 1, 1);
        glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
        return pixel[0];
    };
    for (GLenum n = 0; n < 5; ++n)
        face(n, GL_LUMINANCE, 2);
    EXPECT_EQ(seen(), 9);
    face(5, GL_LUMINANCE, 2);
    EXPECT_EQ(seen(), 50);
    face(3, GL_LUMINANCE, 4);
    EXPECT_EQ(seen(), 9);
    face(3, GL_LUMINANCE8, 2);
    EXPECT_EQ(seen(), 9);
    face(3, GL_LUMINANCE, 2);
    EXPECT_EQ(seen(), 50);
    // A cube map has precedence over a 2D texture (GL 1.3, 3.8.15).
    glEnable(GL_TEXTURE_2D);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 1, 1, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, grey);
    const GLubyte other = 80;
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, &other);
    EXPECT_EQ(seen(), 50);
    glDisable(GL_TEXTURE_CUBE_MAP);
    EXPECT_EQ(seen(), 80);
}

TEST_F(Images, DepthsAreComparedWithR) {
    const GLenum functions[] = {GL_NEVER,   GL_LESS,     GL_EQUAL,  GL_LEQUAL,
                                GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_NICEST);
    for (const GLint internal : {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24}) {
        const GLfloat depths[4] = {0.25f, 0.5f, 0.75f, 1};
        glTexImage2D(GL_TEXTURE_2D, 0, internal, 2, 2, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
        GLfloat back[4] = {};
        glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, back);
        for (int i = 0; i < 4; ++i)
            EXPECT_NEAR(back[i], depths[i], 1e-5);
        EXPECT_EQ(level(GL_TEXTURE_2D, 0, GL_TEXTURE_DEPTH_SIZE), internal == GL_DEPTH_COMPONENT16 ? 16 : 24);
        const auto seen = [&](float s, float r, int component) {
            glColor4ub(3, 3, 3, 3);
            glTexCoord3f(s, 0.25f, r);
            GLubyte pixel[4];
            glRecti(-1, -1, 1, 1);
            glReadPixels(1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
            return int{pixel[component]};
        };
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
        for (const GLenum f : functions) {
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, static_cast<GLint>(f));
            for (const float r : {-1.0f, 0.25f, 0.5f, 0.6f, 2.0f}) {
                const float clamped = std::fmin(std::fmax(r, 0), 1), d = 0.5f;
                const bool pass = f == GL_ALWAYS || (f == GL_LESS && clamped < d) ||
                                  (f == GL_EQUAL && clamped == d) || (f == GL_LEQUAL && clamped <= d) ||
                                  (f == GL_GREATER && clamped > d) || (f == GL_NOTEQUAL && clamped != d) ||
                                  (f == GL_GEQUAL && clamped >= d);
                EXPECT_EQ(seen(0.75f, r, 0), pass ? 255 : 0) << std::hex << f << ' ' << r;
            }
        }
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER,
                        GL_LINEAR); // weights of the passing texels: 0.3 passes 0.25 only
        EXPECT_NEAR(seen(0.375f, 0.3f, 0), 255 * 0.75, 0.51);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_ALPHA);
        EXPECT_EQ(seen(0.75f, 0.6f, 0), 3);
        EXPECT_EQ(seen(0.75f, 0.6f, 3), 255);
        glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_INTENSITY);
        EXPECT_EQ(seen(0.75f, 0.4f, 3), 0);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_NONE);
        glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_LUMINANCE);
        EXPECT_NEAR(seen(0.75f, 0, 0), 127.5, 0.51); // without comparison the depth itself is seen
    }
    const GLubyte bytes[4] = {};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE, bytes);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
    glTexImage3D(GL_TEXTURE_3D, 0, GL_DEPTH_COMPONENT16, 1, 1, 1, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE,
                 bytes);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
}

} // namespace
