// Row D05: ends of lines that are computed only for a part of the window are where other vertices would be.
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "gl/vertex/fixed_math.hpp"
#include "raster/numeric/matrix_build.hpp"

namespace spangle::gl::test {
namespace {

/// Returns a coordinate of any size; some are nothing beside the others, and some are not finite.
Real coordinate(std::mt19937& random, int spread) {
    const auto word = static_cast<std::uint32_t>(random());
    if (word % 64 == 0)
        return Real{word % 128 == 0 ? 0x7F800000u : 0x80000000u};
    const auto exponent = static_cast<std::uint32_t>(
        127 + static_cast<int>(random() % static_cast<unsigned>(2 * spread + 1)) - spread);
    return Real{(word & 0x807FFFFFu) | exponent << 23};
}

TEST(VisibleEnds, FallWhereVerticesDo) {
    std::mt19937 random(31);
    long seen = 0, inside = 0, missed = 0;
    for (int round = 0; round < 400; ++round) {
        TransformState state;
        const auto real = [](double v) { return numeric::from_double(v); };
        const double wide = 1 + random() % 5;
        state.projection.entry[0] =
            round % 3 == 0 ? numeric::ortho(real(-wide), real(wide), real(-1), real(1), real(-2), real(2))
                           : numeric::frustum(real(-wide), real(wide), real(-1), real(1), real(1), real(9));
        if (round % 3 != 0)
            state.modelview.entry[0] = numeric::translation(real(0), real(0), real(-3));
        const GLint viewport[4] = {static_cast<GLint>(random() % 50) - 20,
                                   static_cast<GLint>(random() % 50) - 20, static_cast<GLint>(random() % 150),
                                   static_cast<GLint>(random() % 150)};
        std::copy_n(viewport, 4, state.viewport);
        FixedMath::Transforms t;
        FixedMath::derive(state, gl::dirty_all, t);
        const raster::DrawState::Area area =
            FixedMath::inside_viewport(t, {256, 256, round % 7 == 0 ? 0u : 98u * 256, 78u * 256});
        for (int i = 0; i < 2000; ++i) {
            const int spread = round % 5 == 0 ? 126 : 2;
            Real position[4] = {coordinate(random, spread), coordinate(random, spread),
                                coordinate(random, spread), numeric::one};
            raster::LineEnd end{};
            numeric::LeadingZeros<> zeros;
            const bool is_seen = FixedMath::seen(t, position, area, end, zeros);
            for (int c = 0; c < 3; ++c)
                position[c] = numeric::from_float_bits(position[c].bits);
            FixedMath::Projections<1> projection;
            raster::FixedVertex v{};
            projection.add(0, t, position, v, false);
            projection.finish(1);
            unsigned planes = 0;
            const bool divided = projection.divide(0, t, position, v, planes);
            const bool is_inside = divided && planes == 0 && area.holds(v.x, v.y);
            seen += is_seen, inside += is_inside, missed += is_inside && !is_seen;
            if (!is_seen)
                continue;
            ASSERT_TRUE(is_inside) << round << " " << i;
            const raster::LineEnd want = raster::line_end(v);
            ASSERT_TRUE(end.x == want.x && end.y == want.y && end.depth == want.depth) << round << " " << i;
        }
    }
    EXPECT_GT(seen, 30000);
    EXPECT_LT(missed, inside / 50) << "what is not seen takes longer";
}

/// The seen area excludes the rim of the viewport, because vertices from outside may lie on the rim.
TEST(VisibleEnds, AreInsideOfTheRim) {
    TransformState state;
    const GLint viewport[4] = {10, 20, 30, 41};
    std::copy_n(viewport, 4, state.viewport);
    FixedMath::Transforms t;
    FixedMath::derive(state, gl::dirty_all, t);
    const auto cut = FixedMath::inside_viewport(t, {0, 0, 100 * 256, 100 * 256});
    EXPECT_TRUE(cut.holds(10 * 256 + 1, 20 * 256 + 1) && cut.holds(40 * 256 - 1, 61 * 256 - 1));
    EXPECT_FALSE(cut.holds(10 * 256, 30 * 256) || cut.holds(20 * 256, 20 * 256));
    EXPECT_FALSE(cut.holds(40 * 256, 30 * 256) || cut.holds(20 * 256, 61 * 256));
    EXPECT_EQ(FixedMath::inside_viewport(t, {50 * 256, 0, 256, 100 * 256}).w, 0u);
    EXPECT_EQ(FixedMath::inside_viewport(t, {0, 0, 100 * 256, 256}).h, 0u);
    const auto least = FixedMath::inside_viewport(t, {12 * 256, 30 * 256, 256, 256});
    EXPECT_TRUE(least.holds(12 * 256, 30 * 256) && least.holds(13 * 256 - 1, 31 * 256 - 1));
    EXPECT_FALSE(least.holds(13 * 256, 30 * 256) || least.holds(12 * 256, 31 * 256));
}

} // namespace
} // namespace spangle::gl::test
