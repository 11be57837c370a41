// A tile is a small triangle, as a separate loop draws it on hosts with eight lanes. Its rows are not found
// in advance. Three edges say which lanes are alive, and no division is needed.
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>

#include "raster/ops/lanes.hpp"

namespace spangle::raster {

/// Eight columns of a few rows, all inside of the scissor rectangle. Pixels under dead lanes keep their bits.
/// A wider triangle is two tiles side by side. A narrow tile has four columns, so eight lanes are two rows,
/// and its number of rows is even.
struct Tile {
    static constexpr std::int32_t columns = 8, most_rows = 12, most_rows_of_two = 6;
    static constexpr std::int32_t narrow_columns = 4, most_narrow_rows = 22;

    std::int32_t x, y; ///< window position of lane 0 in the first row
    std::int32_t rows;
    std::int32_t dead_rows; ///< rows without fragments at the beginning, so that the number of rows is even
    bool narrow;
    /// Three edges, k = 0, 1, 2. A lane lies outside of an edge where its value is negative. The value is
    /// twice the signed area between the edge and the centre of the lane, in units of 2^-8 pixels, rounded
    /// down. It is value[2 k] in the first lane. It grows by by[k] from pixel to pixel to the right, and by
    /// by[k + 4] from row to row upwards.
    Lanes<8>::U16 value, by;

    /// Moves to the tile to the right of this tile.
    void move_right() {
        x += columns;
        value += Lanes<8>::mixed_low(by, by) * columns;
    }
};

/// The lanes of a tile that its edges leave alive, row by row, or by pairs of rows. L is Lanes<8> or
/// Lanes<two_rows>.
template <class L> class TileLanes {
  public:
    SPANGLE_INLINE explicit TileLanes(const Tile& tile)
        : a_(std::integral_constant<int, 0>{}, tile), b_(std::integral_constant<int, 1>{}, tile),
          c_(std::integral_constant<int, 2>{}, tile) {}
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
        template <int K>
        SPANGLE_INLINE Side(std::integral_constant<int, K>, const Tile& tile)
            : by(L::template spread<K + 4>(tile.by)) {
            at = L::template spread<2 * K>(tile.value) + L::offsets16(L::template spread<K>(tile.by), by);
            by *= L::rows;
        }
    } a_, b_, c_;
};

} // namespace spangle::raster
