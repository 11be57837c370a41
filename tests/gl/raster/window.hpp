// A canvas whose object coordinates are pixels, and whose pixels a test can read.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "tests/gl/vertex/canvas.hpp"

namespace spangle::test {

using Rgba = std::array<GLubyte, 4>;

class Window : public Canvas {
  protected:
    void SetUp() override {
        Canvas::SetUp();
        glMatrixMode(GL_PROJECTION);
        glOrtho(0, size, 0, size, 0, 1); // z = -depth
        glMatrixMode(GL_MODELVIEW);
        glDisable(GL_DITHER);
        clear();
    }

    static void clear() { glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); }
    static std::vector<Rgba> picture() {
        std::vector<Rgba> pixels(size * size);
        glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        return pixels;
    }
    /// Returns the codes of a depth buffer of 24 bits.
    static std::vector<GLuint> depths() {
        std::vector<GLuint> words(size * size);
        glReadPixels(0, 0, size, size, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, words.data());
        for (GLuint& word : words)
            word >>= 8;
        return words;
    }
    /// Returns which pixels a white drawing reaches.
    template <class Draw> static std::vector<bool> covered(Draw draw) {
        clear();
        draw();
        std::vector<bool> all;
        for (const Rgba& pixel : picture())
            all.push_back(pixel[0] != 0);
        return all;
    }

    std::mt19937 random_{7};
    double lot(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    /// Returns a coordinate on the n.8 grid.
    GLfloat place() { return static_cast<GLfloat>(random_() % (size * 256u)) / 256; }
};

} // namespace spangle::test
