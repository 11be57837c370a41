// One dithered colour in the form in which it is stored: a word, or 4x4 words. It is made once for all
// fragments of that colour.
#pragma once

#include <bit>

#include "raster/span/fill.hpp"
#include "raster/span/instructions.hpp"
#include <spangle/dither.hpp>

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

namespace inner {

/// One threshold for all three components of a DitheredWord, indexed by y & 3 and x & 3.
struct DitherSums {
    std::uint32_t at[16];
    constexpr DitherSums() : at{} {
        for (std::int32_t i = 0; i < 16; ++i)
            at[i] = dither_threshold(dither_row(i >> 2), i) * (1u << 21 | 1u << 10 | 1);
    }
};
inline constexpr DitherSums dither_sums;

} // namespace inner

/// A colour that is to be dithered. Its components are whole 32nds of a step: 10 bits from bit 21, 11 bits
/// from bit 10, and 10 bits from bit 0. More bits would change nothing, because thresholds are whole 32nds.
struct DitheredWord {
    std::uint32_t components;
    /// The stored word of the whole steps, without their fractions.
    SPANGLE_INLINE constexpr std::uint32_t word() const {
        return ((components >> 15) & 0xF800) | ((components >> 10) & 0x07E0) | ((components >> 5) & 0x1F);
    }
    /// The stored word of the fragment at a place. The place is y + (x << 30) modulo 2^32.
    SPANGLE_INLINE std::uint32_t at(std::uint32_t place) const {
        return DitheredWord{components + inner::dither_sums.at[std::rotl(place, 2) & 15]}.word();
    }
    static constexpr std::uint32_t column = 1u << 30; ///< difference of places from column to column
    static constexpr std::uint32_t place(std::int32_t x, std::int32_t y) {
        return static_cast<std::uint32_t>(y) + static_cast<std::uint32_t>(x) * column;
    }
};

namespace inner {

/// The k of thresholds (2 k + 1) / 32, once for each component of a word. Two words share an element, in
/// their order in memory.
struct PatternThresholds {
    std::uint32_t at[8];
    /// `row` and `column` give row & 3 and column & 3 of place i.
    template <class Row, class Column> constexpr PatternThresholds(Row row, Column column) : at{} {
        const auto one = [&](int i) {
            return (dither_threshold(dither_row(row(i)), column(i)) >> 1) * (1u << 11 | 1u << 5 | 1u);
        };
        for (int i = 0; i < 8; ++i)
            at[i] = in_turn(one(2 * i), one(2 * i + 1));
    }
};
inline constexpr PatternThresholds row_thresholds([](int i) { return i >> 2; }, [](int i) { return i; });
/// Thresholds of cells (DitherCells), indexed by the pixels of a row & 3.
inline constexpr PatternThresholds cell_thresholds[4] = {
    {[](int i) { return i; }, [](int i) { return i >> 2; }},
    {[](int i) { return i; }, [](int i) { return (i >> 2) - i; }},
    {[](int i) { return i; }, [](int i) { return (i >> 2) - 2 * i; }},
    {[](int i) { return i; }, [](int i) { return (i >> 2) - 3 * i; }}};

/// The words of two fragments from the components of a DitheredWord. A fraction of f 32nds and a threshold (2
/// k + 1) / 32 make a step where floor((f + 1) / 2) + k >= 16. Each sum takes five bits, and its highest bit
/// lies 4 above the lowest bit of its component.
template <bool SwapsBytes> class DitheredPair {
  public:
    SPANGLE_INLINE explicit DitheredPair(std::uint32_t components)
        : integer_part_(DitheredWord{components}.word() * 0x10001),
          fraction_part_((half(components >> 21) << 11 | half(components >> 10) << 5 | half(components)) *
                         0x10001) {}
    SPANGLE_INLINE std::uint32_t at(std::uint32_t thresholds) const {
        const std::uint32_t words = integer_part_ + (((fraction_part_ + thresholds) & 0x82108210) >> 4);
        return SwapsBytes ? std::rotl(__builtin_bswap32(words), 16) : words;
    }

  private:
    std::uint32_t integer_part_, fraction_part_;
    SPANGLE_INLINE static std::uint32_t half(std::uint32_t component) { return ((component & 31) + 1) >> 1; }
};

} // namespace inner

/// The words of the four rows of a pattern. A row has two periods of four columns.
template <bool SwapsBytes> class DitherRows {
  public:
    SPANGLE_INLINE explicit DitherRows(std::uint32_t components) {
        const inner::DitheredPair<SwapsBytes> pair(components);
        for (int y = 0; y < 4; ++y) {
            pairs_[y][0] = pairs_[y][2] = pair.at(inner::row_thresholds.at[2 * y]);
            pairs_[y][1] = pairs_[y][3] = pair.at(inner::row_thresholds.at[2 * y + 1]);
        }
    }
    SPANGLE_INLINE const inner::Half* row(std::int32_t y) const {
        return reinterpret_cast<const inner::Half*>(pairs_[y & 3]);
    }

  private:
    std::uint32_t pairs_[4][4];
};

/// Takes the place of a pattern where nothing is dithered.
struct NoPattern {
    SPANGLE_INLINE explicit NoPattern(std::uint32_t) {}
};

/// The words of a surface whose pixels are numbered row after row. Cell 4 i + y is the word of each pixel
/// whose number & 3 is i and whose row & 3 is y.
template <bool SwapsBytes> class DitherCells {
  public:
    [[gnu::noinline]] void make(std::uint32_t components, std::int32_t pixels_per_row) {
        const inner::DitheredPair<SwapsBytes> pair(components);
        const std::uint32_t* const thresholds = inner::cell_thresholds[pixels_per_row & 3].at;
        for (int i = 0; i < 8; ++i)
            pairs_[i] = pair.at(thresholds[i]);
    }
    SPANGLE_INLINE const inner::Half* words() const { return reinterpret_cast<const inner::Half*>(pairs_); }

  private:
    std::uint32_t pairs_[8];
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
