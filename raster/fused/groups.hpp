// Draws rows in groups of eight lanes. It serves scissor rectangles of at least eight columns.
#pragma once

#include <bit>
#include <cstdint>

#include "raster/ops/stage.hpp"
#include "raster/ops/stage_guess.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/rows.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// The mask in which lanes [first, last) are alive.
SPANGLE_INLINE Lanes<8>::Mask some_lanes(std::int32_t first, std::int32_t last) {
    constexpr std::uint16_t on = 0xFFFF;
    static constexpr std::uint16_t at[24] = {0, 0, 0, 0, 0, 0, 0, 0, on, on, on, on, on, on, on, on};
    using L = Lanes<8>;
    const auto from = [](std::int32_t lane) {
        return L::load(reinterpret_cast<const std::uint8_t*>(at + lane));
    };
    return from(8 - first) & ~from(8 - last);
}

/// Goes along columns [row.first, row.last) in groups of eight lanes. The last group has dead lanes, whose
/// pixels keep their bits. All groups lie inside of the scissor rectangle, whose last group starts at column
/// `room`. Calls draw(n) for each group, when the list has stepped to it. Lanes from n on are dead.
template <PixelFormat Format, class N, class List, class At, class Draw>
SPANGLE_INLINE void each_group(List& list, Px<N>& p, At& at, const Surface& target, const Row& row,
                               std::int32_t room, Draw draw) {
    at.x = row.first < room ? row.first : room;
    at.y = row.y;
    at.dither_column = at.x;
    point_at(at.color, at.depth, target, at.x, at.y, format_info(Format).bytes_per_pixel, 1);
    list.start(at, 0);
    p.color_plane = at.color;
    p.depth_plane = at.depth;
    std::int32_t first = row.first - at.x;
    const std::int32_t last = row.last - at.x, most = room - at.x;
    for (p.go_to(0);; p.go_to(p.i + 8)) {
        if (p.i > most) [[unlikely]] {
            first = p.i - most;
            p.go_to(most);
            list.start(at, most);
        }
        const std::int32_t n = last - p.i < 8 ? last - p.i : 8;
        p.live = some_lanes(first, n);
        draw(n);
        if (p.i + 8 >= last)
            return;
        list.step();
        first = 0;
    }
}

/// The mask of the first n lanes, 0 < n < 2^15. All lanes are in it where n is 8 or more.
SPANGLE_INLINE Lanes<8>::Mask first_lanes(std::int32_t n) {
    using L = Lanes<8>;
    return L::less_signed(L::offsets16(L::splat(1), L::splat(0)), L::splat(static_cast<std::uint32_t>(n)));
}

/// Goes along columns [first, last) of the row at `row`, in groups of eight lanes. The scissor rectangle must
/// hold seven more columns. The stages of the list must have been started at the first column. Calls draw(n)
/// for each group, when the list has stepped to it. The first n lanes are alive; n may be more than eight.
template <bool Tested, class N, class List, class Draw>
SPANGLE_INLINE void each_whole_group(List& list, Px<N>& p, const RowPlace& row, std::int32_t first,
                                     std::int32_t last, Draw draw) {
    p.color_plane = row.color + std::ptrdiff_t{first} * 2;
    if constexpr (Tested)
        p.depth_plane = row.depth + std::ptrdiff_t{first} * 2;
    p.go_to(0);
    for (std::int32_t left = last - first;;) {
        p.live = first_lanes(left);
        draw(left);
        left -= 8;
        if (left <= 0)
            return;
        list.step();
        p.color_plane += 16;
        if constexpr (Tested)
            p.depth_plane += 16;
    }
}

/// The addresses of column 0 of a row.
template <class Case> SPANGLE_INLINE RowPlace row_of(const Surface& target, std::int32_t y) {
    return {target.color + std::ptrdiff_t{y} * target.color_stride,
            Case::tested ? target.depth + std::ptrdiff_t{y} * target.depth_stride : nullptr};
}

/// A row for stages of depth and colours. It holds copies of planes, which can stay in registers: a store of
/// pixels might change the originals.
struct PlainRow {
    Span<Fixed>& planes;
    std::uint8_t *color, *depth;
    std::int32_t x, y, dither_column; ///< as the members of PlaneRow with these names
    std::int32_t anchor_x = planes.anchor_x, anchor_y = planes.anchor_y;
    Span<Fixed>::Affine z = planes.z, color_value[3] = {planes.color_value[0], planes.color_value[1],
                                                        planes.color_value[2]};
    std::uint32_t flat_word = planes.flat_word;
    const inner::Half* words = nullptr; ///< the words of this row in DitherLaneRows

    template <class T> SPANGLE_INLINE T at(std::int32_t column, const Interpolant<T>& plane) const {
        return plane.at(column + (x - anchor_x), y - anchor_y);
    }
};

/// Handles the fragments that a guess left open. They are divided at once.
template <class Case> struct DivideOpen {
    using Row = std::conditional_t<Case::plain, PlainRow, PlaneRow>;
    /// Handles one group; p is at column x of the row.
    template <class P> SPANGLE_INLINE void operator()(Row& row, P& p, std::int32_t x) const {
        if constexpr (Case::guessed)
            if (p.open &= p.live; Lanes<8>::any(p.open)) [[unlikely]]
                divide_open<Case::key.format>(row.planes, p.color_plane + p.bytes(), p.open, x, row.y);
    }
};

/// Draws rows group by group. Most rows of most primitives are one group, so little is done per row. Where
/// fragments are cheap, no branch depends on the picture.
template <class Case, class Open = DivideOpen<Case>> class LaneRows {
  public:
    using At = typename Open::Row;
    using Pattern = typename Case::LanePattern;
    SPANGLE_INLINE LaneRows(Span<Fixed>& span, std::int32_t y, const Pattern& pattern)
        : LaneRows(At{span, nullptr, nullptr, span.anchor_x, y, span.anchor_x}, Open{}, pattern) {}
    SPANGLE_INLINE LaneRows(const At& at, const Open& open, const Pattern& pattern)
        : row_position_(at), stages_(row_position_, 0), p_(row_position_), open_(open), pattern_(pattern) {}

    /// Draws columns [first, last) of row y, whose address is `row`. The scissor rectangle must hold seven
    /// more columns.
    SPANGLE_INLINE void draw(const RowPlace& row, std::int32_t y, std::int32_t first, std::int32_t last) {
        enter(y);
        row_position_.x = first;
        stages_.start(row_position_, 0);
        each_whole_group<Case::tested>(
            stages_, p_, row, first,
            last, [&](std::int32_t left) __attribute__((always_inline)) { group(last - left); });
    }
    SPANGLE_INLINE void next_row() {}

    /// Draws a row of a primitive. The last group in the scissor rectangle starts at column `room`.
    SPANGLE_INLINE void draw(const Surface& target, const Row& row, std::int32_t room) {
        if (row.last <= room) [[likely]]
            return draw(row_of<Case>(target, row.y), row.y, row.first, row.last);
        enter(row.y);
        each_group<Case::key.format>(
            stages_, p_, row_position_, target, row,
            room, [&](std::int32_t) __attribute__((always_inline)) { group(row_position_.x + p_.i); });
    }

    SPANGLE_INLINE Open& open() { return open_; }

  private:
    SPANGLE_INLINE void enter(std::int32_t y) {
        row_position_.y = y;
        if constexpr (!std::is_same_v<Pattern, NoPattern>)
            row_position_.words = pattern_.row(y);
    }
    /// Runs the list on a group that starts at column x.
    SPANGLE_INLINE void group(std::int32_t x) {
        if constexpr (Case::plain)
            stages_.all(p_);
        else if (!stages_(p_))
            return;
        open_(row_position_, p_, x);
    }

    At row_position_;
    typename Case::template List<8> stages_;
    Px<typename Case::template System<8>> p_;
    [[no_unique_address]] Open open_;
    const Pattern& pattern_;
};

template <class Case>
SPANGLE_INLINE void fused_plain_rows(Span<Fixed>& span, const Row* row, const Row* end) {
    const Rect& clip = span.state->fragment.scissor;
    const std::int32_t room = clip.x + clip.w - 8;
    const Surface target = *span.target; // a copy, which stays in registers
    const typename Case::LanePattern pattern(span.flat_word);
    LaneRows<Case> rows(span, row->y, pattern);
    do
        rows.draw(target, *row, room);
    while (++row != end);
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
