// Measures edges, planes and depth.
#include "raster/primitive/edge.hpp"
#include "raster/span/span.hpp"
#include "tests/oracle/bounds/bounds.hpp"
#include "tests/oracle/extremes/screen.hpp"

namespace spangle::test {
namespace {

using namespace raster;

/// Returns the first column whose centre is on the edge or right of it.
std::int64_t exact_column(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1,
                          std::int64_t row) {
    const std::int64_t dy = y1 - y0, above = row * subpixel_one + subpixel_one / 2 - y0;
    const std::int64_t numerator = (x0 - subpixel_one / 2) * dy + (x1 - x0) * above,
                       denominator = dy * subpixel_one;
    return -((-numerator - ((-numerator % denominator) + denominator) % denominator) / denominator);
}

struct Walked {
    long columns = 0, wrong = 0;
};
/// Walks edges with |x| and y up to `extent`, at their first rows.
template <class E> Walked walk(std::int32_t extent, std::int32_t from, int edges) {
    Random random{11};
    Walked w;
    for (int n = 0; n < edges; ++n) {
        const std::int32_t x0 = lot(random, from) + extent / 2, x1 = lot(random, extent / 2) + extent / 2;
        std::int32_t y0 = static_cast<std::int32_t>(word(random) % static_cast<std::uint32_t>(extent)),
                     y1 = static_cast<std::int32_t>(word(random) % static_cast<std::uint32_t>(extent));
        if (n % 4 == 0)
            y1 = y0 + static_cast<std::int32_t>(random.below(600)) - 300;
        if (y0 > y1)
            std::swap(y0, y1);
        const std::int32_t first = first_center(y0), end = first_center(y1);
        if (first >= end || y1 > extent || y0 < 0)
            continue;
        E edge = E::at(x0, y0, x1, y1, first);
        for (std::int32_t row = first; row < end && row < first + 64; ++row, edge.step()) {
            ++w.columns;
            w.wrong += edge.column() != exact_column(x0, y0, x1, y1, row) ? 1 : 0;
        }
    }
    return w;
}

TEST(Bounds, Edges) {
    const Walked wide = walk<Edge>(guard_band, guard_band / 2, 40'000),
                 small = walk<SmallEdge>(SmallEdge::extent, SmallEdge::extent / 2, 40'000),
                 low = walk<LowEdge>(LowEdge::extent, LowEdge::extent / 2, 80'000);
    EXPECT_EQ(wide.wrong + small.wrong + low.wrong, 0);
    row({"edge, set-up and step", "n.8 vertices; numerator int64, remainder int32",
         "guard band of 8192 pixels each way", "exact column", "edge_wide"},
        "%ld of %ld columns wrong", wide.wrong, wide.columns);
    row({"edge within 64 pixels", "32.32", "64 pixels", "short by 2^-25, of 2^-24; exact column",
         "edge_small"},
        "%ld of %ld columns wrong", small.wrong, small.columns);
    row({"edge within 15 pixels", "6.26", "15 pixels", "-15 to 17 units of 2^-26, of 32; exact column",
         "edge_low"},
        "%ld of %ld columns wrong", low.wrong, low.columns);
    row({"where a line leaves its first diamond", "int32", "short lines", "no overflow; exact",
         "diamond_first"},
        "none wrong ([extremes](extremes.md) 11)");
}

TEST(Bounds, Planes) {
    Random random{12};
    double worst = 0;
    for (int n = 0; n < 200'000; ++n) {
        const long double v = lot(random, 0x3FFFFFFF) + word(random) * 0x1p-32L,
                          dx = lot(random, 0xFFFF) + word(random) * 0x1p-32L,
                          dy = lot(random, 0xFFFF) + word(random) * 0x1p-32L;
        const auto guarded = [](long double of) {
            return static_cast<std::uint64_t>(
                static_cast<std::int64_t>(std::nearbyint(std::ldexp(of, guard_bits))));
        };
        const Interpolant<std::uint64_t> plane{guarded(v), guarded(dx), guarded(dy)};
        const std::int32_t c = lot(random, 16384), r = lot(random, 16384);
        const long double exact = v + c * dx + r * dy,
                          is = std::ldexp(static_cast<long double>(static_cast<std::int64_t>(plane.at(c, r))),
                                          -guard_bits);
        worst = std::fmax(worst, static_cast<double>(std::fabs(is - exact)));
    }
    EXPECT_LE(worst, 0.26);
    row({"plane of 1/w, s/w, colour/w at a pixel", "30 bits and 16 guard bits, in 64",
         "16384 columns and rows", "0.26 2^-30 of the largest vertex", "interpolant"},
        "%.3f 2^-30", worst);
}

TEST(Bounds, DepthPlanes) {
    Random random{13};
    double worst = 0;
    long fragments = 0;
    const Screen screen(tiers[0]);
    screen.pixels_as_coordinates();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    for (int n = 0; n < 60; ++n) {
        std::int64_t x[3], y[3], z[3]; // in 256ths of a pixel, and 2^-20 of the range
        glClearDepth(1);
        glClearColor(0, 0, 0, 0);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glBegin(GL_TRIANGLES);
        for (int i = 0; i < 3; ++i) {
            x[i] = random.below(16384), y[i] = random.below(16384), z[i] = random.below(1 << 20);
            glVertex3d(static_cast<double>(x[i]) / 256, static_cast<double>(y[i]) / 256,
                       -static_cast<double>(z[i]) * 0x1p-20);
        }
        glEnd();
        const std::int64_t area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
        if (std::abs(area) < 1 << 16)
            continue;
        const Picture picture = screen.picture();
        const auto depths = screen.depths();
        for (int at = 0; at < side * side; ++at) {
            if (picture[static_cast<std::size_t>(at)][0] == 0)
                continue;
            const std::int64_t px = at % side * 256 + 128 - x[0], py = at / side * 256 + 128 - y[0];
            const long double b = static_cast<long double>(px * (y[2] - y[0]) - (x[2] - x[0]) * py) /
                                  static_cast<long double>(area),
                              c = static_cast<long double>((x[1] - x[0]) * py - px * (y[1] - y[0])) /
                                  static_cast<long double>(area);
            const long double depth = static_cast<long double>(z[0]) +
                                      b * static_cast<long double>(z[1] - z[0]) +
                                      c * static_cast<long double>(z[2] - z[0]);
            const long double code = depth * 0x1p-20L * 0xFFFFFF;
            worst = std::fmax(
                worst, static_cast<double>(std::fabs(code - (depths[static_cast<std::size_t>(at)] >> 8))));
            ++fragments;
        }
    }
    EXPECT_GT(fragments, 10'000);
    EXPECT_LE(worst, 0.501);
    row({"plane of 24-bit depth", "64 bits, 40 below the code", "guard band",
         "half a code; set-up below 2^61", "depth_24"},
        "%.4f codes", worst);
}

} // namespace
} // namespace spangle::test
