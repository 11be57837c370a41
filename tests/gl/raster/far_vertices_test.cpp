// Row C13: polygons may have vertices anywhere that floats reach, in front of the eye or behind it, and their
// visible part must be right (GL 1.3, 2.1.1 and 2.11). The expected fragments come from the homogeneous edges
// of the unclipped triangle, in long double.
#include <cmath>

#include "tests/gl/raster/window.hpp"

namespace spangle::test {
namespace {

constexpr int side = 128;

struct Vertex {
    long double x, y, w;
};

class FarVertices : public Canvas {
  protected:
    FarVertices() : Canvas(side) {}

    std::mt19937 random_{5};
    double lot(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    float sign() { return random_() % 2 == 0 ? 1.F : -1.F; }
    float near() { return static_cast<float>(lot(-1, 1)); }
    /// Returns a number of any size from 1 to 2^most, of either sign.
    float far(double most) { return sign() * static_cast<float>(std::exp2(lot(0, most))); }

    int fragments_ = 0, wrong_ = 0;
    double worst_ = 0; ///< largest distance in pixels of a wrong fragment's centre from the next edge

    /// Compares the drawing of vertices x, y, w with the exact edges.
    void check(const std::array<Vertex, 3>& v) {
        std::vector<Rgba> pixels(side * side);
        glReadPixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        // Edge i contains the points p of the plane x, y, 1 with edge . p = 0.
        std::array<Vertex, 3> edge{};
        for (unsigned i = 0; i < 3; ++i) {
            const Vertex &a = v[(i + 1) % 3], &b = v[(i + 2) % 3];
            edge[i] = {a.y * b.w - a.w * b.y, a.w * b.x - a.x * b.w, a.x * b.y - a.y * b.x};
        }
        const long double volume = edge[0].x * v[0].x + edge[0].y * v[0].y + edge[0].w * v[0].w;
        for (int py = 0; py < side; ++py)
            for (int px = 0; px < side; ++px) {
                const long double x = (2 * px + 1.0L) / side - 1, y = (2 * py + 1.0L) / side - 1;
                bool inside = volume != 0;
                double distance = 1e9;
                for (const Vertex& e : edge) {
                    const long double at = e.x * x + e.y * y + e.w;
                    inside = inside && (at > 0) == (volume > 0);
                    const long double slope = std::hypot(e.x, e.y);
                    if (slope != 0)
                        distance = std::fmin(distance, static_cast<double>(std::fabs(at) / slope * side / 2));
                }
                const bool drawn = pixels[static_cast<std::size_t>(py * side + px)][0] != 0;
                fragments_ += inside ? 1 : 0;
                if (drawn != inside && distance > 1.0 / 128) {
                    ++wrong_;
                    worst_ = std::fmax(worst_, distance);
                }
            }
    }
    void draw(const std::array<std::array<float, 4>, 3>& v) {
        glClear(GL_COLOR_BUFFER_BIT);
        glBegin(GL_TRIANGLES);
        for (const auto& c : v)
            glVertex4fv(c.data());
        glEnd();
    }
    /// Draws a triangle under a matrix m, column-major as in GL; z is 0.
    void triangle(const std::array<std::array<float, 4>, 3>& v, const std::array<float, 16>& m) {
        draw(v);
        std::array<Vertex, 3> clip{};
        for (unsigned i = 0; i < 3; ++i) {
            const auto row = [&](unsigned r) {
                long double sum = 0;
                for (unsigned j = 0; j < 4; ++j)
                    sum += static_cast<long double>(m[4 * j + r]) * v[i][j];
                return sum;
            };
            clip[i] = {row(0), row(1), row(3)};
        }
        check(clip);
    }
    static constexpr std::array<float, 16> identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    void triangle(const std::array<std::array<float, 4>, 3>& v) { triangle(v, identity); }

    void expect_right(int least) {
        std::printf("%d fragments, %d wrong ones, the worst %g pixels off\n", fragments_, wrong_, worst_);
        EXPECT_GT(fragments_, least);
        EXPECT_EQ(wrong_, 0) << "up to " << worst_ << " pixels off";
    }
};

/// A bug was found with one far vertex: an edge was off by 0.08 pixel at 2^24, 2 pixels at 2^28, and 127 at
/// 2^40.
TEST_F(FarVertices, OneOfThree) {
    for (int n = 0; n < 600; ++n) {
        const double most = n % 3 == 0 ? 32 : 120;
        triangle({{{near(), near(), 0, 1}, {near(), near(), 0, 1}, {far(most), far(most), 0, 1}}});
    }
    expect_right(100'000);
}

TEST_F(FarVertices, TwoOrThree) {
    for (int n = 0; n < 600; ++n) {
        const double most = n % 3 == 0 ? 8 : n % 3 == 1 ? 32 : 50;
        const bool beside = n % 2 == 0; // an edge that passes the window parallel to an axis, or nearly so
        const float y = near();
        triangle({{{-std::fabs(far(most)), beside ? y : far(most), 0, 1},
                   {std::fabs(far(most)), beside ? y + (n % 4 == 0 ? 0.F : near()) : far(most), 0, 1},
                   {n % 5 == 0 ? near() : far(most), far(most), 0, 1}}});
    }
    expect_right(100'000);
}

/// Large terms cancel in the rows of a matrix.
TEST_F(FarVertices, UnderARotation) {
    for (int n = 0; n < 400; ++n) {
        const double angle = lot(0, 6.3);
        const auto c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
        const std::array<float, 16> m{c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, near(), near(), 0, 1};
        glLoadMatrixf(m.data());
        const double most = n % 2 == 0 ? 20 : 32;
        const float x = far(most), y = near();
        triangle({{{x, y, 0, 1}, {-x, y + near(), 0, 1}, {far(most), far(most), 0, 1}}}, m);
    }
    expect_right(100'000);
}

/// Some vertices lie behind the eye, some of these close to its plane. The part in front is drawn.
TEST_F(FarVertices, BehindTheEye) {
    for (int n = 0; n < 800; ++n) {
        const auto corner = [&](bool behind) {
            const auto w = static_cast<float>(std::exp2(lot(-30, 30)));
            const auto scale = static_cast<float>(std::exp2(lot(-3, n % 2 == 0 ? 3 : 40)));
            return std::array<float, 4>{near() * w * scale, near() * w * scale, 0, behind ? -w : w};
        };
        triangle({corner(false), corner(n % 3 == 0), corner(true)});
    }
    // The triangle goes from the middle of the window to a vertex so far behind the eye that only w is left
    // of it in the common exponent.
    for (int n = 0; n < 100; ++n) {
        const float w = -static_cast<float>(std::exp2(lot(20, 110)));
        triangle({{{0, 0, 0, 1}, {near(), near(), 0, n % 2 == 0 ? 1.F : w}, {near(), near(), 0, w}}});
    }
    expect_right(100'000);
}

/// The near plane is much closer than the visible part, so clipping leaves little of w: a ground that
/// continues behind the eye.
TEST_F(FarVertices, CloseNearPlanes) {
    for (int n = 0; n < 300; ++n) {
        const auto near_plane = static_cast<float>(std::exp2(lot(-24, -2)));
        // The rows are x, y, w = -z; the near plane removes what no pixel can show.
        const std::array<float, 16> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -2 * near_plane, 0};
        glMatrixMode(GL_PROJECTION);
        glLoadMatrixf(m.data());
        glMatrixMode(GL_MODELVIEW);
        const auto size = static_cast<float>(std::exp2(lot(-4, 20)));
        const auto coordinate = [&] { return near() * size; };
        const std::array<std::array<float, 4>, 3> v{
            {{coordinate(), coordinate(), -std::fabs(coordinate()), 1},
             {coordinate(), coordinate(), coordinate(), 1},
             {coordinate(), coordinate(), std::fabs(coordinate()), 1}}};
        draw(v);
        std::array<Vertex, 3> clip{};
        for (unsigned i = 0; i < 3; ++i)
            clip[i] = {v[i][0], v[i][1], -static_cast<long double>(v[i][2])};
        // Nothing is drawn in front of the near plane, so triangles with visible places there are left out.
        const bool crosses = std::fmin(clip[0].w, std::fmin(clip[1].w, clip[2].w)) < 0;
        if (crosses && near_plane < size * 0x1p-14F)
            check(clip);
    }
    expect_right(50'000);
}

/// A user clip plane and its complement divide a triangle whose vertices are far away.
TEST_F(FarVertices, UnderUserPlanes) {
    for (int n = 0; n < 200; ++n) {
        const float x = std::fabs(far(n % 2 == 0 ? 20 : 40)), at = near() / 2;
        const std::array<std::array<float, 4>, 3> v{
            {{-x, -0.5F * x, 0, 1}, {x, 0.5F * x, 0, 1}, {-x, x, 0, 1}}};
        glClear(GL_COLOR_BUFFER_BIT);
        glEnable(GL_CLIP_PLANE0);
        for (const float turned : {1.F, -1.F}) {
            const GLdouble plane[4] = {turned * 1.0, 0, 0, turned * -at};
            glClipPlane(GL_CLIP_PLANE0, plane);
            glColor3f(turned > 0 ? 1.F : 0.5F, 1, 1);
            glBegin(GL_TRIANGLES);
            for (const auto& c : v)
                glVertex4fv(c.data());
            glEnd();
        }
        glDisable(GL_CLIP_PLANE0);
        glColor3f(1, 1, 1);
        check({{{v[0][0], v[0][1], 1}, {v[1][0], v[1][1], 1}, {v[2][0], v[2][1], 1}}});
        std::vector<Rgba> pixels(side * side);
        glReadPixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        for (int p = 0; p < side * side; ++p) {
            const double center = (p % side + 0.5) * 2 / side - 1;
            const Rgba& pixel = pixels[static_cast<std::size_t>(p)];
            if (pixel[1] != 0 && std::fabs(center - at) > 2.0 / 128 / side) {
                ASSERT_EQ(pixel[0], center > at ? 255 : 128) << n << " at " << p % side;
            }
        }
    }
    expect_right(100'000);
}

/// A vertex that clipping makes of a near and a far end has the right colour and texture coordinates.
TEST_F(FarVertices, AttributesAlongTheEdge) {
    const float far = 0x1p40F;
    glClear(GL_COLOR_BUFFER_BIT);
    GLubyte texels[256][4];
    for (int i = 0; i < 256; ++i)
        for (int c = 0; c < 4; ++c)
            texels[i][c] = static_cast<GLubyte>(c == 0 ? 255 : i);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 256, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    for (const bool from_far : {false, true}) {
        glBegin(GL_QUADS); // s equals x at each vertex
        const float x[4] = {0, far, far, 0}, y[4] = {-1, -1, 1, 1};
        for (int i = 0; i < 4; ++i) {
            const int k = from_far ? (i + 1) % 4 : i;
            glTexCoord2f(x[k], 0);
            glVertex2f(x[k], y[k]);
        }
        glEnd();
        GLubyte pixels[side][4];
        glReadPixels(0, 20, side, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
        for (int i = side / 2; i < side; ++i)
            EXPECT_NEAR(pixels[i][1], (i - side / 2 + 0.5) * 4, 1) << i; // 256 texels in 64 pixels
    }
}

} // namespace
} // namespace spangle::test
