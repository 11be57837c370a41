// Triangles cover each pixel centre exactly once, whatever else is asked of the row (GL 1.3, 3.5.1; rows D08,
// A05).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "raster/primitive/edge.hpp"
#include "tests/unit/primitive/coverage_fuzz.hpp"

namespace spangle::raster::test {
namespace {

TEST(Coverage, AreasOfShortSidesAreTheSame) {
    std::mt19937 random(19);
    const std::int32_t edges[] = {0,      1, (1 << 14) - 1, 1 << 14, (1 << 14) + 1, 1 << 15, (1 << 16) - 1,
                                  1 << 17};
    const auto coordinate = [&] {
        const std::int32_t v = random() % 3 == 0
                                   ? edges[random() % 8]
                                   : static_cast<std::int32_t>(random() % (1u << (random() % 19)));
        return random() % 2 == 0 ? v : -v;
    };
    for (int round = 0; round < 200000; ++round) {
        std::int32_t v[6];
        for (std::int32_t& c : v)
            c = coordinate();
        if (round % 4 == 0)
            v[0] = v[1] = 0; // sides are then the coordinates themselves
        ASSERT_EQ(signed_area<false>(v[0], v[1], v[2], v[3], v[4], v[5]),
                  signed_area<true>(v[0], v[1], v[2], v[3], v[4], v[5]));
    }
}

TEST(Coverage, FiftyThousandFuzzedTrianglesMatchTheEdgeEquations) {
    EXPECT_EQ(coverage_mismatches(7, 40000, 40, 24), 0);
    EXPECT_EQ(coverage_mismatches(8, 10000, 96, 70), 0);
}

/// There are three ways to walk edges, for sizes of triangles and kinds of machines. All must give the same
/// rows.
TEST(Coverage, EveryKindOfEdgeWalksTheSameRows) {
    struct Listed {
        std::vector<std::int32_t> words;
        void add(const Row* row, const Row* end) {
            for (; row != end; ++row)
                words.insert(words.end(), {row->y, row->left, row->right, row->first, row->last});
        }
    };
    std::mt19937 random(12);
    const Rect clip = {3, 2, 20, 17};
    long rows = 0;
    for (int round = 0; round < 200000; ++round) {
        const int extent = round % 4 == 0 ? 3 * 256 : ShortEdge::extent;
        const auto within = [&](int from) {
            return from * 256 + static_cast<std::int32_t>(random() % static_cast<unsigned>(extent + 1));
        };
        const int left = static_cast<int>(random() % 24) - 6, low = static_cast<int>(random() % 24) - 6;
        std::int32_t x[3], y[3];
        for (int i = 0; i < 3; ++i)
            x[i] = within(left), y[i] = within(low);
        if (round % 5 == 0)
            x[1] &= ~127, y[2] &= ~127, x[2] = x[0]; // vertices on centres, and a vertical edge
        std::int32_t order[3] = {0, 1, 2};
        std::sort(order, order + 3, [&](int a, int b) { return y[a] != y[b] ? y[a] < y[b] : x[a] < x[b]; });
        std::int32_t xs[3], ys[3];
        for (int i = 0; i < 3; ++i)
            xs[i] = x[order[i]], ys[i] = y[order[i]];
        const std::int64_t area = signed_area(xs[0], ys[0], xs[1], ys[1], xs[2], ys[2]);
        if (area == 0)
            continue;
        const auto walked = [&]<class E>(std::type_identity<E>) {
            TriangleRows<E> triangle(xs, ys, area < 0, clip.y, clip.y + clip.h);
            Row buffer[5];
            Listed out;
            for (const Row* end = buffer + 5; end == buffer + 5;)
                out.add(buffer, end = triangle.template fill<true>(buffer, 5, clip.x, clip.x + clip.w));
            return out;
        };
        Row buffer[16];
        Listed at_once;
        at_once.add(buffer, low_rows<ShortEdge, true>(buffer, xs, ys, area < 0, clip));
        Listed low_at_once;
        low_at_once.add(buffer, low_rows<LowEdge, true>(buffer, xs, ys, area < 0, clip));
        Listed small_at_once;
        small_at_once.add(buffer, low_rows<SmallEdge, true>(buffer, xs, ys, area < 0, clip));
        const Listed exact = walked(std::type_identity<Edge>{});
        ASSERT_EQ(exact.words, walked(std::type_identity<SmallEdge>{}).words) << "round " << round;
        ASSERT_EQ(exact.words, at_once.words) << "round " << round;
        ASSERT_EQ(exact.words, low_at_once.words) << "round " << round;
        ASSERT_EQ(exact.words, small_at_once.words) << "round " << round;
        rows += static_cast<long>(exact.words.size() / 5);
    }
    EXPECT_GT(rows, 200000);
}

/// The slope of a small edge is the exact quotient, with long products and with words of 32 bits.
TEST(Coverage, SlopesOfSmallEdgesAreWholeInWordsOfEitherSize) {
    for (std::uint32_t dy = 1; dy <= SmallEdge::extent; dy += 1 + dy / 64)
        for (std::uint32_t v = 0; v <= 2 * SmallEdge::extent; v += 37) {
            const std::uint32_t lifted = v - SmallEdge::extent + (dy << 14);
            const std::uint64_t exact = (std::uint64_t{lifted} << 32) / dy;
            ASSERT_EQ(SmallEdge::divided<false>(lifted, dy), exact) << lifted << '/' << dy;
            ASSERT_EQ(SmallEdge::divided<true>(lifted, dy), exact) << lifted << '/' << dy;
        }
}

/// Of a rectangle on pixel centres, the left and bottom edges own their centres.
TEST(Coverage, RectangleOnCentresOwnsLeftAndBottom) {
    CountingTarget target(8, 8);
    const std::int32_t lo = 2 * 256 + 128, hi = 5 * 256 + 128;
    const std::int32_t ax[3] = {lo, hi, hi}, ay[3] = {lo, lo, hi}, bx[3] = {lo, hi, lo}, by[3] = {lo, hi, hi};
    target.triangle(ax, ay);
    target.triangle(bx, by);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            EXPECT_EQ(target.at(x, y), (x >= 2 && x < 5 && y >= 2 && y < 5) ? 1 : 0) << x << ',' << y;
}

/// A fan of triangles around any point fills the window exactly once.
TEST(Coverage, FansLeaveNoHolesAndHitNothingTwice) {
    std::mt19937 random(3);
    CountingTarget target(64, 48);
    const std::int32_t w = 64 * 256, h = 48 * 256;
    for (int round = 0; round < 120; ++round) {
        std::vector<std::pair<std::int32_t, std::int32_t>> rim;
        const int n = 3 + static_cast<int>(random() % 60);
        std::vector<std::int32_t> along;
        const auto side = [&](std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1) {
            along.assign(1, 0);
            for (int i = 0; i < n; ++i)
                along.push_back(static_cast<std::int32_t>(random() % 4096));
            std::sort(along.begin(), along.end());
            for (const std::int32_t t : along)
                rim.emplace_back(x0 + (x1 - x0) / 4096 * t, y0 + (y1 - y0) / 4096 * t);
        };
        side(0, 0, w, 0);
        side(w, 0, w, h);
        side(w, h, 0, h);
        side(0, h, 0, 0);
        std::int32_t cx = 1 + static_cast<std::int32_t>(random() % (w - 2)),
                     cy = 1 + static_cast<std::int32_t>(random() % (h - 2));
        if (round % 3 == 0) // the point is the middle of a fragment
            cx = (cx & ~255) + 128, cy = (cy & ~255) + 128;
        target.clear();
        for (std::size_t i = 0; i < rim.size(); ++i) {
            const auto [ax, ay] = rim[i];
            const auto [bx, by] = rim[(i + 1) % rim.size()];
            const std::int32_t x[3] = {cx, ax, bx}, y[3] = {cy, ay, by};
            target.triangle(x, y);
        }
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x)
                ASSERT_EQ(target.at(x, y), 1) << "round " << round << " at " << x << ',' << y;
    }
}

TEST(Coverage, IntegerTranslationMovesThePicture) {
    std::mt19937 random(11);
    CountingTarget here(96, 96), there(96, 96);
    for (int n = 0; n < 400; ++n) {
        const FuzzTriangle t = fuzz_triangle(random, 0, 48, 48);
        FuzzTriangle moved = t;
        const int dx = static_cast<int>(random() % 48), dy = static_cast<int>(random() % 48);
        for (int k = 0; k < 3; ++k)
            moved.x[k] += dx * 256, moved.y[k] += dy * 256;
        here.clear();
        there.clear();
        here.triangle(t.x, t.y);
        there.triangle(moved.x, moved.y);
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 48; ++x)
                ASSERT_EQ(here.at(x, y), there.at(x + dx, y + dy));
    }
}

TEST(Coverage, ScissorCutsAndNothingElse) {
    std::mt19937 random(12);
    CountingTarget whole(48, 40), cut(48, 40);
    for (int n = 0; n < 2000; ++n) {
        const FuzzTriangle t = fuzz_triangle(random, n % 7, 48, 40);
        const int x0 = static_cast<int>(random() % 48), y0 = static_cast<int>(random() % 40);
        const Rect box{x0, y0, static_cast<int>(random() % static_cast<unsigned>(49 - x0)),
                       static_cast<int>(random() % static_cast<unsigned>(41 - y0))};
        cut.state.fragment.scissor = box;
        whole.clear();
        cut.clear();
        whole.triangle(t.x, t.y);
        cut.triangle(t.x, t.y);
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 48; ++x) {
                const bool in = x >= box.x && x < box.x + box.w && y >= box.y && y < box.y + box.h;
                ASSERT_EQ(cut.at(x, y), in ? whole.at(x, y) : 0);
            }
    }
}

TEST(Coverage, TouchedColumnsAreExactlyTheSpans) {
    CountingTarget target(32, 16);
    std::vector<RowSpan> rows(16);
    target.surface.touched = rows.data() + 15; // a surface that stores its top row first
    target.surface.touched_step = -1;
    const std::int32_t x[3] = {3 * 256, 20 * 256, 9 * 256}, y[3] = {2 * 256, 5 * 256, 12 * 256};
    target.triangle(x, y);
    for (int row = 0; row < 16; ++row) {
        int begin = 32767, end = 0;
        for (int c = 0; c < 32; ++c)
            if (target.at(c, row) != 0)
                begin = std::min(begin, c), end = c + 1;
        EXPECT_EQ(rows[static_cast<std::size_t>(15 - row)].begin, begin);
        EXPECT_EQ(rows[static_cast<std::size_t>(15 - row)].end, end);
    }
}

} // namespace
} // namespace spangle::raster::test
