// Finds the lengths of runs of texture coordinates, for eight rows at once. The integers are those of
// CoordRuns::choose_log2().
#pragma once

#include "raster/ops/coord_runs.hpp"
#include "raster/ops/lane_log2.hpp"
#include "raster/ops/packet_rows.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// The limits of a draw for CoordRuns. The formulas of CoordRuns are repeated here, so that its code in
/// firmware does not change.
struct RunLimits {
    std::int32_t shortest, longest; ///< log2 of the shortest and longest run, in pixels
    std::int32_t margin;            ///< allows for three logarithms and the error, with 8 fraction bits
    RunLimits(const DrawState& draw, int unit)
        : shortest(of_straight_tier<[](const Knobs& k) { return std::int32_t{k.shortest_run}; }>(draw)),
          longest(of_straight_tier<[](const Knobs& k) { return std::int32_t{k.longest_run}; }>(draw)),
          margin(of_straight_tier<[](const Knobs& k) { return 256 * k.texel_bits - 506; }>(draw)) {
        const auto& wraps = draw.wraps[unit];
        // Coordinates that do not wrap saturate. Runs of more than 64 pixels would interpolate them wrongly
        // where they do.
        if (longest > CoordRuns::max_log2 && !(wraps.s && wraps.t))
            longest = CoordRuns::max_log2;
    }
};

/// Logarithms of the lengths of runs in rows that begin at these places, which count from the anchor. Callers
/// never ask about rows that are not longer than the shortest runs.
SPANGLE_INLINE LaneWords run_log2s(const Span<Fixed>& span, int which, const LaneWords& x, const LaneWords& y,
                                   const LaneWords& length) {
    const auto& unit = span.unit[which];
    const Span<Fixed>::Projective& q_plane = unit.shares_q ? span.q : unit.q;
    if (q_plane.dx == 0)
        return LaneWords::splat(CoordRuns::row_log2);
    const DrawState& draw = *span.state;
    const RunLimits limits(draw, which);
    const std::int32_t by = unguarded(q_plane.dx);
    const std::int32_t less =
        log2_fraction8(numeric::abs_u64(std::int64_t{by}) + 1) + (unit.exponent << 8) + limits.margin;
    const PlaneInRows q(q_plane);
    return LaneWords::mapped(
        [&](const auto& s, const auto& t, const auto& q0, const auto& end) __attribute__((always_inline)) {
            using Vector = std::remove_cvref_t<decltype(s)>;
            const auto numerator = [&](const Vector& v, std::uint64_t dv, int log2_size)
                __attribute__((always_inline)) {
                // 2^31 is added as in RunBound, so that runs have the same lengths.
                return inner::lane_log2(inner::derivative(unguarded(dv), v, by, q0) +
                                        (std::int64_t{1} << 31)) +
                       (static_cast<std::uint32_t>(log2_size) << 8);
            };
            const Vector of_s = numerator(s, unit.s.dx, draw.log2_width[which]),
                         of_t = numerator(t, unit.t.dx, draw.log2_height[which]);
            const Vector least = lane_words::smaller(q0, end),
                         low = Vector{} + static_cast<std::uint32_t>(limits.shortest),
                         high = Vector{} + static_cast<std::uint32_t>(limits.longest);
            const Vector square = inner::lane_log2(inner::at_least_one(least)) * 3u -
                                  lane_words::larger(of_s, of_t) - static_cast<std::uint32_t>(less);
            const auto log2 = std::bit_cast<Vector>(lane_words::as_signed(square) >> 9);
            const Vector none = lane_words::is_less(log2, low) | lane_words::is_less(least, Vector{} + 1u);
            return (low & none) | (lane_words::smaller(log2, high) & ~none);
        },
        PlaneInRows(unit.s).at(x, y), PlaneInRows(unit.t).at(x, y), q.at(x, y),
        q.at(x + length - LaneWords::splat(1), y));
}

/// Finds the lengths of a group of eight rows. The last group may have fewer rows.
[[gnu::noinline]] inline void find_runs(const Span<Fixed>& span, int unit, const RowRuns& runs,
                                        RowRuns::Group& group) {
    alignas(32) std::uint32_t x[8], y[8], length[8];
    for (std::int32_t i = 0; i < 8; ++i) {
        const std::int32_t n = 8 * group.number + i;
        const Row& row = runs.rows[n < runs.count ? n : runs.count - 1];
        x[i] = static_cast<std::uint32_t>(row.left - span.anchor_x);
        y[i] = static_cast<std::uint32_t>(row.y - span.anchor_y);
        length[i] = static_cast<std::uint32_t>(row.right - row.left);
    }
    using L = Lanes<8>;
    run_log2s(span, unit, L::gather(x), L::gather(y), L::gather(length))
        .store(reinterpret_cast<std::uint8_t*>(group.log2));
}

/// The logarithm of the length of runs in one row. The lengths of a group are found when one of its rows is
/// first asked for.
SPANGLE_INLINE std::int32_t run_log2(const Span<Fixed>& span, int unit, RowRuns& runs, std::uint32_t row) {
    RowRuns::Group& group = runs.known[unit][row / 8 % 2];
    const auto number = static_cast<std::int32_t>(row / 8);
    if (group.number != number) {
        group.number = number;
        find_runs(span, unit, runs, group);
    }
    return static_cast<std::int32_t>(group.log2[row % 8]);
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
