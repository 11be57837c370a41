// Rows of which every fragment divides, in eight lanes: pieces of a primitive over which 16 bits are enough.
#pragma once

#include "raster/span/fused_groups.hpp"
#include "raster/span/stage_lit.hpp"

namespace spangle::raster {

/// Around the fragments of rows, from one amidst them: planes of thin triangles are steep beside these.
struct PatchOfRows {
    Patch patch;
    bool fits;
    std::int32_t count;                    ///< of fragments
    static constexpr std::int32_t few = 6; ///< one by one they take less than a patch
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
};

/// Those of a patch, or false. Case has: key, LitPatch, List; redo(span, row) draws a fragment with one lane,
/// without a test of its depth.
template <class Case>
[[gnu::noinline]] bool draw_patch(Span<Fixed>& span, const Row* row, const Row* end, std::int32_t room) {
    using Lit = typename Case::Lit;
    const PatchOfRows rows(row, end);
    typename Lit::Patch patch;
    if (rows.count < PatchOfRows::few || !rows.fits || !patch.set(span, rows.patch)) [[unlikely]]
        return false;
    LitRow<typename Lit::Patch> at{{span, nullptr, nullptr, row->first, row->y, row->first}, patch};
    typename Lit::List list(at, 0);
    const Surface target = *span.target; // in registers
    Px<Raw565<8>> p(at);
    p.open = Lanes<8>::Mask{};
    do {
        each_group<Case::key.format>(
            list, p, at, target, *row, room, [&](std::int32_t) __attribute__((always_inline)) {
                list(p);
                if (p.open &= p.live; Lanes<8>::any(p.open)) [[unlikely]]
                    each_open(p.open, [&](int i) {
                        const std::int32_t x = at.x + p.i + i;
                        Lit::redo(span, {at.y, x, x + 1, x, x + 1});
                    });
            });
    } while (++row != end);
    return true;
}

/// `narrow` draws what there are no lanes for.
template <class Case, class Narrow>
SPANGLE_INLINE void fused_divided_rows(Span<Fixed>& span, const Row* row, const Row* end, Narrow narrow) {
    const Rect& clip = span.state->fragment.scissor;
    const std::int32_t room = clip.x + clip.w - 8;
    for (std::ptrdiff_t n = end - row; row != end;) {
        const Row* const stop = end - row < n ? end : row + n;
        if (draw_patch<Case>(span, row, stop, room)) [[likely]] {
            row = stop;
        } else if (n > 1) {
            n = (n + 1) / 2;
        } else {
            constexpr std::int32_t columns = 32;
            for (Row piece = *row; piece.first != row->last; piece.first = piece.last) {
                piece.last = row->last - piece.first < columns ? row->last : piece.first + columns;
                if (!draw_patch<Case>(span, &piece, &piece + 1, room))
                    narrow(span, piece);
            }
            ++row;
        }
    }
}

} // namespace spangle::raster
