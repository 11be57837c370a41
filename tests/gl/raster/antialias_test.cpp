// Rows D02, D07, D13, D14: antialiased points, lines and polygons multiply alpha by the coverage.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <spangle/reference.hpp>

#include "tests/gl/raster/window.hpp"
#include "tests/unit/primitive/clipped_area.hpp"

namespace spangle::test {
namespace {

class Antialias : public Window {
  protected:
    void SetUp() override {
        Window::SetUp();
        for (const GLenum on : {GL_POINT_SMOOTH, GL_LINE_SMOOTH, GL_POLYGON_SMOOTH})
            glEnable(on);
    }
    using Corner = std::array<GLfloat, 2>;
    Corner corner() { return {place(), place()}; }

    template <class Corners> static void give(GLenum mode, const Corners& corners) {
        glBegin(mode);
        for (const Corner& c : corners)
            glVertex2fv(c.data());
        glEnd();
    }
    template <class Draw> static std::vector<Rgba> drawn(Draw draw) {
        clear();
        draw();
        return picture();
    }
    /// Compares a white drawing without blending: alpha is the coverage, colours stay white, and pixels
    /// without coverage are unchanged.
    static void expect_areas(const std::vector<Rgba>& got, const oracle::Polygon& polygon, double tolerance,
                             int trial) {
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const Rgba& pixel = got[static_cast<std::size_t>(y * size + x)];
                const double area = oracle::area_in(polygon, x, y);
                ASSERT_NEAR(pixel[3], 255 * area, tolerance) << trial << " at " << x << ',' << y;
                if (area > 1e-3) {
                    ASSERT_EQ(pixel[0], 255) << trial << " at " << x << ',' << y;
                }
                if (area == 0) {
                    ASSERT_EQ(pixel[0], 0) << trial << " at " << x << ',' << y;
                }
            }
    }
    static oracle::Polygon polygon(const std::vector<Corner>& corners) {
        oracle::Polygon out;
        for (const Corner& c : corners)
            out.push_back({c[0], c[1]});
        return out;
    }
};

constexpr double rounding = 0.5 + 255.0 / 4096;

TEST_F(Antialias, PolygonsCoverTheirAreas) {
    for (int n = 0; n < 300; ++n) {
        const std::vector<Corner> t = {corner(), corner(), corner()};
        expect_areas(drawn([&] { give(GL_TRIANGLES, t); }), polygon(t), rounding, n);
    }
    for (int n = 0; n < 100; ++n) { // draws convex quads
        const auto c = [&](double low, double high) {
            return static_cast<GLfloat>(std::floor(lot(low, high) * 256) / 256);
        };
        const std::vector<Corner> q = {
            {c(2, 20), c(2, 20)}, {c(40, 60), c(2, 20)}, {c(42, 62), c(42, 62)}, {c(2, 18), c(40, 60)}};
        expect_areas(drawn([&] { give(GL_QUADS, q); }), polygon(q), rounding, n);
    }
}

/// Slivers may cover no pixel centre.
TEST_F(Antialias, ThinAndTinyPolygons) {
    for (int n = 0; n < 200; ++n) {
        const Corner a = corner(), b = n % 2 != 0 ? corner() : Corner{a[0] + 0.75f, a[1] + 0.5f};
        const std::vector<Corner> t = {a, b, {a[0] + 0.25f, a[1] - 0.125f}};
        expect_areas(drawn([&] { give(GL_TRIANGLES, t); }), polygon(t), rounding, n);
    }
}

/// Triangles of a fan around a point are added: alpha is full everywhere, to the last bit.
TEST_F(Antialias, AbuttingPolygonsSumToOne) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA_SATURATE, GL_ONE);
    for (int n = 0; n < 50; ++n) {
        const std::vector<Corner> fan = {
            {static_cast<GLfloat>(lot(10, 50)), static_cast<GLfloat>(lot(10, 50))},
            {4, 4},
            {60, 4},
            {60, 60},
            {4, 60},
            {4, 4}};
        const auto got = drawn([&] { give(GL_TRIANGLE_FAN, fan); });
        int least = 255;
        for (int y = 4; y < 60; ++y)
            for (int x = 4; x < 60; ++x)
                least = std::min<int>(least, got[static_cast<std::size_t>(y * size + x)][3]);
        EXPECT_GE(least, 254); // at most five triangles meet in a pixel, each rounded
    }
}

TEST_F(Antialias, LinesCoverTheirRectangles) {
    for (int n = 0; n < 300; ++n) {
        const Corner a = corner(), b = corner();
        const double width = n % 3 == 0 ? 1 : 1 + static_cast<int>(lot(0, 120)) / 8.0;
        glLineWidth(static_cast<GLfloat>(width));
        const auto got = drawn([&] { give(GL_LINES, std::array{a, b}); });
        expect_areas(got, oracle::rectangle({a[0], a[1]}, {b[0], b[1]}, width), rounding + 0.4, n);
    }
}

/// A stippled line consists of parts of length 1, numbered from the start of a strip (GL 1.3, 3.4.2).
TEST_F(Antialias, StippledLinesAreCutIntoParts) {
    glEnable(GL_LINE_STIPPLE);
    for (int n = 0; n < 100; ++n) {
        const Corner a = corner(), b = corner();
        const unsigned pattern = random_() & 0xFFFF, factor = 1 + random_() % 4;
        glLineStipple(static_cast<GLint>(factor), static_cast<GLushort>(pattern));
        const double width = 1 + static_cast<int>(lot(0, 40)) / 8.0;
        glLineWidth(static_cast<GLfloat>(width));
        const auto got = drawn([&] { give(GL_LINES, std::array{a, b}); });
        const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
        std::vector<double> sum(size * size);
        for (unsigned i = 0; i < length; ++i) {
            if ((pattern >> (i / factor % 16) & 1) == 0)
                continue;
            const double from = i / length, to = std::min(1.0, (i + 1) / length);
            const auto at = [&](double t) {
                return oracle::Point{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
            };
            const auto part = oracle::rectangle(at(from), at(to), width);
            for (int p = 0; p < size * size; ++p)
                sum[static_cast<std::size_t>(p)] += oracle::area_in(part, p % size, p / size);
        }
        // Without blending, the coverage of two runs that reach one pixel is not added, so it may be less.
        for (std::size_t p = 0; p < sum.size(); ++p) {
            ASSERT_LE(got[p][3], 255 * sum[p] + rounding + 0.6) << n;
            if (sum[p] > 0.01) {
                ASSERT_EQ(got[p][0], 255);
            }
        }
        double wish = 0, have = 0;
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
        const auto added = drawn([&] { give(GL_LINES, std::array{a, b}); });
        glDisable(GL_BLEND);
        for (std::size_t p = 0; p < sum.size(); ++p) {
            ASSERT_NEAR(added[p][3], 255 * sum[p], 2.5) << n << ' ' << p;
            wish += sum[p];
            have += added[p][3] / 255.0;
        }
        EXPECT_NEAR(have, wish, 0.5 + wish * 0.01);
    }
}

TEST_F(Antialias, PointsAreDiscs) {
    for (int n = 0; n < 200; ++n) {
        const double diameter = n % 4 == 0 ? 1 : 1 + static_cast<int>(lot(0, 31 * 8)) / 8.0;
        const Corner at = {20 + place() / 4, 20 + place() / 4};
        glPointSize(static_cast<GLfloat>(diameter));
        const auto got = drawn([&] { give(GL_POINTS, std::vector<Corner>{at}); });
        double sum = 0;
        constexpr int fine = 4096;
        oracle::Polygon circle;
        for (int i = 0; i < fine; ++i)
            circle.push_back({at[0] + diameter / 2 * std::cos(2 * std::numbers::pi * i / fine),
                              at[1] + diameter / 2 * std::sin(2 * std::numbers::pi * i / fine)});
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const Rgba& pixel = got[static_cast<std::size_t>(y * size + x)];
                const double dx = x + 0.5 - at[0], dy = y + 0.5 - at[1], r = std::hypot(dx, dy);
                if (std::fabs(r - diameter / 2) > 1) {
                    ASSERT_EQ(pixel[3], r < diameter / 2 ? 255 : 0) << n;
                } else {
                    ASSERT_NEAR(pixel[3] / 255.0, oracle::area_in(circle, x, y), 1 / 256.0 + 0.5 / 255)
                        << n << ' ' << x << ',' << y;
                }
                sum += pixel[3] / 255.0;
            }
        EXPECT_NEAR(sum, std::numbers::pi * diameter * diameter / 4, 0.05 + 0.01 * diameter);
    }
}

/// Sizes are rounded to the nearest existing size; the largest is 64, the smallest 1.
TEST_F(Antialias, SizesSnapToTheGranularity) {
    const auto alpha_of = [](GLfloat width) {
        glLineWidth(width);
        const auto got = drawn([] { give(GL_LINES, std::array{Corner{0, 32}, Corner{size, 32}}); });
        int sum = 0;
        for (int y = 0; y < size; ++y)
            sum += got[static_cast<std::size_t>(y * size + 30)][3];
        return sum / 255.0;
    };
    EXPECT_NEAR(alpha_of(0.01f), 1, 0.02);
    EXPECT_NEAR(alpha_of(2.3f), 2.25, 0.02);
    EXPECT_NEAR(alpha_of(2.33f), 2.375, 0.02);
    EXPECT_NEAR(alpha_of(16), 16, 0.02);
    EXPECT_NEAR(alpha_of(1000), 64, 0.02);
}

/// Inside, colours and depths are those of the same primitive without antialiasing. On the edges they stay in
/// the range of the vertices, although centres lie outside.
TEST_F(Antialias, NothingIsExtrapolated) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    for (int n = 0; n < 200; ++n) {
        std::array<Corner, 4> at;
        std::array<std::array<GLfloat, 4>, 4> color;
        std::array<GLfloat, 4> z;
        const bool quad = n % 2 != 0;
        const std::array<Corner, 4> square = {{{8, 8}, {55, 8}, {55, 55}, {8, 55}}};
        for (std::size_t i = 0; i < 4; ++i) {
            at[i] = quad ? Corner{square[i][0] + place() / 8, square[i][1] + place() / 8} : corner();
            for (GLfloat& c : color[i])
                c = random_() % 2 != 0 ? 1 : 0; // the ends of the range would wrap first
            color[i][3] = 1;
            z[i] = random_() % 2 != 0 ? 0 : -1;
        }
        const auto draw = [&] {
            glBegin(quad ? GL_QUADS : GL_TRIANGLES);
            for (std::size_t i = 0; i < (quad ? 4u : 3u); ++i) {
                glColor4fv(color[i].data());
                glVertex3f(at[i][0], at[i][1], z[i]);
            }
            glEnd();
        };
        glDisable(GL_POLYGON_SMOOTH);
        const auto hard = drawn(draw);
        const auto hard_z = depths();
        glEnable(GL_POLYGON_SMOOTH);
        const auto soft = drawn(draw);
        const auto soft_z = depths();
        for (int c = 0; c < 3; ++c) {
            GLfloat least = 1, most = 0;
            for (std::size_t i = 0; i < (quad ? 4u : 3u); ++i) {
                least = std::min(least, color[i][static_cast<std::size_t>(c)]);
                most = std::max(most, color[i][static_cast<std::size_t>(c)]);
            }
            for (std::size_t p = 0; p < soft.size(); ++p) {
                const GLubyte v = soft[p][static_cast<std::size_t>(c)];
                if (soft[p][3] == 0)
                    continue;
                ASSERT_TRUE(least == most ? v == 255 * least : true) << n;
                if (soft[p][3] == 255 && hard[p][3] != 0) {
                    ASSERT_NEAR(v, hard[p][static_cast<std::size_t>(c)], 1) << n;
                }
            }
        }
        if (std::min({z[0], z[1], z[2], quad ? z[3] : z[2]}) ==
            std::max({z[0], z[1], z[2], quad ? z[3] : z[2]}))
            for (std::size_t p = 0; p < soft.size(); ++p)
                if (soft[p][3] != 0) {
                    ASSERT_EQ(soft_z[p], z[0] == 0 ? 0u : 16777215u);
                }
    }
}

/// A fragment has the colours of a place less than two pixels away, also if its centre is outside. The
/// gradients reach both ends of their range on the edges.
TEST_F(Antialias, EdgesContinueGradients) {
    for (int n = 0; n < 100; ++n) {
        const GLfloat low = 8 + place() / 64, high = 40 + place() / 8, range = high + 2 - low;
        const auto got = drawn([&] {
            glBegin(GL_QUADS);
            for (const auto& [x, y] :
                 {std::pair{low, low}, {high, low + 2}, {high + 2, high + 2}, {low + 1, high + 1}}) {
                glColor4f((x - low) / range, (y - low) / range, 0, 1);
                glVertex2f(x, y);
            }
            glEnd();
        });
        const auto expected = [&](double at) { return 255 * std::clamp((at + 0.5 - low) / range, 0.0, 1.0); };
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                if (const Rgba& p = got[static_cast<std::size_t>(y * size + x)]; p[3] != 0) {
                    ASSERT_NEAR(p[0], expected(x), 2 * 255 / range + 1) << n;
                    ASSERT_NEAR(p[1], expected(y), 2 * 255 / range + 1) << n;
                }
    }
}

TEST_F(Antialias, ScissorAndTranslationChangeNothing) {
    for (int n = 0; n < 60; ++n) {
        const std::array<Corner, 3> t = {
            {{place() / 2, place() / 2}, {place() / 2, place() / 2}, {place() / 2, place() / 2}}};
        const GLenum mode = n % 3 == 0 ? GL_POINTS : n % 3 == 1 ? GL_LINE_STRIP : GL_TRIANGLES;
        glPointSize(7.5f);
        glLineWidth(3.25f);
        const auto whole = drawn([&] { give(mode, t); });
        glEnable(GL_SCISSOR_TEST);
        glScissor(7, 9, 20, 11);
        glClearColor(0, 0, 0, 0);
        const auto cut = drawn([&] { give(mode, t); });
        glDisable(GL_SCISSOR_TEST);
        glLoadIdentity();
        glTranslatef(5, 11, 0);
        const auto moved = drawn([&] { give(mode, t); });
        glLoadIdentity();
        for (int y = 9; y < 20; ++y)
            for (int x = 7; x < 27; ++x)
                ASSERT_EQ(cut[static_cast<std::size_t>(y * size + x)],
                          whole[static_cast<std::size_t>(y * size + x)]);
        for (int y = 0; y < size - 11; ++y)
            for (int x = 0; x < size - 5; ++x)
                ASSERT_EQ(moved[static_cast<std::size_t>((y + 11) * size + x + 5)],
                          whole[static_cast<std::size_t>(y * size + x)])
                    << n;
    }
}

/// Each enable applies to its own primitives and to polygons of its own mode. Other primitives stay as they
/// are.
TEST_F(Antialias, EnablesAreOfTheirPrimitives) {
    const std::array<Corner, 3> t = {{{5.3f, 6.7f}, {50.1f, 20.9f}, {20.4f, 58.2f}}};
    constexpr GLenum enables[] = {GL_POINT_SMOOTH, GL_LINE_SMOOTH, GL_POLYGON_SMOOTH};
    constexpr GLenum own[] = {GL_POINTS, GL_LINE_LOOP, GL_TRIANGLES}, modes[] = {GL_POINT, GL_LINE, GL_FILL};
    glPointSize(5);
    glLineWidth(2);
    const auto soft = [](const std::vector<Rgba>& pixels) {
        return std::any_of(pixels.begin(), pixels.end(),
                           [](const Rgba& p) { return p[3] != 0 && p[3] != 255; });
    };
    for (const GLenum off : enables)
        glDisable(off);
    for (int on = 0; on < 3; ++on) {
        glEnable(enables[on]);
        for (int i = 0; i < 3; ++i) {
            glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
            EXPECT_EQ(soft(drawn([&] { give(own[i], t); })), i == on) << on << i;
            glPolygonMode(GL_FRONT_AND_BACK, modes[i]);
            EXPECT_EQ(soft(drawn([&] { give(GL_TRIANGLES, t); })), i == on) << on << i;
        }
        glDisable(enables[on]);
    }
}

/// Row D14: colours stay, and alpha is multiplied before the alpha test and blending.
TEST_F(Antialias, AlphaIsMultipliedBeforeTheTests) {
    glColor4f(0.25f, 0.5f, 1, 0.5f);
    const auto draw = [] { give(GL_LINES, std::array{Corner{4, 20.25f}, Corner{60, 20.25f}}); };
    auto got = drawn(draw);
    const auto at = [&](int y) { return got[static_cast<std::size_t>(y * size + 30)]; };
    EXPECT_EQ(at(19), (Rgba{64, 128, 255, 32})); // a quarter of the pixel is covered
    EXPECT_EQ(at(20), (Rgba{64, 128, 255, 96}));
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_GREATER, 0.3f);
    got = drawn(draw);
    EXPECT_EQ(at(19), (Rgba{0, 0, 0, 0}));
    EXPECT_EQ(at(20)[3], 96);
    glDisable(GL_ALPHA_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    got = drawn(draw);
    EXPECT_NEAR(at(20)[2], 255 * 0.375, 1);
}

/// A size larger than the largest is drawn as the largest.
TEST_F(Antialias, SizesOfAnyMagnitude) {
    constexpr int middle = size / 2 * size + size / 2;
    for (const bool lines : {false, true}) {
        const auto figure = [&](GLfloat across) {
            return drawn([&] {
                lines ? glLineWidth(across) : glPointSize(across);
                const std::array<Corner, 2> ends{{{size / 2, size / 2}, {size / 2 + 1, size / 2}}};
                give(lines ? GL_LINES : GL_POINTS, ends);
            });
        };
        const std::vector<Rgba> largest = figure(64);
        EXPECT_EQ(largest[middle + 12 * size][3], 255) << "it is large";
        for (const GLfloat across : {65.0f, 32767.5f, 32768.0f, 1e9f, std::numeric_limits<GLfloat>::max()})
            EXPECT_EQ(figure(across), largest) << across;
    }
}

} // namespace
} // namespace spangle::test
