// A list of stages over a tile: one group of eight lanes per row.
#pragma once

#include "raster/span/rows.hpp"
#include "raster/span/stage.hpp"
#include "raster/span/stage_guess.hpp"
#include "raster/span/tile.hpp"

namespace spangle::raster {

template <class Case> [[gnu::noinline]] void fused_tile(Span<Fixed>& span, const Tile& tile) {
    using N = typename Case::template System<8>;
    const Surface& target = *span.target;
    PlaneRow at{span, nullptr, nullptr, tile.x, tile.y, tile.x};
    point_at(at.color, at.depth, target, tile.x, tile.y, format_info(Case::key.format).bytes_per_pixel, 1);
    typename Case::template List<8> list(at, 0);
    Px<N> p(at);
    p.i = 0;
    TileLanes lanes(tile);
    const std::ptrdiff_t color_stride = target.color_stride, depth_stride = target.depth_stride;
    [[maybe_unused]] Lanes<8>::Mask open[Tile::most_rows], any_open{};
    for (std::int32_t row = 0; row != tile.rows; ++row) {
        p.live = lanes.alive();
        list.all(p);
        if constexpr (Case::guessed)
            any_open |= open[row] = p.open & p.live;
        list.next_row();
        lanes.next_row();
        p.color_plane += color_stride;
        if constexpr (Case::tested)
            p.depth_plane += depth_stride;
    }
    if constexpr (Case::guessed)
        if (Lanes<8>::any(any_open))
            for (std::int32_t row = 0; row != tile.rows; ++row)
                divide_open<Case::key.format>(span, at.color + row * color_stride, open[row], tile.x,
                                              tile.y + row);
}

} // namespace spangle::raster
