// Row G24: tests pixel rectangles, bitmaps, read-back and copies on a surface of colour indices (GL 1.3,
// 3.6.3 to 3.7, 3.8.2, 4.3).
#include <array>

#include "tests/gl/pixel/index_canvas.hpp"

namespace spangle::test {
namespace {

#if SPANGLE_FEATURE_COLOR_INDEX

class IndexPixels : public IndexCanvas {
  protected:
    /// Fills the surface with 0, 1, 2, ... along the rows.
    static void count_up() {
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                surface().color_row(y)[x] = static_cast<std::uint8_t>(y * size + x);
    }
    static std::vector<int> read(int x, int y, int w, int h) {
        std::vector<GLubyte> bytes(static_cast<std::size_t>(w * h));
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(x, y, w, h, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, bytes.data());
        return {bytes.begin(), bytes.end()};
    }
};

TEST_F(IndexPixels, AreReadAsTheyAre) {
    count_up();
    EXPECT_EQ(read(0, 0, size, size), pixels());
    GLfloat real[2] = {};
    glReadPixels(3, 9, 2, 1, GL_COLOR_INDEX, GL_FLOAT, real);
    EXPECT_EQ(real[0], 147);
    EXPECT_EQ(real[1], 148);
    GLbyte small[2] = {};
    glReadPixels(3, 9, 2, 1, GL_COLOR_INDEX, GL_BYTE, small);
    EXPECT_EQ(small[0], 147 & 127);
    GLubyte bits = 0;
    glReadPixels(4, 0, 8, 1, GL_COLOR_INDEX, GL_BITMAP, &bits);
    EXPECT_EQ(bits, 0x55);
}

#if SPANGLE_FEATURE_PIXEL_TRANSFER
/// An index is shifted, then offset, then looked up in the map from indices to indices if MAP_COLOR is on.
/// Drawing, reading and copying do the same.
class IndexTransfer : public IndexPixels {
  protected:
    struct Case {
        int shift, offset;
        bool map;
        double (*of)(int index);
    };
    static constexpr Case cases[] = {{0, 0, false, [](int i) { return i * 1.0; }},
                                     {1, 0, false, [](int i) { return i * 2.0; }},
                                     {-2, 0, false, [](int i) { return i / 4.0; }},
                                     {0, 7, false, [](int i) { return i + 7.0; }},
                                     {2, -9, false, [](int i) { return i * 4 - 9.0; }},
                                     {0, 0, true, [](int i) { return 50.0 - (i & 3); }},
                                     {-1, 1, true, [](int i) { return 50.0 - (((i + 1) / 2 + 1) & 3); }}};
    static void set(const Case& c) {
        const GLfloat map[4] = {50, 49, 48, 47};
        glPixelMapfv(GL_PIXEL_MAP_I_TO_I, 4, map);
        glPixelTransferi(GL_INDEX_SHIFT, c.shift);
        glPixelTransferi(GL_INDEX_OFFSET, c.offset);
        glPixelTransferi(GL_MAP_COLOR, c.map ? 1 : 0);
    }
};

TEST_F(IndexTransfer, OfReading) {
    count_up();
    for (const Case& c : cases) {
        set(c);
        const std::vector<int> now = read(4, 2, 3, 2);
        for (int i = 0; i < 6; ++i)
            EXPECT_EQ(now[static_cast<std::size_t>(i)], nearest(c.of((2 + i / 3) * size + 4 + i % 3)))
                << c.shift << ' ' << c.offset << ' ' << c.map;
    }
}

#if SPANGLE_FEATURE_DRAW_PIXELS && SPANGLE_FEATURE_RASTER_POS
TEST_F(IndexTransfer, OfDrawing) {
    const GLubyte image[3] = {5, 130, 255};
    for (const Case& c : cases) {
        set(c);
        fill(1);
        glRasterPos2i(2, 3);
        glDrawPixels(3, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, image);
        for (int i = 0; i < 3; ++i)
            EXPECT_EQ(at(2 + i, 3), nearest(c.of(image[i]))) << c.shift << ' ' << c.offset << ' ' << c.map;
        EXPECT_EQ(at(5, 3), 1);
    }
}

TEST_F(IndexTransfer, OfCopying) {
    for (const Case& c : cases) {
        set(c);
        count_up();
        glRasterPos2i(9, 5);
        glCopyPixels(2, 1, 4, 2, GL_COLOR);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const bool copied = x >= 9 && x < 13 && y >= 5 && y < 7;
                EXPECT_EQ(at(x, y), copied ? nearest(c.of((y - 4) * size + x - 7)) : y * size + x);
            }
    }
}
#endif

/// An index map gives integers if its values are integers. Otherwise indices keep a fraction, which is
/// dithered.
TEST_F(IndexPixels, MapsKeepFractions) {
#if SPANGLE_FEATURE_DRAW_PIXELS && SPANGLE_FEATURE_RASTER_POS
    const GLfloat real[2] = {10.5f, 20};
    const GLuint whole[2] = {10, 20};
    const std::vector<GLubyte> zeros(size * size, 0);
    glPixelTransferi(GL_MAP_COLOR, 1);
    glEnable(GL_DITHER);
    glRasterPos2i(0, 0);
    glPixelMapfv(GL_PIXEL_MAP_I_TO_I, 2, real);
    glDrawPixels(size, size, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, zeros.data());
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            ASSERT_EQ(at(x, y), dithered(10.5, x, y));
    glPixelMapuiv(GL_PIXEL_MAP_I_TO_I, 2, whole);
    glDrawPixels(size, size, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, zeros.data());
    EXPECT_EQ(pixels(), std::vector<int>(size * size, 10));
#endif
}

/// Indices that are read as colours, or become texels, are looked up in the four maps (GL 1.3, 3.6.5, 3.8.2,
/// 4.3.2).
TEST_F(IndexPixels, BecomeColoursByTheMaps) {
    const GLfloat red[4] = {0, 1, 0.2f, 0.4f}, green[2] = {1, 0.6f}, blue[1] = {0.8f}, alpha[2] = {0, 1};
    glPixelMapfv(GL_PIXEL_MAP_I_TO_R, 4, red);
    glPixelMapfv(GL_PIXEL_MAP_I_TO_G, 2, green);
    glPixelMapfv(GL_PIXEL_MAP_I_TO_B, 1, blue);
    glPixelMapfv(GL_PIXEL_MAP_I_TO_A, 2, alpha);
    glPixelTransferi(GL_INDEX_OFFSET, 1);
    count_up();
    std::array<GLubyte, 16> rgba{};
    glReadPixels(1, 3, 4, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    const auto color = [&](int i) {
        const auto of = [](const GLfloat* map, int v) { return static_cast<int>(map[v] * 255 + 0.5f); };
        return std::array<int, 4>{of(red, i & 3), of(green, i & 1), of(blue, 0), of(alpha, i & 1)};
    };
    for (int x = 0; x < 4; ++x)
        for (int c = 0; c < 4; ++c)
            EXPECT_EQ(rgba[static_cast<std::size_t>(4 * x + c)], color(x + 2)[static_cast<std::size_t>(c)]);
    GLubyte luminance = 0;
    glReadPixels(2, 3, 1, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, &luminance);
    EXPECT_EQ(luminance, 255);
#if SPANGLE_FEATURE_COPY_TEXTURE
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 3, 4, 1, 0);
    std::array<GLubyte, 16> texels{};
    glPixelTransferi(GL_INDEX_OFFSET, 0);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    EXPECT_EQ(texels, rgba);
#endif
}
#endif

#if SPANGLE_FEATURE_DRAW_PIXELS && SPANGLE_FEATURE_RASTER_POS
/// Indices are drawn zoomed in both directions, row by row, of every type; fractions are dithered.
TEST_F(IndexPixels, AreDrawnZoomed) {
    const GLubyte image[2][2] = {{10, 20}, {30, 40}};
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glRasterPos2i(4, 12);
    glPixelZoom(3, -2);
    glDrawPixels(2, 2, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, image);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const bool inside = x >= 4 && x < 10 && y >= 8 && y < 12;
            EXPECT_EQ(at(x, y), inside ? image[(11 - y) / 2][(x - 4) / 3] : 0) << x << ' ' << y;
        }
    const GLfloat real[1] = {255.75f};
    glPixelZoom(size, size);
    glRasterPos2i(0, 0);
    glDrawPixels(1, 1, GL_COLOR_INDEX, GL_FLOAT, real);
    EXPECT_EQ(pixels(), std::vector<int>(size * size, 255));
    const GLfloat half[1] = {-0.5f};
    glEnable(GL_DITHER);
    glDrawPixels(1, 1, GL_COLOR_INDEX, GL_FLOAT, half);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            ASSERT_EQ(at(x, y), dithered(-0.5, x, y));
}

/// Drawn indices are fragments: depth, fog, logical operation and mask apply.
TEST_F(IndexPixels, AreFragments) {
    const GLubyte image[2] = {0x35, 0x35};
    fill(0x0F);
    glEnable(GL_INDEX_LOGIC_OP);
    glLogicOp(GL_XOR);
    glIndexMask(0xF7);
    glRasterPos2i(1, 1);
    glDrawPixels(2, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, image);
    EXPECT_EQ(at(1, 1), ((0x35 ^ 0x0F) & 0xF7) | 0x08);
    glDisable(GL_INDEX_LOGIC_OP);
    glIndexMask(0xFF);
#if SPANGLE_FEATURE_FOG
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogi(GL_FOG_INDEX, 20);
    glRasterPos3f(1, 1, -0.5f);
    glDrawPixels(2, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, image);
    EXPECT_EQ(at(2, 1), 0x35 + 10);
    glDisable(GL_FOG);
#endif
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_NEVER);
    glRasterPos2i(5, 5);
    glDrawPixels(2, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, image);
    EXPECT_EQ(at(5, 5), 0x0F);
}

/// A copy reads all pixels before it writes, zoomed or not.
TEST_F(IndexPixels, OverlappingCopies) {
    count_up();
    glRasterPos2i(3, 2);
    glCopyPixels(2, 1, 5, 5, GL_COLOR);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 5; ++x)
            EXPECT_EQ(at(3 + x, 2 + y), (1 + y) * size + 2 + x);
    count_up();
    glPixelZoom(2, 2);
    glCopyPixels(3, 2, 4, 4, GL_COLOR);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            EXPECT_EQ(at(3 + x, 2 + y), (2 + y / 2) * size + 3 + x / 2);
}

/// Colours cannot be drawn to a surface of indices (GL 1.3, 3.6.4); depth and stencil can.
TEST_F(IndexPixels, ColoursAreRefused) {
    const GLfloat image[4] = {0.25f, 0, 0, 0};
    fill(9);
    glRasterPos2i(0, 0);
    for (const GLenum format : {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_RGB, GL_RGBA, GL_BGR, GL_BGRA,
                                GL_LUMINANCE, GL_LUMINANCE_ALPHA}) {
        glDrawPixels(1, 1, format, GL_FLOAT, image);
        EXPECT_EQ(error(), static_cast<GLenum>(GL_INVALID_OPERATION)) << format;
    }
    EXPECT_EQ(pixels(), std::vector<int>(size * size, 9));
    const GLubyte stencil[1] = {0x3C};
    glDrawPixels(1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil);
    EXPECT_EQ(at(0, 0), 9);
    glIndexi(31);
    glRasterPos2i(0, 0);
    glDrawPixels(1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, image);
    EXPECT_EQ(at(0, 0), 31) << "fragments of the raster position's index";
}
#endif

#if SPANGLE_FEATURE_BITMAPS && SPANGLE_FEATURE_RASTER_POS
/// Fragments of bitmaps have the raster position's index.
TEST_F(IndexPixels, Bitmaps) {
    const GLubyte bits[2] = {0xA0, 0x40};
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glIndexf(45.25f);
    glRasterPos2i(3, 4);
    glIndexi(7);
    glBitmap(3, 2, 0, 0, 0, 0, bits);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const bool set = (y == 4 && (x == 3 || x == 5)) || (y == 5 && x == 4);
            EXPECT_EQ(at(x, y), set ? 45 : 0) << x << ' ' << y;
        }
}
#endif

/// Indices cannot be read from a surface of colours.
TEST(ColorPixels, HaveNoIndices) {
    const HeadlessGl context(4, 4);
    GLubyte v = 77;
    glReadPixels(0, 0, 1, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, &v);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
    EXPECT_EQ(v, 77);
}

#endif

} // namespace
} // namespace spangle::test
