// Compares lines with the diamond-exit rule in rational numbers (GL 1.3, 3.4.1; row D05).
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/unit/primitive/counting_target.hpp"

namespace spangle::raster::test {
namespace {

using Wide = __int128;

/// The diamond-exit rule word for word. Both ends are moved by (-e, -e^2), with an e too small to pass any
/// vertex of the 1/256 grid. Coordinates are in 2^-40 subpixels, and e is 2^-20 of a subpixel.
bool diamond_exit(std::int64_t ax, std::int64_t ay, std::int64_t bx, std::int64_t by, int column, int row) {
    constexpr int scale = 40;
    constexpr std::int64_t e = std::int64_t{1} << 20, e2 = 1, half = std::int64_t{128} << scale;
    const Wide x0 = (ax << scale) - e, y0 = (ay << scale) - e2, x1 = (bx << scale) - e,
               y1 = (by << scale) - e2;
    const Wide xf = (std::int64_t{column} * 256 + 128) * (Wide{1} << scale);
    const Wide yf = (std::int64_t{row} * 256 + 128) * (Wide{1} << scale);
    const auto size = [](Wide v) { return v < 0 ? -v : v; };
    const auto inside = [&](Wide x, Wide y) { return size(x - xf) + size(y - yf) < half; };
    if (inside(x1, y1))
        return false;
    // |x - xf| + |y - yf| is convex along the segment, so its least value is at an end or where one term is
    // 0.
    if (inside(x0, y0))
        return true;
    const Wide dx = x1 - x0, dy = y1 - y0;
    const auto crossing = [&](Wide from, Wide d, Wide at, Wide other, Wide other_d, Wide other_at) {
        if (d == 0 || (at - from) * d < 0 || size(at - from) > size(d))
            return false;
        return size((other - other_at) * d + (at - from) * other_d) < half * size(d);
    };
    return crossing(x0, dx, xf, y0, dy, yf) || crossing(y0, dy, yf, x0, dx, xf);
}

struct Line {
    std::int32_t ax, ay, bx, by;
};

Line fuzz_line(std::mt19937& random, int kind, int size) {
    const auto within = [&](int low, int high) {
        return low + static_cast<int>(random() % static_cast<unsigned>(high - low));
    };
    Line l{within(0, size * 256), within(0, size * 256), within(0, size * 256), within(0, size * 256)};
    if (kind == 1) // ends on the corners of diamonds
        l = {l.ax & ~127, l.ay & ~127, l.bx & ~127, l.by & ~127};
    if (kind == 2) // short lines
        l.bx = l.ax + within(-300, 301), l.by = l.ay + within(-300, 301);
    if (kind == 3) // short lines on a coarse grid, which have the most ties
        l = {l.ax & ~63, l.ay & ~63, (l.ax & ~63) + 64 * within(-8, 9), (l.ay & ~63) + 64 * within(-8, 9)};
    if (kind == 4) // diagonal lines
        l.by = l.ay + (random() % 2 != 0 ? l.bx - l.ax : l.ax - l.bx);
    if (kind == 5) // horizontal or vertical lines
        (random() % 2 != 0 ? l.bx : l.by) = random() % 2 != 0 ? l.ax : l.ay;
    return l;
}

TEST(Lines, MatchTheDiamondExitRuleInRationalNumbers) {
    constexpr int size = 12;
    std::mt19937 random(5);
    CountingTarget target(size, size);
    for (int n = 0; n < 60000; ++n) {
        const Line l = fuzz_line(random, n % 6, size);
        target.clear();
        target.line(l.ax, l.ay, l.bx, l.by);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                ASSERT_EQ(target.at(x, y), diamond_exit(l.ax, l.ay, l.bx, l.by, x, y) ? 1 : 0)
                    << l.ax << ',' << l.ay << " -> " << l.bx << ',' << l.by << " at " << x << ',' << y;
    }
}

/// Segments in one direction draw one fragment in each column, joints included (row D05, rules 3 and 4).
TEST(Lines, SegmentsInOneDirectionShareNoFragment) {
    std::mt19937 random(6);
    CountingTarget target(32, 32);
    for (int n = 0; n < 3000; ++n) {
        std::int32_t x = static_cast<std::int32_t>(random() % 512), y = 16 * 256;
        target.clear();
        const int columns_from = x;
        while (x < 30 * 256) {
            const std::int32_t dx = 1 + static_cast<std::int32_t>(random() % 700);
            const std::int32_t dy =
                static_cast<std::int32_t>(random() % static_cast<unsigned>(2 * dx + 1)) - dx;
            const std::int32_t ny = std::clamp(y + dy, 4 * 256, 28 * 256);
            target.line(x, y, x + dx, ny);
            x += dx;
            y = ny;
        }
        // There is one fragment in every column between the ends.
        for (int c = (columns_from >> 8) + 1; c < (x >> 8) && c < 32; ++c) {
            int total = 0;
            for (int r = 0; r < 32; ++r)
                total += target.at(c, r);
            ASSERT_EQ(total, 1) << "column " << c << " round " << n;
        }
    }
}

TEST(Lines, ZeroLengthDrawsNothing) {
    CountingTarget target(8, 8);
    for (int x = 0; x < 1024; x += 32)
        for (int y = 0; y < 1024; y += 32)
            target.line(x, y, x, y);
    for (const auto hit : target.hits)
        EXPECT_EQ(hit, 0);
}

/// A line of width w is the line moved down by (w - 1) / 2 along its minor axis, with w fragments for each of
/// its own (GL 1.3, 3.4.2).
TEST(Lines, WidthsReplicateAlongTheMinorAxis) {
    std::mt19937 random(9);
    constexpr int size = 24;
    CountingTarget wide(size, size);
    for (int n = 0; n < 4000; ++n) {
        const Line l = fuzz_line(random, n % 6, size);
        const int width = 2 + static_cast<int>(random() % 15);
        wide.clear();
        wide.line(l.ax, l.ay, l.bx, l.by, width);
        const bool along_x = std::abs(l.bx - l.ax) >= std::abs(l.by - l.ay);
        const int down = (width - 1) * 128;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                int want = 0;
                for (int k = 0; k < width; ++k)
                    want += along_x ? diamond_exit(l.ax, l.ay - down, l.bx, l.by - down, x, y - k)
                                    : diamond_exit(l.ax - down, l.ay, l.bx - down, l.by, x - k, y);
                ASSERT_EQ(wide.at(x, y), want) << width << " at " << x << ',' << y;
            }
    }
}

TEST(Lines, ScissorCutsAndNothingElse) {
    std::mt19937 random(10);
    CountingTarget whole(40, 40), cut(40, 40);
    for (int n = 0; n < 4000; ++n) {
        Line l = fuzz_line(random, n % 6, 40);
        if (n % 7 == 0)
            l = {l.ax * 50 - 200000, l.ay * 50 - 200000, l.bx * 50 - 200000, l.by * 50 - 200000};
        const int width = 1 + n % 4, x0 = static_cast<int>(random() % 30),
                  y0 = static_cast<int>(random() % 30);
        cut.state.fragment.scissor = {x0, y0, static_cast<int>(random() % 10) + 1,
                                      static_cast<int>(random() % 10) + 1};
        const Rect box = cut.state.fragment.scissor;
        whole.clear();
        cut.clear();
        whole.line(l.ax, l.ay, l.bx, l.by, width);
        cut.line(l.ax, l.ay, l.bx, l.by, width);
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 40; ++x) {
                const bool in = x >= box.x && x < box.x + box.w && y >= box.y && y < box.y + box.h;
                ASSERT_EQ(cut.at(x, y), in ? whole.at(x, y) : 0) << x << ',' << y;
            }
    }
}

} // namespace
} // namespace spangle::raster::test
