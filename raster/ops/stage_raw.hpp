// The first and the last stages of lists whose colour is the 16 bits R5 G6 B5 from its source to the surface.
#pragma once

#include "raster/ops/dither_pattern.hpp"
#include "raster/ops/stage_store.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/path.hpp"
#include "raster/span/rows.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

namespace inner {

/// A dithered colour (DitheredWord) for eight lanes at once.
template <class L> struct DitheredLanes {
    using U16 = typename L::U16;
    U16 whole, r, g, b; ///< the word of whole steps, and the fractions of r, g and b in 32nds of a step
    SPANGLE_INLINE explicit DitheredLanes(std::uint32_t components)
        : whole(L::splat(DitheredWord{components}.word())), r(L::splat(components >> 21 & 31)),
          g(L::splat(components >> 10 & 31)), b(L::splat(components & 31)) {}
    SPANGLE_INLINE U16 at(U16 thresholds) const {
        return whole + (((r + thresholds) & 32) << 6) + ((g + thresholds) & 32) + ((b + thresholds) >> 5);
    }
};

} // namespace inner

/// Rows of the window in one dithered colour, in the byte order of the surface. A row holds eight columns
/// from any of the four columns of a period.
template <PixelFormat Format> class DitherLaneRows {
  public:
    SPANGLE_INLINE explicit DitherLaneRows(std::uint32_t components) {
        using L = Lanes<8>;
        const inner::DitheredLanes<L> lanes(components);
        for (std::int32_t y = 0; y < 4; ++y) {
            const auto words =
                Words565<L, Format>::to_wire_order(lanes.at(inner::DitherRow<L>(0, y).threshold()));
            L::store(reinterpret_cast<std::uint8_t*>(threshold_rows_[y]), words);
            L::store(reinterpret_cast<std::uint8_t*>(threshold_rows_[y] + 4), words);
        }
    }
    SPANGLE_INLINE const inner::Half* row(std::int32_t y) const { return threshold_rows_[y & 3]; }

  private:
    inner::Half threshold_rows_[4][12];
};

/// Gives all fragments of the primitive one colour, which is a word.
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

/// Gives the rows of a tile one dithered colour. Eight columns are two periods of the pattern, so the words
/// of a row do not change along it.
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
/// Gives rows of eight lanes one dithered colour. The words are those of DitherLaneRows.
struct FlatDitheredRows : StageBase {
    static constexpr unsigned out = field_color;
    using N = Raw565<8>;
    N::T words{};
    // The words are set by start(), which is called for each row.
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
/// Gives a row one dithered colour. The words are those of DitherRows, in the byte order of the surface.
struct RowPattern : StageBase {
    static constexpr unsigned out = field_color;
    using N = Raw565<1>;
    const inner::Half* words; ///< words of this row; the list counts fragments from the first of them
    SPANGLE_INLINE RowPattern(const PlaneRow& row, std::int32_t)
        : words(numeric::factor32(row.words + (row.dither_column & 3))) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.color.word = words[p.i & 3];
        return true;
    }
};
/// Gives paths one dithered colour. The words are those of DitherCells.
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

/// Stores the word. Host: the word has the byte order of the host and is stored in that of the surface.
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
