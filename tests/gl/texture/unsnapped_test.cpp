// In the exact tier, planes of attributes go through vertices as they are given, not as they are snapped to
// 1/256 pixel for coverage. Compares them with the formulas of GL 1.3, 3.5.1 and 3.8.8 in double.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>
#include <spangle/GL/gl.h>

#include "tests/support/headless_gl.hpp"
#include "tests/support/random.hpp"

namespace spangle::test {
namespace {

constexpr int size = 256;

struct Corner {
    float x, y, w, s;
};

/// A vertex as it is given: window x and y, 1/w, and s/w.
struct Exact {
    double x, y, q, s;
};

class TexelNumbers {
  public:
    explicit TexelNumbers(EGLint precision, int texels = 2048)
        : gl_(size, size, {EGL_PRECISION_SPANGLE, precision}), texels_(texels) {
        const auto count = static_cast<std::size_t>(texels);
        std::vector<GLubyte> image(count * 4);
        for (std::size_t i = 0; i < count; ++i) {
            image[4 * i] = static_cast<GLubyte>(i);
            image[4 * i + 1] = static_cast<GLubyte>(i >> 8);
            image[4 * i + 3] = 255;
        }
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, texels, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        glEnable(GL_TEXTURE_2D);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        glOrtho(0, size, 0, size, -1, 1);
    }

    long fragments = 0, wrong = 0;
    double worst = 0; ///< largest distance of a coordinate from the texel that it takes

    void draw(const Corner (&corner)[3]) {
        glClear(GL_COLOR_BUFFER_BIT);
        Exact e[3];
        glBegin(GL_TRIANGLES);
        for (int i = 0; i < 3; ++i) {
            const Corner& c = corner[i];
            glTexCoord2f(c.s, 0);
            const float x = c.x * c.w, y = c.y * c.w;
            glVertex4f(x, y, 0, c.w);
            e[i] = {double{x} / c.w, double{y} / c.w, 1.0 / c.w, double{c.s} / c.w};
        }
        glEnd();
        std::vector<GLubyte> picture(size * size * 4);
        glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
        const double area = cross(e[0], e[1], e[2].x, e[2].y);
        for (std::size_t pixel = 0; pixel < size * size; ++pixel)
            if (const GLubyte* const at = picture.data() + 4 * pixel; at[3] != 0) {
                const double x = static_cast<double>(pixel % size) + 0.5,
                             y = static_cast<double>(pixel / size) + 0.5;
                const double a = cross(e[1], e[2], x, y) / area, b = cross(e[2], e[0], x, y) / area,
                             c = 1 - a - b;
                const double u =
                    texels_ * (a * e[0].s + b * e[1].s + c * e[2].s) / (a * e[0].q + b * e[1].q + c * e[2].q);
                judge(u + 1.0 / 8192, at[0] + 256 * at[1]); // the bias of NEAREST
            }
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    }

  private:
    static double cross(const Exact& a, const Exact& b, double x, double y) {
        return (b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y);
    }
    void judge(double u, int texel) {
        ++fragments;
        const double inside = u - std::floor(u);
        const long whole = static_cast<long>(std::floor(u));
        const int more = static_cast<int>(((texel - whole) % texels_ + texels_) % texels_);
        if (more == 0)
            return;
        ++wrong;
        worst = std::max(worst, more == 1 ? 1 - inside : more == texels_ - 1 ? inside : 1);
    }

    HeadlessGl gl_;
    int texels_;
};

/// Draws triangles of 30 to 250 pixels, with `span` repeats of the texture on each.
void draw_triangles(TexelNumbers& drawn, float span, bool perspective) {
    Random random{17};
    const auto any = [&](float low, float high) {
        return low + (high - low) * static_cast<float>(random.below(1 << 20)) / (1 << 20);
    };
    for (int n = 0; n < 60; ++n) {
        Corner c[3];
        for (int i = 0; i < 3; ++i)
            c[i] = {any(3, 253), any(3, 253), perspective ? any(1, 3) : 1, any(0, span)};
        const float area = (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[2].x - c[0].x) * (c[1].y - c[0].y);
        if (std::fabs(area) > 2000)
            drawn.draw(c);
    }
}

TEST(Unsnapped, TexelsAreThoseOfTheVerticesAsGiven) {
    for (const bool perspective : {false, true})
        for (const float span : {1.0f, 16.0f}) {
            TexelNumbers drawn(EGL_PRECISION_EXACT_SPANGLE);
            draw_triangles(drawn, span, perspective);
            std::printf("span %g%s: %ld of %ld texels wrong, at most %.4f texel\n", double{span},
                        perspective ? ", perspective" : "", drawn.wrong, drawn.fragments, drawn.worst);
            EXPECT_GT(drawn.fragments, 200'000);
            EXPECT_LE(drawn.wrong, drawn.fragments / 5000);
            EXPECT_LE(drawn.worst, 0.002) << "span " << span << (perspective ? ", perspective" : "");
        }
}

/// A coordinate has as many bits as a float: 24 bits of the largest in its primitive. NEAREST also leaves
/// 2^-13 texel open (docs/architecture/numbers.md).
double texels_off(double largest) {
    return std::ldexp(1.0, -13) + std::ldexp(largest, -24);
}

/// A floor one below the eye, as far as `far` to all sides of it; the eye is rolled and pitched, degrees. The
/// texture repeats every 16. Floors reach the horizon but for 1/far of their distance, and triangles of what
/// clipping leaves of them are thin there.
class Floor {
  public:
    Floor(double far, double roll, double pitch) : far_(far) {
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        glFrustum(-1, 1, -1, 1, 0.5, 4 * far);
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
        glRotated(roll, 0, 0, 1);
        glRotated(pitch, 1, 0, 0);
        GLdouble m[16];
        glGetDoublev(GL_MODELVIEW_MATRIX, m);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                turned_[i][j] = m[4 * j + i];
    }
    void draw() const {
        const auto corner = [&](double x, double z) {
            glTexCoord2d(coordinate(x, z), 0);
            glVertex3d(x, -1, z);
        };
        glBegin(GL_QUADS);
        corner(-far_, 0);
        corner(far_, 0);
        corner(far_, -far_);
        corner(-far_, -far_);
        glEnd();
    }
    /// s at a place in the window: where the ray through it meets the floor. NaN: above the horizon.
    double at(double x, double y) const {
        const double ray[3] = {2 * (2 * x / size - 1), 2 * (2 * y / size - 1), -1};
        double seen[3]; // the columns of a rotation are its inverse's rows
        for (int j = 0; j < 3; ++j)
            seen[j] = ray[0] * turned_[0][j] + ray[1] * turned_[1][j] + ray[2] * turned_[2][j];
        return seen[1] < 0 ? coordinate(seen[0] / -seen[1], seen[2] / -seen[1]) : std::nan("");
    }
    double largest() const { return coordinate(far_, -far_); }

  private:
    static double coordinate(double x, double z) { return (x - z) / 16; }
    double far_, turned_[3][3];
};

TEST(Unsnapped, FloorsToTheHorizonTakeTheirTexels) {
    constexpr int texels = 512;
    TexelNumbers drawn(EGL_PRECISION_EXACT_SPANGLE, texels);
    Random random{23};
    long far_off = 0;
    double worst = 0;
    for (int n = 0; n < 120; ++n) {
        const double far = std::pow(10.0, 1 + n % 4), roll = random.below(3600) / 10.0,
                     pitch = random.below(240) / 10.0 - 12;
        const Floor floor(far, roll, pitch);
        glClear(GL_COLOR_BUFFER_BIT);
        floor.draw();
        std::vector<GLubyte> picture(size * size * 4);
        glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
        for (std::size_t pixel = 0; pixel < size * size; ++pixel) {
            const GLubyte* const at = picture.data() + 4 * pixel;
            const double x = static_cast<double>(pixel % size) + 0.5,
                         y = static_cast<double>(pixel / size) + 0.5;
            const double s = floor.at(x, y),
                         steep = std::fabs(floor.at(x + 1e-3, y) - s) + std::fabs(floor.at(x, y + 1e-3) - s);
            if (at[3] == 0 || std::isnan(s + steep))
                continue;
            // Vertices lie where they should within 2^-17 pixel, which is 2^-27 of the guard band's width.
            const double allowed = texels_off(texels * floor.largest()) + texels * steep * 1e3 * 0x1p-17,
                         u = texels * s + 1.0 / 8192, texel = at[0] + 256 * at[1];
            double off = std::remainder(u - texel - 0.5, texels);
            off = std::fmax(std::fabs(off) - 0.5, 0);
            ++drawn.fragments;
            far_off += off > allowed ? 1 : 0;
            if (far <= 1000)
                worst = std::fmax(worst, off / allowed);
        }
    }
    std::printf(
        "floors: %ld of %ld texels are further off than allowed; as far as 1000, a texel is %.2f times that "
        "off\n",
        far_off, drawn.fragments, worst);
    EXPECT_GT(drawn.fragments, 1'000'000);
    EXPECT_LE(worst, 1);
    // A floor as far as 10000 ends 0.01 pixel below its horizon. Of the triangles there, some are too thin
    // for planes through unsnapped vertices.
    EXPECT_LE(far_off, drawn.fragments / 5000);
}

TEST(Unsnapped, AMillionRepeatsAreAsExactAsFloatsAre) {
    struct Case {
        float repeats;
        int texels;
    };
    for (const bool perspective : {false, true})
        for (const Case c : {Case{64, 2048}, Case{1024, 2048}, Case{1024, 16}, Case{16384, 256},
                             Case{65536, 64}, Case{1e6f, 4}}) {
            TexelNumbers drawn(EGL_PRECISION_EXACT_SPANGLE, c.texels);
            draw_triangles(drawn, c.repeats, perspective);
            const double most = texels_off(double{c.repeats} * c.texels);
            std::printf("%g repeats of %d texels%s: %.6f texel off, %.6f may be\n", double{c.repeats},
                        c.texels, perspective ? " in perspective" : "", drawn.worst, most);
            EXPECT_GT(drawn.fragments, 200'000);
            EXPECT_LE(drawn.worst, most);
            EXPECT_GE(drawn.worst, most / 64) << "the bound says nothing";
        }
}

} // namespace
} // namespace spangle::test
