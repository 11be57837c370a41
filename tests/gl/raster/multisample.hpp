// Draws on surfaces with four samples a pixel, and computes by brute force what each sample is.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include "raster/surface/samples.hpp"
#include "tests/gl/raster/window.hpp"

namespace spangle::test::samples {

inline constexpr int size = 48;
using Picture = std::vector<Rgba>;
using Draw = std::function<void()>;

/// A context with this number of samples; object coordinates are pixels.
struct Target {
    HeadlessGl gl;
    explicit Target(int samples, std::initializer_list<EGLint> more = {})
        : gl(size, size, with(samples, more)) {
        glMatrixMode(GL_PROJECTION);
        glOrtho(0, size, 0, size, 0, 1); // z = -depth
        glMatrixMode(GL_MODELVIEW);
        glDisable(GL_DITHER);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }
    ~Target() { EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}); }

  private:
    static std::vector<EGLint> with(int samples, std::initializer_list<EGLint> more) {
        std::vector<EGLint> all = {EGL_STENCIL_SIZE, 8, EGL_SAMPLES, samples};
        all.insert(all.end(), more);
        return all;
    }
};

inline Picture picture() {
    Picture pixels(size * size);
    glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
}

inline double offset(unsigned sample, bool y) {
    const raster::SamplePosition& at = raster::sample_position[sample];
    return (y ? at.y : at.x) / 256.0;
}

/// Returns the white picture of the samples for which `inside` is true.
template <class Inside> std::vector<int> counts(Inside inside) {
    std::vector<int> all(size * size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            for (unsigned s = 0; s < raster::sample_count; ++s)
                all[static_cast<std::size_t>(y * size + x)] +=
                    inside(x + offset(s, false), y + offset(s, true)) ? 1 : 0;
    return all;
}
inline std::vector<int> drawn_counts() {
    std::vector<int> all;
    for (const Rgba& pixel : picture())
        all.push_back((pixel[0] * 4 + 127) / 255);
    return all;
}

class Multisample : public testing::Test {
  protected:
    std::mt19937 random_{11};
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(random_() % n); }
    double lot(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    GLfloat place() { return static_cast<GLfloat>(below(size * 256)) / 256; }

    /// Draws on a surface with samples. The picture must be the mean of four without samples, for which the
    /// window is moved to each sample.
    void expect_mean(const Draw& draw, const char* what, std::initializer_list<EGLint> more = {}) {
        Picture got;
        {
            Target target(4, more);
            draw();
            got = picture();
        }
        std::vector<std::array<int, 4>> sum(size * size);
        for (unsigned s = 0; s < raster::sample_count; ++s) {
            Target target(0, more);
            glMatrixMode(GL_PROJECTION);
            glTranslated(0.5 - offset(s, false), 0.5 - offset(s, true), 0);
            glMatrixMode(GL_MODELVIEW);
            draw();
            const Picture one = picture();
            for (std::size_t p = 0; p < one.size(); ++p)
                for (unsigned c = 0; c < 4; ++c)
                    sum[p][c] += one[p][c];
        }
        for (std::size_t p = 0; p < got.size(); ++p)
            for (unsigned c = 0; c < 4; ++c)
                ASSERT_EQ(got[p][c], (sum[p][c] + 2) / 4)
                    << what << " at " << p % size << ',' << p / size << " channel " << c;
    }

    void random_color() {
        const auto c = [&] { return static_cast<GLubyte>(below(4) == 0 ? 255 * below(2) : below(256)); };
        const GLubyte r = c(), g = c(), b = c(), a = c();
        glColor4ub(r, g, b, a);
    }
    void triangles(int n) {
        glBegin(GL_TRIANGLES);
        for (int i = 0; i < 3 * n; ++i) {
            random_color();
            const GLfloat x = place(), y = place();
            glTexCoord2f(x / 16, y / 16);
            glVertex3f(x, y, -static_cast<GLfloat>(below(257)) / 256);
        }
        glEnd();
    }
};

/// The rule of edges (GL 1.3, 3.5.1): edges at the left and at the bottom belong to the triangle.
inline bool holds(const std::array<double, 6>& t, double x, double y) {
    const double area = (t[2] - t[0]) * (t[5] - t[1]) - (t[4] - t[0]) * (t[3] - t[1]);
    for (unsigned i = 0; i < 3; ++i) {
        const unsigned a = 2 * i, b = 2 * ((i + 1) % 3);
        const double dx = (t[b] - t[a]) * (area < 0 ? -1 : 1),
                     dy = (t[b + 1] - t[a + 1]) * (area < 0 ? -1 : 1);
        const double side = dx * (y - t[a + 1]) - dy * (x - t[a]);
        if (side < 0 || (side == 0 && !(dy < 0 || (dy == 0 && dx > 0))))
            return false;
    }
    return area != 0;
}

} // namespace spangle::test::samples
