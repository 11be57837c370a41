// Lines in lanes: words of a vertex that no line reads may hold anything. This file is compiled so that
// signed overflow traps, with GCC in the lanes of vectors, too.
#include "raster/primitive/vector_lines.hpp"

#include <gtest/gtest.h>

namespace spangle::raster {
namespace {

template <class L> void expect_taken() {
    if constexpr (L::count > 1) {
        const DrawState::Area area{256, 256, 100 * subpixel_one, 60 * subpixel_one};
        // `word` stands for the mantissa of 1/w. For w = 1 it is 2^31, the only word whose negative does not
        // fit a signed word.
        for (const std::uint32_t word : {0u, 1u << 29, 1u << 30, 0x7FFFFFFFu, 0x80000000u, 0xFFFFFFFFu})
            for (const std::uint32_t depth : {0u, 1u << 29, 1u << 30}) {
                FixedVertex a{}, b{};
                a.x = a.y = 300;
                b.x = 9000;
                b.y = 4000;
                a.z = depth;
                b.z = depth_one - depth;
                a.w_mantissa = b.w_mantissa = word;
                const FixedVertex* const ends[2] = {&a, &b};
                VectorLines<L> lines;
                EXPECT_TRUE(lines.take(ends, 2, 1, area)) << word;
                Paths paths;
                lines.set_up(paths, 100, true);
                EXPECT_GT(paths.at(Paths::count, 0), 30);
                b.y = 61 * subpixel_one;
                EXPECT_FALSE(lines.take(ends, 2, 1, area)) << word;
                b.y = 4000;
                b.x = 255;
                EXPECT_FALSE(lines.take(ends, 2, 1, area)) << word;
            }
    }
}

TEST(VectorLines, LooksAtNothingButPlaces) {
    expect_taken<HostLines>();
}

} // namespace
} // namespace spangle::raster
