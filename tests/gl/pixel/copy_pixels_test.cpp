// Compares CopyPixels with drawing an image that was read first: overlaps, zooms, depth and stencil, other
// surfaces (docs/features.md E08).
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_DRAW_PIXELS

#include <random>

#include "tests/gl/pixel/pixel_canvas.hpp"

namespace spangle::gl::test {
namespace {

void fill(PixelCanvas& canvas, unsigned seed) {
    std::mt19937 random(seed);
    for (auto& byte : canvas.color)
        byte = static_cast<std::uint8_t>(random());
    for (auto& word : canvas.depth)
        word = static_cast<std::uint32_t>(random());
}

struct Copy {
    int x, y, width, height;
    float to_x, to_y, zoom_x, zoom_y;
};

/// Returns the group that covers a fragment's centre, or -1.
int group_of(double center, double at, double zoom, int groups) {
    for (int n = 0; n < groups; ++n)
        if (center >= std::min(at + zoom * n, at + zoom * (n + 1)) &&
            center < std::max(at + zoom * n, at + zoom * (n + 1)))
            return n;
    return -1;
}

/// Compares each pixel of `after` with the pixel that it was copied from. same(x, y, from_x, from_y) compares
/// the values.
template <class Same> void expect_copied(const Copy& c, int width, int height, Same same) {
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int n = group_of(x + 0.5, c.to_x, c.zoom_x, c.width),
                      m = group_of(y + 0.5, c.to_y, c.zoom_y, c.height);
            int from_x = c.x + n, from_y = c.y + m;
            if (n < 0 || m < 0 || from_x < 0 || from_y < 0 || from_x >= width || from_y >= height)
                from_x = x, from_y = y; // a place where nothing is drawn
            ASSERT_TRUE(same(x, y, from_x, from_y))
                << x << ' ' << y << " from " << from_x << ' ' << from_y << ": " << c.x << ' ' << c.y << ' '
                << c.width << 'x' << c.height << " to " << c.to_x << ' ' << c.to_y << " zoom " << c.zoom_x
                << ' ' << c.zoom_y;
        }
}

Copy random_copy(std::mt19937& random, int width, int height, bool zooms) {
    const auto upto = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    Copy c{upto(width + 8) - 4, upto(height + 8) - 4, upto(width), upto(height), 0, 0, 1, 1};
    if (zooms) {
        constexpr float zoom[] = {-1, 2, -2, 0.5f, 1.5f, -0.75f, 1};
        c.zoom_x = zoom[upto(7)];
        c.zoom_y = zoom[upto(7)];
    }
    c.to_x = static_cast<float>(upto(4 * width)) / 4;
    c.to_y = static_cast<float>(upto(4 * height)) / 4;
    return c;
}

void run(const Copy& c, GLenum type) {
    glWindowPos2f(c.to_x, c.to_y);
    glPixelZoom(c.zoom_x, c.zoom_y);
    glCopyPixels(c.x, c.y, c.width, c.height, type);
}

constexpr PixelFormat surfaces[] = {PixelFormat::rgb565_be, PixelFormat::rgb565_le, PixelFormat::rgb888,
                                    PixelFormat::rgba8888};

/// Copied colours are the same to the byte, dithered or not.
TEST(CopyPixels, ColoursMoveAsIfReadFirst) {
    std::mt19937 random(1);
    for (int i = 0; i < 4000; ++i) {
        const int width = i % 5 == 0 ? 150 : 30, height = 20;
        PixelCanvas canvas({.format = surfaces[i % 4],
                            .tier = i % 3 == 0 ? raster::Tier::balanced : raster::Tier::exact,
                            .width = width,
                            .height = height,
                            .top_first = i % 2 != 0});
        fill(canvas, static_cast<unsigned>(i));
        const auto before = canvas.color;
        const auto pixel = static_cast<std::size_t>(format_info(surfaces[i % 4]).bytes_per_pixel);
        const Copy c = random_copy(random, width, height, i % 2 == 0);
        run(c, GL_COLOR);
        ASSERT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        ASSERT_NO_FATAL_FAILURE(expect_copied(c, width, height, [&](int x, int y, int fx, int fy) {
            const auto at = [&](int px, int py) {
                return static_cast<std::size_t>(canvas.surface().color_row(py) - canvas.color.data()) +
                       static_cast<std::size_t>(px) * pixel;
            };
            return std::equal(&canvas.color[at(x, y)], &canvas.color[at(x, y)] + pixel, &before[at(fx, fy)]);
        }));
    }
}

TEST(CopyPixels, DepthAndStencilMoveAsIfReadFirst) {
    std::mt19937 random(2);
    for (int i = 0; i < 3000; ++i) {
        const int width = i % 5 == 0 ? 150 : 30, height = 20;
        PixelCanvas canvas({.width = width, .height = height});
        fill(canvas, static_cast<unsigned>(i));
        const auto before = canvas.depth;
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_ALWAYS);
        const Copy c = random_copy(random, width, height, i % 2 == 0);
        const bool depth = i % 3 != 0;
        run(c, depth ? GL_DEPTH : GL_STENCIL);
        ASSERT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        ASSERT_NO_FATAL_FAILURE(expect_copied(c, width, height, [&](int x, int y, int fx, int fy) {
            const auto old = [&](int px, int py) {
                return before[static_cast<std::size_t>(py * width + px)];
            };
            return canvas.depth_at(x, y) == old(depth ? fx : x, depth ? fy : y) >> 8 &&
                   canvas.stencil_at(x, y) == (old(depth ? x : fx, depth ? y : fy) & 0xFF);
        }));
    }
}

#if SPANGLE_FEATURE_PIXEL_TRANSFER
TEST(CopyPixels, TransferIsAppliedOnce) {
    PixelCanvas canvas;
    glClearColor(0.4f, 0.2f, 0.6f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glClearStencil(3);
    glClear(GL_STENCIL_BUFFER_BIT);
    glPixelTransferf(GL_RED_SCALE, 0.5f);
    glPixelTransferf(GL_GREEN_BIAS, 0.2f);
    glPixelTransferi(GL_INDEX_SHIFT, 1);
    glPixelTransferi(GL_INDEX_OFFSET, 1);
    glRasterPos2i(10, 10);
    glCopyPixels(0, 0, 2, 2, GL_COLOR);
    EXPECT_EQ(canvas.at(11, 11, 0), 51);
    EXPECT_EQ(canvas.at(11, 11, 1), 102);
    EXPECT_EQ(canvas.at(11, 11, 2), 153);
    EXPECT_EQ(canvas.at(12, 11, 0), 102);
    glCopyPixels(0, 0, 2, 2, GL_STENCIL);
    EXPECT_EQ(canvas.stencil_at(11, 11), 7);
}

/// Pixel transfer may change a 16-bit colour to one that has no such bits, which is dithered.
TEST(CopyPixels, ColoursOf565GoThroughTransfer) {
    for (const PixelFormat format : {PixelFormat::rgb565_be, PixelFormat::rgb565_le})
        for (const bool maps : {false, true}) {
            PixelCanvas canvas({.format = format});
            glClearColor(15 / 31.0f, 0, 0, 1);
            glClear(GL_COLOR_BUFFER_BIT);
            if (maps) {
                const GLfloat half[3] = {7.5f / 31, 7.5f / 31, 1};
                glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 3, half);
                glPixelTransferi(GL_MAP_COLOR, GL_TRUE);
            } else {
                glPixelTransferf(GL_RED_SCALE, 0.5f);
            }
            glRasterPos2i(16, 8);
            glCopyPixels(0, 0, 16, 16, GL_COLOR);
            int sum = 0;
            for (int y = 8; y < 24; ++y)
                for (int x = 16; x < 32; ++x)
                    sum += static_cast<int>(raster::read_color(canvas.surface(), x, y).c[0].k);
            EXPECT_NEAR(sum / 256., 7.5, 0.05) << maps;
        }
}
#endif

TEST(CopyPixels, ZoomedOntoItselfWithoutMemoryIsAnError) {
    PixelCanvas canvas;
    fill(canvas, 1);
    const auto before = canvas.color;
    std::vector<void*> taken;
    for (std::size_t bytes = 1 << 20; bytes >= 16; bytes /= 2)
        while (void* const block = canvas.arena.allocate(bytes))
            taken.push_back(block);
    glPixelZoom(2, 1);
    glCopyPixels(0, 0, 20, 20, GL_COLOR);
    EXPECT_EQ(glGetError(), GLenum{GL_OUT_OF_MEMORY});
    EXPECT_EQ(before, canvas.color);
    glPixelZoom(1, 1); // scrolling needs no memory
    glWindowPos2i(3, 2);
    glCopyPixels(0, 0, 20, 20, GL_COLOR);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    EXPECT_NE(before, canvas.color);
    for (void* const block : taken)
        canvas.arena.free(block);
}

TEST(CopyPixels, WhatIsRefused) {
    PixelCanvas canvas;
    glCopyPixels(0, 0, 1, 1, GL_COLOR_INDEX);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    glCopyPixels(0, 0, -1, 1, GL_COLOR);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    glCopyPixels(0, 0, 1, -1, GL_COLOR);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    glCopyPixels(INT32_MIN, INT32_MAX, INT32_MAX, INT32_MAX, GL_COLOR);
    glCopyPixels(INT32_MAX, INT32_MIN, INT32_MAX, INT32_MAX, GL_DEPTH);
    glCopyPixels(-5, -5, INT32_MAX, INT32_MAX, GL_STENCIL);
}

} // namespace
} // namespace spangle::gl::test

#endif
