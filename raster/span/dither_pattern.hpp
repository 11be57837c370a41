// One colour as it is stored, dithered: a word, or 4x4 of them, made once for all fragments that have it.
#pragma once

#include <bit>

#include "raster/span/fill.hpp"
#include <spangle/dither.hpp>

namespace spangle::raster {

namespace detail {

/// One threshold added to all three components of a DitheredWord, by y & 3, x & 3.
struct DitherSums {
    std::uint32_t at[16];
    constexpr DitherSums() : at{} {
        for (std::int32_t i = 0; i < 16; ++i)
            at[i] = dither_threshold(dither_row(i >> 2), i) * (1u << 21 | 1u << 10 | 1);
    }
};
inline constexpr DitherSums dither_sums;

} // namespace detail

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
        return DitheredWord{components + detail::dither_sums.at[std::rotl(place, 2) & 15]}.word();
    }
    static constexpr std::uint32_t column = 1u << 30; ///< from place to place
    static constexpr std::uint32_t place(std::int32_t x, std::int32_t y) {
        return static_cast<std::uint32_t>(y) + static_cast<std::uint32_t>(x) * column;
    }
};

namespace detail {

/// The components of a DitheredWord, four columns at a time.
template <bool SwapsBytes> struct DitheredColumns {
    std::uint32_t whole, r, g, b; ///< the word twice, and fractions of its components four times
    SPANGLE_INLINE explicit DitheredColumns(std::uint32_t components)
        : whole(DitheredWord{components}.word() * 0x10001), r((components >> 21 & 31) * 0x01010101),
          g((components >> 10 & 31) * 0x01010101), b((components & 31) * 0x01010101) {}
    /// Of column x, 0 or 1, of these thresholds, and of x + 2.
    SPANGLE_INLINE std::uint32_t at(std::uint32_t thresholds, int x) const {
        constexpr std::uint32_t more = 0x00200020; // where a fraction and its threshold are one step
        const std::uint32_t words = whole + ((r + thresholds) >> 8 * x & more) * 64 +
                                    ((g + thresholds) >> 8 * x & more) +
                                    ((b + thresholds) >> 8 * x & more) / 32;
        return SwapsBytes ? std::rotl(__builtin_bswap32(words), 16) : words;
    }
};

} // namespace detail

/// Rows of the window, of two periods.
template <bool SwapsBytes> class DitherRows {
  public:
    SPANGLE_INLINE explicit DitherRows(std::uint32_t components) {
        const detail::DitheredColumns<SwapsBytes> columns(components);
        for (std::int32_t y = 0; y < 4; ++y) {
            const std::uint32_t even = columns.at(dither_row(y), 0), odd = columns.at(dither_row(y), 1);
            pairs_[y][0] = pairs_[y][2] = detail::in_turn(even & 0xFFFF, odd & 0xFFFF);
            pairs_[y][1] = pairs_[y][3] = detail::in_turn(even >> 16, odd >> 16);
        }
    }
    SPANGLE_INLINE const detail::Half* row(std::int32_t y) const {
        return reinterpret_cast<const detail::Half*>(pairs_[y & 3]);
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
        const detail::DitheredColumns<SwapsBytes> columns(components);
        int shear = 0;
        for (std::int32_t y = 0; y < 4; ++y, shear -= 8 * pixels_per_row) {
            const std::uint32_t t = std::rotr(dither_row(y), shear & 31);
            const std::uint32_t even = columns.at(t, 0), odd = columns.at(t, 1);
            word[y] = static_cast<std::uint16_t>(even);
            word[4 + y] = static_cast<std::uint16_t>(odd);
            word[8 + y] = static_cast<std::uint16_t>(even >> 16);
            word[12 + y] = static_cast<std::uint16_t>(odd >> 16);
        }
    }
    std::uint16_t word[16];
};

} // namespace spangle::raster
