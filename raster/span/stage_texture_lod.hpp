// Level of detail (GL 1.3, 3.8.8): lambda = log2 of the largest derivative of u and v along x and y, which is
// one of the approximations the specification allows.
#pragma once

#include "raster/span/stage_coord.hpp"

namespace spangle::raster {

template <class N, int Unit> struct Lod : StageBase {
    static_assert(N::lanes == 1);
    static constexpr unsigned out = field_lod << Unit;
    const Span<Fixed>& span;
    std::int32_t x, constant;
    SPANGLE_INLINE Lod(const Span<Fixed>& s, std::int32_t first) : span(s), x(first), constant(0) {
        if (s.kind < Kind::textured)
            constant = affine();
    }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.lod[Unit][0] = span.kind < Kind::textured ? constant : projective();
        return true;
    }
    SPANGLE_INLINE void step() { ++x; }

  private:
    static std::uint64_t largest(std::uint64_t a, std::uint64_t b) { return a > b ? a : b; }

    /// The largest of the four, v scaled to the texels of u.
    std::uint64_t in_texels(std::uint64_t ds, std::uint64_t dt) const {
        const int up = span.state->log2_height[Unit] - span.state->log2_width[Unit];
        return largest(ds, up >= 0 ? dt << up : dt >> -up);
    }

    std::int32_t affine() const {
        const auto steps = [](std::uint64_t dx, std::uint64_t dy, bool wraps) {
            const std::uint64_t m = largest(numeric::abs_u64(static_cast<std::int64_t>(dx)),
                                            numeric::abs_u64(static_cast<std::int64_t>(dy)));
            return m << (wraps ? 0 : 32 - clamped_coord_bits);
        };
        const auto& unit = span.unit[Unit];
        const std::uint64_t ds = steps(unit.s.dx, unit.s_dy, span.state->wraps[Unit].s);
        const std::uint64_t dt = steps(unit.t.dx, unit.t_dy, span.state->wraps[Unit].t);
        return log2_fraction8(in_texels(ds, dt)) + ((span.state->log2_width[Unit] - 32) << 8);
    }

    /// d(S/Q) = (dS Q - S dQ) / Q^2, of which only the logarithm is wanted.
    std::int32_t projective() const {
        const auto& unit = span.unit[Unit];
        const auto& q = unit.shares_q ? span.q : unit.q;
        const std::uint64_t q_dy = unit.shares_q ? span.q_dy : unit.q_dy;
        const std::int64_t at_q = positive(span.at(x, q)), at_s = unguarded(span.at(x, unit.s)),
                           at_t = unguarded(span.at(x, unit.t));
        const auto numerator = [&](std::uint64_t dv, std::int64_t v, std::uint64_t dq) {
            return numeric::abs_u64(unguarded(dv) * at_q - v * unguarded(dq));
        };
        const std::uint64_t ds = largest(numerator(unit.s.dx, at_s, q.dx), numerator(unit.s_dy, at_s, q_dy));
        const std::uint64_t dt = largest(numerator(unit.t.dx, at_t, q.dx), numerator(unit.t_dy, at_t, q_dy));
        return log2_fraction8(in_texels(ds, dt)) - 2 * log2_fraction8(static_cast<std::uint64_t>(at_q)) +
               ((unit.exponent + span.state->log2_width[Unit]) << 8);
    }
    static std::int64_t positive(std::uint64_t q) {
        const std::int32_t v = unguarded(q);
        return v > 0 ? v : 1;
    }
};

} // namespace spangle::raster
