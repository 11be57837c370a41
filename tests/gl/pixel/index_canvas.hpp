// A pbuffer of colour indices, whose bytes in memory a test can compare.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>
#include <spangle/GL/gl.h>

#include "gl/context/context.hpp"
#include "tests/support/headless_gl.hpp"

namespace spangle::test {

class IndexCanvas : public testing::Test {
  protected:
    static constexpr int size = 16;

    void SetUp() override {
        current_.emplace(
            size, size,
            std::initializer_list<EGLint>{EGL_ALPHA_SIZE, 0, EGL_COLOR_BUFFER_TYPE, EGL_INDEX_BUFFER_SPANGLE,
                                          EGL_INDEX_SIZE_SPANGLE, 8, EGL_STENCIL_SIZE, 8},
            std::initializer_list<EGLint>{EGL_ACCUM_SIZE_SPANGLE, SPANGLE_FEATURE_ACCUM ? 16 : 0});
        glMatrixMode(GL_PROJECTION);
        glOrtho(0, size, 0, size, -1, 1);
        glMatrixMode(GL_MODELVIEW);
        glDisable(GL_DITHER);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }
    void TearDown() override {
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        current_.reset();
    }

    static const raster::Surface& surface() { return gl::current_context()->drawable.surface; }
    static int at(int x, int y) { return surface().color_row(y)[x]; }
    /// Returns the pixels row by row, from the bottom.
    static std::vector<int> pixels() {
        std::vector<int> out;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                out.push_back(at(x, y));
        return out;
    }
    static void fill(int index) {
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                surface().color_row(y)[x] = static_cast<std::uint8_t>(index);
    }
    static void cover(float z = 0) {
        glBegin(GL_QUADS);
        glVertex3f(0, 0, z);
        glVertex3f(size, 0, z);
        glVertex3f(size, size, z);
        glVertex3f(0, size, z);
        glEnd();
    }
    /// Returns what a quad of this index stores in all pixels; 256 if pixels differ.
    static int covered(float index, float z = 0) {
        glIndexf(index);
        cover(z);
        const std::vector<int> all = pixels();
        for (const int v : all)
            if (v != all[0])
                return 256;
        return all[0];
    }
    static GLenum error() { return glGetError(); }

    /// Masks an index: whole numbers modulo 256, with the fraction kept (GL 1.3, 2.13.6, 4.1.8). The largest
    /// stored index is 255.
    static double masked(double index) { return index - 256 * std::floor(index / 256); }
    static int nearest(double index) {
        return static_cast<int>(std::fmin(std::floor(masked(index) + 0.5), 255));
    }
    static int dithered(double index, int x, int y) {
        static constexpr int k[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
        return static_cast<int>(std::floor(std::fmin(masked(index), 255) + (k[y & 3][x & 3] + 0.5) / 16));
    }

  private:
    std::optional<HeadlessGl> current_;
};

} // namespace spangle::test
