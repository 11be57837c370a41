// Thresholds of ordered dithering along rows of the window (GL 1.3, 4.1.8).
#pragma once

#include <bit>

#include "raster/ops/packet_rows.hpp"
#include "raster/ops/stage.hpp"
#include "raster/span/instructions.hpp"
#include <spangle/dither.hpp>

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {
namespace inner {

/// The thresholds of the fragments of a group, in 32nds of a step. step() walks along the row.
template <class L> struct DitherRow;

/// The rows of the dither matrix, rotated to start at each of their four columns. The current threshold lies
/// in bits 22 to 26, where 32nds of a step are added, so one mask extracts it. On processors whose masks are
/// no operands it lies in the top five bits, so one shift extracts it.
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

/// Thresholds that are looked up by the number of a fragment in its row, in 2^-Bits of a step.
template <int Bits> struct DitherNumbered {
    std::uint32_t of[4 * 8];
    constexpr DitherNumbered() : of{} {
        for (int i = 0; i < 4 * 8; ++i)
            of[i] = dither_threshold(dither_row(i >> 3), i) << (Bits - 5);
    }
    template <bool Masks = numeric::three_operands>
    SPANGLE_INLINE const std::uint32_t* from(std::int32_t x, std::int32_t y) const {
        if constexpr (Masks)
            return of + (y & 3) * 8 + (x & 3);
        // The offset counts bytes. Rows of the table are 32 bytes apart and columns 4 bytes, so two shifts
        // make each coordinate's part of the offset.
        const auto low2 = [](std::int32_t v, int up) {
            return numeric::factor32(static_cast<std::uint32_t>(v) << 30) >> (30 - up);
        };
        return reinterpret_cast<const std::uint32_t*>(reinterpret_cast<const unsigned char*>(of) +
                                                      (low2(y, 5) + low2(x, 2)));
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

/// The form of thresholds as words of 32nds of a step.
struct ThresholdWord {
    static constexpr int words = 1;
    static constexpr std::uint32_t word(int, std::uint32_t threshold32) { return threshold32; }
};
/// Words of thresholds of a group of lanes, for each place in the pattern at which the first lane may be.
template <class L, class Threshold> struct DitherGroups {
    alignas(16) std::uint16_t of[16][Threshold::words][8];
    constexpr DitherGroups() : of{} {
        for (int i = 0; i < 16; ++i)
            for (int word = 0; word < Threshold::words; ++word)
                for (int lane = 0; lane < 8; ++lane)
                    of[i][word][lane] = static_cast<std::uint16_t>(
                        Threshold::word(word, dither_threshold(dither_row((i >> 2) + lane / L::columns),
                                                               i + lane % L::columns)));
    }
};
template <class L, class Threshold> inline constexpr DitherGroups<L, Threshold> dither_groups;

/// The thresholds of a group of lanes. Eight columns, or four columns of two rows, are whole periods of the
/// pattern, so every group of a row has the same thresholds.
template <class L, class Threshold> class DitherGroup {
  public:
    SPANGLE_INLINE DitherGroup(std::int32_t x, std::int32_t y) {
        const auto place = (static_cast<std::uint32_t>(y) & 3) << 2 | (static_cast<std::uint32_t>(x) & 3);
        const auto& words = dither_groups<L, Threshold>.of[place];
        for (int i = 0; i < Threshold::words; ++i)
            word_[i] = Lanes<8>::load(reinterpret_cast<const std::uint8_t*>(words[i]));
    }
    SPANGLE_INLINE typename L::U16 word(int i) const { return word_[i]; }

    /// The thresholds of lanes that each have their own place.
    template <class Lanes>
    SPANGLE_INLINE DitherGroup(const LanePlaces<Lanes>& x, const LanePlaces<Lanes>& y) {
        const auto place = (y.of & 3u) << 2 | (x.of & 3u);
        for (int i = 0; i < Threshold::words; ++i)
            word_[i] = Lanes::generate([&](std::uint32_t lane) __attribute__((always_inline)) {
                return dither_groups<L, Threshold>.of[place.lane(static_cast<int>(lane))][i][0];
            });
    }

  private:
    typename L::U16 word_[Threshold::words];
};

template <int Count> struct DitherRow<Lanes<Count>> : DitherGroup<Lanes<Count>, ThresholdWord> {
    using DitherRow::DitherGroup::DitherGroup;
    SPANGLE_INLINE typename Lanes<Count>::U16 threshold() const { return this->word(0); }
    SPANGLE_INLINE void step() {}
};

/// A DitherRow that keeps its window position, for stages that go from row to row.
template <class L> struct DitherPlace : DitherRow<L> {
    std::int32_t x, y;
    SPANGLE_INLINE DitherPlace(std::int32_t column, std::int32_t line)
        : DitherRow<L>(column, line), x(column), y(line) {}
    SPANGLE_INLINE DitherPlace(const LanePlaces<L>& columns, const LanePlaces<L>& lines)
        // Lanes with places of their own never go to another row.
        : DitherRow<L>(columns, lines), x(0), y(0) {}
    SPANGLE_INLINE void next_row() { *this = DitherPlace(x, y + L::rows); }
};

/// The thresholds of a group in the form that number system N adds (N::Threshold).
template <class N> struct KeptThresholds : DitherGroup<typename N::L, typename N::Threshold> {
    using KeptThresholds::DitherGroup::DitherGroup;
    SPANGLE_INLINE const KeptThresholds& threshold() const { return *this; }
    SPANGLE_INLINE void step() {}
};
template <class N>
using ThresholdsOf = std::conditional_t<(N::lanes > 1), KeptThresholds<N>, DitherRow<typename N::L>>;

/// Takes the place of thresholds where nothing is dithered.
struct NoThreshold {
    template <class X, class Y> SPANGLE_INLINE NoThreshold(const X&, const Y&) {}
    SPANGLE_INLINE static std::uint32_t threshold(std::int32_t = 0) { return 0; }
    SPANGLE_INLINE void step() {}
    SPANGLE_INLINE void next_row() {}
};

} // namespace inner
} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
