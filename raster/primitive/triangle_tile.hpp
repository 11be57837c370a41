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
/// 17 and 7; from centre to centre it changes by whole multiples of 2^8, so what is dropped below decides
/// nothing.
SPANGLE_INLINE Tile::Edge tile_edge(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1,
                                    std::int32_t center_x, std::int32_t center_y, bool right) {
    static_assert((Tile::columns + 1) * (Tile::most_rows + 1) * subpixel_one < 1 << 15);
    static_assert((2 * Tile::columns + 1) * (Tile::most_rows_of_two + 1) * subpixel_one < 1 << 15);
    const std::int32_t dx = x1 - x0, dy = y1 - y0, flip = -static_cast<std::int32_t>(right);
    const std::int32_t area =
        (center_x - x0) * dy - (center_y - y0) * dx - static_cast<std::int32_t>(dy == 0);
    return {static_cast<std::int16_t>((area >> subpixel_bits) ^ flip),
            static_cast<std::int16_t>((dy ^ flip) - flip), static_cast<std::int16_t>((-dx ^ flip) - flip)};
}

/// Corners upwards; columns [left, right) hold all its centres and lie inside of `clip`, as do the rows that
/// are left. The first of `tiles` side by side; false where it takes more than two.
SPANGLE_INLINE bool make_tile(Tile& tile, int& tiles, const std::int32_t (&xs)[3],
                              const std::int32_t (&ys)[3], bool middle_left, std::int32_t left,
                              std::int32_t right, const Rect& clip) {
    const std::int32_t low = first_center(ys[0]), high = first_center(ys[2]);
    tiles = right - left > Tile::columns ? 2 : 1;
    const std::int32_t columns = tiles * Tile::columns,
                       most_rows = tiles == 1 ? Tile::most_rows : Tile::most_rows_of_two;
    if (right - left > columns || high - low > most_rows || clip.w < columns)
        return false;
    const std::int32_t last = clip.x + clip.w - columns, top = clip.y + clip.h;
    tile.x = left < last ? left : last;
    tile.y = low < clip.y ? clip.y : low;
    tile.rows = (high < top ? high : top) - tile.y;
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
    const RowSpan* row = target.touched + std::ptrdiff_t{tile.y} * target.touched_step;
    for (std::int32_t n = tile.rows; n > 0; --n, row += target.touched_step)
        if (left < row->begin || right > row->end)
            return false;
    return true;
}

/// Touches what a tile covers. Not in line: once per frame and pixel or so.
[[gnu::noinline]] inline void touch_tile(const Surface& target, const Tile& tile) {
    TileLanes lanes(tile);
    for (std::int32_t y = tile.y; y != tile.y + tile.rows; ++y, lanes.next_row()) {
        const Lanes<8>::Mask alive = lanes.alive();
        const std::uint64_t low = Lanes<8>::half(alive, 0), high = Lanes<8>::half(alive, 1);
        if ((low | high) == 0)
            continue;
        const int first = low != 0 ? std::countr_zero(low) : 64 + std::countr_zero(high);
        const int last = high != 0 ? 128 - std::countl_zero(high) : 64 - std::countl_zero(low);
        touch(target, y, tile.x + first / 16, tile.x + last / 16);
    }
}

} // namespace spangle::raster
