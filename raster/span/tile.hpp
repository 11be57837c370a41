// Tiles: what a small triangle hands to a loop of its own where there are eight lanes. Its rows are not found
// first: lanes are alive where three edges say so, and nothing is divided.
#pragma once

#include <bit>
#include <cstdint>

#include "raster/span/lanes.hpp"

namespace spangle::raster {

/// Eight columns of a few rows, all of them inside of the scissor rectangle: lanes that are dead keep what
/// they hold. Triangles of more columns are two of them side by side. Narrow ones have four columns, of which
/// eight lanes are two rows, and an even number of rows.
struct Tile {
    static constexpr std::int32_t columns = 8, most_rows = 12, most_rows_of_two = 6;
    static constexpr std::int32_t narrow_columns = 4, most_narrow_rows = 22;

    /// Twice the signed area that the centre of a lane spans with an edge, in units of 2^-8 pixels, rounded
    /// down: negative outside. A pixel further it is `dx` more, a row further `dy`.
    struct Edge {
        std::int32_t value, dx, dy; ///< of 16 bits
    };
    std::int32_t x, y; ///< window position of lane 0 of the first row
    std::int32_t rows;
    std::int32_t dead_rows; ///< the first ones, that make them even
    bool narrow;
    Edge edge[3];

    /// On to the one right of it.
    void move_right() {
        x += columns;
        for (Edge& e : edge)
            e.value += columns * e.dx;
    }
};

/// The lanes of a tile that its edges leave, row by row or by two of them. L: Lanes<8> or Lanes<two_rows>.
template <class L> class TileLanes {
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
            : at(L::splat(word(e.value)) + L::offsets16(word(e.dx), word(e.dy))),
              by(L::splat(word(e.dy) * static_cast<std::uint32_t>(L::rows))) {}
        SPANGLE_INLINE static std::uint32_t word(std::int32_t v) { return static_cast<std::uint32_t>(v); }
    } a_, b_, c_;
};

} // namespace spangle::raster
