// Texture coordinates of a fragment: affine, divided at every fragment, or divided at the ends of runs.
#pragma once

#include "raster/span/stage_color.hpp"

namespace spangle::raster {

template <class N, int Unit, bool Projective> struct Coord;

/// Affine over the primitive.
template <class N, int Unit> struct Coord<N, Unit, false> : StageBase {
    static constexpr unsigned out = field_coord << Unit;
    std::uint32_t s, t, ds, dt;
    SPANGLE_INLINE Coord(const Span<Fixed>& span, std::int32_t x)
        : s(span.s[Unit].at(x)), t(span.t[Unit].at(x)), ds(span.s[Unit].dx), dt(span.t[Unit].dx) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) {
        std::uint32_t at_s = s, at_t = t;
        for (int lane = 0; lane < N::lanes; ++lane) {
            p.coord[Unit].s[lane] = at_s;
            p.coord[Unit].t[lane] = at_t;
            at_s += ds;
            at_t += dt;
        }
        return true;
    }
    SPANGLE_INLINE void step() {
        s += static_cast<std::uint32_t>(N::lanes) * ds;
        t += static_cast<std::uint32_t>(N::lanes) * dt;
    }
};

namespace detail {

/// The projective interpolants of one unit at one pixel of a span.
struct Homogeneous {
    std::int32_t s, t, q;
    SPANGLE_INLINE Homogeneous(const Span<Fixed>& span, int unit, std::int32_t x)
        : s(unguarded(span.unit[unit].s.at(x))), t(unguarded(span.unit[unit].t.at(x))),
          q(unguarded(span.unit[unit].shares_q ? span.q.at(x) : span.unit[unit].q.at(x))) {}
};

/// s / q in repeats with 32 fraction bits, from the 61-bit product: mod 2^64 where the shift is to the left
/// (then |s| is beyond 2^10 repeats and its fraction means nothing).
SPANGLE_INLINE std::int64_t to_repeats(std::int32_t s, const Inverse& inverse, int exponent) {
    const std::int64_t product = std::int64_t{s} * inverse.mantissa;
    const int down = 30 - inverse.zeros - exponent;
    if (down >= 0)
        return product >> (down < 63 ? down : 63);
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(product) << (-down < 63 ? -down : 63));
}

/// As the texture stage wants it (TexCoords): wrapping, or saturated with the whole repeats added back.
SPANGLE_INLINE std::uint32_t to_coord(std::int64_t repeats, bool wraps, std::int32_t base) {
    if (wraps)
        return static_cast<std::uint32_t>(repeats);
    const std::int64_t v =
        (repeats >> (32 - clamped_coord_bits)) + (std::int64_t{base} << clamped_coord_bits);
    return static_cast<std::uint32_t>(numeric::saturate_i32(v));
}

} // namespace detail

/// Exact tier: one division per fragment. None where 1/w does not change along the row: the inverse is kept.
template <int Unit> struct Coord<Exact, Unit, true> : StageBase {
    using N = Exact;
    static constexpr unsigned out = field_coord << Unit;
    std::uint64_t s, t, q, ds, dt, dq;
    Inverse inverse;
    int exponent;
    std::int32_t s_base, t_base;
    bool s_wraps, t_wraps;

    SPANGLE_INLINE Coord(const Span<Fixed>& span, std::int32_t x)
        : s(span.unit[Unit].s.at(x)), t(span.unit[Unit].t.at(x)),
          q(span.unit[Unit].shares_q ? span.q.at(x) : span.unit[Unit].q.at(x)), ds(span.unit[Unit].s.dx),
          dt(span.unit[Unit].t.dx), dq(span.unit[Unit].shares_q ? span.q.dx : span.unit[Unit].q.dx),
          inverse(unguarded(q)), exponent(span.unit[Unit].exponent), s_base(span.unit[Unit].s_base),
          t_base(span.unit[Unit].t_base), s_wraps(span.state->wraps[Unit].s),
          t_wraps(span.state->wraps[Unit].t) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) {
        if (dq != 0)
            inverse = Inverse(unguarded(q));
        p.coord[Unit].s[0] =
            detail::to_coord(detail::to_repeats(unguarded(s), inverse, exponent), s_wraps, s_base);
        p.coord[Unit].t[0] =
            detail::to_coord(detail::to_repeats(unguarded(t), inverse, exponent), t_wraps, t_base);
        return true;
    }
    SPANGLE_INLINE void step() {
        s += ds;
        t += dt;
        q += dq;
    }
};

/// Balanced and fast tiers: affine between the ends of runs. A run of 16 pixels is halved until the error of
/// the affine form is proven to be at most 1/4 texel of the base level: |du| |dq| <= 4 tol min(q0, q1)
/// (numerics.md 1.2); the fast tier takes 16 pixels always. Runs depend on the anchor and the span only,
/// never on where drawing starts.
template <int Unit> class CoordRuns {
  public:
    std::uint32_t s, t, ds, dt;

    SPANGLE_INLINE CoordRuns(const Span<Fixed>& span, std::int32_t x)
        : span_(span), next_(x), started_(false) {}

    /// Makes s, t, ds, dt valid at pixel x; returns the end of its run.
    std::int32_t begin(std::int32_t x) {
        if (started_ && x < next_)
            return next_;
        std::int32_t from = x & -run_length, length = run_length;
        if (started_) { // runs that hold the pixel before x, too, are known to be too long
            const std::int32_t aligned = x & -x;
            length = aligned != 0 && aligned < run_length ? aligned : run_length;
            from = x;
        } else {
            first_ = Sample(span_, from);
        }
        started_ = true;
        for (;;) {
            const std::int32_t limit = span_.length - 1;
            const std::int32_t to = from + length < limit ? from + length : limit;
            const Sample last(span_, to);
            if (length == 1 || affine(first_, last)) {
                set(last, from, to, x);
                next_ = from + length;
                first_ = last; // the next run's first, unless the span ends here
                return next_;
            }
            length >>= 1;
            if (x >= from + length) {
                from += length;
                first_ = Sample(span_, from);
            }
        }
    }

    SPANGLE_INLINE void step() {
        s += ds;
        t += dt;
    }

  private:
    struct Sample {
        std::int64_t s, t; ///< repeats, 32 fraction bits
        std::int32_t q;
        Sample() = default;
        Sample(const Span<Fixed>& span, std::int32_t x) {
            const detail::Homogeneous h(span, Unit, x);
            const Inverse inverse(h.q);
            s = detail::to_repeats(h.s, inverse, span.unit[Unit].exponent);
            t = detail::to_repeats(h.t, inverse, span.unit[Unit].exponent);
            q = h.q > 0 ? h.q : 1;
        }
    };

    /// The bound, with 4 tol = 1 texel; 8 of the 32 fraction bits are rounded away, upwards.
    bool affine(const Sample& a, const Sample& b) const {
        if (span_.state->tier == Tier::fast)
            return true;
        const auto least = static_cast<std::uint32_t>(a.q < b.q ? a.q : b.q);
        const std::uint32_t dq = numeric::abs_u32(b.q - a.q);
        const auto within = [&](std::int64_t u0, std::int64_t u1, int log2_size) {
            const std::uint64_t du = numeric::abs_u64(difference(u1, u0)) >> 8;
            return du < 0xFFFFFFFFu && (du + 1) * dq <= std::uint64_t{least} << (24 - log2_size);
        };
        return within(a.s, b.s, span_.state->log2_width[Unit]) &&
               within(a.t, b.t, span_.state->log2_height[Unit]);
    }

    SPANGLE_INLINE static std::int64_t difference(std::int64_t a, std::int64_t b) {
        return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b));
    }

    /// d / n, n 0 .. 16.
    SPANGLE_INLINE static std::uint32_t slope(std::int64_t d, std::int32_t n) {
        if (n == run_length)
            return static_cast<std::uint32_t>(d >> 4);
        constexpr auto inverse = [] {
            struct {
                std::uint32_t of[run_length];
            } table{};
            for (std::uint32_t i = 1; i < run_length; ++i)
                table.of[i] = ((1u << 21) / i + 1) / 2; // 20 fraction bits
            return table;
        }();
        return static_cast<std::uint32_t>((static_cast<std::uint64_t>(d) * inverse.of[n]) >> 20);
    }

    void set(const Sample& last, std::int32_t from, std::int32_t to, std::int32_t x) {
        const std::int32_t n = to - from;
        const auto& unit = span_.unit[Unit];
        const auto skip = static_cast<std::uint32_t>(x - from);
        const auto along = [&](std::int64_t v0, std::int64_t v1, bool wraps, std::int32_t base,
                               std::uint32_t& v, std::uint32_t& dv) {
            v = detail::to_coord(v0, wraps, base);
            dv = wraps ? slope(difference(v1, v0), n)
                       : slope(std::int64_t{static_cast<std::int32_t>(detail::to_coord(v1, false, base))} -
                                   static_cast<std::int32_t>(v),
                               n);
            v += skip * dv;
        };
        along(first_.s, last.s, span_.state->wraps[Unit].s, unit.s_base, s, ds);
        along(first_.t, last.t, span_.state->wraps[Unit].t, unit.t_base, t, dt);
    }

    const Span<Fixed>& span_;
    Sample first_;
    std::int32_t next_;
    bool started_;
};

template <class N, int Unit> struct Coord<N, Unit, true> : StageBase {
    static constexpr unsigned out = field_coord << Unit;
    static constexpr bool runs = N::lanes == 1;
    CoordRuns<Unit> run;
    std::int32_t x, next;
    SPANGLE_INLINE Coord(const Span<Fixed>& span, std::int32_t first)
        : run(span, first), x(first), next(first) {}
    SPANGLE_INLINE std::int32_t begin(std::int32_t at) { return run.begin(at); }
    SPANGLE_INLINE bool operator()(Px<N>& p) {
        for (int lane = 0; lane < N::lanes; ++lane) {
            if constexpr (N::lanes > 1) { // lanes of one group may lie in several runs
                if (x == next)
                    next = run.begin(x);
                ++x;
            }
            p.coord[Unit].s[lane] = run.s;
            p.coord[Unit].t[lane] = run.t;
            if constexpr (N::lanes > 1)
                run.step();
        }
        return true;
    }
    SPANGLE_INLINE void step() {
        if constexpr (N::lanes == 1)
            run.step();
    }
};

} // namespace spangle::raster
