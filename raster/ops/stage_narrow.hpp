// The last stages of lists that draw on a surface of a narrow format. One set of stages serves all narrow
// formats.
#pragma once

#include "raster/ops/stage_store.hpp"
#include "raster/span/instructions.hpp"
#include "raster/surface/narrow.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// The stored word of a colour. Where `dither` is set, the threshold is added first.
template <class N>
[[gnu::noinline]] std::uint32_t narrow_word_of(PixelFormat format, const typename N::Color& c, bool dither,
                                               std::uint32_t threshold) {
    const Rgb8 rgb = {N::to8(c.r), N::to8(c.g), N::to8(c.b)};
    if (!has_format(PixelFormat::rgb666) || format != PixelFormat::rgb666)
        return narrow_word(format, rgb, dither, threshold);
    if (!dither)
        return word_666(rgb.r >> 2, rgb.g >> 2, rgb.b >> 2);
    return word_666(N::template dithered<6>(c.r, threshold), N::template dithered<6>(c.g, threshold),
                    N::template dithered<6>(c.b, threshold));
}

/// The place of a fragment on a narrow surface. The address in the colour plane is that of the row, because a
/// pixel may share its byte with others.
struct NarrowPlace {
    PixelFormat format;
    std::int32_t x, y;
    template <class S>
    NarrowPlace(const S& s, std::int32_t column) : format(s.state->format), x(s.x + column), y(s.y) {}
};

/// Loads the stored colour with which a fragment blends.
template <class N> struct StoredNarrow : NarrowPlace {
    static constexpr bool anywhere = false;
    StoredNarrow(const Span<typename N::Policy>& s, std::int32_t column) : NarrowPlace(s, column) {}
    typename N::Color load(const Px<N>& p) const { return load(p.color_plane); }
    [[gnu::noinline]] typename N::Color load(const std::uint8_t* row) const {
        const NarrowColor stored = narrow_color(format, load_narrow(format, row, x, y));
        const auto units = [&](int i) { return N::from_units(narrow_units(stored.k[i], stored.max[i])); };
        return {units(0), units(1), units(2), N::from_units(color_one)};
    }
    void step() { ++x; }
};

template <class N> struct StoreNarrow : StageBase {
    static_assert(N::lanes == 1);
    static constexpr unsigned in = field_color;
    static constexpr bool effect = true;
    StoredNarrow<N> place;
    inner::DitherRow<typename N::L> dither;
    bool dithers, merges;
    std::uint8_t mask;
    LogicTable logic;
    StoreNarrow(const Span<typename N::Policy>& s, std::int32_t column)
        : place(s, column), dither(s.x + column, s.y), dithers(s.state->fragment.dither),
          merges(s.state->fragment.logic || (s.state->fragment.color_mask & 7) != 7),
          mask(s.state->fragment.color_mask & 7), logic(s.state->fragment) {}

    bool operator()(Px<N>& p) const {
        typename N::Color c = p.color;
        if (mask != 7 && format_info(place.format).grey) {
            // A grey is the luma of all three channels, so masked channels keep their old values in it.
            const typename N::Color old = place.load(p);
            c = {(mask & 1) != 0 ? c.r : old.r, (mask & 2) != 0 ? c.g : old.g, (mask & 4) != 0 ? c.b : old.b,
                 c.a};
        }
        std::uint32_t word = narrow_word_of<N>(place.format, c, dithers, dither.threshold());
        if (merges)
            word = logic.merged(word, load_narrow(place.format, p.color_plane, place.x, place.y),
                                narrow_open(place.format, mask));
        store_narrow(place.format, p.color_plane, place.x, place.y, word);
        return true;
    }
    void step() {
        place.step();
        dither.step();
    }
};

/// Fills rows with one colour, without tests. Rows are filled by bytes, which is faster than by fragments.
template <class N> void fill_narrow_rows(const Span<Fixed>& span, const Row* row, const Row* end) {
    const DrawState& state = *span.state;
    const auto of = [&](int i) { return N::from_affine(span.color_value[i].value); };
    const typename N::Color color = {of(0), of(1), of(2), N::from_units(color_one)};
    const bool dithers = state.fragment.dither;
    for (; row != end; ++row) {
        const std::uint32_t thresholds = dither_row(row->y);
        std::uint32_t word[4];
        for (int x = 0; x < 4; ++x)
            word[x] = x != 0 && !dithers
                          ? word[0]
                          : narrow_word_of<N>(state.format, color, dithers, dither_threshold(thresholds, x));
        fill_narrow(state.format, span.target->color_row(row->y), row->y, row->first, row->last, word);
    }
}

/// Draws rows by the chain. The span's address in the colour plane is that of the stored row.
template <class P, void (*Draw)(const Span<P>&)>
void by_narrow_row(Span<P>& span, const Row* row, const Row* end) {
    for (; row != end; ++row) {
        enter(span, *row);
        span.color = span.target->color_row(row->y);
        Draw(span);
    }
}

/// Draws rows of affine colours. Where the colour is constant, rows are filled.
template <class N, void (*Draw)(const Span<Fixed>&)>
void narrow_rows(Span<Fixed>& span, const Row* row, const Row* end) {
    bool one_color = true;
    for (int i = 0; i < 3; ++i)
        one_color = one_color && span.color_value[i].dx == 0 && span.color_value[i].dy == 0;
    if (one_color)
        fill_narrow_rows<N>(span, row, end);
    else
        by_narrow_row<Fixed, Draw>(span, row, end);
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
