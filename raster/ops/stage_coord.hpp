// Texture coordinates of a fragment. They are affine over the primitive, or they follow runs.
#pragma once

#include "raster/ops/coord_runs.hpp"
#include "raster/ops/cubic_runs.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

template <class N, int Unit, bool Projective> struct Coord;

/// Coordinates that are affine over the primitive.
template <class N, int Unit> struct Coord<N, Unit, false> : StageBase {
    static constexpr unsigned out = field_coord << Unit;
    std::uint32_t s, t, ds, dt;
    SPANGLE_INLINE Coord(const Span<Fixed>& span, std::int32_t x)
        : s(span.at(x, span.s[Unit])), t(span.at(x, span.t[Unit])), ds(span.s[Unit].dx), dt(span.t[Unit].dx) {
    }
    SPANGLE_INLINE bool operator()(Px<N>& p) {
        for (std::uint32_t lane = 0; lane < N::lanes; ++lane) {
            p.coord[Unit].s[lane] = s + lane * ds;
            p.coord[Unit].t[lane] = t + lane * dt;
        }
        return true;
    }
    SPANGLE_INLINE void step() {
        s += std::uint32_t{N::lanes} * ds;
        t += std::uint32_t{N::lanes} * dt;
    }
};

template <class N, int Unit>
requires(N::lanes > 1) struct Coord<N, Unit, false> : StageBase {
    static constexpr unsigned out = field_coord << Unit;
    Ramp<typename N::L> s, t;
    template <class S>
    SPANGLE_INLINE Coord(const S& span, std::int32_t x)
        : s(span, x, span.s[Unit]), t(span, x, span.t[Unit]) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) {
        const auto put = [](std::uint32_t* to, const typename N::L::U32& v) {
            N::L::store32(reinterpret_cast<std::uint8_t*>(to), v);
        };
        put(p.coord[Unit].s, s.at);
        put(p.coord[Unit].t, t.at);
        return true;
    }
    SPANGLE_INLINE void step() {
        s.step();
        t.step();
    }
};

/// Takes the place of runs where coordinates are affine over the whole primitive.
struct NoRuns {
    SPANGLE_INLINE NoRuns(const Span<Fixed>&, std::int32_t, int) {}
};
template <class Runs> inline constexpr bool is_cubic = requires(Runs r) {
    r.ds.third;
};

/// A coordinate that steps along a row, on a straight line or on a cubic.
template <bool Cubic> struct CoordWalk {
    std::uint32_t at;
    std::conditional_t<Cubic, Differences, std::uint32_t> by;
    SPANGLE_INLINE std::uint32_t slope() const {
        if constexpr (Cubic)
            return by.first;
        else
            return by;
    }
    SPANGLE_INLINE std::uint32_t value_after(std::int32_t steps) const {
        if constexpr (Cubic)
            return by.value_after(at, steps);
        else
            return straight_ahead(static_cast<std::uint32_t>(steps));
    }
    SPANGLE_INLINE std::uint32_t straight_ahead(std::uint32_t steps) const { return at + steps * slope(); }
    SPANGLE_INLINE void step(std::int32_t steps) {
        if constexpr (!Cubic)
            at = value_after(steps);
        else if (steps == 1)
            by.step(at);
        else
            by.jump(at, steps);
    }
    SPANGLE_INLINE bool straight() const {
        if constexpr (Cubic)
            return by.straight();
        else
            return true;
    }
    SPANGLE_INLINE void step_straight(std::uint32_t steps) { at = straight_ahead(steps); }
    /// True where `at` >> shift stays the same over n steps. The n steps must be straight and go less than
    /// half a repeat.
    SPANGLE_INLINE bool constant(std::uint32_t n, int shift) const {
        const auto down = static_cast<std::int32_t>(slope());
        if (straight() && down == 0) // sprites have the step 0, for which no product is needed
            return true;
        // Most coordinates fail the first comparison, so the long product comes after it.
        return straight() && at >> shift == straight_ahead(n) >> shift &&
               numeric::mul_u32(numeric::abs_u32(down), n) < 1u << 31;
    }
};

/// The runs of texture coordinates in the tier of N: cubic between two divisions in the exact tier, straight
/// in the other tiers.
template <class N> using RunsOf = std::conditional_t<std::is_same_v<N, Exact>, CubicRuns, CoordRuns>;

template <class N, int Unit, class Runs> struct CoordAlong : StageBase {
    static_assert(N::lanes == 1);
    static constexpr unsigned out = field_coord << Unit;
    static constexpr bool runs = true;
    Runs run;
    SPANGLE_INLINE CoordAlong(const Span<Fixed>& span, std::int32_t first) : run(span, first, Unit) {}
    SPANGLE_INLINE std::int32_t begin(std::int32_t at) { return run.begin(at); }
    SPANGLE_INLINE bool operator()(Px<N>& p) {
        p.coord[Unit].s[0] = run.s;
        p.coord[Unit].t[0] = run.t;
        return true;
    }
    SPANGLE_INLINE void step() { run.step(); }
};
template <class N, int Unit> struct Coord<N, Unit, true> : CoordAlong<N, Unit, RunsOf<N>> {
    using CoordAlong<N, Unit, RunsOf<N>>::CoordAlong;
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
