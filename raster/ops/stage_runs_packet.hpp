// Texture coordinates of the balanced and fast tiers, a packet at a time. The integers are those of
// CoordRuns. The ends of all runs are divided together, in lanes. The fragments between two ends are a ramp.
// Only instruction sets that divide in lanes use it.
#pragma once

#include "raster/ops/lane_division.hpp"
#include "raster/ops/packet.hpp"
#include "raster/ops/run_lengths.hpp"
#include "raster/ops/stage_coord.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

namespace inner {

/// Mantissas of Inverse(n) for n pixels, for all n below the longest common length of runs (max_log2).
struct ShortRuns {
    std::uint32_t mantissa[1 << CoordRuns::max_log2];
    constexpr ShortRuns() : mantissa{} {
        for (std::uint32_t n = 1; n < 1 << CoordRuns::max_log2; ++n)
            mantissa[n] = numeric::reciprocal(n << numeric::clz32(n));
    }
};
inline constexpr ShortRuns short_runs;

} // namespace inner

/// Finds the runs of one unit in which the fragments of a packet lie.
template <class Places> class PacketRuns {
    static constexpr std::int32_t lanes = Places::lanes;
    static_assert(lanes == 8);

  public:
    template <int Unit> static void run(Places& k, const Span<Fixed>& span) {
        if (k.rows == nullptr && k.n <= short_row)
            return chain_stage<Raw565<lanes>, Coord<Raw565<1>, Unit, true>>(k, span);
        run(k, span, Unit);
    }

  private:
    /// Up to this many fragments of one row take longer in lanes than one by one.
    static constexpr std::int32_t short_row = 8;

    [[gnu::noinline]] static void run(Places& k, const Span<Fixed>& span, int unit) {
        PacketRuns(k, span, unit).find(k.coord[unit]);
    }

    /// The fragments of one row that lie in the packet.
    struct Part {
        std::uint32_t left, y; ///< position of pixel 0 of the row, counted from the anchor
        std::int32_t length, number;
        std::int32_t x, at, n; ///< pixel and packet index of the first fragment; number of fragments
        std::int32_t first_end;
        std::int32_t log2; ///< log2 of the length of runs, or `whole`
    };
    static constexpr std::int32_t whole = -1;

    /// The largest number of ends in a packet. A part has at most one more end than it has fragments.
    static constexpr std::int32_t most_ends = 2 * packet_length;
    static constexpr std::int32_t few_ends = 2; ///< up to this many ends take longer in lanes than one by one

    PacketRuns(const Places& k, const Span<Fixed>& span, int unit)
        : packet_(k), span_(span), unit_(span.unit[unit]), wraps_s_(span.state->wraps[unit].s),
          wraps_t_(span.state->wraps[unit].t), unit_number_(unit),
          log2_shortest_run_(RunLimits(*span.state, unit).shortest),
          shortest_run_(log2_shortest_run_ != 0 && (unit_.shares_q ? span.q : unit_.q).dx != 0
                            ? 1 << log2_shortest_run_
                            : 0) {
        if (k.rows == nullptr) {
            std::int32_t number = 0;
            if constexpr (divides_in_lanes)
                number = k.row.number;
            add_part(span.x, span.y, span.length, number, k.x, 0, k.n);
            return;
        }
        for (const Piece *piece = k.rows->piece, *end = piece + k.rows->pieces; piece != end; ++piece) {
            const Row& row = piece->row;
            add_part(row.left, row.y, row.right - row.left, piece->number, row.first - row.left, piece->at,
                     row.last - row.first);
        }
    }
    SPANGLE_INLINE void add_part(std::int32_t left, std::int32_t y, std::int32_t length, std::int32_t number,
                                 std::int32_t x, std::int32_t at, std::int32_t n) {
        Part& part = row_parts_[part_count_++];
        part.left = static_cast<std::uint32_t>(left - span_.anchor_x);
        part.y = static_cast<std::uint32_t>(y - span_.anchor_y);
        part.length = length;
        part.number = number;
        part.x = x;
        part.at = at;
        part.n = n;
        if (wraps_s_ && wraps_t_ && length <= CoordRuns::short_row)
            plan_whole_row(part);
        else
            plan_runs(part);
    }

    template <class Coord> SPANGLE_INLINE void find(Coord* to) {
        divide();
        PacketBits open = 0; // a bit says that the part of its number has a row of more than one run
        for (std::int32_t n = 0; n < part_count_; ++n) {
            if (row_parts_[n].log2 != whole)
                store_runs(row_parts_[n]);
            else if (!store_whole_row(row_parts_[n]))
                open |= PacketBits{1} << n;
        }
        if (open != 0)
            store_open_rows(open);
        for (std::int32_t i = 0; i < packet_.n; i += lanes, ++to) {
            __builtin_memcpy(to->s, s_ + i, sizeof to->s);
            __builtin_memcpy(to->t, t_ + i, sizeof to->t);
        }
    }
    [[gnu::noinline]] void store_open_rows(PacketBits open) {
        end_count_ = 0;
        for (PacketBits left = open; left != 0; left &= left - 1)
            plan_runs(row_parts_[std::countr_zero(left)]);
        divide();
        for (PacketBits left = open; left != 0; left &= left - 1) {
            const Part& part = row_parts_[std::countr_zero(left)];
            std::uint32_t *const s = s_ + part.at + part.n, *const t = t_ + part.at + part.n;
            // Ramps write behind the part, too, so the words there are restored.
            const auto behind_s = Lanes<8>::gather(s), behind_t = Lanes<8>::gather(t);
            store_runs(part);
            store(s, behind_s);
            store(t, behind_t);
        }
    }

    // The next three functions find the places of the ends.

    SPANGLE_INLINE void plan_whole_row(Part& part) {
        part.log2 = whole;
        part.first_end = end_count_;
        end_columns_[end_count_] = part.left;
        end_columns_[end_count_ + 1] = part.left + static_cast<std::uint32_t>(part.length - 1);
        y_[end_count_] = y_[end_count_ + 1] = part.y;
        end_count_ += 2;
    }
    [[gnu::noinline]] void plan_runs(Part& part) {
        part.log2 = log2_of(part);
        part.first_end = end_count_;
        const std::int32_t step = std::int32_t{1} << part.log2, first = part.x & -step,
                           runs = (part.x + part.n - first + step - 1) >> part.log2,
                           end = first + (runs << part.log2), last = part.length - 1;
        fill(end_columns_ + end_count_, part.left + static_cast<std::uint32_t>(first),
             static_cast<std::uint32_t>(step), runs);
        fill(y_ + end_count_, part.y, 0, runs);
        end_count_ += runs;
        if (step == 1) // runs of one pixel need no end
            return;
        end_columns_[end_count_] = part.left + static_cast<std::uint32_t>(end < last ? end : last);
        y_[end_count_++] = part.y;
    }
    SPANGLE_INLINE std::int32_t log2_of(const Part& part) {
        if (part.length <= shortest_run_)
            return log2_shortest_run_;
        if constexpr (divides_in_lanes)
            if (packet_.row.runs != nullptr)
                return run_log2(span_, unit_number_, *packet_.row.runs,
                                static_cast<std::uint32_t>(part.number));
        if (packet_.rows != nullptr)
            enter(packet_.rows->span, packet_.rows->piece[&part - row_parts_].row);
        return CoordRuns(span_, 0, unit_number_).choose_log2();
    }

    // The next functions find w, s and t at each end. s and t are in repeats where they wrap, and otherwise
    // in the form in which they are stored.

    SPANGLE_INLINE void divide() {
        const auto& q_plane = unit_.shares_q ? span_.q : unit_.q;
        if (end_count_ > few_ends)
            divide_in_lanes(q_plane);
        else
            divide_each(q_plane);
    }
    [[gnu::noinline]] void divide_each(const Span<Fixed>::Projective& q_plane) {
        const int exponent = unit_.exponent;
        for (std::int32_t i = 0; i < end_count_; ++i) {
            const auto x = static_cast<std::int32_t>(end_columns_[i]), y = static_cast<std::int32_t>(y_[i]);
            const Inverse inverse(unguarded(q_plane.at(x, y)));
            q_at_[i] = inverse.q;
            s_at_[i] = stored(inner::to_repeats(unguarded(unit_.s.at(x, y)), inverse, exponent), wraps_s_,
                              unit_.s_base);
            t_at_[i] = stored(inner::to_repeats(unguarded(unit_.t.at(x, y)), inverse, exponent), wraps_t_,
                              unit_.t_base);
        }
    }
    SPANGLE_INLINE static std::int64_t stored(std::int64_t repeats, bool wraps, std::int32_t base) {
        return wraps ? repeats : static_cast<std::int32_t>(inner::to_coord(repeats, false, base));
    }
    [[gnu::noinline]] void divide_in_lanes(const Span<Fixed>::Projective& q_plane) {
        store(end_columns_ + end_count_,
              LaneWords::splat(end_columns_[0])); // lanes beyond the last end repeat the first end
        store(y_ + end_count_, LaneWords::splat(y_[0]));
        const PlaneInRows s(unit_.s), t(unit_.t), q(q_plane);
        for (std::int32_t i = 0; i < end_count_; i += lanes) {
            const LaneWords x = Lanes<8>::gather(end_columns_ + i), y = Lanes<8>::gather(y_ + i);
            const InverseLanes inverse(q.at(x, y));
            store(q_at_ + i, inverse.q);
            inverse.repeats(s.at(x, y), unit_.exponent, wraps_s_, unit_.s_base, s_at_ + i);
            inverse.repeats(t.at(x, y), unit_.exponent, wraps_t_, unit_.t_base, t_at_ + i);
        }
    }

    // The next functions write the coordinates of the fragments between the ends.

    /// Returns false where the row needs several runs (CoordRuns::is_one_run()).
    SPANGLE_INLINE bool store_whole_row(const Part& part) {
        const std::int32_t begin = part.first_end, end = begin + 1;
        const std::int64_t s_range = CoordRuns::difference(s_at_[end], s_at_[begin]),
                           t_range = CoordRuns::difference(t_at_[end], t_at_[begin]);
        const auto by_s = static_cast<std::int32_t>(s_range), by_t = static_cast<std::int32_t>(t_range);
        if (by_s != s_range || by_t != t_range)
            return false;
        const DrawState& draw = *span_.state;
        if (1 << log2_shortest_run_ < CoordRuns::short_row) {
            const std::uint32_t q0 = q_at_[begin], q1 = q_at_[end], least = q0 < q1 ? q0 : q1,
                                range = q0 < q1 ? q1 - q0 : q0 - q1;
            // The limit is half of the allowed error. Four times this half is 2^(1 - texel_bits).
            const int up = of_straight_tier<[](const Knobs& k) { return 33 - k.texel_bits; }>(draw);
            const auto is_within = [&](std::int32_t v, int log2_size) __attribute__((always_inline)) {
                return numeric::mul_u32(numeric::abs_u32(v), range) <= std::uint64_t{least}
                                                                           << (up - log2_size);
            };
            if (!is_within(by_s, draw.log2_width[unit_number_]) ||
                !is_within(by_t, draw.log2_height[unit_number_]))
                return false;
        }
        const std::int32_t n = part.length > 1 ? part.length - 1 : 1;
        const auto ds = static_cast<std::uint32_t>(by_s / n), dt = static_cast<std::uint32_t>(by_t / n),
                   x = static_cast<std::uint32_t>(part.x);
        fill(s_ + part.at, static_cast<std::uint32_t>(s_at_[begin]) + x * ds, ds, part.n);
        fill(t_ + part.at, static_cast<std::uint32_t>(t_at_[begin]) + x * dt, dt, part.n);
        return true;
    }
    [[gnu::noinline]] void store_runs(const Part& part) {
        const std::int64_t *s = s_at_ + part.first_end, *t = t_at_ + part.first_end;
        std::uint32_t *to_s = s_ + part.at, *to_t = t_ + part.at;
        const int log2 = part.log2;
        if (log2 == 0)
            return put_ends(s, t, to_s, to_t, part.n);
        const std::int32_t step = std::int32_t{1} << log2, limit = part.length - 1, stop = part.x + part.n;
        for (std::int32_t x = part.x, from = x & -step; x < stop; ++s, ++t, from += step) {
            const std::int32_t next = from + step, end = next < stop ? next : stop, n = end - x;
            const std::int64_t by_s = CoordRuns::difference(s[1], s[0]),
                               by_t = CoordRuns::difference(t[1], t[0]);
            std::uint32_t ds, dt;
            if (next <= limit) {
                ds = static_cast<std::uint32_t>(by_s >> log2);
                dt = static_cast<std::uint32_t>(by_t >> log2);
            } else { // the end of the row cuts this run short
                const Inverse length = inverse_of(limit - from);
                ds = inner::slope(by_s, limit - from, length);
                dt = inner::slope(by_t, limit - from, length);
            }
            const auto skipped = static_cast<std::uint32_t>(x - from);
            fill(to_s, static_cast<std::uint32_t>(s[0]) + skipped * ds, ds, n);
            fill(to_t, static_cast<std::uint32_t>(t[0]) + skipped * dt, dt, n);
            to_s += n;
            to_t += n;
            x = end;
        }
    }
    SPANGLE_INLINE static void put_ends(const std::int64_t* s, const std::int64_t* t, std::uint32_t* to_s,
                                        std::uint32_t* to_t, std::int32_t n) {
        for (std::int32_t i = 0; i < n; ++i) {
            to_s[i] = static_cast<std::uint32_t>(s[i]);
            to_t[i] = static_cast<std::uint32_t>(t[i]);
        }
    }
    /// Gives Inverse(n), from a table where n is small.
    SPANGLE_INLINE static Inverse inverse_of(std::int32_t n) {
        if (n <= 0 || n >= std::int32_t{1} << CoordRuns::max_log2)
            return Inverse(n);
        Inverse inverse;
        inverse.q = static_cast<std::uint32_t>(n);
        inverse.zeros = numeric::clz32(inverse.q);
        inverse.mantissa = inner::short_runs.mantissa[n];
        return inverse;
    }
    /// Writes v, v + by, ... for n fragments. The last store goes on to the next multiple of the lanes.
    SPANGLE_INLINE static void fill(std::uint32_t* to, std::uint32_t v, std::uint32_t by, std::int32_t n) {
        LaneWords at = LaneWords::ramp(v, by);
        store(to, at);
        if (n <= lanes)
            return;
        const LaneWords step = LaneWords::splat(lanes * by);
        for (std::int32_t i = lanes; i < n; i += lanes) {
            at += step;
            store(to + i, at);
        }
    }
    SPANGLE_INLINE static void store(std::uint32_t* to, const LaneWords& v) {
        v.store(reinterpret_cast<std::uint8_t*>(to));
    }

    const Places& packet_;
    const Span<Fixed>& span_;
    const Span<Fixed>::Unit& unit_;
    const bool wraps_s_, wraps_t_;
    const int unit_number_;
    /// log2 of the length of the shortest runs. Rows of up to shortest_run_ pixels have runs of this length.
    const std::int32_t log2_shortest_run_, shortest_run_;
    std::int32_t part_count_ = 0, end_count_ = 0;
    Part row_parts_[packet_length];
    /// Places of the ends, counted from the anchor.
    std::uint32_t end_columns_[most_ends + lanes], y_[most_ends + lanes];
    std::uint32_t q_at_[most_ends + lanes];
    std::int64_t s_at_[most_ends + lanes], t_at_[most_ends + lanes];
    std::uint32_t s_[packet_length + lanes], t_[packet_length + lanes]; ///< coordinates of the fragments
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
