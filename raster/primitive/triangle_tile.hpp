// A small triangle as a tile: the same fragments as its rows have (edge.hpp), from the sides that their
// centres lie on.
#pragma once

#include "raster/primitive/edge.hpp"
#include "raster/span/lanes.hpp"
#include "raster/span/tile.hpp"
#include "raster/surface/surface.hpp"

namespace spangle::raster {

/// A side of a triangle, (x0, y0) up to (x1, y1). Left edges own their centres, right ones do not; the one
/// that lies flat on the ground, which counts as right, does.
///
/// Ends and centres lie within 9 columns and 13 rows, so that twice an area is at most 9 13 2^16; from centre
/// to centre it changes by whole multiples of 2^8, so what is dropped below decides nothing.
SPANGLE_INLINE Tile::Edge tile_edge(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1,
                                    std::int32_t center_x, std::int32_t center_y, bool right) {
    static_assert((Tile::columns + 1) * (Tile::most_rows + 1) * subpixel_one < 1 << 15);
    const std::int32_t dx = x1 - x0, dy = y1 - y0, flip = -static_cast<std::int32_t>(right);
    const std::int32_t area =
        (center_x - x0) * dy - (center_y - y0) * dx - static_cast<std::int32_t>(dy == 0);
    return {static_cast<std::int16_t>((area >> subpixel_bits) ^ flip),
            static_cast<std::int16_t>((dy ^ flip) - flip), static_cast<std::int16_t>((-dx ^ flip) - flip)};
}

/// Corners upwards; columns [left, right) hold all its centres and lie inside of `clip`, as do the rows that
/// are left. False where this is no tile.
SPANGLE_INLINE bool make_tile(Tile& tile, const std::int32_t (&xs)[3], const std::int32_t (&ys)[3],
                              bool middle_left, std::int32_t left, std::int32_t right, const Rect& clip) {
    const std::int32_t low = first_center(ys[0]), high = first_center(ys[2]);
    if (right - left > Tile::columns || high - low > Tile::most_rows || clip.w < Tile::columns)
        return false;
    const std::int32_t last = clip.x + clip.w - Tile::columns, top = clip.y + clip.h;
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

} // namespace spangle::raster
