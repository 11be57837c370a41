// Tests points of both axes with the table of row D01 (gl-commands 17.6).
#include <gtest/gtest.h>

#include "tests/unit/primitive/counting_target.hpp"

namespace spangle::raster::test {
namespace {

struct Row {
    int subpixel; ///< xw is 10 + subpixel / 256
    int size, first, last;
};

// xw is 10.0, 10.3, 10.5 and 10.7; a point of size 1 is the fragment at floor(xw).
constexpr Row rows[] = {
    {0, 1, 10, 10},   {0, 2, 9, 10},    {0, 3, 9, 11},    {0, 4, 8, 11},    {77, 1, 10, 10}, {77, 2, 9, 10},
    {77, 3, 9, 11},   {77, 4, 8, 11},   {128, 1, 10, 10}, {128, 2, 10, 11}, {128, 3, 9, 11}, {128, 4, 9, 12},
    {179, 1, 10, 10}, {179, 2, 10, 11}, {179, 3, 9, 11},  {179, 4, 9, 12},
};

TEST(Points, CoverTheSquaresOfTheTable) {
    CountingTarget target(24, 24);
    for (const Row& across : rows)
        for (const Row& up : rows) {
            if (across.size != up.size)
                continue;
            target.clear();
            target.point(10 * 256 + across.subpixel, 10 * 256 + up.subpixel, across.size);
            for (int y = 0; y < 24; ++y)
                for (int x = 0; x < 24; ++x) {
                    const bool in = x >= across.first && x <= across.last && y >= up.first && y <= up.last;
                    ASSERT_EQ(target.at(x, y), in ? 1 : 0)
                        << "size " << across.size << " at " << across.subpixel << ',' << up.subpixel;
                }
        }
}

TEST(Points, AreCutAtTheSurface) {
    CountingTarget target(6, 6);
    target.point(0, 0, 5);             // covers -2 to 2
    target.point(6 * 256, 6 * 256, 4); // covers 4 to 7
    target.point(-900, 700, 3);
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 6; ++x)
            EXPECT_EQ(target.at(x, y), (x <= 2 && y <= 2) || (x >= 4 && y >= 4) ? 1 : 0);
}

} // namespace
} // namespace spangle::raster::test
