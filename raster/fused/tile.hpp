// Runs a list of stages over a tile. A group of eight lanes draws one row, or two rows of a narrow tile.
#pragma once

#include "raster/ops/stage.hpp"
#include "raster/ops/stage_guess.hpp"
#include "raster/ops/tile.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/rows.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Draws a tile in lanes. `Wide` is 8, or two_rows for a narrow tile.
template <class Case, int Wide> SPANGLE_INLINE void tile_in_lanes(Span<Fixed>& span, const Tile& tile) {
    using N = typename Case::template System<Wide>;
    using L = Lanes<Wide>;
    const Surface& target = *span.target;
    PlaneRow at{span, nullptr, nullptr, tile.x, tile.y, tile.x};
    point_at(at.color, at.depth, target, tile.x, tile.y, format_info(Case::key.format).bytes_per_pixel, 1);
    typename Case::template TileList<Wide> list(at, 0);
    Px<N> p(at, target.color_stride, target.depth_stride);
    p.go_to(0);
    TileLanes<L> lanes(tile);
    const std::ptrdiff_t color_step = L::rows * std::ptrdiff_t{target.color_stride},
                         depth_step = L::rows * std::ptrdiff_t{target.depth_stride};
    constexpr int most = (L::rows == 2 ? Tile::most_narrow_rows : Tile::most_rows) / L::rows;
    [[maybe_unused]] Lanes<8>::Mask open[most], any_open{};
    for (std::int32_t n = 0, row = 0; row != tile.rows; ++n, row += L::rows) {
        p.live = lanes.alive();
        list.all(p);
        if constexpr (Case::guessed)
            any_open |= open[n] = p.open & p.live;
        list.next_row();
        lanes.next_row();
        p.color_plane += color_step;
        if constexpr (Case::tested)
            p.depth_plane += depth_step;
    }
    if constexpr (Case::guessed)
        if (Lanes<8>::any(any_open))
            for (std::int32_t n = 0, row = 0; row != tile.rows; ++n, row += L::rows)
                if (Lanes<8>::any(open[n]))
                    divide_open<Case::key.format, L>(
                        span,
                        L::place(at.color + row * std::ptrdiff_t{target.color_stride}, target.color_stride),
                        open[n], tile.x, tile.y + row);
}

template <class Case> [[gnu::noinline]] void fused_tile(Span<Fixed>& span, const Tile& tile) {
    if (tile.narrow)
        tile_in_lanes<Case, two_rows>(span, tile);
    else
        tile_in_lanes<Case, 8>(span, tile);
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
