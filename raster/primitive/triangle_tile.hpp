// A small triangle as a tile: the same fragments as its rows have (edge.hpp), from the sides that their
// centres lie on.
#pragma once

#include <bit>

#include "raster/primitive/edge.hpp"
#include "raster/span/lanes.hpp"
#include "raster/span/tile.hpp"
#include "raster/surface/surface.hpp"

namespace spangle::raster {

/// A side of a triangle, (x0, y0) up to (x1, y1). Left edges own their centres, right ones do not; the one
/// that lies flat on the ground, which counts as right, does.
///
/// Ends and centres lie within 9 columns and 13 rows, so that twice an area is at most 9 13 2^16, or within
/// 17 and 7, or 5 and 24; from centre to centre it changes by whole multiples of 2^8, so what is dropped
/// below decides nothing.
SPANGLE_INLINE Tile::Edge tile_edge(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1,
                                    std::int32_t center_x, std::int32_t center_y, bool right) {
    static_assert((Tile::columns + 1) * (Tile::most_rows + 1) * subpixel_one < 1 << 15);
    static_assert((Tile::narrow_columns + 1) * (Tile::most_narrow_rows + 2) * subpixel_one < 1 << 15);
    static_assert((2 * Tile::columns + 1) * (Tile::most_rows_of_two + 1) * subpixel_one < 1 << 15);
    const std::int32_t dx = x1 - x0, dy = y1 - y0, flip = -static_cast<std::int32_t>(right);
    const std::int32_t area =
        (center_x - x0) * dy - (center_y - y0) * dx - static_cast<std::int32_t>(dy == 0);
    return {(area >> subpixel_bits) ^ flip, (dy ^ flip) - flip, (-dx ^ flip) - flip};
}

/// Corners upwards; columns [left, right) hold all its centres and lie inside of `clip`, as do the rows that
/// are left. The first of `tiles` side by side; false where it takes more than two.
SPANGLE_INLINE bool make_tile(Tile& tile, int& tiles, const std::int32_t (&xs)[3],
                              const std::int32_t (&ys)[3], bool middle_left, std::int32_t left,
                              std::int32_t right, const Rect& clip) {
    const std::int32_t low = first_center(ys[0]), high = first_center(ys[2]), top = clip.y + clip.h;
    const std::int32_t begin = low < clip.y ? clip.y : low, end = high < top ? high : top;
    // The row below the lowest corner is outside of one edge at least.
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
    const std::int32_t x = tile.x * subpixel_one + subpixel_one / 2,
                       y = tile.y * subpixel_one + subpixel_one / 2;
    tile.edge[0] = tile_edge(xs[0], ys[0], xs[2], ys[2], x, y, middle_left);
    tile.edge[1] = tile_edge(xs[0], ys[0], xs[1], ys[1], x, y, !middle_left);
    tile.edge[2] = tile_edge(xs[1], ys[1], xs[2], ys[2], x, y, !middle_left);
    return true;
}

/// Columns [left, right) of all rows of the tile count as touched already.
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

/// Touches what a tile covers. Not in line: once per frame and pixel or so.
[[gnu::noinline]] inline void touch_tile(const Surface& target, const Tile& tile) {
    const std::int32_t columns = tile.narrow ? Tile::narrow_columns : Tile::columns;
    for (std::int32_t row = 0; row != tile.rows; ++row) {
        const auto alive = [&](std::int32_t column) {
            std::int32_t sides = 0;
            for (const Tile::Edge& e : tile.edge)
                sides |= e.value + column * e.dx + row * e.dy;
            return sides >= 0;
        };
        std::int32_t first = 0, last = columns;
        while (first != last && !alive(first))
            ++first;
        while (first != last && !alive(last - 1))
            --last;
        if (first != last)
            touch(target, tile.y + row, tile.x + first, tile.x + last);
    }
}

} // namespace spangle::raster
