// One colour as it is stored, dithered: a word, or 4x4 of them, made once for all fragments that have it.
#pragma once

#include <bit>

#include "raster/span/fill.hpp"
#include "raster/span/instructions.hpp"
#include <spangle/dither.hpp>

namespace spangle::raster::inline SPANGLE_INSTRUCTIONS {

namespace inner {

/// One threshold added to all three components of a DitheredWord, by y & 3, x & 3.
struct DitherSums {
    std::uint32_t at[16];
    constexpr DitherSums() : at{} {
        for (std::int32_t i = 0; i < 16; ++i)
            at[i] = dither_threshold(dither_row(i >> 2), i) * (1u << 21 | 1u << 10 | 1);
    }
};
inline constexpr DitherSums dither_sums;

} // namespace inner

/// One colour, dithered. Its components are given in 32nds of a step, whole ones, 10 bits at 21, 11 at 10 and
/// 10 at 0: no more of them tells, thresholds being whole 32nds.
struct DitheredWord {
    std::uint32_t components;
    /// Of the whole steps.
    SPANGLE_INLINE constexpr std::uint32_t word() const {
        return ((components >> 15) & 0xF800) | ((components >> 10) & 0x07E0) | ((components >> 5) & 0x1F);
    }
    /// Of the fragment in that place: y + (x << 30), mod 2^32.
    SPANGLE_INLINE std::uint32_t at(std::uint32_t place) const {
        return DitheredWord{components + inner::dither_sums.at[std::rotl(place, 2) & 15]}.word();
    }
    static constexpr std::uint32_t column = 1u << 30; ///< from place to place
    static constexpr std::uint32_t place(std::int32_t x, std::int32_t y) {
        return static_cast<std::uint32_t>(y) + static_cast<std::uint32_t>(x) * column;
    }
};

namespace inner {

/// k of thresholds (2 k + 1) / 32, once for each component of a word, two words at a time as they follow in
/// memory.
struct PatternThresholds {
    std::uint32_t at[8];
    /// Of a place in rows of four: its row & 3 and column & 3.
    template <class Row, class Column> constexpr PatternThresholds(Row row, Column column) : at{} {
        const auto one = [&](int i) {
            return (dither_threshold(dither_row(row(i)), column(i)) >> 1) * (1u << 11 | 1u << 5 | 1u);
        };
        for (int i = 0; i < 8; ++i)
            at[i] = in_turn(one(2 * i), one(2 * i + 1));
    }
};
inline constexpr PatternThresholds row_thresholds([](int i) { return i >> 2; }, [](int i) { return i; });
/// Of cells, by pixels per row & 3.
inline constexpr PatternThresholds cell_thresholds[4] = {
    {[](int i) { return i; }, [](int i) { return i >> 2; }},
    {[](int i) { return i; }, [](int i) { return (i >> 2) - i; }},
    {[](int i) { return i; }, [](int i) { return (i >> 2) - 2 * i; }},
    {[](int i) { return i; }, [](int i) { return (i >> 2) - 3 * i; }}};

/// The components of a DitheredWord as words of two fragments. A fraction of f 32nds and a threshold are a
/// step where floor((f + 1) / 2) + k >= 16: five bits for each sum, whose highest lies 4 above the least of
/// its component.
template <bool SwapsBytes> class DitheredPair {
  public:
    SPANGLE_INLINE explicit DitheredPair(std::uint32_t components)
        : whole_(DitheredWord{components}.word() * 0x10001),
          fraction_((half(components >> 21) << 11 | half(components >> 10) << 5 | half(components)) *
                    0x10001) {}
    SPANGLE_INLINE std::uint32_t at(std::uint32_t thresholds) const {
        const std::uint32_t words = whole_ + (((fraction_ + thresholds) & 0x82108210) >> 4);
        return SwapsBytes ? std::rotl(__builtin_bswap32(words), 16) : words;
    }

  private:
    std::uint32_t whole_, fraction_;
    SPANGLE_INLINE static std::uint32_t half(std::uint32_t component) { return ((component & 31) + 1) >> 1; }
};

} // namespace inner

/// Rows of the window, of two periods.
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

/// In place of them, where nothing is dithered.
struct NoPattern {
    SPANGLE_INLINE explicit NoPattern(std::uint32_t) {}
};

/// Cell 4 i + y is the word of row y & 3 in every pixel i & 3 of a surface, as many of which make a row.
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

} // namespace spangle::raster::inline SPANGLE_INSTRUCTIONS
