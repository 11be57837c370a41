// Compares which pixels small, thin and adjacent primitives cover with brute force in integers of 1/256
// pixel.
#include "tests/oracle/extremes/extreme.hpp"

namespace spangle::test {
namespace {

using Grid = std::array<std::int64_t, 2>; ///< a position in 256ths of a pixel

Place place(const Grid& v) {
    return {static_cast<double>(v[0]) / 256, static_cast<double>(v[1]) / 256, 0, 1};
}
std::int64_t lot(Random& random, std::int64_t from, std::int64_t to) {
    return from + random.below(static_cast<std::uint32_t>(to - from + 1));
}

/// Counts fragments of a pixel that differ from the exact number.
struct Count {
    long fragments = 0, wrong = 0, twice = 0;
    static constexpr int anything = 2;
    void add(int drawn, int exact) { // `exact` is 1 for drawn once, 0 for at most once, -1 for never
        fragments += exact == 1 ? 1 : 0;
        wrong += (exact == 1 && drawn == 0) || (exact == -1 && drawn != 0) ? 1 : 0;
        twice += drawn > 1 && exact != anything ? 1 : 0;
    }
};

template <class Exact> void compare(const Screen& screen, Count& count, Exact exact) {
    const Picture picture = screen.picture();
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            count.add(picture[static_cast<std::size_t>(y * side + x)][0], exact(x, y));
}

TEST(Extreme, 07_ThinTriangles) {
    Random random{7};
    Count thin, none;
    for (const EGLint tier : tiers) {
        const Screen screen(tier);
        screen.pixels_as_coordinates();
        for (const Form form : fractions)
            for (int n = 0; n < 60; ++n) {
                const Grid a{lot(random, 0, 16384), lot(random, 0, 16384)};
                Grid b{lot(random, 0, 16384), lot(random, 0, 16384)};
                const Grid step{lot(random, -128, 128), lot(random, -128, 128)};
                Grid c{};
                if (n % 5 == 0) // two vertices are equal
                    c = n % 2 == 0 ? a : b;
                else if (n % 5 == 1) { // the vertices lie on one line
                    b = {a[0] + 3 * step[0], a[1] + 3 * step[1]};
                    c = {a[0] - 5 * step[0], a[1] - 5 * step[1]};
                } else if (n % 5 == 2) // a sliver of 1/256 pixel along a row or a column of centres
                    b = {a[0] / 256 * 256 + 128, 0}, c = {b[0] + (n % 2 == 0 ? 1 : -1), 16384};
                else
                    c = {b[0] + (n % 2 == 0 ? 1 : 0), b[1] + (n % 3 == 0 ? 1 : -1)};
                const std::array<Grid, 3> v{a, b, c};
                Screen::count_fragments();
                polygon(form, GL_TRIANGLES, std::array<Place, 3>{place(a), place(b), place(c)});
                compare(screen, n % 5 < 2 ? none : thin, [&](int x, int y) { return covers(v, x, y); });
            }
    }
    EXPECT_EQ(thin.wrong + thin.twice + none.wrong, 0);
    EXPECT_GT(thin.fragments, 300);
    EXPECT_EQ(none.fragments, 0);
    row("no fragment without a centre inside, one with it", "exact edges in whole numbers",
        "%ld of %ld fragments wrong", thin.wrong + none.wrong, thin.fragments);
}

TEST(Extreme, 08_FansAroundCentres) {
    Random random{8};
    Count count;
    long edges_on_centres = 0;
    for (const EGLint tier : tiers) {
        const Screen screen(tier);
        screen.pixels_as_coordinates();
        for (const Form form : fractions)
            for (int n = 0; n < 40; ++n) {
                const int corners = n % 2 == 0 ? 4 : 8;
                const std::int64_t half = lot(random, 1, 20) * 256;
                const Grid hub{lot(random, 20, 43) * 256 + 128, lot(random, 20, 43) * 256 + 128};
                std::vector<Grid> rim;
                const std::int64_t way[8][2] = {{1, 0},  {1, 1},   {0, 1},  {-1, 1},
                                                {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
                for (int i = 0; i < 8; i += 8 / corners)
                    rim.push_back({hub[0] + way[i][0] * half, hub[1] + way[i][1] * half});
                Screen::count_fragments();
                glBegin(GL_TRIANGLE_FAN);
                vertex(form, place(hub));
                for (std::size_t i = 0; i <= rim.size(); ++i)
                    vertex(form, place(rim[n % 3 == 0 ? rim.size() - 1 - i % rim.size() : i % rim.size()]));
                glEnd();
                compare(screen, count, [&](int x, int y) {
                    int exact = -1;
                    bool inner = false;
                    for (std::size_t i = 0; i < rim.size(); ++i) {
                        const Grid &a = rim[i], &b = rim[(i + 1) % rim.size()];
                        const int part = covers({hub, a, b}, x, y);
                        const Grid center{x * 256 + 128, y * 256 + 128};
                        inner = inner || (part == 0 && area(a, b, center) > 0);
                        exact = std::max(exact, part);
                    }
                    edges_on_centres += inner ? 1 : 0;
                    return inner ? 1 : exact;
                });
            }
    }
    EXPECT_EQ(count.wrong + count.twice, 0);
    EXPECT_GT(edges_on_centres, 5'000);
    row("a centre on an inner edge is drawn exactly once", "whole numbers; counting blend",
        "%ld of %ld fragments wrong, %ld twice; %ld on edges", count.wrong, count.fragments, count.twice,
        edges_on_centres);
}

constexpr int cells = 16;
/// Divides the window into cells whose inner corners are moved by less than a pixel, so that no cell folds.
std::array<std::array<Place, cells + 1>, cells + 1> mesh(Random& random, bool perspective) {
    std::array<std::array<Place, cells + 1>, cells + 1> v{};
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
            const auto moved = [&](int k) {
                return k * 4 + (k > 0 && k < cells ? static_cast<double>(lot(random, -240, 240)) / 256 : 0);
            };
            const double w = perspective ? static_cast<double>(lot(random, 32, 256)) / 64 : 1;
            v[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] = {moved(i) * w, moved(j) * w, 0, w};
        }
    return v;
}

TEST(Extreme, 09_MeshesAndTJunctions) {
    Random random{9};
    Count count;
    long junctions = 0;
    for (const EGLint tier : tiers) {
        const Screen screen(tier);
        screen.pixels_as_coordinates();
        for (const Form form : fractions) {
            for (int n = 0; n < 8; ++n) {
                const auto v = mesh(random, false);
                Screen::count_fragments();
                for (std::size_t j = 0; j < cells; ++j) {
                    glBegin(n % 2 == 0 ? GL_TRIANGLE_STRIP : GL_QUAD_STRIP);
                    for (std::size_t i = 0; i <= cells; ++i)
                        vertex(form, v[j][i]), vertex(form, v[j + 1][i]);
                    glEnd();
                }
                compare(screen, count, [](int, int) { return 1; });
            }
            for (int n = 0; n < 20; ++n) {
                // One triangle lies above an edge, and two lie below it and meet near its middle.
                const Grid a{0, lot(random, 4096, 12288)}, b{16384, lot(random, 4096, 12288)};
                const Grid middle{(a[0] + b[0]) / 2 + lot(random, -99, 99), (a[1] + b[1]) / 2};
                Screen::count_fragments();
                const Grid top{8192, 16384}, low{8192, 0};
                polygon(form, GL_TRIANGLES,
                        std::array<Place, 9>{place(a), place(b), place(top), place(a), place(middle),
                                             place(low), place(middle), place(b), place(low)});
                compare(screen, count, [&](int x, int y) {
                    const Grid center{x * 256 + 128, y * 256 + 128};
                    const double off =
                        static_cast<double>(area(a, b, center)) /
                        std::hypot(static_cast<double>(b[0] - a[0]), static_cast<double>(b[1] - a[1]));
                    if (std::fabs(off) < 256) // so near an edge gaps and overlaps are allowed
                        return Count::anything;
                    const int above = covers({a, b, top}, x, y), left = covers({a, middle, low}, x, y);
                    const int right = covers({middle, b, low}, x, y);
                    const bool seam = area(a, low, center) > 0 && area(low, b, center) > 0 && off < 0;
                    return seam ? 1 : std::max({above, left, right});
                });
                ++junctions;
            }
        }
    }
    EXPECT_EQ(count.wrong, 0);
    EXPECT_EQ(count.twice, 0);
    row("shared edges exactly once; junctions off by a pixel at most", "whole numbers; counting blend",
        "%ld of %ld fragments wrong, %ld twice; %ld junctions", count.wrong, count.fragments, count.twice,
        junctions);
}

TEST(Extreme, 10_SumsOfBlendedMeshes) {
    Random random{10};
    long wrong = 0, pixels = 0;
    for (const EGLint tier : tiers) {
        const Screen screen(tier);
        screen.pixels_as_coordinates();
        for (const Form form : fractions)
            for (int n = 0; n < 10; ++n) {
                const auto v = mesh(random, true);
                glClear(GL_COLOR_BUFFER_BIT);
                glEnable(GL_BLEND);
                glBlendFunc(GL_ONE, GL_ONE);
                glColor3ub(85, 170, 255);
                glBegin(GL_TRIANGLES);
                for (std::size_t j = 0; j < cells; ++j)
                    for (std::size_t i = 0; i < cells; ++i)
                        for (const auto& [y, x] :
                             {std::array<std::size_t, 2>{0, 0}, {0, 1}, {1, 1}, {1, 1}, {1, 0}, {0, 0}})
                            vertex(form, v[j + y][i + x]);
                glEnd();
                for (const Rgba& pixel : screen.picture()) {
                    ++pixels;
                    wrong += pixel[0] != 85 || pixel[1] != 170 || pixel[2] != 255 ? 1 : 0;
                }
            }
    }
    EXPECT_EQ(wrong, 0);
    row("ONE, ONE sums to the colour once at every pixel, each vertex of its own w", "the colour",
        "%ld of %ld pixels wrong", wrong, pixels);
}

/// Returns whether the segment leaves a diamond, which draws a fragment (GL 1.3, 3.4.1). 0: the segment only
/// touches it.
int leaves_diamond(const Grid& a, const Grid& b, int px, int py) {
    const Grid c{px * 256 + 128, py * 256 + 128};
    const auto from = [&](const Grid& p) { return std::abs(p[0] - c[0]) + std::abs(p[1] - c[1]); };
    if (from(b) <= 128)
        return from(b) < 128 ? -1 : 0;
    int found = from(a) < 128 ? 1 : from(a) == 128 ? 0 : -1;
    for (std::size_t i = 0; i < 2; ++i) { // where the segment crosses a diagonal of the diamond
        const std::size_t j = 1 - i;
        const std::int64_t d = b[i] - a[i], e = b[j] - a[j];
        if (d == 0 || c[i] < std::min(a[i], b[i]) || c[i] > std::max(a[i], b[i]))
            continue;
        const std::int64_t off = std::abs((a[j] - c[j]) * d + (c[i] - a[i]) * e), least = 128 * std::abs(d);
        found = std::max(found, off < least ? 1 : off == least ? 0 : -1);
    }
    return found;
}

TEST(Extreme, 11_DiamondExits) {
    Random random{11};
    Count count, strips;
    for (const EGLint tier : tiers) {
        const Screen screen(tier);
        screen.pixels_as_coordinates();
        for (const Form form : fractions) {
            for (int n = 0; n < 48; ++n) {
                Grid a{lot(random, 256, 16128), lot(random, 256, 16128)};
                Grid b{lot(random, 256, 16128), lot(random, 256, 16128)};
                if (n % 4 == 1)
                    b = a; // a line without length
                else if (n % 4 == 2)
                    b = {a[0] + lot(random, -300, 300), a[1] + lot(random, -300, 300)};
                else if (n % 4 == 3) // lines that end in corners and centres of pixels
                    a = {a[0] / 128 * 128, a[1] / 128 * 128}, b = {b[0] / 128 * 128, b[1] / 128 * 128};
                for (const bool back : {false, true}) {
                    const Grid &from = back ? b : a, &to = back ? a : b;
                    Screen::count_fragments();
                    polygon(form, GL_LINES, std::array<Place, 2>{place(from), place(to)});
                    compare(screen, count, [&](int x, int y) { return leaves_diamond(from, to, x, y); });
                }
            }
            for (int n = 0; n < 12; ++n) { // lines of a strip in one direction share no fragment
                Screen::count_fragments();
                glBegin(GL_LINE_STRIP);
                Grid at{n % 2 == 0 ? 0 : 16384, 8192};
                for (int i = 0; i < 24; ++i) {
                    vertex(form, place(at));
                    const std::int64_t far = lot(random, 1, 700);
                    at[0] += n % 2 == 0 ? far : -far;
                    at[1] += lot(random, -far, far);
                }
                glEnd();
                compare(screen, strips, [](int, int) { return 0; });
            }
        }
    }
    EXPECT_EQ(count.wrong + count.twice, 0);
    EXPECT_EQ(strips.twice, 0);
    EXPECT_GT(count.fragments, 5'000);
    row("a fragment where a diamond is left; strips share none", "diamonds in whole numbers; counting blend",
        "%ld of %ld fragments wrong, %ld twice", count.wrong, count.fragments, count.twice + strips.twice);
}

TEST(Extreme, 12_SizesOfPoints) {
    long wrong = 0, points = 0;
    GLfloat range[2] = {};
    for (const EGLint tier : tiers) {
        const Screen screen(tier);
        screen.pixels_as_coordinates();
        glGetFloatv(GL_ALIASED_POINT_SIZE_RANGE, range);
        for (const Form form : fractions)
            for (const double size : {0.4, 1.0, 1.4, 2.0, 3.0, 7.0, double{range[1]}, 2.0 * range[1]})
                for (const Grid& at : {Grid{8192, 8192}, Grid{8191, 8193}, Grid{8320, 8319}, Grid{0, 0}}) {
                    if (form == Form::of_fixed)
                        glPointSizexOES(fixed(size));
                    else
                        glPointSize(static_cast<GLfloat>(size));
                    Screen::count_fragments();
                    polygon(form, GL_POINTS, std::array<Place, 1>{place(at)});
                    ++points;
                    const std::int64_t width =
                        std::clamp<std::int64_t>(std::lround(size), 1, std::lround(range[1]));
                    // An odd square is around a centre, an even square around a corner (GL 1.3, 3.3).
                    const auto low = [&](std::int64_t v) {
                        return width % 2 == 1 ? (v >> 8) - width / 2 : ((v + 128) >> 8) - width / 2;
                    };
                    const std::int64_t x0 = low(at[0]), y0 = low(at[1]);
                    const Picture picture = screen.picture();
                    for (int y = 0; y < side; ++y)
                        for (int x = 0; x < side; ++x) {
                            const int in = x >= x0 && x < x0 + width && y >= y0 && y < y0 + width ? 1 : 0;
                            wrong += picture[static_cast<std::size_t>(y * side + x)][0] != in ? 1 : 0;
                        }
                }
        glPointSize(0);
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
        glPointSizexOES(-65536);
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    }
    EXPECT_EQ(wrong, 0);
    row("rounded to a whole size of 1 to the largest; 0 is an error", "the squares of 3.3",
        "%ld pixels wrong of %ld points up to %g pixels", wrong, points, static_cast<double>(range[1]));
}

TEST(Extreme, 13_Viewports) {
    long wrong = 0, drawn = 0;
    GLint most[2] = {};
    for (const EGLint tier : tiers) {
        const Screen screen(tier);
        glGetIntegerv(GL_MAX_VIEWPORT_DIMS, most);
        const int w = most[0], h = most[1];
        const std::array<int, 4> cases[] = {
            {5, 7, 1, 1},           {5, 7, 0, 0},   {5, 7, 0, 9},     {-9, -4, 20, 20}, {0, 0, w, h},
            {-w / 2, -h / 2, w, h}, {60, 60, 9, 9}, {-64, 0, 64, 64}, {0, 64, 64, 64},  {63, 0, w, 1}};
        for (const Form form : forms)
            for (const auto& v : cases) {
                glClear(GL_COLOR_BUFFER_BIT);
                glViewport(v[0], v[1], v[2], v[3]);
                polygon(form, GL_QUADS,
                        std::array<Place, 4>{{{-1, -1, 0, 1}, {1, -1, 0, 1}, {1, 1, 0, 1}, {-1, 1, 0, 1}}});
                const Picture picture = screen.picture();
                for (int y = 0; y < side; ++y)
                    for (int x = 0; x < side; ++x) {
                        const bool in = x >= v[0] && x < v[0] + v[2] && y >= v[1] && y < v[1] + v[3];
                        const bool is = picture[static_cast<std::size_t>(y * side + x)][0] != 0;
                        wrong += in != is ? 1 : 0;
                        drawn += in ? 1 : 0;
                    }
            }
        glViewport(0, 0, -1, 5);
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    }
    EXPECT_EQ(wrong, 0);
    row("a full square fills the viewport's part of the window", "the rectangle",
        "%ld of %ld fragments wrong, up to %d x %d pixels", wrong, drawn, most[0], most[1]);
}

} // namespace
} // namespace spangle::test
