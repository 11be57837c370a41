// Compares the areas of pixels under outlines with clipping in double (GL 1.3, 3.5.3; rows D07, D13).
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "raster/primitive/area.hpp"
#include "raster/primitive/line_outline.hpp"
#include "tests/unit/primitive/clipped_area.hpp"

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
    if (row.empty() || x < row.first() || x > row.last())
        return 0;
    std::uint32_t coverage;
    row.fill(x, x + 1, &coverage);
    return coverage;
}

Position any(std::mt19937& random) {
    return {static_cast<std::int32_t>(random() % (size * 256)),
            static_cast<std::int32_t>(random() % (size * 256))};
}

TEST(Area, OfTrianglesIsExactWithinOnePart) {
    std::mt19937 random(3);
    for (int n = 0; n < 4000; ++n) {
        std::vector<Position> t = {any(random), any(random), any(random)};
        if (n % 4 == 1) // a small outline
            for (std::size_t i = 1; i < 3; ++i)
                t[i] = {t[0].x + static_cast<int>(random() % 400) - 200,
                        t[0].y + static_cast<int>(random() % 400) - 200};
        if (n % 4 == 2) // horizontal and vertical edges
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

/// However many columns are asked for together, each has its own coverage. The core asks for one column.
TEST(Area, ColumnsTogetherAreThoseAlone) {
    std::mt19937 random(4);
    int longest = 0, full = 0;
    for (int n = 0; n < 2000; ++n) {
        std::vector<Position> corners = {any(random), any(random), any(random)};
        if (n % 3 == 0)
            corners.push_back(any(random)); // the edges of the outline may cross
        const auto outline = outline_of(corners);
        for (int y = 0; y < size; ++y) {
            const AreaRow row(raster::outline_of(outline.data(), static_cast<int>(outline.size())), y);
            if (row.empty())
                continue;
            std::uint32_t together[AreaRow::window];
            const int begin = static_cast<int>(random() % (size + 2)) - 1,
                      end = begin + static_cast<int>(random() % (size + 2));
            row.fill(begin, end, together);
            for (int x = begin; x < end; ++x)
                ASSERT_EQ(together[x - begin], coverage(outline, x, y)) << n << " at " << x << ',' << y;
            ASSERT_LE(row.core_begin(), row.core_end());
            longest = std::max(longest, row.core_end() - row.core_begin());
            for (int x = row.core_begin(); x < row.core_end(); ++x) {
                ASSERT_EQ(coverage(outline, x, y), coverage(outline, row.core_begin(), y));
                full += coverage(outline, x, y) == full_coverage ? 1 : 0;
            }
        }
    }
    EXPECT_GT(longest, 4);
    EXPECT_GT(full, 1000);
}

/// Checks the whole part of square roots, beside squares and of any numbers.
TEST(Root, IsWhole) {
    std::mt19937_64 random(6);
    const auto check = [](std::uint64_t v) {
        const std::uint64_t root = detail::integer_sqrt(v);
        ASSERT_LE(root * root, v);
        ASSERT_LE(v - root * root, 2 * root) << v;
    };
    for (std::uint64_t v = 0; v < 70000; ++v)
        check(v);
    for (int n = 0; n < 200000; ++n) {
        const std::uint64_t v = random() >> (n % 64), root = random() >> (32 + n % 32);
        for (const std::uint64_t at : {v, root * root, root * root - 1, root * root + 1, root * (root + 2)})
            check(at);
    }
    check(UINT64_MAX);
}

/// Triangles around an inner point fill their square, so each pixel is covered exactly once in all.
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
            if (random() % 2 != 0) // clockwise or counter-clockwise
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
