// Runs a list of stages as one loop: eight lanes at a time where the host has lanes, and one lane for the
// fragments that remain.
#pragma once

#include <cstdint>

#include "raster/fused/divided.hpp"
#include "raster/fused/fogged.hpp"
#include "raster/fused/gathered.hpp"
#include "raster/fused/path_list.hpp"
#include "raster/fused/rows_apart.hpp"
#include "raster/ops/dither_pattern.hpp"
#include "raster/ops/stage.hpp"
#include "raster/ops/stage_raw.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/rows.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// True where a loop along a row of texels counts one index in bytes. Elsewhere pointers are better, because
/// registers are too few for addresses that are sums of two words.
template <class N>
inline constexpr bool walks_bytes = !numeric::three_operands && std::is_same_v<N, PackedCoarse>;

/// Draws fragments [i, stop) one by one, i < stop.
template <bool Row, class N, class List, class Place>
SPANGLE_INLINE void fused_loop(List& list, const Place& span, std::int32_t i, std::int32_t stop) {
    Px<N> p(span);
    p.live = true;
    p.row = Row;
    if constexpr (!List::runs && (List::rows ? Row && walks_bytes<N> : !numeric::scales_indices)) {
        p.twice = 2 * i;
        do { // one index serves all planes, not one pointer for each
            p.twice = numeric::factor32(p.twice);
            p.i = p.twice >> 1;
            list(p);
            if constexpr (Row)
                list.step_row();
            else
                list.step();
            p.twice += 2;
        } while (p.twice != 2 * stop);
        return;
    }
    do {
        p.go_to(i);
        list(p);
        if constexpr (Row)
            list.step_row();
        else
            list.step();
        if constexpr (!List::runs && (!List::rows || numeric::scales_indices))
            i = numeric::factor32(i); // one index serves all planes, not one pointer for each
    } while (++i != stop);
}

/// Draws n pixels from column `begin` with one lane. The stages of the list must have been started at the
/// first pixel.
template <class N, class List>
SPANGLE_INLINE void fused_narrow(List& list, const Span<typename N::Policy>& span, std::int32_t begin,
                                 std::int32_t n) {
    static_assert(N::lanes == 1);
    std::int32_t i = 0;
    do {
        std::int32_t stop = n;
        if constexpr (List::runs) {
            const std::int32_t next = list.begin(begin + i) - begin;
            stop = next < n ? next : n;
        }
        if (List::rows && list.row(stop - i))
            fused_loop<true, N>(list, span, i, stop);
        else
            fused_loop<false, N>(list, span, i, stop);
        i = stop;
    } while (List::runs && i != n);
}

/// Draws n pixels from column `begin`, eight at a time. The last pixels of a run are a group of their own, in
/// which other lanes are dead. That group stays inside of the span, unless the span has fewer than eight
/// pixels. The stages of the list must have been started at the first pixel.
template <class N, class List>
SPANGLE_INLINE void fused_wide(List& list, const Span<typename N::Policy>& span, std::int32_t begin,
                               std::int32_t n) {
    static_assert(N::lanes == 8);
    Px<N> p(span);
    std::int32_t i = 0, stop = n;
    do {
        if constexpr (List::runs) {
            const std::int32_t next = list.begin(begin + i) - begin;
            stop = next < n ? next : n;
        }
        p.row = List::rows && list.row(stop - i);
        do {
            p.go_to(i);
            p.live = N::L::all;
            if (i + 8 > stop) {
                p.go_to(n < 8 ? 0 : i < n - 8 ? i : n - 8);
                p.live = some_lanes(i - p.i, stop - p.i);
                if (p.i != i)
                    list.jump(span, begin + p.i, p.i - i);
            }
            list(p);
            list.step();
            i = p.i + 8;
        } while (i < stop);
        if (List::runs && i > stop && stop != n)
            list.jump(span, begin + stop, stop - i);
        i = stop;
    } while (List::runs && i != n);
}

namespace inner {

/// Loads n < 8 words of 16 bits into eight lanes; store_words() stores them. Neither function touches a byte
/// behind the words. Where two loads or two stores overlap, both have the same words there.
SPANGLE_INLINE Lanes<8>::U16 load_words(const std::uint8_t* at, std::int32_t n) {
    std::uint64_t low = 0, high = 0;
    if (n >= 4) {
        __builtin_memcpy(&low, at, 8);
        __builtin_memcpy(&high, at + 2 * (n - 4), 8);
        high = high >> 1 >> (16 * (8 - n) - 1);
    } else {
        std::uint32_t two = 0;
        std::uint16_t one = 0;
        if (n >= 2)
            __builtin_memcpy(&two, at, 4);
        __builtin_memcpy(&one, at + 2 * (n - 1), 2);
        low = two | std::uint64_t{one} << (16 * (n - 1));
    }
    return Lanes<8>::halves(low, high);
}
SPANGLE_INLINE void store_words(std::uint8_t* at, Lanes<8>::U16 v, std::int32_t n) {
    const std::uint64_t low = Lanes<8>::half(v, 0), high = Lanes<8>::half(v, 1);
    if (n >= 4) {
        const std::uint64_t last = low >> (16 * (n - 4)) | high << 1 << (16 * (8 - n) - 1);
        __builtin_memcpy(at, &low, 8);
        __builtin_memcpy(at + 2 * (n - 4), &last, 8);
    } else {
        const auto two = static_cast<std::uint32_t>(low);
        const auto one = static_cast<std::uint16_t>(low >> (16 * (n - 1)));
        if (n >= 2)
            __builtin_memcpy(at, &two, 4);
        __builtin_memcpy(at + 2 * (n - 1), &one, 2);
    }
}

} // namespace inner

/// Makes the span describe pixels [row.first, row.last) of a row.
template <class Case> SPANGLE_INLINE void enter_fused(Span<Fixed>& span, const Row& row) {
    // Where no run is anchored to the left edge, pixel 0 is the first pixel that is drawn.
    span.x = row.first;
    if constexpr (Case::template List<1>::runs) {
        span.x = row.left;
        span.length = row.right - row.left;
    }
    span.y = row.y;
    if constexpr (Case::key.dither)
        span.dither_column = row.first & 3;
    point_at(span.color, span.depth, *span.target, row.first, row.y,
             format_info(Case::key.format).bytes_per_pixel, 1);
}

template <class Case>
SPANGLE_INLINE RowPlace place_of(const Surface& target, const Row& row, std::int32_t column) {
    const auto place = [&](std::uint8_t* base, std::int32_t stride, std::int32_t bytes) {
        // The address becomes one word before the loop, not a sum in the loop.
        return numeric::factor32(base + (std::ptrdiff_t{row.y} * stride + std::ptrdiff_t{column} * bytes));
    };
    return {place(target.color, target.color_stride, format_info(Case::key.format).bytes_per_pixel),
            Case::tested ? place(target.depth, target.depth_stride, 2) : nullptr};
}

/// Enters a row and returns the place from which fragments are counted. Pixel 0 of the span becomes the first
/// pixel that is drawn.
template <class Case> SPANGLE_INLINE RowPlace enter_counted(Span<Fixed>& span, const Row& row) {
    const std::int32_t dither_column = Case::numbered ? row.first : row.last;
    span.x = row.first;
    span.y = row.y;
    if constexpr (Case::key.dither)
        span.dither_column = dither_column & 3;
    return place_of<Case>(*span.target, row, dither_column);
}

/// Draws the fragments of a row one by one, counted up to 0, so that the last index needs no register.
template <class Case>
SPANGLE_INLINE void fused_plain_row(Span<Fixed>& span, const Row& row,
                                    [[maybe_unused]] const typename Case::Pattern& pattern) {
    const RowPlace place = place_of<Case>(*span.target, row, row.last);
    PlaneRow at{span, place.color, place.depth, row.first, row.y, row.last};
    if constexpr (Case::patterned)
        at.words = pattern.row(row.y);
    typename Case::template List<1> list(at, 0);
    fused_loop<false, typename Case::template System<1>>(list, at, row.first - row.last, 0);
}

template <class Case>
SPANGLE_INLINE void fused_narrow_plain_rows(Span<Fixed>& span, const Row* row, const Row* end) {
    const typename Case::Pattern pattern(span.flat_word);
    do
        fused_plain_row<Case>(span, *row, pattern);
    while (++row != end);
}

/// True for lists that ask, for a whole row at a time, whether its fragments lie in one row of texels.
template <class List> inline constexpr bool takes_rows = List::rows && !List::runs;

/// Draws the n fragments before `end`, counted up to 0.
template <class N, class List>
SPANGLE_INLINE void fused_texels(List& list, const RowPlace& end, std::int32_t n) {
    if (list.row(n))
        fused_loop<true, N>(list, end, -n, 0);
    else
        fused_loop<false, N>(list, end, -n, 0);
}

template <class Case> SPANGLE_INLINE void fused_narrow_row(Span<Fixed>& span, const Row& row) {
    using N = typename Case::template System<1>;
    using List = typename Case::template List<1>;
    if constexpr (takes_rows<List> && Case::key.dither)
        span.dither_column = row.last & 3;
    List list(span, row.first - span.x);
    if constexpr (takes_rows<List>)
        fused_texels<N>(list, place_of<Case>(*span.target, row, row.last), row.last - row.first);
    else
        fused_narrow<N>(list, span, row.first - span.x, row.last - row.first);
}

/// Draws rows with one lane. One list serves all rows.
template <class Case>
SPANGLE_INLINE void fused_narrow_rows(Span<Fixed>& span, const Row* row, const Row* end) {
    using N = typename Case::template System<1>;
    using List = typename Case::template List<1>;
    if constexpr (!List::runs && !List::rows) {
        // Fragments are counted up to 0, so that the last index needs no register.
        const RowPlace first = enter_counted<Case>(span, *row);
        List list(span, 0);
        for (RowPlace at = first;; at = enter_counted<Case>(span, *row), list.start(span, 0)) {
            if constexpr (Case::numbered)
                fused_loop<false, N>(list, at, 0, row->last - row->first);
            else
                fused_loop<false, N>(list, at, row->first - row->last, 0);
            if (++row == end)
                return;
        }
    } else {
        if constexpr (takes_rows<List>) {
            RowPlace end_of_row = enter_counted<Case>(span, *row);
            List list(span, 0);
            for (;; end_of_row = enter_counted<Case>(span, *row), list.start(span, 0)) {
                fused_texels<N>(list, end_of_row, row->last - row->first);
                if (++row == end)
                    return;
            }
        }
        enter_fused<Case>(span, *row);
        List list(span, row->first - span.x);
        for (;;) {
            fused_narrow<N>(list, span, row->first - span.x, row->last - row->first);
            if (++row == end)
                return;
            enter_fused<Case>(span, *row);
            list.start(span, row->first - span.x);
        }
    }
}

/// Draws the fragments that guesses have left open, with one lane.
template <class Case>
SPANGLE_INLINE void fused_open(Span<Fixed>& span, const OpenGroup* open, const OpenGroup* end) {
    using N = typename Case::template System<1>;
    typename Case::template List<1> list(span, 0);
    each_open(
        open, end, [&](std::int32_t x, std::int32_t y) __attribute__((always_inline)) {
            const RowPlace at = enter_counted<Case>(span, {y, x, x + 1, x, x + 1});
            list.start(span, 0);
            fused_loop<false, N>(list, at, Case::numbered ? 0 : -1, Case::numbered ? 1 : 0);
        });
}

/// Draws rows in eight lanes. One list serves all rows, so its values of the primitive are found once. A row
/// of less than eight pixels is one group that works on copies, so no pixel beside it is touched.
template <class Case> SPANGLE_INLINE void fused_rows(Span<Fixed>& span, const Row* row, const Row* end) {
    using N = typename Case::template System<8>;
    using List = typename Case::template List<8>;
    using L = typename N::L;
    alignas(16) std::uint8_t color_copy[16], depth_copy[16];
    std::uint8_t *color, *depth;
    std::int32_t n;
    bool copied;
    const auto enter = [&] {
        enter_fused<Case>(span, *row);
        color = span.color;
        depth = span.depth;
        n = row->last - row->first;
        copied = n > 2 && n < 8 && !List::runs;
        if (copied) {
            span.color = color_copy;
            span.depth = depth_copy;
        }
    };
    enter();
    List list(span, row->first - span.x);
    // Runs shorter than a group would leave most lanes dead.
    const auto lanes_pay = [&] {
        const std::int32_t x = row->first - span.x;
        return copied || (n >= 8 && (!List::runs || list.begin(x) - x >= 8));
    };
    for (;;) {
        if (!lanes_pay()) {
            fused_narrow_row<Case>(span, *row);
        } else {
            if (copied) {
                L::store(color_copy, inner::load_words(color, n));
                if constexpr (Case::tested)
                    L::store(depth_copy, inner::load_words(depth, n));
            }
            fused_wide<N>(list, span, row->first - span.x, n);
            if (copied) {
                inner::store_words(color, L::load(color_copy), n);
                if constexpr (Case::tested)
                    inner::store_words(depth, L::load(depth_copy), n);
            }
        }
        if (++row == end)
            return;
        enter();
        if (n >= 8 || copied)
            list.start(span, row->first - span.x);
    }
}

template <class Case>
SPANGLE_INLINE bool gathered_rows([[maybe_unused]] Span<Fixed>& span, [[maybe_unused]] const Row* row,
                                  [[maybe_unused]] const Row* end) {
    if constexpr (Case::gathered)
        return fused_gathered_rows<typename Case::Gathered>(span, row, end);
    return false;
}

/// Draws rows that patches do not serve. This function is not inline, so all callers share one copy of the
/// loop.
template <class Case>
[[gnu::noinline]] void fused_patchless_rows(Span<Fixed>& span, const Row* row, const Row* end) {
    fused_narrow_rows<Case>(span, row, end);
}

/// Draws lit rows one fragment at a time: in patches, where the rows have enough fragments.
template <class Case, class Products>
SPANGLE_INLINE void fused_lit_rows(Span<Fixed>& span, const Row* row, const Row* end) {
    if (PatchOfRows::are_many(row, end, PatchOfRows::few_for_one))
        fused_divided_rows(span, row, end, &draw_patch_one<Case, Products>, &fused_patchless_rows<Case>);
    else
        fused_patchless_rows<Case>(span, row, end);
}

/// Draws rows of a case. A Case has the templates System<Lanes> and List<Lanes>, and these constants:
/// - key: the key of the case;
/// - tested: depths are tested or written;
/// - wide, heavy: lanes pay, also for few fragments;
/// - plain: there are depths and colours only;
/// - lit: divided attributes are drawn in patches;
/// - apart: the stages have no start();
/// - numbered: the stages ask for the number of the fragment in its row.
template <class Case, int Wide = host_lanes>
[[gnu::noinline]] void fused(Span<Fixed>& span, const Row* row, const Row* end) {
    if constexpr (Case::lit && Wide == 8) {
        const Rect& clip = span.state->fragment.scissor;
        if (clip.w < 8 || !PatchOfRows::are_many(row, end, PatchOfRows::few))
            return fused_patchless_rows<Case>(span, row, end);
        const auto draw = [room = clip.x + clip.w - 8](Span<Fixed>& at, const Row* first, const Row* last) {
            return draw_patch<Case>(at, first, last, room);
        };
        fused_divided_rows(span, row, end, draw, &fused_patchless_rows<Case>);
    } else if constexpr (Case::lit) {
        fused_lit_rows<Case, NearProducts>(span, row, end);
    } else if constexpr (Wide == 8 && Case::heavy) {
        using List = typename Case::template List<8>;
        if constexpr (List::runs || List::rows)
            fused_rows<Case>(span, row, end);
        else if (span.state->fragment.scissor.w < 8)
            fused_narrow_rows<Case>(span, row, end);
        else if (!gathered_rows<Case>(span, row, end))
            fused_plain_rows<Case>(span, row, end);
    } else if constexpr (Case::fogged && Wide == 1) {
        fused_fogged_rows<Case>(span, row, end);
    } else if constexpr (Case::plain) {
        if constexpr (Wide == 8 && Case::wide)
            if (span.state->fragment.scissor.w >= 8)
                return fused_plain_rows<Case>(span, row, end);
        if constexpr (Case::patterned)
            if (!PatchOfRows::are_many(row, end, Case::FewFragments::most + 1))
                return fused_narrow_plain_rows<typename Case::FewFragments>(span, row, end);
        fused_narrow_plain_rows<Case>(span, row, end);
    } else if constexpr (draws_rows_apart<Case, Wide>) {
        do {
            enter_fused<Case>(span, *row);
            fused_narrow_row<Case>(span, *row);
        } while (++row != end);
    } else if constexpr (Wide == 1 || !Case::wide) {
        fused_narrow_rows<Case>(span, row, end);
    } else {
        do {
            const std::int32_t n = row->last - row->first;
            enter_fused<Case>(span, *row);
            if (n >= 8) {
                typename Case::template List<8> list(span, row->first - span.x);
                fused_wide<typename Case::template System<8>>(list, span, row->first - span.x, n);
                continue;
            }
            fused_narrow_row<Case>(span, *row);
        } while (++row != end);
    }
}

/// Draws the fragments of path i. The stages of the list must have been started at the first fragment.
template <bool Dithered, class List, class N>
SPANGLE_INLINE void walk_path(List& list, Px<N>& p, const Paths& paths, int i,
                              [[maybe_unused]] std::uint32_t before) {
    const auto word = [&](Paths::Word w) { return static_cast<std::uint32_t>(paths.at(w, i)); };
    const std::uint32_t along = word(Paths::along), aside = word(Paths::aside);
    const std::int32_t rise = paths.at(Paths::rise, i), denominator = paths.at(Paths::denominator, i);
    std::uint32_t at = word(Paths::first) + (Dithered ? before : 0);
    std::int32_t count = paths.at(Paths::count, i), rest = paths.at(Paths::rest, i);
    if constexpr (!numeric::cheap_branches)
        rest += denominator;
    do {
        p.go_to(static_cast<std::int32_t>(Dithered ? PathPixels::pixel(at) : at));
        p.place = at;
        list(p);
        list.step();
        if constexpr (Dithered)
            // The step waits until the dithered word has been looked up, which saves a register.
            at = numeric::factor32(at);
        if constexpr (numeric::cheap_branches) {
            rest += rise;
            at += along;
            if (rest >= 0) {
                rest -= denominator;
                at += aside;
            }
        } else {
            rest += rise - denominator;               // keeps 0 <= rest < denominator
            const std::int32_t straight = rest >> 31; // all ones where the path does not step aside
            rest += denominator & straight;
            at += along + (aside & ~static_cast<std::uint32_t>(straight));
        }
    } while (--count != 0);
}

/// Draws the paths of a case. Pixels are counted from window position (0, 0).
template <class Case>
[[gnu::noinline]] void fused_paths(const DrawState& state, const Surface& target, const Paths& paths,
                                   int count) {
    static_assert(format_info(Case::key.format).bytes_per_pixel == 2 &&
                  Case::key.depth_format != DepthFormat::z24s8);
    using N = typename Case::template System<1>;
    Span<Fixed> span;
    span.state = &state;
    span.target = &target;
    span.color = target.color;
    span.depth = target.depth;
    span.x = span.y = span.anchor_x = span.anchor_y = 0;
    Px<N> p(span);
    p.live = true;
    p.selects = !numeric::cheap_branches; // a depth test's outcome is hard to predict
    const std::uint32_t before = PathPixels::before(target);
    if constexpr (Case::patterned) {
        const auto back = static_cast<std::ptrdiff_t>(before) * 2;
        // The address becomes one word before the loop, not a sum in the loop.
        p.color_plane = numeric::factor32(p.color_plane - back);
        if constexpr (Case::tested)
            p.depth_plane = numeric::factor32(p.depth_plane - back);
    }
    const auto walk = [&](int i) __attribute__((always_inline)) {
        if (paths.at(Paths::count, i) <= 0)
            return;
        span.flat_word = static_cast<std::uint32_t>(paths.at(Paths::flat, i));
        span.z = {static_cast<std::uint32_t>(paths.at(Paths::depth, i)),
                  static_cast<std::uint32_t>(paths.at(Paths::depth_step, i)), 0};
        for (int c = 0; c < 3; ++c)
            span.color_value[c] = {paths.color[c], paths.color_step[c], 0};
        typename Case::PathStages stages(span, 0);
        walk_path<Case::patterned>(stages, p, paths, i, before);
    };
    if constexpr (Case::listed) {
        PathList<Case> list(target, paths, count);
        for (int i = 0; i < count; i += 4)
            if (!list.add(i)) [[unlikely]] {
                list.draw();
                for (int k = i; k < i + 4 && k < count; ++k) {
                    p.cells = list.cells(k);
                    walk(k);
                }
            }
        list.draw();
    } else if constexpr (Case::patterned) {
        DitherCells<Case::swaps> cells;
        p.cells = numeric::factor32(cells.words());
        const int together = paths.one_color ? count : 1;
        for (int first = 0; first < count; first += together) {
            cells.make(static_cast<std::uint32_t>(paths.at(Paths::flat, first)), target.color_stride / 2);
            // The loop counts `left` down, so that its bound needs no register.
            for (int left = together, i = first; left > 0; --left, ++i)
                walk(i);
        }
    } else {
        for (int i = 0; i < count; ++i)
            walk(i);
    }
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
