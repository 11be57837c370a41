// Every tile stores the bytes of its chain, in the fragments that exact rows find.
#include <gtest/gtest.h>

#include <sys/mman.h>
#include <unistd.h>

#include "raster/primitive/triangle.hpp"
#include "tests/unit/span/expect_chain.hpp"

namespace spangle::raster::test {
namespace {

constexpr int width = 40, height = 40;

struct Hits {
    int tiles = 0, seconds = 0, rows[Tile::most_rows + 1] = {}, at_border = 0;
    int narrow_rows[Tile::most_narrow_rows + 1] = {}, above_dead = 0;
    Tile last{}; ///< the last tile of the triangle
};
Hits hits;
void (*under_test)(Span<Fixed>&, const Tile&);

void note_and_draw(Span<Fixed>& span, const Tile& tile) {
    const Rect& clip = span.state->fragment.scissor;
    const std::int32_t columns = tile.narrow ? Tile::narrow_columns : Tile::columns;
    EXPECT_GE(tile.x, clip.x);
    EXPECT_LE(tile.x + columns, clip.x + clip.w);
    EXPECT_GE(tile.y, clip.y);
    EXPECT_LE(tile.y + tile.rows, clip.y + clip.h);
    ++hits.tiles;
    hits.seconds += tile.x == hits.last.x + Tile::columns && tile.y == hits.last.y ? 1 : 0;
    hits.last = tile;
    ++(tile.narrow ? hits.narrow_rows : hits.rows)[tile.rows];
    hits.above_dead += tile.dead_rows;
    hits.at_border += tile.x == clip.x + clip.w - columns ? 1 : 0;
    under_test(span, tile);
}

/// Returns a small triangle. Some corners lie on pixel centres, pixel corners or lines between pixels; some
/// sides are horizontal or vertical.
Triangle small_triangle(RandomVertices& source, Kind kind) {
    Triangle t = random_triangle(source, width, height, kind);
    const auto left = static_cast<std::int32_t>(source.below(width - 4)),
               low = static_cast<std::int32_t>(source.below(height - 4));
    const std::uint32_t step = source.below(2) == 0 ? 1 : 64;
    const auto place = [&](std::int32_t from, std::uint32_t pixels, std::int32_t most) {
        const auto v =
            from * subpixel_one + static_cast<std::int32_t>(source.below(pixels * 256 / step) * step);
        return v < most * subpixel_one ? v : most * subpixel_one;
    };
    struct Size {
        std::uint32_t columns, rows;
    };
    static constexpr Size sizes[] = {{17, 7}, {9, 14}, {5, 27}, {5, 5}};
    const Size& size = sizes[source.below(4)];
    for (FixedVertex& v : t.v) {
        v.x = place(left, size.columns, width);
        v.y = place(low, size.rows, height);
    }
    make_special(t, source, kind);
    return t;
}

void expect_equal(const FusedSpan& fused, const std::string& name) {
    under_test = fused.shapes->tile;
    hits = {};
    const Shapes shapes = {&note_and_draw, fused.shapes->trapezoids};
    expect_chain(fused, name, {width, height}, 6000, shapes, [&](RandomVertices& source) {
        hits.last = Tile();
        return small_triangle(source, fused.key.kind);
    });
    EXPECT_GE(hits.tiles, 1500) << name;
    EXPECT_GE(hits.seconds, 300) << name;
    for (int rows = 1; rows <= Tile::most_rows; ++rows)
        EXPECT_GE(hits.rows[rows], 10) << name << ' ' << rows;
    for (int rows = 2; rows <= Tile::most_narrow_rows; rows += 2)
        EXPECT_GE(hits.narrow_rows[rows], 10) << name << ' ' << rows;
    EXPECT_GE(hits.above_dead, 100) << name;
    EXPECT_GE(hits.at_border, 100) << name;
}

TEST(Tiles, EveryTileIsItsChain) {
    int tiles = 0;
    for (std::size_t i = 0; i < fused_span_count; ++i)
        if (const Shapes* const shapes = fused_span(i).shapes; shapes != nullptr && shapes->tile != nullptr) {
            expect_equal(fused_span(i), "entry " + std::to_string(i));
            ++tiles;
        }
    EXPECT_GE(tiles, host_lanes > 1 ? 4 : 0);
}

/// Surfaces in memory of their own, where sanitizers see what a tile touches beside them.
TEST(Tiles, SurfacesOfFewerColumnsAreLeftAlone) {
    for (const int columns : {1, 7, 8, 9}) {
        FragmentState fragment;
        fragment.tier = Tier::balanced;
        fragment.dither = false;
        fragment.scissor = {0, 0, columns, 5};
        Canvas canvas(columns, 5, PixelFormat::rgb565_be, DepthFormat::none);
        const DrawState state = compile<FixedVertex>(fragment, canvas.surface);
        RandomVertices source(3);
        Triangle t{{source.vertex(1, 1), source.vertex(1, 1), source.vertex(1, 1)}};
        t.v[0].x = t.v[2].x = 0, t.v[1].x = columns * subpixel_one;
        t.v[0].y = t.v[1].y = 0, t.v[2].y = 5 * subpixel_one;
        for (FixedVertex& v : t.v)
            std::fill_n(v.color, 4, color_one);
        draw(state, canvas.surface, t);
        EXPECT_EQ(canvas.color[0], 0xFF) << columns;
        EXPECT_EQ(canvas.color.back(), 0) << columns;
    }
}

/// Behind the last pixel of the surface lies a page that nobody may touch.
TEST(Tiles, NothingBehindASurfaceIsTouched) {
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    auto* const memory = static_cast<std::uint8_t*>(
        mmap(nullptr, 2 * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
    ASSERT_NE(static_cast<void*>(memory), MAP_FAILED);
    ASSERT_EQ(mprotect(memory + page, page, PROT_NONE), 0);
    for (int columns = 1; columns <= 40; ++columns) {
        FragmentState fragment;
        fragment.tier = Tier::balanced;
        fragment.dither = false;
        fragment.scissor = {0, 0, columns, 20};
        Surface surface;
        surface.width = columns;
        surface.height = 20;
        surface.color_stride = 2 * columns;
        surface.color = memory + page - static_cast<std::size_t>(2 * columns * 20);
        const DrawState state = compile<FixedVertex>(fragment, surface);
        Triangle t{};
        t.v[0].x = 0, t.v[1].x = t.v[2].x = columns * subpixel_one;
        t.v[0].y = t.v[2].y = 20 * subpixel_one;
        for (int i = 0; i < 3; ++i) {
            t.v[i].w_mantissa = 1u << 31;
            std::fill_n(t.v[i].color, 4, color_one - (static_cast<std::uint32_t>(i) << color_fraction_bits));
        }
        draw(state, surface, t);
        EXPECT_EQ(memory[page - 1], 0xFF) << columns;
    }
    munmap(memory, 2 * page);
}

TEST(Tiles, BothWaysOfSortingAgree) {
    RandomVertices source(5);
    for (int round = 0; round < 5000; ++round) {
        FixedVertex v[3];
        for (FixedVertex& at : v)
            at.x = static_cast<std::int32_t>(source.below(7)) - 3,
            at.y = static_cast<std::int32_t>(source.below(3)) - 1;
        const std::int64_t area = signed_area(v[0].x, v[0].y, v[1].x, v[1].y, v[2].x, v[2].y);
        if (area == 0)
            continue;
        const FixedVertex* order[2][3];
        for (int way = 0; way < 2; ++way) {
            detail::Corner low(v[0]), middle(v[1]), high(v[2]);
            std::int64_t area2 = area;
            way == 0 ? detail::sort<true>(low, middle, high, area2)
                     : detail::sort<false>(low, middle, high, area2);
            ASSERT_EQ(area2, signed_area(low.x, low.y, middle.x, middle.y, high.x, high.y));
            ASSERT_TRUE(low.y < middle.y || (low.y == middle.y && low.x < middle.x));
            ASSERT_TRUE(middle.y < high.y || (middle.y == high.y && middle.x < high.x));
            order[way][0] = low.vertex, order[way][1] = middle.vertex, order[way][2] = high.vertex;
        }
        for (int i = 0; i < 3; ++i)
            ASSERT_EQ(order[0][i], order[1][i]);
    }
}

} // namespace
} // namespace spangle::raster::test
