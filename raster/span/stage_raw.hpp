// Lists whose colour is 16 bits from its source to the surface: the two ends of them.
#pragma once

#include "raster/span/path.hpp"
#include "raster/span/rows.hpp"
#include "raster/span/stage_thresholds.hpp"

namespace spangle::raster {

/// One colour for the whole primitive.
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
    /// Of the fragment in that place: y + (x << 30), mod 2^32.
    SPANGLE_INLINE std::uint32_t at(std::uint32_t place) const {
        const std::uint32_t sum = components + detail::dither_sums.at[std::rotl(place, 2) & 15];
        return ((sum >> 15) & 0xF800) | ((sum >> 10) & 0x07E0) | ((sum >> 5) & 0x1F);
    }
    static constexpr std::uint32_t column = 1u << 30; ///< from place to place
    static constexpr std::uint32_t place(std::int32_t x, std::int32_t y) {
        return static_cast<std::uint32_t>(y) + static_cast<std::uint32_t>(x) * column;
    }
};

/// The same as a stage along rows: eight columns are two periods, nothing to walk.
template <int Count> struct FlatDithered : StageBase {
    static constexpr unsigned out = field_color;
    using N = Raw565<Count>;
    typename N::L::U32 r, g, b; ///< steps
    detail::DitherPlace<typename N::L> dither;
    typename N::T words;
    template <class S>
    SPANGLE_INLINE FlatDithered(const S& s, std::int32_t x)
        : r(N::L::splat32(s.flat_word >> 21 << 22)), g(N::L::splat32((s.flat_word >> 10 & 0x7FF) << 21)),
          b(N::L::splat32((s.flat_word & 0x3FF) << 22)), dither(s.x + x, s.y) {
        mix();
    }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.color.word = words;
        return true;
    }
    SPANGLE_INLINE void next_row() {
        dither.next_row();
        mix();
    }
    template <class S> SPANGLE_INLINE void start(const S& s, std::int32_t x) {
        dither = detail::DitherPlace<typename N::L>(s.x + x, s.y);
        mix();
    }

  private:
    SPANGLE_INLINE void mix() { words = N::word(N::dithered(N::tops(r, g, b), dither.threshold())).word; }
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
/// Words of DitherRows, as they are stored.
struct RowPattern : StageBase {
    static constexpr unsigned out = field_color;
    using N = Raw565<1>;
    const detail::Half* words; ///< from the fragment on that the list counts from
    SPANGLE_INLINE RowPattern(const PlaneRow& row, std::int32_t)
        : words(numeric::factor32(row.words + (row.counted_from & 3))) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.color.word = words[p.i & 3];
        return true;
    }
};
/// And of DitherCells, along paths.
struct PathPattern : StageBase {
    static constexpr unsigned out = field_color;
    using N = Raw565<1>;
    template <class S> SPANGLE_INLINE PathPattern(const S&, std::int32_t) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.color.word = p.cells[PathPixels::cell(p.place)];
        return true;
    }
};

/// The word, in the byte order of the surface or swapped to it.
template <int Count, PixelFormat Format, bool Host = true> struct StoreRaw : StageBase {
    static_assert(Format == PixelFormat::rgb565_be || Format == PixelFormat::rgb565_le);
    static constexpr unsigned in = field_color;
    static constexpr bool effect = true;
    using N = Raw565<Count>;
    using L = typename N::L;
    static constexpr bool swaps =
        Host && (Format == PixelFormat::rgb565_be) == (std::endian::native == std::endian::little);
    template <class S> SPANGLE_INLINE StoreRaw(const S&, std::int32_t) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        const auto at = p.color_plane + 2 * p.i;
        typename L::U16 word = p.color.word;
        if constexpr (swaps)
            word = L::swap_bytes(word);
        if (Count > 1 || p.selects)
            word = L::select(p.live, word, L::load(at));
        L::store(at, word);
        return true;
    }
};

} // namespace spangle::raster
