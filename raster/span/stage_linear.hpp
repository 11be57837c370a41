// LINEAR of one REPEAT image along a span: what the chain does per fragment, as a walk over texels. Fused
// spans only.
#pragma once

#include "raster/span/stage_coord.hpp"
#include "raster/span/stage_texture.hpp"

namespace spangle::raster {

/// One axis: texel and weight of its neighbour, 8 fraction bits, by one shift of a word that wraps as the
/// texture does.
template <bool Cubic> class LinearAxis {
  public:
    using Step = decltype(CoordWalk<Cubic>::by);
    LinearAxis() = default;
    SPANGLE_INLINE LinearAxis(int log2_size, std::uint32_t v, const Step& dv)
        : log2_(log2_size), shift_(24 - log2_size), v_{v - ((1u << 31) >> log2_size), dv} {}
    SPANGLE_INLINE std::uint32_t position() const { return v_.at >> shift_; }
    SPANGLE_INLINE std::uint32_t position(std::uint32_t steps) const { return v_.ahead(steps) >> shift_; }
    SPANGLE_INLINE static std::uint32_t texel(std::uint32_t position) { return position >> 8; }
    SPANGLE_INLINE static std::uint32_t weight(std::uint32_t position) { return position & 255; }
    SPANGLE_INLINE std::uint32_t next(std::uint32_t i) const { return (i + 1) & ((1u << log2_) - 1); }
    /// Of the lanes of a group.
    template <class L> SPANGLE_INLINE typename L::U16 weights() const {
        static_assert(!Cubic);
        return L::low_half((L::ramp(v_.at, v_.by) << log2_) >> 24);
    }
    SPANGLE_INLINE void step(std::uint32_t steps) { v_.step(steps); }
    SPANGLE_INLINE void step_straight(std::uint32_t steps) { v_.step_straight(steps); }
    SPANGLE_INLINE bool straight() const { return v_.straight(); }
    /// n steps stay where they are.
    SPANGLE_INLINE bool constant(std::uint32_t n) const { return v_.constant(n, shift_); }

  private:
    int log2_, shift_;
    CoordWalk<Cubic> v_;
};

/// T is a TextureFixed with Filter::linear.
template <class T, int Unit, class Runs> struct LinearWalk : T {
    using N = typename T::System;
    using L = typename N::L;
    static constexpr unsigned in = T::in & field_color, out = T::out;
    static constexpr bool runs = !std::is_same_v<Runs, NoRuns>, rows = true;
    static constexpr std::uint32_t lanes = N::lanes;
    using Weights = typename T::template Filter4<N::lanes>;
    using Axis = LinearAxis<is_cubic<Runs>>;
    Axis s, t;
    const std::uint8_t *near, *far; ///< texels of the two rows
    Weights across{L::splat(0)};
    [[no_unique_address]] Runs run;

    SPANGLE_INLINE LinearWalk(const Span<Fixed>& span, std::int32_t x) : T(span, x), run(span, x) {
        if constexpr (!runs)
            walk(span.at(x, span.s[Unit]), span.at(x, span.t[Unit]), span.s[Unit].dx, span.t[Unit].dx);
    }
    SPANGLE_INLINE void start(const Span<Fixed>& span, std::int32_t x) {
        if constexpr (runs)
            run = Runs(span, x);
        else
            walk(span.at(x, span.s[Unit]), span.at(x, span.t[Unit]), span.s[Unit].dx, span.t[Unit].dx);
    }
    SPANGLE_INLINE std::int32_t begin(std::int32_t x) {
        const std::int32_t end = run.begin(x);
        walk(run.s, run.t, run.ds, run.dt);
        return end;
    }
    SPANGLE_INLINE bool row(std::int32_t n) {
        if (!s.straight() || !t.constant(static_cast<std::uint32_t>(n) - 1))
            return false;
        const std::uint32_t v = t.position();
        near = line(Axis::texel(v));
        far = line(t.next(Axis::texel(v)));
        across = Weights(L::splat(Axis::weight(v)));
        return true;
    }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        if constexpr (lanes == 1) {
            if (p.row)
                return one(p, near, far, across);
            const std::uint32_t v = t.position(), j = Axis::texel(v);
            return one(p, line(j), line(t.next(j)), Weights(Axis::weight(v)));
        } else {
            if (p.row)
                return group(
                    p, across, [&](std::uint32_t) __attribute__((always_inline)) { return near; },
                    [&](std::uint32_t) __attribute__((always_inline)) { return far; });
            return group(
                p, Weights(t.template weights<L>()),
                [&](std::uint32_t k)
                    __attribute__((always_inline)) { return line(Axis::texel(t.position(k))); },
                [&](std::uint32_t k)
                    __attribute__((always_inline)) { return line(t.next(Axis::texel(t.position(k)))); });
        }
    }
    SPANGLE_INLINE void step() {
        s.step(lanes);
        t.step(lanes);
    }
    SPANGLE_INLINE void step_row() { s.step_straight(lanes); }
    SPANGLE_INLINE void jump(std::int32_t pixels) {
        s.step(static_cast<std::uint32_t>(pixels));
        t.step(static_cast<std::uint32_t>(pixels));
    }

  private:
    template <class Step>
    SPANGLE_INLINE void walk(std::uint32_t s0, std::uint32_t t0, const Step& ds, const Step& dt) {
        s = {this->log2_width, s0, ds};
        t = {this->log2_height, t0, dt};
    }
    SPANGLE_INLINE const std::uint8_t* line(std::uint32_t j) const {
        return this->at(0, static_cast<std::int32_t>(j));
    }
    SPANGLE_INLINE bool one(Px<N>& p, const std::uint8_t* n, const std::uint8_t* f,
                            const Weights& filter) const {
        const std::uint32_t u = s.position(), i0 = T::bytes * Axis::texel(u),
                            i1 = T::bytes * s.next(Axis::texel(u));
        return this->environment(p, T::mix(filter, this->word_at(n + i0), this->word_at(n + i1),
                                           this->word_at(f + i0), this->word_at(f + i1), Axis::weight(u)));
    }
    /// Texels of one row per lane, in the column or in the next one.
    template <bool Next, class Line> SPANGLE_INLINE auto texels(Line line_of) const {
        return L::generate([&](int lane) __attribute__((always_inline)) {
            const auto k = static_cast<std::uint32_t>(lane);
            const std::uint32_t i = Axis::texel(s.position(k));
            return this->word_at(line_of(k) + T::bytes * (Next ? s.next(i) : i));
        });
    }
    template <class Near, class Far>
    SPANGLE_INLINE bool group(Px<N>& p, const Weights& filter, Near n, Far f) const {
        return this->environment(p, T::mix(filter, texels<false>(n), texels<true>(n), texels<false>(f),
                                           texels<true>(f), s.template weights<L>()));
    }
};

} // namespace spangle::raster
