// Texture coordinates of the exact tier. Between two divisions a coordinate follows a cubic.
#pragma once

#include "raster/numeric/reciprocal.hpp"
#include "raster/ops/coord_runs.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Forward differences of a cubic. They wrap, as coordinates do.
struct Differences {
    std::uint32_t first, second, third;
    SPANGLE_INLINE void step(std::uint32_t& v) {
        v += first;
        first += second;
        second += third;
    }
    SPANGLE_INLINE bool straight() const { return (second | third) == 0; }
    /// The value n pixels after the pixel of v; n may be negative. A row that is one run may be so wide that
    /// n^2 does not fit a word. All sums and products are modulo 2^32.
    SPANGLE_INLINE constexpr std::uint32_t value_after(std::uint32_t v, std::int32_t n) const {
        return v + static_cast<std::uint32_t>(n) * first + choose_2(n) * second + choose_3(n) * third;
    }
    constexpr void jump(std::uint32_t& v, std::int32_t n) {
        v = value_after(v, n);
        first += static_cast<std::uint32_t>(n) * second + choose_2(n) * third;
        second += static_cast<std::uint32_t>(n) * third;
    }

  private:
    /// n (n - 1) / 2. The even factor is halved before it is multiplied.
    SPANGLE_INLINE static constexpr std::uint32_t choose_2(std::int32_t n) {
        const std::int32_t odd = n & 1;
        return static_cast<std::uint32_t>(n >> (1 - odd)) * static_cast<std::uint32_t>((n - 1) >> odd);
    }
    /// n (n - 1) (n - 2) / 6. The product of choose_2(n) and n - 2 is three times this number. Modulo 2^32 a
    /// division by 3 is a multiplication by 0xAAAAAAAB, the inverse of 3.
    SPANGLE_INLINE static constexpr std::uint32_t choose_3(std::int32_t n) {
        return choose_2(n) * static_cast<std::uint32_t>(n - 2) * 0xAAAAAAABu;
    }
};

/// Coordinates that are divided at every fragment.
class DividedCoords {
  public:
    std::uint32_t s, t; ///< coordinates at the current pixel, as in TexCoords

    SPANGLE_INLINE DividedCoords(const Span<Fixed>& span, std::int32_t, int unit)
        : span_(&span), row_{{span, span.unit[unit].s},
                             {span, span.unit[unit].t},
                             {span, span.unit[unit].shares_q ? span.q : span.unit[unit].q}},
          unit_(unit) {}
    [[gnu::noinline]] std::int32_t begin(std::int32_t x) {
        divide(*span_, row_, unit_, x, s, t);
        return x + 1;
    }
    SPANGLE_INLINE void step() {}

    /// Finds s and t at pixel x.
    template <class Row>
    SPANGLE_INLINE static void divide(const Span<Fixed>& span, const Row& row, int unit_index, std::int32_t x,
                                      std::uint32_t& s, std::uint32_t& t) {
        const auto& unit = span.unit[unit_index];
        const auto& wraps = span.state->wraps[unit_index];
        const Inverse inverse(row.q(x));
        s = inner::to_coord(inner::to_repeats(row.s(x), inverse, unit.exponent), wraps.s, unit.s_base);
        t = inner::to_coord(inner::to_repeats(row.t(x), inverse, unit.exponent), wraps.t, unit.t_base);
    }

  private:
    struct Rows {
        GuardedRow along_s, along_t, along_q;
        SPANGLE_INLINE std::int32_t s(std::int32_t x) const { return along_s.value(x); }
        SPANGLE_INLINE std::int32_t t(std::int32_t x) const { return along_t.value(x); }
        SPANGLE_INLINE std::int32_t q(std::int32_t x) const { return along_q.value(x); }
    };
    const Span<Fixed>* span_;
    Rows row_;
    int unit_;
};

/// Coordinates that follow cubics between the ends of runs. Runs start at multiples of their length from the
/// anchor.
///
/// In one row u = S / Q has u' = N / Q^2, where N = dS Q - S dQ is constant. So the difference D of u over a
/// run of L pixels gives both slopes: L u' is D Q1 / Q0 at the start and D Q0 / Q1 at the end. Hermite's
/// cubic through both ends is off by at most L^4 max |u''''| / 384, with |u''''| = 24 |N dQ^3 / Q^5|.
///
/// The length is a power of two, which is chosen per span. It keeps the error at most 2^-texel_bits texel of
/// the base level (Knobs). In the exact tier this is 2^-13, which is the tolerance of NEAREST
/// (nearest_bias_bits). A length of 1 means one division per fragment.
///
/// Where 1/w changes so little along the row that a straight line is as good, the row is one run. Coordinates
/// that do not wrap are divided at every fragment, because they saturate.
class CubicRuns {
  public:
    std::uint32_t s, t; ///< coordinates at the current pixel, as in TexCoords

    SPANGLE_INLINE CubicRuns(const Span<Fixed>& span, std::int32_t x, int unit)
        : span_(&span), row_(span, unit), unit_(unit), run_end_(x), log2_run_(unknown) {}

    /// Makes s and t valid at pixel x, and returns the end of its run.
    SPANGLE_INLINE std::int32_t begin(std::int32_t x) { return x < run_end_ ? run_end_ : start_run(x); }
    SPANGLE_INLINE void step() {
        ds.step(s);
        dt.step(t);
    }

    Differences ds, dt; ///< differences from pixel to pixel

    /// True where the row has no runs, and each of its fragments is divided. This may only be called before
    /// the first run.
    template <int lanes = host_lanes> SPANGLE_INLINE bool divides_each_fragment() {
        static_assert(lanes > 1, "the length stays known until start_run()");
        const int log2 = choose_log2();
        log2_run_ = unknown - 1 - log2;
        return log2 == 0;
    }

  private:
    /// Stands for a length that is not known yet. Smaller numbers hold a length that divides_each_fragment()
    /// has found, but with which begin() has not started.
    static constexpr int unknown = -1;
    /// max_log2 is log2 of 16 pixels, and row_log2 stands for the whole row.
    static constexpr int max_log2 = 4, row_log2 = 16;
    static constexpr int ratio_bits = 26;

    struct DividedCoord {
        std::int64_t s, t; ///< coordinates in repeats, with 32 fraction bits
        std::int32_t q, zeros;
        std::uint32_t mantissa;
        DividedCoord() = default;
        SPANGLE_INLINE DividedCoord(const inner::HomogeneousRow& row, std::int32_t x, int exponent)
            : q(row.q(x)) {
            const Inverse inverse(q);
            zeros = inverse.zeros;
            mantissa = inverse.mantissa;
            s = inner::to_repeats(row.s(x), inverse, exponent);
            t = inner::to_repeats(row.t(x), inverse, exponent);
        }
        /// d / q with ratio_bits fraction bits.
        SPANGLE_INLINE std::int32_t quotient_of(std::int32_t d) const {
            return static_cast<std::int32_t>(numeric::mul_s32_u32(d, mantissa) >> (62 - ratio_bits - zeros));
        }
    };

    /// The difference modulo 2^64, as to_repeats() returns coordinates that are far outside of the texture.
    SPANGLE_INLINE static std::int64_t difference(std::int64_t a, std::int64_t b) {
        return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b));
    }

    [[gnu::noinline]] std::int32_t start_run(std::int32_t x) {
        const auto& unit = span_->unit[unit_];
        const bool first = log2_run_ < 0;
        if (first)
            log2_run_ = host_lanes > 1 && log2_run_ != unknown ? unknown - 1 - log2_run_ : choose_log2();
        if (log2_run_ == 0)
            return one_pixel(x);
        const bool whole = log2_run_ == row_log2;
        const std::int32_t length = whole ? span_->length - 1 : 1 << log2_run_,
                           from = whole ? 0 : x & -length;
        const DividedCoord start = first ? DividedCoord(row_, from, unit.exponent) : run_start_;
        run_start_ = DividedCoord(row_, from + length, unit.exponent);
        s = static_cast<std::uint32_t>(start.s);
        t = static_cast<std::uint32_t>(start.t);
        if (whole) {
            const Inverse steps(length);
            ds = {inner::slope(difference(run_start_.s, start.s), length, steps), 0, 0};
            dt = {inner::slope(difference(run_start_.t, start.t), length, steps), 0, 0};
            run_end_ = span_->length;
        } else {
            const std::int32_t dq = run_start_.q - start.q, e0 = start.quotient_of(dq),
                               e1 = run_start_.quotient_of(dq);
            ds = differences_through(difference(run_start_.s, start.s), e0, e1);
            dt = differences_through(difference(run_start_.t, start.t), e0, e1);
            run_end_ = from + length;
        }
        if (const std::int32_t skipped = x - from; skipped != 0) {
            ds.jump(s, skipped);
            dt.jump(t, skipped);
        }
        return run_end_;
    }

    /// Divides at one fragment, which is a run by itself.
    std::int32_t one_pixel(std::int32_t x) {
        DividedCoords::divide(*span_, row_, unit_, x, s, t);
        ds = dt = {};
        run_end_ = x + 1;
        return run_end_;
    }

    /// Forward differences of the cubic a x + b x^2 + c x^3, where x is 1 after a run of L pixels. a = D (1 +
    /// e0), b = D (e1 - 2 e0), c = D (e0 - e1). The slopes at the ends are D (1 + e0) and D / (1 + e0) = D (1
    /// - e1).
    Differences differences_through(std::int64_t d, std::int32_t e0, std::int32_t e1) const {
        const std::int64_t d0 = d * e0 >> ratio_bits, d1 = d * e1 >> ratio_bits;
        const std::int64_t length = std::uint32_t{1}
                                    << log2_run_; // unsigned, so the compiler knows that it is above 0
        const std::int64_t c = d0 - d1, b = (d1 - 2 * d0) * length, a = (d + d0) * length * length;
        const int bits = 3 * log2_run_;
        const auto down = [bits, half = std::uint32_t{1} << (bits - 1)](std::int64_t v) {
            return numeric::low_word_after(v + half, bits);
        };
        return {down(a + b + c), down(2 * b + 6 * c), down(6 * c)};
    }

    int choose_log2() const {
        const auto& unit = span_->unit[unit_];
        if (!span_->state->wraps[unit_].s || !span_->state->wraps[unit_].t)
            return 0;
        if (row_.dq == 0)
            return row_log2;
        // The last run may reach beyond the span by a quarter of its length. The 30-bit values then stay
        // below 2^31.
        const auto quarter = static_cast<std::uint32_t>(span_->length - 1) >> 2;
        if (quarter < 2)
            return 0;
        const std::int32_t longest = 31 - numeric::clz32(quarter), reach = static_cast<std::int32_t>(quarter);
        const std::int32_t end = row_.q(span_->length - 1 + reach), q0 = row_.q(0);
        const std::int32_t least = q0 < end ? q0 : end;
        if (least <= 0)
            return 0;
        const inner::RunBound bound(*span_, unit_, row_);
        const std::int32_t q = log2_fraction8(static_cast<std::uint64_t>(least)),
                           exponent = unit.exponent << 8;
        // differences_through() takes differences of at most 16 repeats, and ratios of 1/q of at most 2.
        if (bound.repeats + exponent > 2 * q)
            return 0;
        // A straight row is off by at most L^2 |N| |dQ| / (4 Q^3). The margin allows for three logarithms.
        const std::int32_t straight_margin =
            of_cubic_tier<[](const Knobs& k) { return 6 + ((k.texel_bits - 2) << 8); }>(*span_->state);
        const std::int32_t square = 3 * q - bound.n - bound.dq - exponent - straight_margin;
        if (square >> 8 >= 2 * (32 - numeric::clz32(static_cast<std::uint32_t>(span_->length))))
            return row_log2;
        const std::int32_t doubled = (q - bound.dq - 2) >> 8;
        // The margin allows for nine logarithms. The fourth power of the length is at most 384 / 24 = 16
        // times the error.
        const std::int32_t margin =
            of_cubic_tier<[](const Knobs& k) { return 10 + ((k.texel_bits - 4) * 256); }>(*span_->state);
        const std::int32_t fourth = (5 * q - bound.n - 3 * bound.dq - exponent - margin) >> 10;
        const std::int32_t log2 = fourth < doubled ? fourth : doubled;
        const std::int32_t limit = of_cubic_tier<[](const Knobs& k) {
            return std::int32_t{k.longest_run < max_log2 ? k.longest_run : max_log2};
        }>(*span_->state);
        const std::int32_t most = longest < limit ? longest : limit;
        return log2 < 0 ? 0 : log2 > most ? most : log2;
    }

    const Span<Fixed>* span_;
    inner::HomogeneousRow row_;
    int unit_;
    DividedCoord run_start_;
    std::int32_t run_end_;
    int log2_run_;
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
