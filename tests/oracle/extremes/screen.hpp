// The surface of the extreme cases: Spangle's in one tier, or Mesa's, which draws the same cases for the
// page's last column.
#pragma once

#include <array>
#include <vector>

#include <gtest/gtest.h>

#ifdef SPANGLE_SCENES_ON_OTHER_GL
#include "tests/oracle/extremes/mesa_window.hpp"
#else
#include "tests/oracle/extremes/window.hpp"
#endif

namespace spangle::test {

inline constexpr int side = 64;

using Rgba = std::array<GLubyte, 4>;
using Picture = std::vector<Rgba>;

/// A current context of one tier with a square window whose pixels can be read, as long as the object lives.
/// Dithering is off.
class Screen {
  public:
    explicit Screen(EGLint tier, int size = side, EGLint depth = 24, EGLint red = 8)
        : size_(size), window_(tier, size, depth, red) {
        glDisable(GL_DITHER);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    }
    ~Screen() { EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}); }
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    [[nodiscard]] Picture picture() const {
        Picture pixels(static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_));
        glReadPixels(0, 0, size_, size_, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        return pixels;
    }
    /// Returns depths as 32-bit numbers, from 0 for 0 to all ones for 1.
    [[nodiscard]] std::vector<GLuint> depths() const {
        std::vector<GLuint> words(static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_));
        glReadPixels(0, 0, size_, size_, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, words.data());
        return words;
    }
    [[nodiscard]] Rgba pixel(int x, int y) const {
        return picture()[static_cast<std::size_t>(y * size_ + x)];
    }
    /// From now on every fragment adds 1 to red.
    static void count_fragments() {
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
        glColor3ub(1, 0, 0);
    }
    /// Makes object coordinates pixels, and z = -depth.
    void pixels_as_coordinates() const {
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        glOrtho(0, size_, 0, size_, 0, 1);
        glMatrixMode(GL_MODELVIEW);
    }

  private:
    int size_;
    Window window_;
};

} // namespace spangle::test
