// Draws images one texel to a pixel as programs do: with a projection of pixels, GL_LINEAR, the initial
// dithering, and one rectangle. Every byte of the image must arrive, and no pixel beside it may change.
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>
#include <spangle/GL/gl.h>

#include "tests/support/headless_gl.hpp"

namespace spangle::test {
namespace {

struct Rectangle {
    GLsizei surface_width, surface_height;
    GLint x, y;
    GLsizei width, height;
};

const Rectangle rectangles[] = {
    {300, 200, 17, 11, 256, 128}, {320, 240, 0, 0, 320, 240}, {2048, 9, 511, 2, 1024, 4},
    {9, 2048, 2, 3, 4, 1024},     {129, 131, 1, 1, 1, 1},     {640, 480, 33, 7, 600, 470},
};

void project_pixels(GLsizei width, GLsizei height) {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, width, 0, height, -1, 1);
}

void corner(const Rectangle& r, int right, int top) {
    glTexCoord2i(right, top);
    glVertex2i(r.x + right * r.width, r.y + top * r.height);
}

std::vector<GLubyte> read(const Rectangle& r) {
    std::vector<GLubyte> out(static_cast<std::size_t>(r.surface_width * r.surface_height * 4));
    glReadPixels(0, 0, r.surface_width, r.surface_height, GL_RGBA, GL_UNSIGNED_BYTE, out.data());
    return out;
}

/// Draws a random image, or a checkerboard: its components are 0 and 255, which any fractional weight would
/// change.
void draw_image(EGLint precision, const Rectangle& r, bool checkerboard) {
    const HeadlessGl gl(r.surface_width, r.surface_height, {EGL_PRECISION_SPANGLE, precision});
    const auto width = static_cast<std::size_t>(r.width), height = static_cast<std::size_t>(r.height);
    std::vector<GLubyte> image(width * height * 4);
    std::uint32_t seed = 7;
    for (std::size_t i = 0; i < image.size(); ++i) {
        const std::size_t pixel = i / 4;
        seed = seed * 1664525 + 1013904223;
        const bool odd = (pixel % width + pixel / width + i % 4) % 2 != 0;
        image[i] = checkerboard ? (odd ? 255 : 0) : static_cast<GLubyte>(seed >> 24);
    }
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, r.width, r.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    project_pixels(r.surface_width, r.surface_height);
    glClearColor(51 / 255.0f, 102 / 255.0f, 153 / 255.0f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glBegin(GL_QUADS);
    corner(r, 0, 0);
    corner(r, 1, 0);
    corner(r, 1, 1);
    corner(r, 0, 1);
    glEnd();
    const std::vector<GLubyte> picture = read(r);
    const GLubyte clear[] = {51, 102, 153, 255};
    int wrong = 0;
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const auto pixel = static_cast<GLsizei>(i / 4);
        const GLint x = pixel % r.surface_width - r.x, y = pixel / r.surface_width - r.y;
        const bool inside = x >= 0 && x < r.width && y >= 0 && y < r.height;
        const std::size_t texel = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
        wrong += picture[i] != (inside ? image[texel * 4 + i % 4] : clear[i % 4]);
    }
    EXPECT_EQ(wrong, 0) << r.surface_width << 'x' << r.surface_height << ", precision " << std::hex
                        << precision;
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST(ImageOfPixels, ArrivesAsItIs) {
    for (const EGLint precision :
         {EGL_PRECISION_EXACT_SPANGLE, EGL_PRECISION_BALANCED_SPANGLE, EGL_PRECISION_FAST_SPANGLE})
        for (const Rectangle& r : rectangles) {
            draw_image(precision, r, false);
            draw_image(precision, r, true);
        }
}

/// The image covers a surface of the largest width, so rows are one run of 2048 pixels, clipped by a scissor
/// box. Pixels outside of the box keep their values.
TEST(ImageOfPixels, CoordinatesOfAWideRectangleGoOnBehindAScissor) {
    for (const EGLint precision : {EGL_PRECISION_EXACT_SPANGLE, EGL_PRECISION_FAST_SPANGLE}) {
        const Rectangle r{2048, 8, 0, 0, 2048, 8};
        const HeadlessGl gl(r.surface_width, r.surface_height, {EGL_PRECISION_SPANGLE, precision});
        std::vector<GLubyte> image(2048 * 4);
        for (std::size_t i = 0; i < image.size(); ++i)
            image[i] = static_cast<GLubyte>(i * 37 + i / 256);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2048, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glEnable(GL_TEXTURE_2D);
        project_pixels(r.surface_width, r.surface_height);
        glEnable(GL_SCISSOR_TEST);
        for (const GLint begin : {1, 1627, 1628, 1629, 2040}) {
            glScissor(0, 0, 2048, 8);
            glClear(GL_COLOR_BUFFER_BIT);
            glScissor(begin, 0, 2048 - begin, 8);
            glBegin(GL_QUADS);
            for (int i = 0; i < 4; ++i) { // q is not 1: coordinates are divided, and constant along the row
                const int right = i == 1 || i == 2, top = i >= 2;
                glTexCoord4i(2 * right, top, 0, 2);
                glVertex2i(r.x + right * r.width, r.y + top * r.height);
            }
            glEnd();
            const std::vector<GLubyte> picture = read(r);
            int wrong = 0;
            for (std::size_t i = 0; i < picture.size(); ++i) {
                const std::size_t x = i / 4 % 2048;
                wrong += picture[i] != (x >= static_cast<std::size_t>(begin) ? image[x * 4 + i % 4] : 0);
            }
            EXPECT_EQ(wrong, 0) << begin;
        }
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    }
}

} // namespace
} // namespace spangle::test
