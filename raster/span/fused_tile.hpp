// A list of stages over a tile: one group of eight lanes per row.
#pragma once

#include "raster/span/rows.hpp"
#include "raster/span/stage.hpp"
#include "raster/span/stage_guess.hpp"
#include "raster/span/tile.hpp"

namespace spangle::raster {

namespace detail {

/// The lanes of a tile that its edges leave, row by row.
class TileLanes {
  public:
    SPANGLE_INLINE explicit TileLanes(const Tile& tile)
        : a_(tile.edge[0]), b_(tile.edge[1]), c_(tile.edge[2]) {}
    SPANGLE_INLINE Lanes<8>::Mask alive() const {
        using Signed [[gnu::vector_size(16)]] = std::int16_t;
        return ~std::bit_cast<Lanes<8>::Mask>(std::bit_cast<Signed>(a_.at | b_.at | c_.at) >> 15);
    }
    SPANGLE_INLINE void next_row() {
        a_.at += a_.by;
        b_.at += b_.by;
        c_.at += c_.by;
    }

  private:
    struct Side {
        Lanes<8>::U16 at, by;
        SPANGLE_INLINE explicit Side(const Tile::Edge& e)
            : at(splat(e.value) + splat(e.dx) * Lanes<8>::U16{0, 1, 2, 3, 4, 5, 6, 7}), by(splat(e.dy)) {}
        SPANGLE_INLINE static Lanes<8>::U16 splat(std::int16_t v) {
            return Lanes<8>::splat(static_cast<std::uint16_t>(v));
        }
    } a_, b_, c_;
};

} // namespace detail

template <class Case> [[gnu::noinline]] void fused_tile(Span<Fixed>& span, const Tile& tile) {
    using N = typename Case::template System<8>;
    const Surface& target = *span.target;
    PlaneRow at{span, nullptr, nullptr, tile.x, tile.y, tile.x};
    point_at(at.color, at.depth, target, tile.x, tile.y, format_info(Case::key.format).bytes_per_pixel, 1);
    typename Case::template List<8> list(at, 0);
    Px<N> p(at);
    p.i = 0;
    detail::TileLanes lanes(tile);
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
