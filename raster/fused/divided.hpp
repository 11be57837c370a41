// Draws rows whose fragments all divide. They are drawn in patches, which are pieces of a primitive over
// which 16 bits are enough.
#pragma once

#include "raster/fused/groups.hpp"
#include "raster/ops/stage_lit_one.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// A patch around the fragments of rows. Its place is a fragment in their middle, because the planes of thin
/// triangles are steep beside their fragments.
struct PatchOfRows {
    Patch patch;
    bool fits;
    std::int32_t count; ///< number of fragments
    /// Fewer fragments than this are drawn faster without a patch. `few` is for eight lanes, and
    /// `few_for_one` for one lane.
    static constexpr std::int32_t few = 6, few_for_one = 14;
    SPANGLE_INLINE PatchOfRows(const Row* row, const Row* end) {
        std::int32_t first = row->first, last = row->last;
        count = last - first;
        for (const Row* at = row + 1; at != end; ++at) {
            first = at->first < first ? at->first : first;
            last = at->last > last ? at->last : last;
            count += at->last - at->first;
        }
        const Row& middle = row[(end - row) / 2];
        patch.x = middle.first + (middle.last - middle.first) / 2;
        patch.y = middle.y;
        const std::int32_t left = patch.x - first, right = last - 1 - patch.x, below = patch.y - row->y,
                           above = end[-1].y - patch.y;
        patch.columns = left > right ? left : right;
        patch.rows = below > above ? below : above;
        fits = patch.columns <= Patch::most_columns && patch.rows <= Patch::most_rows;
    }
    /// Whether the rows have at least `least` fragments, so that patches pay.
    SPANGLE_INLINE static bool are_many(const Row* row, const Row* end, std::int32_t least) {
        std::int32_t count = 0;
        for (; row != end && count < least; ++row)
            count += row->last - row->first;
        return count >= least;
    }
};

/// Eight columns from column x on in row y, some of which a guess left open. The open fragments of many
/// groups are drawn again together.
struct OpenGroup {
    Lanes<8>::Mask open;
    std::int32_t x, y;
    /// The largest number of groups in a row of a patch.
    static constexpr int of_row = 2 * Patch::most_columns / 8 + 2;
};

/// Calls f(x, y) for each open fragment of the groups.
template <class F> SPANGLE_INLINE void each_open(const OpenGroup* group, const OpenGroup* end, F f) {
    for (; group != end; ++group)
        each_open(
            group->open, [&](int i) __attribute__((always_inline)) { f(group->x + i, group->y); });
}

/// Draws the fragments of a patch. Returns false where 16 bits are not enough, or where a patch does not pay.
/// Case::Lit has the members that LaneRows asks for, Patch, and redo_open(span, open, end). redo_open() draws
/// fragments again with one lane and without a depth test.
template <class Case>
[[gnu::noinline]] bool draw_patch(Span<Fixed>& span, const Row* row, const Row* end, std::int32_t room) {
    using Lit = typename Case::Lit;
    struct Collect {
        using Row = LitRow<typename Lit::Patch>;
        OpenGroup* end;
        /// Every group is written, so that no branch depends on whether it is open.
        SPANGLE_INLINE void operator()(const Row& at, const Px<typename Lit::N>& p, std::int32_t x) {
            const Lanes<8>::Mask open = p.open & p.live;
            *end = {open, x, at.y};
            end += Lanes<8>::any(open);
        }
    };
    const PatchOfRows rows(row, end);
    typename Lit::Patch patch;
    if (rows.count < PatchOfRows::few || !rows.fits || !patch.set(span, rows.patch)) [[unlikely]]
        return false;
    constexpr int most = 2 * OpenGroup::of_row;
    OpenGroup open[most];
    // The last group in a scissor rectangle may begin seven columns before the patch.
    const std::int32_t left = rows.patch.x - rows.patch.columns - 7;
    const NoPattern none(0);
    LaneRows<Lit, Collect> lanes({{span, nullptr, nullptr, left, row->y, left}, patch}, {open}, none);
    const Surface target = *span.target; // a copy, which stays in registers
    do {
        lanes.draw(target, *row, room);
        if (OpenGroup*& last = lanes.open().end; last - open > most - OpenGroup::of_row) [[unlikely]] {
            Lit::redo_open(span, open, last);
            last = open;
        }
    } while (++row != end);
    if (const OpenGroup* const last = lanes.open().end; last != open)
        Lit::redo_open(span, open, last);
    return true;
}

/// Does what draw_patch() does, one fragment at a time. Case has SingleLane, whose members are Patch, N, Test
/// and Draw.
template <class Case, class Products>
[[gnu::noinline]] bool draw_patch_one(Span<Fixed>& span, const Row* row, const Row* end) {
    using Lit = typename Case::template SingleLane<Products>;
    const PatchOfRows rows(row, end);
    typename Lit::Patch patch;
    if (rows.count < PatchOfRows::few_for_one || !rows.fits || !patch.set(span, rows.patch)) [[unlikely]]
        return false;
    LitRow<typename Lit::Patch> at{{span, nullptr, nullptr, row->first, row->y, row->first}, patch};
    typename Lit::Test test(at, 0);
    typename Lit::Draw fragment(at, 0);
    for (;;) {
        const RowPlace place = place_of<Case>(*span.target, *row, row->first);
        Px<typename Lit::N> p(place);
        const std::int32_t n = row->last - row->first;
        p.go_to(0);
        do {
            if (test(p) && !fragment.draw(p.i, place.color)) [[unlikely]]
                Case::Lit::redraw_fragment(span,
                                           {at.y, at.x + p.i, at.x + p.i + 1, at.x + p.i, at.x + p.i + 1});
            test.step();
            p.go_to(numeric::factor32(p.i + 1)); // one index serves all planes, not one pointer for each
        } while (p.i != n);
        if (++row == end)
            return true;
        at.x = row->first;
        at.y = row->y;
        test.start(at, 0);
        fragment.start(at, 0);
    }
}

/// Draws rows in as few patches as possible. draw() draws rows as one patch, or returns false where they need
/// several. narrow() draws pieces for which no patch is possible.
template <class Draw, class Narrow>
SPANGLE_INLINE void fused_divided_rows(Span<Fixed>& span, const Row* row, const Row* end, Draw draw,
                                       Narrow narrow) {
    for (std::ptrdiff_t n = end - row; row != end;) {
        const Row* const stop = end - row < n ? end : row + n;
        if (draw(span, row, stop)) [[likely]] {
            row = stop;
        } else if (n > 1) {
            n = (n + 1) / 2;
        } else {
            constexpr std::int32_t columns = 32;
            for (Row piece = *row; piece.first != row->last; piece.first = piece.last) {
                piece.last = row->last - piece.first < columns ? row->last : piece.first + columns;
                if (!draw(span, &piece, &piece + 1))
                    narrow(span, &piece, &piece + 1);
            }
            ++row;
        }
    }
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
