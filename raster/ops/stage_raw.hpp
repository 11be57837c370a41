// The first and the last stages of lists whose colour is 16 bits from its source to the surface.
#pragma once

#include "raster/ops/dither_pattern.hpp"
#include "raster/ops/stage_store.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/path.hpp"
#include "raster/span/rows.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

namespace inner {

/// A DitheredWord for eight lanes at once.
template <class L> struct DitheredLanes {
    using U16 = typename L::U16;
    U16 whole, r, g, b; ///< the word of whole steps; fractions of r, g and b in 32nds of a step
    SPANGLE_INLINE explicit DitheredLanes(std::uint32_t components)
        : whole(L::splat(DitheredWord{components}.word())), r(L::splat(components >> 21 & 31)),
          g(L::splat(components >> 10 & 31)), b(L::splat(components & 31)) {}
    SPANGLE_INLINE U16 at(U16 thresholds) const {
        return whole + (((r + thresholds) & 32) << 6) + ((g + thresholds) & 32) + ((b + thresholds) >> 5);
    }
};

} // namespace inner

/// Rows of the window in one dithered colour, as they are stored: eight columns, starting at any of the four
/// columns of a period.
template <PixelFormat Format> class DitherLaneRows {
  public:
    SPANGLE_INLINE explicit DitherLaneRows(std::uint32_t components) {
        using L = Lanes<8>;
        const inner::DitheredLanes<L> lanes(components);
        for (std::int32_t y = 0; y < 4; ++y) {
            const auto words =
                Words565<L, Format>::to_wire_order(lanes.at(inner::DitherRow<L>(0, y).threshold()));
            L::store(reinterpret_cast<std::uint8_t*>(thresholds_of_[y]), words);
            L::store(reinterpret_cast<std::uint8_t*>(thresholds_of_[y] + 4), words);
        }
    }
    SPANGLE_INLINE const inner::Half* row(std::int32_t y) const { return thresholds_of_[y & 3]; }

  private:
    inner::Half thresholds_of_[4][12];
};

/// Gives all fragments of the primitive one colour, as a word.
template <int Count> struct FlatWord : StageBase {
    static constexpr unsigned out = field_color;
    using N = Raw565<Count>;
    typename N::T word;
    template <class S> SPANGLE_INLINE FlatWord(const S& s, std::int32_t) : word(N::L::splat(s.flat_word)) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.color.word = word;
        return true;
    }
};

/// One dithered colour, from row to row of a tile: eight columns are two periods, so nothing walks along a
/// row.
template <int Count> struct FlatDithered : StageBase {
    static constexpr unsigned out = field_color;
    using N = Raw565<Count>;
    inner::DitheredLanes<typename N::L> lanes;
    inner::DitherPlace<typename N::L> dither;
    typename N::T words;
    template <class S>
    SPANGLE_INLINE FlatDithered(const S& s, std::int32_t x)
        : lanes(s.flat_word), dither(s.x + x, s.y), words(lanes.at(dither.threshold())) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.color.word = words;
        return true;
    }
    SPANGLE_INLINE void next_row() {
        dither.next_row();
        words = lanes.at(dither.threshold());
    }
};
/// One dithered colour along rows of eight lanes: reads words of DitherLaneRows.
struct FlatDitheredRows : StageBase {
    static constexpr unsigned out = field_color;
    using N = Raw565<8>;
    N::T words{};
    // start() sets the words of each row.
    template <class S> SPANGLE_INLINE FlatDitheredRows(const S&, std::int32_t) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.color.word = words;
        return true;
    }
    template <class S> SPANGLE_INLINE void start(const S& s, std::int32_t x) {
        words = N::L::load(reinterpret_cast<const std::uint8_t*>(s.words + ((s.x + x) & 3)));
    }
};
template <> struct FlatDithered<1> : StageBase {
    static constexpr unsigned out = field_color;
    using N = Raw565<1>;
    DitheredWord word;
    std::uint32_t place;
    template <class S>
    SPANGLE_INLINE FlatDithered(const S& s, std::int32_t x)
        : word{s.flat_word}, place(DitheredWord::place(s.x + x, s.y)) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.color.word = word.at(place);
        return true;
    }
    SPANGLE_INLINE void step() { place += DitheredWord::column; }
    template <class S> SPANGLE_INLINE void start(const S& s, std::int32_t x) {
        place = DitheredWord::place(s.x + x, s.y);
    }
};
/// Reads words of DitherRows, as they are stored.
struct RowPattern : StageBase {
    static constexpr unsigned out = field_color;
    using N = Raw565<1>;
    const inner::Half* words; ///< words from the fragment on at which the list starts to count
    SPANGLE_INLINE RowPattern(const PlaneRow& row, std::int32_t)
        : words(numeric::factor32(row.words + (row.dither_column & 3))) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.color.word = words[p.i & 3];
        return true;
    }
};
/// Reads words of DitherCells, along paths.
struct PathPattern : StageBase {
    static constexpr unsigned out = field_color;
    using N = Raw565<1>;
    template <class S> SPANGLE_INLINE PathPattern(const S&, std::int32_t) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        if constexpr (numeric::cheap_branches)
            numeric::begin_here();
        p.color.word = p.cells[PathPixels::cell(p.place)];
        return true;
    }
};

/// Stores the word. Host: it has the host's byte order and is brought into that of the surface.
template <int Count, PixelFormat Format, bool Host = true> struct StoreRaw : StageBase {
    static_assert(Format == PixelFormat::rgb565_be || Format == PixelFormat::rgb565_le);
    static constexpr unsigned in = field_color;
    static constexpr bool effect = true;
    using N = Raw565<Count>;
    using L = typename N::L;
    template <class S> SPANGLE_INLINE StoreRaw(const S&, std::int32_t) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        const auto at = p.color_plane + p.bytes();
        typename L::U16 word = p.color.word;
        if constexpr (Host)
            word = Words565<L, Format>::to_wire_order(word);
        if (Count > 1 || p.selects)
            word = L::select(p.live, word, L::load(at));
        L::store(at, word);
        return true;
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
