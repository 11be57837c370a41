// Areas of pixels under outlines against clipping in double (GL 1.3, 3.5.3; rows D07, D13).
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "raster/primitive/area.hpp"
#include "tests/primitive/clipped_area.hpp"

namespace spangle::raster::test {
namespace {

constexpr int size = 12;

std::vector<OutlinePoint> outline_of(const std::vector<Position>& corners) {
    std::vector<OutlinePoint> out;
    for (const Position& p : corners)
        out.push_back(outline_point(p));
    return out;
}

std::uint32_t coverage(const std::vector<OutlinePoint>& outline, int x, int y) {
    const AreaRow row(raster::outline_of(outline.data(), static_cast<int>(outline.size())), y);
    return row.empty() || x < row.first() || x > row.last() ? 0 : row.coverage(x);
}

Position any(std::mt19937& random) {
    return {static_cast<std::int32_t>(random() % (size * 256)),
            static_cast<std::int32_t>(random() % (size * 256))};
}

TEST(Area, OfTrianglesIsExactWithinOnePart) {
    std::mt19937 random(3);
    for (int n = 0; n < 4000; ++n) {
        std::vector<Position> t = {any(random), any(random), any(random)};
        if (n % 4 == 1) // small
            for (std::size_t i = 1; i < 3; ++i)
                t[i] = {t[0].x + static_cast<int>(random() % 400) - 200,
                        t[0].y + static_cast<int>(random() % 400) - 200};
        if (n % 4 == 2) // upright and level
            t[1].x = t[0].x, t[2].y = t[0].y;
        const auto outline = outline_of(t);
        const oracle::Polygon exact = oracle::polygon(t);
        for (int y = -1; y <= size; ++y)
            for (int x = -1; x <= size; ++x)
                ASSERT_NEAR(coverage(outline, x, y) / double{full_coverage}, oracle::area_in(exact, x, y),
                            1.0 / 4096)
                    << n << " at " << x << ',' << y;
    }
}

/// Where a coverage is said to last, it does.
TEST(Area, PlainColumnsHaveOneCoverage) {
    std::mt19937 random(4);
    int longest = 0;
    for (int n = 0; n < 500; ++n) {
        const auto outline = outline_of({any(random), any(random), any(random)});
        for (int y = 0; y < size; ++y) {
            const AreaRow row(raster::outline_of(outline.data(), 3), y);
            for (int x = row.first(); !row.empty() && x <= row.last();) {
                const int end = row.plain_end(x);
                longest = std::max(longest, end - x);
                for (int i = x; i < end; ++i)
                    ASSERT_EQ(row.coverage(i), row.coverage(x));
                x = end > x ? end : x + 1;
            }
        }
    }
    EXPECT_GT(longest, 4);
}

/// Triangles around an inner point fill their square: each pixel exactly once in all.
TEST(Area, AbuttingTrianglesSumToOne) {
    std::mt19937 random(5);
    for (int n = 0; n < 500; ++n) {
        const int last = size * 256;
        const Position inner = {1 + static_cast<int>(random() % (last - 1u)),
                                1 + static_cast<int>(random() % (last - 1u))};
        std::vector<Position> ring = {{0, 0}, {last, 0}, {last, last}, {0, last}};
        const auto cut = [&] { return static_cast<std::int32_t>(random() % static_cast<unsigned>(last)); };
        ring.insert(ring.begin() + 1, {cut(), 0});
        ring.push_back({0, cut()});
        std::vector<std::uint64_t> sum(size * size);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            std::vector<Position> t = {inner, ring[i], ring[(i + 1) % ring.size()]};
            if (random() % 2 != 0) // either way around
                std::swap(t[1], t[2]);
            const auto outline = outline_of(t);
            for (int p = 0; p < size * size; ++p)
                sum[static_cast<std::size_t>(p)] += coverage(outline, p % size, p / size);
        }
        for (const std::uint64_t s : sum)
            ASSERT_EQ(s, full_coverage) << n;
    }
}

} // namespace
} // namespace spangle::raster::test
