// Row G09: stored depths differ from the plane through the vertices by less than one step of the depth
// buffer, whatever the size of the primitive and the slope of its depth (GL 1.3, 2.10.1 and 3.5.1).
#include <cmath>

#include "tests/gl/raster/window.hpp"

namespace spangle::test {
namespace {

struct Place {
    long double x, y, z;
};

class Depths : public testing::TestWithParam<int> {
  protected:
    std::mt19937 random_{2};
    double lot(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

    /// Clears, draws, and compares every white pixel with the plane through three places. Returns the largest
    /// difference in steps.
    template <class Draw> double worst(int size, const std::array<Place, 3>& v, Draw draw) {
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw();
        const auto pixels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
        std::vector<GLuint> depth(pixels);
        std::vector<GLubyte> red(pixels);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, size, size, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depth.data());
        glReadPixels(0, 0, size, size, GL_RED, GL_UNSIGNED_BYTE, red.data());
        GLint bits = 0;
        glGetIntegerv(GL_DEPTH_BITS, &bits);
        const long double most = std::ldexp(1.0L, bits) - 1;
        const long double x1 = v[1].x - v[0].x, y1 = v[1].y - v[0].y, x2 = v[2].x - v[0].x,
                          y2 = v[2].y - v[0].y, z1 = v[1].z - v[0].z, z2 = v[2].z - v[0].z,
                          area = x1 * y2 - x2 * y1;
        const long double dx = (z1 * y2 - z2 * y1) / area, dy = (z2 * x1 - z1 * x2) / area;
        double off = 0;
        for (std::size_t p = 0; p < pixels; ++p) {
            if (red[p] == 0)
                continue;
            ++seen_;
            const auto x = static_cast<long double>(p % static_cast<std::size_t>(size)) + 0.5L,
                       y = static_cast<long double>(p / static_cast<std::size_t>(size)) + 0.5L;
            const long double expected = (v[0].z + dx * (x - v[0].x) + dy * (y - v[0].y)) * most;
            off = std::fmax(off, static_cast<double>(std::fabs((depth[p] >> (32 - bits)) - expected)));
        }
        return off;
    }
    std::size_t seen_ = 0;
    /// Returns a context whose depth buffer has as many bits as the test asks for.
    static HeadlessGl context(int size) {
        return GetParam() == 16 ? HeadlessGl(size, size, {EGL_DEPTH_SIZE, 16, EGL_STENCIL_SIZE, 0})
                                : HeadlessGl(size, size, {EGL_STENCIL_SIZE, 8});
    }
};

/// Draws compact triangles, slivers that are 2^10 times as long as wide and more, whole ranges of depth, and
/// the largest surfaces.
TEST_P(Depths, OfTriangles) {
    for (const int size : {64, 512, 2048}) {
        const HeadlessGl gl = context(size);
        GLint bits = 0;
        glGetIntegerv(GL_DEPTH_BITS, &bits);
        ASSERT_EQ(bits, GetParam());
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_ALWAYS);
        glMatrixMode(GL_PROJECTION);
        glOrtho(0, size, 0, size, 0, -1);
        double off = 0;
        for (int n = 0; n < (size == 2048 ? 24 : 240); ++n) {
            std::array<Place, 3> v{};
            for (Place& p : v) {
                const auto z =
                    static_cast<float>(n % 3 == 0 ? static_cast<double>(random_() % 2) : lot(0, 1));
                p = {std::floor(lot(0, size) * 256) / 256, std::floor(lot(0, size) * 256) / 256, z};
            }
            if (n % 4 == 0)
                v[0].x = v[0].y = v[1].y = v[2].x = 0, v[1].x = v[2].y = size;
            if (n % 4 == 1) { // makes a sliver
                const double t = lot(0, 1), width = std::exp2(lot(-4, 1));
                v[2].x = std::floor((v[0].x + t * (v[1].x - v[0].x)) * 256) / 256 + width;
                v[2].y = std::floor((v[0].y + t * (v[1].y - v[0].y)) * 256) / 256;
                v[2].x = std::floor(v[2].x * 256) / 256;
            }
            const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
            const auto [low, high] = std::minmax({v[0].y, v[1].y, v[2].y});
            const long double area =
                std::fabs((v[1].x - v[0].x) * (v[2].y - v[0].y) - (v[2].x - v[0].x) * (v[1].y - v[0].y));
            if (GetParam() == 16 && (right - left) * (high - low) > 1023 * area)
                continue; // such slivers are interpolated along their longer axis there
            off = std::fmax(off, worst(size, v, [&] {
                                glBegin(GL_TRIANGLES);
                                for (const Place& p : v)
                                    glVertex3f(static_cast<float>(p.x), static_cast<float>(p.y),
                                               static_cast<float>(p.z));
                                glEnd();
                            }));
        }
        std::printf("%d bits, %d pixels: %.2f steps\n", GetParam(), size, off);
        EXPECT_LT(off, GetParam() == 16 ? 1.0 : 0.75) << size;
    }
    EXPECT_GT(seen_, 1'000'000u);
}

/// Near planes are as close as 1e-7 of the far plane, so nearly all codes lie near the eye.
TEST_P(Depths, UnderPerspective) {
    constexpr int size = 128;
    const HeadlessGl gl = context(size);
    GLint bits = 0;
    glGetIntegerv(GL_DEPTH_BITS, &bits);
    ASSERT_EQ(bits, GetParam());
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    for (const double ratio : {1e-2, 1e-5, 1e-7}) {
        const long double near_plane = 1e-3F, far_plane = static_cast<float>(1e-3 / ratio);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        const auto n = static_cast<double>(near_plane);
        glFrustum(-n, n, -n, n, n, static_cast<double>(far_plane));
        glMatrixMode(GL_MODELVIEW);
        double off = 0;
        for (int i = 0; i < 300; ++i) {
            std::array<std::array<float, 3>, 3> corner{};
            std::array<Place, 3> v{};
            for (unsigned k = 0; k < 3; ++k) {
                const double w = i % 2 == 0 ? n * std::exp(lot(0, -std::log(ratio))) : n * lot(1, 5);
                const auto exact = static_cast<float>(w);
                // Vertices lie on the n.8 grid, so snapping does not move them.
                const auto on_grid = [&] { return std::floor(lot(0, size) * 256) / 256; };
                const auto from_eye = [&](double at) {
                    return static_cast<float>((2 * at / size - 1) * static_cast<double>(exact));
                };
                const double x = on_grid(), y = on_grid();
                corner[k] = {from_eye(x), from_eye(y), -exact};
                v[k] = {x, y, far_plane / (far_plane - near_plane) * (1 - near_plane / exact)};
            }
            if (std::fabs((v[1].x - v[0].x) * (v[2].y - v[0].y) - (v[2].x - v[0].x) * (v[1].y - v[0].y)) < 4)
                continue;
            off = std::fmax(off, worst(size, v, [&] {
                                glBegin(GL_TRIANGLES);
                                for (const auto& c : corner)
                                    glVertex3fv(c.data());
                                glEnd();
                            }));
        }
        std::printf("%d bits, near/far %g: %.2f steps\n", GetParam(), ratio, off);
        EXPECT_LT(off, GetParam() == 16 ? 1.0 : 0.75) << ratio;
    }
}

/// A cleared depth is the nearest code of a float, so it is at most one code from that of the double.
TEST_P(Depths, OfClears) {
    const HeadlessGl gl = context(8);
    GLint bits = 0;
    glGetIntegerv(GL_DEPTH_BITS, &bits);
    const double most = std::ldexp(1.0, bits) - 1;
    const auto stored = [&](double depth) {
        glClearDepth(depth);
        glClear(GL_DEPTH_BUFFER_BIT);
        GLuint word = 0;
        glReadPixels(3, 3, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &word);
        return static_cast<double>(word >> (32 - bits));
    };
    EXPECT_EQ(stored(0.96), std::floor(0.96 * most + 0.5));
    EXPECT_EQ(stored(0), 0);
    EXPECT_EQ(stored(1), most);
    for (int i = 0; i < 5000; ++i) {
        const double depth = lot(0, 1), as_float = static_cast<float>(depth);
        ASSERT_LT(std::fabs(stored(as_float) - as_float * most), 0.52) << as_float;
        ASSERT_LT(std::fabs(stored(depth) - depth * most), 1.02) << depth;
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, Depths, testing::Values(16, 24));

} // namespace
} // namespace spangle::test
