// What varies over 1/w along a row, where every fragment divides: one division, which all attributes share.
// Fused spans only; the bits of the stages of the chain, which divide each for itself.
#pragma once

#include "raster/span/coord_runs.hpp"
#include "raster/span/stage_color.hpp"
#include "raster/span/stage_texture.hpp"

namespace spangle::raster {

/// A projective interpolant along a row, its guard bits in a word of their own.
class GuardedRamp {
  public:
    SPANGLE_INLINE GuardedRamp(const Span<Fixed>& span, std::int32_t x, const Span<Fixed>::Projective& plane)
        : by_(plane.dx << up) {
        start(span, x, plane);
    }
    SPANGLE_INLINE void start(const Span<Fixed>& span, std::int32_t x, const Span<Fixed>::Projective& plane) {
        at_ = span.at(x, plane) << up;
    }
    /// unguarded().
    SPANGLE_INLINE std::int32_t value() const {
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(at_ >> 32));
    }
    SPANGLE_INLINE void step() { at_ += by_; }

  private:
    static constexpr int up = 32 - guard_bits;
    std::uint64_t at_, by_;
};

/// 1/w, for the stages behind it.
template <class N> struct Divide : StageBase {
    GuardedRamp q;
    SPANGLE_INLINE Divide(const Span<Fixed>& s, std::int32_t x) : q(s, x, s.q) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.inverse = Inverse(q.value());
        return true;
    }
    SPANGLE_INLINE void step() { q.step(); }
    SPANGLE_INLINE void start(const Span<Fixed>& s, std::int32_t x) { q.start(s, x, s.q); }
};

/// GouraudGray.
template <class N> struct GouraudGrayDivided : StageBase {
    static constexpr unsigned out = field_color;
    GuardedRamp v;
    SPANGLE_INLINE GouraudGrayDivided(const Span<Fixed>& s, std::int32_t x) : v(s, x, s.color_q[0]) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        const typename N::T c = N::from_units(detail::projective_color(v.value(), p.inverse));
        p.color = {c, c, c, N::from_units(color_one)};
        return true;
    }
    SPANGLE_INLINE void step() { v.step(); }
    SPANGLE_INLINE void start(const Span<Fixed>& s, std::int32_t x) { v.start(s, x, s.color_q[0]); }
};

/// GouraudQ.
template <class N, bool Alpha> struct GouraudDivided : StageBase {
    static constexpr unsigned out = field_color;
    GuardedRamp r, g, b;
    [[no_unique_address]] std::conditional_t<Alpha, GuardedRamp, StageBase> a;

    SPANGLE_INLINE GouraudDivided(const Span<Fixed>& s, std::int32_t x)
        : r(s, x, s.color_q[0]), g(s, x, s.color_q[1]), b(s, x, s.color_q[2]), a(alpha(s, x)) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.color.r = N::from_units(detail::projective_color(r.value(), p.inverse));
        p.color.g = N::from_units(detail::projective_color(g.value(), p.inverse));
        p.color.b = N::from_units(detail::projective_color(b.value(), p.inverse));
        if constexpr (Alpha)
            p.color.a = N::from_units(detail::projective_color(a.value(), p.inverse));
        else
            p.color.a = N::from_units(color_one);
        return true;
    }
    SPANGLE_INLINE void step() {
        r.step();
        g.step();
        b.step();
        if constexpr (Alpha)
            a.step();
    }
    SPANGLE_INLINE void start(const Span<Fixed>& s, std::int32_t x) {
        r.start(s, x, s.color_q[0]);
        g.start(s, x, s.color_q[1]);
        b.start(s, x, s.color_q[2]);
        if constexpr (Alpha)
            a.start(s, x, s.color_q[3]);
    }

  private:
    SPANGLE_INLINE static auto alpha(const Span<Fixed>& s, std::int32_t x) {
        if constexpr (Alpha)
            return GuardedRamp(s, x, s.color_q[3]);
        else
            return StageBase{};
    }
};

/// FogCoord, as far as LINEAR can tell: below 0 it is 0, and beyond 2 anything more than 1.
template <class N> struct FogCoordDivided : StageBase {
    static constexpr unsigned out = field_fog;
    GuardedRamp f;
    int exponent;
    SPANGLE_INLINE FogCoordDivided(const Span<Fixed>& s, std::int32_t x)
        : f(s, x, s.fog_q), exponent(s.fog_exponent) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.fog = coordinate(p.inverse);
        return true;
    }
    SPANGLE_INLINE void step() { f.step(); }
    SPANGLE_INLINE void start(const Span<Fixed>& s, std::int32_t x) { f.start(s, x, s.fog_q); }

  private:
    SPANGLE_INLINE std::uint32_t coordinate(const Inverse& inverse) const {
        constexpr int usual = 6; // all fog coordinates of the primitive fit s7.24
        if (exponent != usual) [[unlikely]]
            return unusual(f.value(), exponent, inverse);
        const auto most = static_cast<std::int32_t>(inverse.q >> (usual - 1));
        const std::int32_t least = f.value() < 0 ? 0 : f.value(), v = least < most ? least : most;
        return numeric::mul_high_u32(static_cast<std::uint32_t>(v) << inverse.zeros, inverse.mantissa);
    }
    [[gnu::noinline]] static std::uint32_t unusual(std::int32_t over_w, int exponent, Inverse inverse) {
        return detail::projective_fog(over_w, exponent, inverse);
    }
};

/// NEAREST of one REPEAT image, T a TextureFixed.
template <class T, int Unit> class NearestDivided : public T {
  public:
    using N = typename T::System;
    static constexpr unsigned in = T::in & field_color, out = T::out;

    SPANGLE_INLINE NearestDivided(const Span<Fixed>& span, std::int32_t x)
        : T(span, x), span_(&span), x_(x), s_(span, x, span.unit[Unit].s), t_(span, x, span.unit[Unit].t),
          exponent_(span.unit[Unit].exponent), shares_q_(span.unit[Unit].shares_q) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        if (!shares_q_) [[unlikely]]
            return sampled(p, own_inverse(p.i));
        return sampled(p, p.inverse);
    }
    SPANGLE_INLINE void step() {
        s_.step();
        t_.step();
    }
    SPANGLE_INLINE void start(const Span<Fixed>& span, std::int32_t x) {
        x_ = x;
        s_.start(span, x, span.unit[Unit].s);
        t_.start(span, x, span.unit[Unit].t);
    }

  private:
    const Span<Fixed>* span_;
    std::int32_t x_;
    GuardedRamp s_, t_;
    int exponent_;
    bool shares_q_;

    [[gnu::noinline]] Inverse own_inverse(std::int32_t i) const {
        return Inverse(unguarded(span_->at(x_ + i, span_->unit[Unit].q)));
    }
    SPANGLE_INLINE bool sampled(Px<N>& p, const Inverse& inverse) const {
        const std::uint32_t i = texel(s_, inverse, this->log2_width),
                            j = texel(t_, inverse, this->log2_height);
        return this->combine(p, [&](std::uint32_t) { return T::texel(this->row_of(j), i); });
    }
    /// repeat_nearest; the shift is below 32 with one texel, too.
    SPANGLE_INLINE std::uint32_t texel(const GuardedRamp& v, const Inverse& inverse, int log2_size) const {
        const std::uint32_t repeats = detail::repeat_fraction(v.value(), inverse, exponent_);
        return (repeats + nearest_bias(log2_size)) >> 1 >> (31 - log2_size);
    }
};

} // namespace spangle::raster
