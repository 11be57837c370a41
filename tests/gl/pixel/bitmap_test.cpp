// Tests Bitmap: where bits are drawn, what their fragments are, and how the raster position moves
// (docs/features.md E09).
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_BITMAPS

#include <random>

#include "tests/gl/pixel/client_oracle.hpp"
#include "tests/gl/pixel/pixel_canvas.hpp"

namespace spangle::gl::test {
namespace {

void expect_position(float x, float y) {
    GLfloat at[4];
    glGetFloatv(GL_CURRENT_RASTER_POSITION, at);
    EXPECT_EQ(at[0], x);
    EXPECT_EQ(at[1], y);
}

TEST(Bitmap, BitsLandAtTheRoundedDownCorner) {
    std::mt19937 random(1);
    constexpr PixelFormat surfaces[] = {PixelFormat::rgb565_be, PixelFormat::rgb565_le, PixelFormat::rgb888,
                                        PixelFormat::rgba8888};
    for (int i = 0; i < 3000; ++i) {
        PixelCanvas canvas({.format = surfaces[i % 4], .width = 60, .height = 30});
        const int width = static_cast<int>(random() % 45), height = static_cast<int>(random() % 14);
        const Store store = Store::random(random, width);
        const ClientOracle oracle(GL_COLOR_INDEX, GL_BITMAP, width, height, store);
        std::vector<unsigned char> memory(oracle.bytes());
        for (auto& byte : memory)
            byte = static_cast<unsigned char>(random() & random());
        store.apply();
        const auto eighths = [&](int from, int to) {
            return static_cast<float>(from * 8 +
                                      static_cast<int>(random() % static_cast<unsigned>((to - from) * 8))) /
                   8;
        };
        const float x = eighths(0, 60), y = eighths(0, 30), xo = eighths(-12, 12), yo = eighths(-12, 12),
                    xm = eighths(-30, 30), ym = eighths(-30, 30);
        glColor3f(1, 1, 1);
        glWindowPos2f(x, y);
        glBitmap(width, height, xo, yo, xm, ym, memory.data());
        const int left = static_cast<int>(std::floor(x - xo)), low = static_cast<int>(std::floor(y - yo));
        for (int py = 0; py < 30; ++py)
            for (int px = 0; px < 60; ++px) {
                const int n = px - left, m = py - low;
                const bool on =
                    n >= 0 && m >= 0 && n < width && m < height && oracle.value(memory.data(), n, m, 0) != 0;
                ASSERT_EQ(canvas.at(px, py, 1), on ? 255 : 0) << px << ' ' << py << ' ' << i;
            }
        expect_position(x + xm, y + ym);
    }
}

TEST(Bitmap, MovesTheRasterPositionEvenWithoutBits) {
    PixelCanvas canvas;
    glRasterPos2i(3, 4);
    glBitmap(0, 0, 0, 0, -100, 2.5f, nullptr); // out of the viewport, and still valid
    expect_position(-97, 6.5f);
    glBitmap(8, 8, 1, 1, 100, 0, nullptr);
    expect_position(3, 6.5f);
    GLboolean valid = GL_FALSE;
    glGetBooleanv(GL_CURRENT_RASTER_POSITION_VALID, &valid);
    EXPECT_EQ(valid, GL_TRUE);
    for (const auto byte : canvas.color)
        ASSERT_EQ(byte, 0);
}

/// A raster position in whole pixels stays whole, whatever the projection does.
TEST(Bitmap, TextStaysInItsColumns) {
    const GLubyte bit = 0x80;
    for (int w = 8; w <= 2048; w = w * 4 / 3 + 1)
        for (const bool from_top : {false, true}) {
            PixelCanvas canvas({.depth = DepthFormat::none, .width = w, .height = 9});
            glMatrixMode(GL_PROJECTION);
            glLoadIdentity();
            glOrtho(0, w, from_top ? 9 : 0, from_top ? 0 : 9, -1, 1);
            glMatrixMode(GL_MODELVIEW);
            for (int x = 0; x < w; ++x) {
                glRasterPos2i(x, from_top ? 9 - x % 9 : x % 9);
                glBitmap(1, 1, 0, 0, 0, 0, &bit);
                ASSERT_EQ(canvas.at(x, x % 9, 0), 255) << x << " of " << w;
            }
        }
}

TEST(Bitmap, AnInvalidPositionStaysWhereItIs) {
    PixelCanvas canvas;
    glRasterPos2i(3, 4);
    glRasterPos2i(-3, 4);
    const GLubyte bits[8] = {255, 255, 255, 255, 255, 255, 255, 255};
    glBitmap(8, 8, -4, 0, 5, 5, bits);
    for (const auto byte : canvas.color)
        ASSERT_EQ(byte, 0);
    expect_position(3, 4);
}

TEST(Bitmap, IsNeitherZoomedNorTransferred) {
    PixelCanvas canvas;
    glColor4ub(100, 150, 200, 250);
    glRasterPos2i(3, 4);
    glColor4ub(1, 2, 3, 4); // not the colour of the raster position
#if SPANGLE_FEATURE_DRAW_PIXELS
    glPixelZoom(3, 3);
#endif
#if SPANGLE_FEATURE_PIXEL_TRANSFER
    glPixelTransferf(GL_RED_BIAS, 1);
    glPixelTransferi(GL_INDEX_OFFSET, 1);
#endif
    const GLubyte bits[2] = {0x40, 0x80};
    glBitmap(2, 2, 0, 0, 0, 0, bits);
    EXPECT_EQ(canvas.at(4, 4, 0), 100);
    EXPECT_EQ(canvas.at(4, 4, 3), 250);
    EXPECT_EQ(canvas.at(3, 5, 2), 200);
    EXPECT_EQ(canvas.at(3, 4, 0), 0);
    EXPECT_EQ(canvas.at(5, 5, 0), 0);
}

TEST(Bitmap, WhatIsRefusedMovesNothing) {
    PixelCanvas canvas;
    glRasterPos2i(3, 4);
    const GLubyte bits[8] = {};
    glBitmap(-1, 1, 0, 0, 9, 9, bits);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    glBitmap(1, -1, 0, 0, 9, 9, bits);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    expect_position(3, 4);
    glBitmap(1, 1, 3e38f, -3e38f, 0, 0, bits);
    glBitmap(1, 1, -3e38f, 3e38f, 3e38f, 3e38f, bits);
    glBitmap(INT32_MAX, INT32_MAX, 2e9f, 2e9f, 0, 0, bits);
}

#if SPANGLE_FEATURE_SELECTION && SPANGLE_FEATURE_FEEDBACK
TEST(Bitmap, IsFedBackAndNeverSelected) {
    PixelCanvas canvas;
    const GLubyte bits[4] = {255, 255, 255, 255};
    GLfloat fed[64];
    glColor4f(0.25f, 0.5f, 0.75f, 1);
    glTexCoord2f(3, 4);
    glRasterPos3f(3, 4, 0.5f);
    glFeedbackBuffer(64, GL_4D_COLOR_TEXTURE, fed);
    glRenderMode(GL_FEEDBACK);
    glBitmap(8, 4, 0, 0, 2, 0, bits);
#if SPANGLE_FEATURE_DRAW_PIXELS
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bits);
    glCopyPixels(0, 0, 1, 1, GL_COLOR);
    constexpr GLenum tokens[] = {GL_BITMAP_TOKEN, GL_DRAW_PIXEL_TOKEN, GL_COPY_PIXEL_TOKEN};
#else
    constexpr GLenum tokens[] = {GL_BITMAP_TOKEN};
#endif
    const GLint written = glRenderMode(GL_RENDER);
    ASSERT_EQ(written, static_cast<GLint>(13 * std::size(tokens)));
    for (std::size_t i = 0; i < std::size(tokens); ++i) {
        const GLfloat wanted[13] = {static_cast<GLfloat>(tokens[i]),
                                    i == 0 ? 3.0f : 5.0f,
                                    4,
                                    0.25f,
                                    1,
                                    0.25f,
                                    0.5f,
                                    0.75f,
                                    1,
                                    3,
                                    4,
                                    0,
                                    1};
        for (std::size_t k = 0; k < 13; ++k)
            EXPECT_EQ(fed[13 * i + k], wanted[k]) << i << ' ' << k;
    }
    GLuint hits[8];
    glSelectBuffer(8, hits);
    glRenderMode(GL_SELECT);
    glInitNames();
    glPushName(1);
    glBitmap(8, 4, 0, 0, 2, 0, bits);
#if SPANGLE_FEATURE_DRAW_PIXELS
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bits);
#endif
    EXPECT_EQ(glRenderMode(GL_RENDER), 0);
    expect_position(7, 4);
    for (const auto byte : canvas.color)
        ASSERT_EQ(byte, 0);
}
#endif

} // namespace
} // namespace spangle::gl::test

#endif
