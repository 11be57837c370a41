// Texture coordinates of the balanced and fast tiers. Between two divisions a coordinate follows a straight
// line.
#pragma once

#include "raster/ops/log2.hpp"
#include "raster/ops/run_steps.hpp"
#include "raster/ops/stage_color.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/of_tier.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

namespace inner {

/// The projective planes of one unit's coordinates along a row.
struct HomogeneousRow {
    std::uint64_t s0, t0, q0, ds, dt, dq;
    SPANGLE_INLINE HomogeneousRow(const Span<Fixed>& span, int unit)
        : s0(span.at(0, span.unit[unit].s)), t0(span.at(0, span.unit[unit].t)), ds(span.unit[unit].s.dx),
          dt(span.unit[unit].t.dx) {
        const auto& plane = span.unit[unit].shares_q ? span.q : span.unit[unit].q;
        q0 = span.at(0, plane);
        dq = plane.dx;
    }
    SPANGLE_INLINE std::int32_t s(std::int32_t x) const { return at(x, s0, ds); }
    SPANGLE_INLINE std::int32_t t(std::int32_t x) const { return at(x, t0, dt); }
    SPANGLE_INLINE std::int32_t q(std::int32_t x) const { return at(x, q0, dq); }
    /// Makes pixel x the pixel at which the row begins.
    SPANGLE_RUN_INLINE void begin_at(std::int32_t x) {
        if (x == 0) // the row begins there already, unless it is clipped
            return;
        s0 += numeric::times(ds, x);
        t0 += numeric::times(dt, x);
        q0 += numeric::times(dq, x);
    }

  private:
    SPANGLE_RUN_INLINE static std::int32_t at(std::int32_t x, std::uint64_t v, std::uint64_t dv) {
        return unguarded(v + numeric::times(dv, x));
    }
};

/// s / q in repeats with 32 fraction bits, from the 61-bit product. Where the shift is to the left, the
/// result is modulo 2^64. In this case |s| is beyond 2^10 repeats, and the low bits of its fraction are 0.
SPANGLE_RUN_INLINE std::int64_t to_repeats(std::int32_t s, const Inverse& inverse, int exponent) {
    const std::int64_t product = numeric::mul_s32_u32(s, inverse.mantissa);
    const int down = 30 - inverse.zeros - exponent;
    if constexpr (!numeric::wide_words)
        if (down > 0 && down < 32) [[likely]]
            return numeric::words_after(product, down);
    return numeric::times_two_to(product, -down);
}

/// The low word of to_repeats(), which is the fraction of a repeat. Wrapping keeps only this word.
SPANGLE_INLINE std::uint32_t repeat_fraction(std::int32_t s, const Inverse& inverse, int exponent) {
    if constexpr (!numeric::wide_words) {
        const int down = 30 - inverse.zeros - exponent;
        if (down > 0 && down < 32) [[likely]]
            return numeric::low_word_after(numeric::mul_s32_u32(s, inverse.mantissa), down);
    }
    return static_cast<std::uint32_t>(to_repeats(s, inverse, exponent));
}

/// A coordinate in the form that texture stages read (TexCoords). It wraps, or it is saturated and has its
/// whole repeats added back.
SPANGLE_INLINE std::uint32_t to_coord(std::int64_t repeats, bool wraps, std::int32_t base) {
    if (wraps)
        return static_cast<std::uint32_t>(repeats);
    const std::int64_t v =
        (repeats >> (32 - clamped_coord_bits)) + (std::int64_t{base} << clamped_coord_bits);
    return static_cast<std::uint32_t>(numeric::saturate_i32(v));
}

/// d / n modulo 2^32, where `length` is Inverse(n). The result is off by up to 2^-30 of itself plus 1. It is
/// 0 for n <= 0.
inline std::uint32_t slope(std::int64_t d, std::int32_t n, const Inverse& length) {
    if (n <= 0 || d == 0)
        return 0;
    const int zeros = length.zeros;
    const std::uint32_t inverse = length.mantissa; // 2^(62 - zeros) / n
    const std::uint64_t magnitude = numeric::abs_u64(d);
    const int down = magnitude >> 32 == 0 ? 0 : 32 - numeric::clz64(magnitude);
    const std::uint64_t product = numeric::mul_u32(static_cast<std::uint32_t>(magnitude >> down), inverse);
    const int to_right = 62 - zeros - down; // at least -1, as n < 2^31
    const auto quotient = to_right >= 32 ? static_cast<std::uint32_t>(product >> 32) >> (to_right - 32)
                                         : static_cast<std::uint32_t>(to_right >= 0 ? product >> to_right
                                                                                    : product << -to_right);
    return d < 0 ? 0 - quotient : quotient;
}

/// Logarithms that bound the length of runs, with 8 fraction bits. Each is within 1/256.
struct RunBound {
    std::int32_t n;       ///< logarithm of |N| in texels, of the larger of both axes; N = dS Q - S dQ
    std::int32_t dq;      ///< logarithm of |dQ|
    std::int32_t repeats; ///< logarithm of |N| in repeats
    RunBound(const Span<Fixed>& span, int unit, const HomogeneousRow& row) {
        const std::int32_t s0 = row.s(0), t0 = row.t(0), q0 = row.q(0);
        const std::int32_t by = unguarded(row.dq);
        // The numerator N is off by at most Q + |S|, because gradients have lost the bits below their last
        // one.
        const auto numerator = [&](std::uint64_t dv, std::int32_t v) SPANGLE_RUN_LAMBDA {
            return numeric::abs_u64(numeric::mul_s32(unguarded(dv), q0) - numeric::mul_s32(v, by)) +
                   (std::uint64_t{1} << 31);
        };
        const std::uint64_t ns = numerator(row.ds, s0), nt = numerator(row.dt, t0);
        const std::int32_t width = span.state->log2_width[unit] << 8,
                           height = span.state->log2_height[unit] << 8;
        // The logarithm is monotonic, so the logarithm of the larger numerator is enough.
        repeats = log2_fraction8(ns > nt ? ns : nt);
        n = repeats + (ns > nt ? width : height);
        if (width != height) {
            const std::int32_t other = ns > nt ? log2_fraction8(nt) + height : log2_fraction8(ns) + width;
            n = n > other ? n : other;
        }
        dq = log2_fraction8(numeric::abs_u64(by) + 1);
    }
};

} // namespace inner

/// Coordinates that are affine between the ends of runs. Runs start at multiples of their length from the
/// anchor.
///
/// The length is a power of two, which is chosen per span. The error of the affine form is proven to be at
/// most 2^-texel_bits texel of the base level (Knobs), which is a quarter in the balanced tier.
///
/// In one row N = dS Q - S dQ is constant, and du/dx = N / Q^2. So a run of L pixels has |du| <= L |N| /
/// min(Q)^2 and |dq| = L |dQ|. Its error is at most |du| |dq| / (4 min(Q)) (docs/architecture/fragments.md,
/// "Runs of texture coordinates"). A quarter therefore needs L^2 <= min(Q)^3 / (|N| |dQ|).
///
/// The fast tier takes runs of at least 16 pixels. Longer runs are taken where they are proven to be off by
/// at most half a texel. Where 1/w does not change along the row, the row is one run. A short row is also one
/// run where |du| |dq| / (4 min(Q)) between its ends is at most half of the allowed error.
class CoordRuns {
    template <class Runs> friend void continue_run(Runs& runs, std::int32_t from);
    template <class Runs> friend void prepare_runs(Runs& runs);

  public:
    std::uint32_t s; ///< coordinates at the current pixel, as in TexCoords; ds is their difference per pixel

  private:
    /// run_end_ lies between s and t, so that no compiler stores four words as one. Narrower loads would wait
    /// for such a store.
    std::int32_t run_end_;

  public:
    std::uint32_t t, ds;

  private:
    int log2_run_;

  public:
    std::uint32_t dt;

    SPANGLE_INLINE CoordRuns(const Span<Fixed>& span, std::int32_t x, int unit)
        : run_end_(x), log2_run_(-1), row_(span, unit),
          both_wrap_(span.state->wraps[unit].s && span.state->wraps[unit].t), unit_(unit), span_(&span) {}

    /// Makes s and t valid at pixel x, and returns the end of its run.
    SPANGLE_INLINE std::int32_t begin(std::int32_t x) { return x < run_end_ ? run_end_ : start_run(x); }
    SPANGLE_INLINE void step() {
        s += ds;
        t += dt;
    }

  private:
    struct DividedCoord {
        std::int64_t s, t; ///< coordinates in repeats, with 32 fraction bits; run_start_ has followed() ones
        DividedCoord() = default;
        SPANGLE_INLINE DividedCoord(const inner::HomogeneousRow& row, int exponent)
            : DividedCoord(row, 0, Inverse(row.q(0)), exponent) {}
        SPANGLE_RUN_INLINE DividedCoord(const inner::HomogeneousRow& row, std::int32_t x,
                                        const Inverse& inverse, int exponent) {
            s = inner::to_repeats(row.s(x), inverse, exponent);
            t = inner::to_repeats(row.t(x), inverse, exponent);
        }
    };

    SPANGLE_RUN_SELDOM std::int32_t start_run(std::int32_t x) {
        if (log2_run_ < 0) {
            if (span_->length <= short_row && is_one_run(x))
                return run_end_;
            start_first_run(x);
        }
        const std::int32_t from = run_end_;
        run_end_ += std::int32_t{1} << log2_run_;
        continue_run(*this, from);
        if (x != from) {
            s += static_cast<std::uint32_t>(x - from) * ds;
            t += static_cast<std::uint32_t>(x - from) * dt;
        }
        return run_end_;
    }
    /// Whether the run that ends at run_end_ ends within the row.
    SPANGLE_INLINE bool is_whole_run() const { return run_end_ < span_->length; }
    /// Makes a run for which is_whole_run() holds, from run_steps_.
    SPANGLE_INLINE void make_whole_run() {
        row_.q0 += run_steps_.q;
        const Inverse inverse(row_.q(0), w_zeros_);
        // The coordinates are computed one after the other, which takes few registers.
        const auto along = [&](std::uint64_t& row, std::uint64_t run, std::int64_t& last, const bool& wraps,
                               const std::int32_t& base, std::uint32_t& v, std::uint32_t& dv)
                               SPANGLE_RUN_INLINE_LAMBDA {
                                   row += run;
                                   std::int64_t end = inner::to_repeats(unguarded(row), inverse, exponent_);
                                   if (!both_wrap_)
                                       end = followed(end, wraps, base);
                                   v = static_cast<std::uint32_t>(last);
                                   dv = per_pixel(difference(end, last));
                                   last = end;
                               };
        const auto& wraps = span_->state->wraps[unit_];
        const auto& unit = span_->unit[unit_];
        along(row_.s0, run_steps_.s, run_start_.s, wraps.s, unit.s_base, s, ds);
        along(row_.t0, run_steps_.t, run_start_.t, wraps.t, unit.t_base, t, dt);
    }
    /// Prepares make_whole_run().
    SPANGLE_INLINE void set_run_steps() {
        run_steps_ = {row_.ds << log2_run_, row_.dt << log2_run_, row_.dq << log2_run_};
    }
    /// Tries to take a short row as one run. Its ends cost less than logarithms, and bound the error better.
    /// Returns false where the row needs several runs, or where its coordinates saturate.
    SPANGLE_RUN_SELDOM bool is_one_run(std::int32_t x) {
        if (!both_wrap_)
            return false;
        const int exponent = span_->unit[unit_].exponent;
        const std::int32_t steps = span_->length - 1;
        const Inverse first(row_.q(0)), last(row_.q(steps));
        const DividedCoord begin(row_, 0, first, exponent), end(row_, steps, last, exponent);
        const std::int64_t s_range = difference(end.s, begin.s), t_range = difference(end.t, begin.t);
        const auto by_s = static_cast<std::int32_t>(s_range), by_t = static_cast<std::int32_t>(t_range);
        if (by_s != s_range || by_t != t_range)
            return false;
        const std::uint32_t least = first.q < last.q ? first.q : last.q,
                            range = first.q < last.q ? last.q - first.q : first.q - last.q;
        // The limit is half of the allowed error. Four times this half is 2^(1 - texel_bits). The value is
        // not used where `asks` is false.
        const int up = of_straight_tier<[](const Knobs& k) {
            return 33 - (1 << k.shortest_run < short_row ? k.texel_bits : balanced_knobs.texel_bits);
        }>(*span_->state);
        const auto within = [&](std::int32_t v, int log2_size) {
            return numeric::mul_u32(numeric::abs_u32(v), range) <= std::uint64_t{least} << (up - log2_size);
        };
        const bool asks =
            of_straight_tier<[](const Knobs& k) { return 1 << k.shortest_run < short_row; }>(*span_->state);
        if (asks && !(within(by_s, span_->state->log2_width[unit_]) &&
                      within(by_t, span_->state->log2_height[unit_])))
            return false;
        const std::int32_t n = steps > 0 ? steps : 1;
        ds = static_cast<std::uint32_t>(by_s / n);
        dt = static_cast<std::uint32_t>(by_t / n);
        s = static_cast<std::uint32_t>(begin.s) + static_cast<std::uint32_t>(x) * ds;
        t = static_cast<std::uint32_t>(begin.t) + static_cast<std::uint32_t>(x) * dt;
        run_end_ = span_->length;
        return true;
    }
    /// A coordinate as runs follow it: repeats where it wraps, and otherwise the number that to_coord()
    /// makes.
    SPANGLE_RUN_INLINE static std::int64_t followed(std::int64_t repeats, bool wraps, std::int32_t base) {
        return wraps ? repeats
                     : std::int64_t{static_cast<std::int32_t>(inner::to_coord(repeats, false, base))};
    }
    /// The coordinates where row_ begins, as runs follow them.
    SPANGLE_RUN_INLINE DividedCoord followed_coord() const {
        const auto& unit = span_->unit[unit_];
        const auto& wraps = span_->state->wraps[unit_];
        DividedCoord v(row_, exponent_);
        v.s = followed(v.s, wraps.s, unit.s_base);
        v.t = followed(v.t, wraps.t, unit.t_base);
        return v;
    }
    /// Finds the start of the first run of a row.
    SPANGLE_RUN_SELDOM void start_first_run(std::int32_t x) {
        log2_run_ = choose_log2();
        run_end_ = x & -(std::int32_t{1} << log2_run_);
        row_.begin_at(run_end_);
        exponent_ = span_->unit[unit_].exponent;
        run_start_ = followed_coord();
        prepare_runs(*this);
    }
    /// Makes any run, also one that the end of the row cuts short.
    SPANGLE_RUN_SELDOM void start_clipped_run(std::int32_t from) {
        const std::int32_t limit = span_->length - 1, to = run_end_ < limit ? run_end_ : limit;
        row_.begin_at(to - from);
        const DividedCoord end = followed_coord();
        const Inverse length = to == run_end_ ? Inverse{} : Inverse(to - from);
        const auto along = [&](std::int64_t v0, std::int64_t v1, std::uint32_t& v, std::uint32_t& dv)
                               SPANGLE_RUN_LAMBDA {
                                   v = static_cast<std::uint32_t>(v0);
                                   const std::int64_t d = difference(v1, v0);
                                   dv = to == run_end_ ? per_pixel(d) : inner::slope(d, to - from, length);
                               };
        along(run_start_.s, end.s, s, ds);
        along(run_start_.t, end.t, t, dt);
        run_start_.s = end.s; // a copy of the whole pair would be a call of memcpy()
        run_start_.t = end.t;
    }

  public: // packets use what follows, because they find several runs at once
    static constexpr std::int32_t short_row = 16;
    /// max_log2 is log2 of 64 pixels, and row_log2 stands for the whole row.
    static constexpr int max_log2 = 6, row_log2 = 16;

  private:
    /// The difference of the coordinates at a run's ends, divided by the run's length.
    SPANGLE_INLINE std::uint32_t per_pixel(std::int64_t d) const {
        if constexpr (numeric::wide_words)
            return static_cast<std::uint32_t>(d >> log2_run_);
        return static_cast<std::uint32_t>(d) >> log2_run_ | static_cast<std::uint32_t>(d >> 32)
                                                                << 1 << (31 - log2_run_);
    }

  public:
    SPANGLE_INLINE static std::int64_t difference(std::int64_t a, std::int64_t b) {
        return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b));
    }

    int choose_log2() const {
        if (row_.dq == 0)
            return row_log2;
        const DrawState& draw = *span_->state;
        const std::int32_t shortest =
            of_straight_tier<[](const Knobs& k) { return std::int32_t{k.shortest_run}; }>(draw);
        if (shortest != 0 && span_->length <= 1 << shortest)
            return shortest;
        const bool any_length =
            of_straight_tier<[](const Knobs& k) { return max_log2 < k.longest_run; }>(draw);
        const std::int32_t longest =
            any_length && both_wrap_ // coordinates that do not wrap saturate
                ? of_straight_tier<[](const Knobs& k) { return std::int32_t{k.longest_run}; }>(draw)
                : of_straight_tier<[](const Knobs& k) {
                      return std::int32_t{k.longest_run < max_log2 ? k.longest_run : max_log2};
                  }>(draw);
        const std::int32_t q0 = row_.q(0), end = row_.q(span_->length - 1);
        const std::int32_t least = q0 < end ? q0 : end;
        if (least <= 0)
            return shortest;
        const inner::RunBound bound(*span_, unit_, row_);
        // The margin allows for three logarithms. texel_bits - 2 is added to it, because the square of the
        // length grows with the allowed error times four.
        const std::int32_t margin =
            of_straight_tier<[](const Knobs& k) { return 6 + 256 * (k.texel_bits - 2); }>(draw);
        const std::int32_t square = 3 * log2_fraction8(static_cast<std::uint64_t>(least)) - bound.n -
                                    bound.dq - (span_->unit[unit_].exponent << 8) - margin;
        const std::int32_t log2 = square >> 9;
        return log2 < shortest ? shortest : log2 > longest ? longest : log2;
    }

  private:
    // The members that each run uses come first, because short load instructions reach 128 bytes.
    inner::HomogeneousRow row_; ///< begins where the last sample was taken
    struct {
        std::uint64_t s, t, q;
    } run_steps_; ///< differences from run to run
    DividedCoord run_start_;
    bool both_wrap_;                                        ///< true if s and t both wrap
    [[no_unique_address]] numeric::LeadingZeros<> w_zeros_; ///< leading zeros of w at the ends of runs
    int exponent_, unit_;
    const Span<Fixed>* span_;
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
