// Makes a tile of a small triangle. The tile has the same fragments as the rows of edge.hpp. Signed areas say
// on which side of each edge a centre lies.
#pragma once

#include <bit>
#include <cstddef>

#include "raster/ops/lanes.hpp"
#include "raster/ops/tile.hpp"
#include "raster/primitive/edge.hpp"
#include "raster/surface/surface.hpp"

namespace spangle::raster {

/// Sets the edges of a triangle whose corners are sorted upwards: from the lowest to the highest corner, from
/// the lowest to the middle one, and from there to the highest. Left edges own their centres, and right edges
/// do not. A horizontal bottom edge counts as a right edge, but owns its centres.
///
/// Corners and centres lie within 9 columns and 13 rows, so twice an area is at most 9 * 13 * 2^16. They may
/// also lie within 17 and 7, or 5 and 24; differences fit 16 bits then, too. From centre to centre the area
/// changes by whole multiples of 2^8, so dropped bits below decide nothing.
SPANGLE_INLINE void set_edges(Tile& tile, const FixedVertex& a, const FixedVertex& b, const FixedVertex& c,
                              bool middle_left) {
    static_assert((Tile::columns + 1) * (Tile::most_rows + 1) * subpixel_one < 1 << 15);
    static_assert((Tile::narrow_columns + 1) * (Tile::most_narrow_rows + 2) * subpixel_one < 1 << 15);
    static_assert((2 * Tile::columns + 1) * (Tile::most_rows_of_two + 1) * subpixel_one < 1 << 15);
    using L = Lanes<8>;
    using U16 = L::U16;
    const auto words = [](U16 v) { return std::bit_cast<L::Words>(v); };
    const auto corner = [](const FixedVertex& v) {
        static_assert(offsetof(FixedVertex, x) == 0 && offsetof(FixedVertex, y) == 4);
        std::uint64_t at;
        __builtin_memcpy(&at, &v, sizeof at);
        return L::halves(at, 0);
    };
    // x of the edges in lanes 0 to 2, y in lanes 4 to 6.
    const U16 ab = L::mixed_low(corner(a), corner(b)), cb = L::mixed_low(corner(c), corner(b)),
              from = __builtin_shufflevector(ab, ab, 0, 0, 1, 1, 4, 4, 5, 5),
              to = __builtin_shufflevector(cb, cb, 0, 1, 0, 0, 4, 5, 4, 4);
    const std::uint32_t at =
        (static_cast<std::uint32_t>(tile.x) & 0xFFFF) | static_cast<std::uint32_t>(tile.y) << 16;
    const auto pixel = std::bit_cast<U16>(L::Words{at, at, at, at});
    const L::Words xy = words(L::mixed_low(pixel, pixel)), along = words(to - from);
    const U16 corner_of_pixel = std::bit_cast<U16>(__builtin_shufflevector(xy, xy, 0, 0, 1, 1))
                                << subpixel_bits,
              off = corner_of_pixel + subpixel_one / 2 - from,
              across = std::bit_cast<U16>(__builtin_shufflevector(along, along, 2, 3, 0, 1)); // y before x
    const U16 product = off * across, product_high = L::mul_high_signed(off, across),
              flat = L::equal(across, U16{}); // -1
    const L::Words area = words(L::mixed_low(product, product_high)) -
                          words(L::mixed_high(product, product_high)) + words(L::mixed_low(flat, flat));
    constexpr std::uint16_t on = 0xFFFF;
    constexpr U16 if_right = {0, on, on, 0, on, 0, 0, 0};
    // Exactly one of the two steps, along x or along y, is negated.
    const U16 flip = L::splat(middle_left ? on : 0u) ^ if_right;
    tile.value = std::bit_cast<U16>(area >> subpixel_bits) ^ L::mixed_low(flip, flip);
    tile.by = (across ^ flip) - flip;
}

/// Makes the first of `tiles` tiles side by side. Returns false where the triangle needs more than two.
/// Corners are sorted upwards. Columns [left, right) hold all centres and lie inside of `clip`; so do the
/// remaining rows.
SPANGLE_INLINE bool make_tile(Tile& tile, int& tiles, const FixedVertex& a, const FixedVertex& b,
                              const FixedVertex& c, bool middle_left, std::int32_t left, std::int32_t right,
                              const Rect& clip) {
    const std::int32_t low = first_center(a.y), high = first_center(c.y), top = clip.y + clip.h;
    const std::int32_t begin = low < clip.y ? clip.y : low, end = high < top ? high : top;
    // The row below the lowest corner lies outside of at least one edge.
    const std::int32_t odd = (end - begin) & 1;
    tile.narrow = right - left <= Tile::narrow_columns && begin - odd >= clip.y;
    tiles = right - left > Tile::columns ? 2 : 1;
    const std::int32_t columns = tile.narrow ? Tile::narrow_columns : tiles * Tile::columns,
                       most_rows = tile.narrow  ? Tile::most_narrow_rows
                                   : tiles == 1 ? Tile::most_rows
                                                : Tile::most_rows_of_two;
    if (right - left > columns || high - low > most_rows || clip.w < columns)
        return false;
    const std::int32_t last = clip.x + clip.w - columns;
    tile.dead_rows = tile.narrow ? odd : 0;
    tile.x = left < last ? left : last;
    tile.y = begin - tile.dead_rows;
    tile.rows = end - tile.y;
    set_edges(tile, a, b, c, middle_left);
    return true;
}

/// Whether columns [left, right) are marked as touched in all rows of the tile.
SPANGLE_INLINE bool is_touched(const Surface& target, const Tile& tile, std::int32_t left,
                               std::int32_t right) {
    if (target.touched == nullptr)
        return true;
    const RowSpan* row = target.touched + std::ptrdiff_t{tile.y + tile.dead_rows} * target.touched_step;
    for (std::int32_t n = tile.rows - tile.dead_rows; n > 0; --n, row += target.touched_step)
        if (left < row->begin || right > row->end)
            return false;
    return true;
}

/// Marks the columns and rows that a tile covers as touched. It is not inline, because it runs about once per
/// frame and pixel.
[[gnu::noinline]] inline void touch_tile(const Surface& target, const Tile& tile) {
    const std::int32_t columns = tile.narrow ? Tile::narrow_columns : Tile::columns;
    for (std::int32_t row = 0; row != tile.rows; ++row) {
        const auto alive = [&](std::int32_t column) {
            std::int32_t sides = 0;
            for (int k = 0; k < 3; ++k) {
                const auto word = [](std::uint16_t v) { return static_cast<std::int16_t>(v); };
                sides |= word(tile.value[2 * k]) + column * word(tile.by[k]) + row * word(tile.by[k + 4]);
            }
            return sides >= 0;
        };
        std::int32_t first = 0, last = columns;
        while (first != last && !alive(first))
            ++first;
        while (first != last && !alive(last - 1))
            --last;
        if (first != last)
            mark_damage(target, tile.y + row, tile.x + first, tile.x + last);
    }
}

} // namespace spangle::raster
