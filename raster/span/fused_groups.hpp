// Rows in groups of eight lanes, as far as scissor rectangles have eight columns.
#pragma once

#include <bit>
#include <cstdint>

#include "raster/span/rows.hpp"
#include "raster/span/stage.hpp"
#include "raster/span/stage_guess.hpp"

namespace spangle::raster {

/// Lanes [first, last) live.
SPANGLE_INLINE Lanes<8>::Mask some_lanes(std::int32_t first, std::int32_t last) {
    constexpr std::uint16_t on = 0xFFFF;
    static constexpr std::uint16_t at[24] = {0, 0, 0, 0, 0, 0, 0, 0, on, on, on, on, on, on, on, on};
    using L = Lanes<8>;
    const auto from = [](std::int32_t lane) {
        return L::load(reinterpret_cast<const std::uint8_t*>(at + lane));
    };
    return from(8 - first) & ~from(8 - last);
}

/// Columns [row.first, row.last) in groups of eight lanes, the last of them with lanes that are dead: these
/// keep what they hold, and lie inside of the scissor rectangle, whose last group starts at column `room`.
/// draw(n): the list is at a group of which lanes from n on are dead.
template <PixelFormat Format, class N, class List, class Draw>
SPANGLE_INLINE void each_group(List& list, Px<N>& p, PlaneRow& at, const Row& row, std::int32_t room,
                               Draw draw) {
    at.x = row.first < room ? row.first : room;
    at.y = row.y;
    at.counted_from = at.x;
    point_at(at.color, at.depth, *at.planes.target, at.x, at.y, format_info(Format).bytes_per_pixel, 1);
    list.start(at, 0);
    p.color_plane = at.color;
    p.depth_plane = at.depth;
    std::int32_t first = row.first - at.x;
    const std::int32_t last = row.last - at.x, most = room - at.x;
    for (p.i = 0;; p.i += 8) {
        if (p.i > most) [[unlikely]] {
            first = p.i - most;
            p.i = most;
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

template <class Case>
SPANGLE_INLINE void fused_plain_rows(Span<Fixed>& span, const Row* row, const Row* end) {
    const Rect& clip = span.state->fragment.scissor;
    const std::int32_t room = clip.x + clip.w - 8;
    PlaneRow at{span, nullptr, nullptr, row->first, row->y, row->first};
    typename Case::template List<8> list(at, 0);
    do {
        Px<typename Case::template System<8>> p(at);
        p.open = Lanes<8>::Mask{};
        each_group<Case::key.format>(
            list, p, at, *row, room, [&](std::int32_t) __attribute__((always_inline)) {
                list(p);
                if constexpr (Case::guessed)
                    if (p.open &= p.live; Lanes<8>::any(p.open)) [[unlikely]]
                        divide_open<Case::key.format>(span, p.color_plane + 2 * p.i, p.open, at.x + p.i,
                                                      at.y);
            });
    } while (++row != end);
}

} // namespace spangle::raster
