// Thresholds of ordered dithering along rows of the window (GL 1.3, 4.1.10).
#pragma once

#include <bit>

#include "raster/span/stage.hpp"
#include <spangle/dither.hpp>

namespace spangle::raster::detail {

/// Thresholds of the fragments of a group, in 32nds of a step, and the walk along the row.
template <class L> struct DitherRow;

/// Rows of the matrix from each column of it on, its threshold in those five bits where sums of 32 steps in a
/// word have it: one mask; where masks are no operands, one shift.
struct DitherWords {
    static constexpr int place = numeric::three_operands ? 22 : 27;
    std::uint32_t of[16];
    constexpr DitherWords() : of{} {
        for (int i = 0; i < 16; ++i)
            of[i] = std::rotl(dither_row(i >> 2), place - 8 * (i & 3));
    }
    SPANGLE_INLINE constexpr std::uint32_t at(std::int32_t x, std::int32_t y) const {
        return of[numeric::with_bits<2, 2>(static_cast<std::uint32_t>(x) & 3, static_cast<std::uint32_t>(y))];
    }
};
inline constexpr DitherWords dither_words;

template <> struct DitherRow<Lanes<1>> {
    std::uint32_t row;
    SPANGLE_INLINE DitherRow(std::int32_t x, std::int32_t y) : row(dither_words.at(x, y)) {}
    SPANGLE_INLINE std::uint32_t threshold() const { return row >> DitherWords::place & 31; }
    SPANGLE_INLINE void step() { row = std::rotr(row, 8); }
};

/// Thresholds of rows' fragments by number, in 2^-Bits of a step.
template <int Bits> struct DitherNumbered {
    std::uint32_t of[4][7];
    constexpr DitherNumbered() : of{} {
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 7; ++x)
                of[y][x] = dither_threshold(dither_row(y), x) << (Bits - 5);
    }
    SPANGLE_INLINE const std::uint32_t* from(std::int32_t x, std::int32_t y) const {
        return of[y & 3] + (x & 3);
    }
};
template <int Bits> inline constexpr DitherNumbered<Bits> dither_numbered;

template <int Bits> class NumberedThresholds {
  public:
    SPANGLE_INLINE NumberedThresholds(std::int32_t x, std::int32_t y)
        : from_(dither_numbered<Bits>.from(x, y)) {}
    SPANGLE_INLINE std::uint32_t threshold(std::int32_t i) const { return from_[i & 3]; }

  private:
    const std::uint32_t* from_;
};

/// Eight columns from any of a period's first, for each row of it.
struct DitherColumns {
    std::uint16_t of[4][11];
    constexpr DitherColumns() : of{} {
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 11; ++x)
                of[y][x] = static_cast<std::uint16_t>(dither_threshold(dither_row(y), x));
    }
};
inline constexpr DitherColumns dither_columns;

/// Eight columns are two periods: nothing to walk.
template <> struct DitherRow<Lanes<8>> {
    Lanes<8>::U16 row;
    SPANGLE_INLINE DitherRow(std::int32_t x, std::int32_t y)
        : row(Lanes<8>::load(reinterpret_cast<const std::uint8_t*>(dither_columns.of[y & 3] + (x & 3)))) {}
    SPANGLE_INLINE explicit DitherRow(const Lanes<8>::U16& thresholds) : row(thresholds) {}
    SPANGLE_INLINE Lanes<8>::U16 threshold() const { return row; }
    SPANGLE_INLINE void step() {}
};

/// Four columns of a row and of the next one, from any column and row of a period.
struct DitherTiles {
    std::uint16_t of[4][4][8];
    constexpr DitherTiles() : of{} {
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 4; ++x)
                for (int lane = 0; lane < 8; ++lane)
                    of[y][x][lane] =
                        static_cast<std::uint16_t>(dither_threshold(dither_row(y + lane / 4), x + lane % 4));
    }
};
inline constexpr DitherTiles dither_tiles;

/// Four columns are one.
template <> struct DitherRow<Lanes<two_rows>> : DitherRow<Lanes<8>> {
    SPANGLE_INLINE DitherRow(std::int32_t x, std::int32_t y)
        : DitherRow<Lanes<8>>(
              Lanes<8>::load(reinterpret_cast<const std::uint8_t*>(dither_tiles.of[y & 3][x & 3]))) {}
};

/// The same that knows where it is, for stages that walk from row to row.
template <class L> struct DitherPlace : DitherRow<L> {
    std::int32_t x, y;
    SPANGLE_INLINE DitherPlace(std::int32_t column, std::int32_t line)
        : DitherRow<L>(column, line), x(column), y(line) {}
    SPANGLE_INLINE void next_row() { *this = DitherPlace(x, y + L::rows); }
};

/// In place of either, where nothing is dithered.
struct NoThreshold {
    SPANGLE_INLINE NoThreshold(std::int32_t, std::int32_t) {}
    SPANGLE_INLINE static std::uint32_t threshold(std::int32_t = 0) { return 0; }
    SPANGLE_INLINE void step() {}
    SPANGLE_INLINE void next_row() {}
};

} // namespace spangle::raster::detail
