// NEAREST texels of one REPEAT image along a span: what Coord and TextureFixed do, as a walk over addresses.
// Fused spans only.
#pragma once

#include "raster/span/stage_coord.hpp"
#include "raster/span/stage_texture.hpp"

namespace spangle::raster {

/// Texel indices of one axis by one shift of a word that wraps as the texture does.
template <bool Cubic> class TexelAxis {
  public:
    using Step = decltype(CoordWalk<Cubic>::by);
    TexelAxis() = default;
    /// Along an axis of one texel there is nothing to walk.
    SPANGLE_INLINE TexelAxis(int log2_size, std::uint32_t v, const Step& dv)
        : shift_(log2_size == 0 ? 31 : 32 - log2_size), v_{log2_size == 0 ? 0 : v + nearest_bias(log2_size),
                                                           log2_size == 0 ? Step{} : dv} {}
    SPANGLE_INLINE std::uint32_t index() const { return v_.at >> shift_; }
    SPANGLE_INLINE std::uint32_t index(std::uint32_t steps) const { return v_.ahead(steps) >> shift_; }
    SPANGLE_INLINE void step(std::uint32_t steps) { v_.step(steps); }
    SPANGLE_INLINE void step_straight(std::uint32_t steps) { v_.step_straight(steps); }
    SPANGLE_INLINE bool straight() const { return v_.straight(); }
    /// n steps stay in one texel.
    SPANGLE_INLINE bool constant(std::uint32_t n) const { return v_.constant(n, shift_); }
    /// n pixels have one texel each, in order: the step is one texel, or so nearly that none is met twice.
    SPANGLE_INLINE bool one_to_one(std::uint32_t n) const {
        static_assert(!Cubic);
        const auto excess = static_cast<std::int32_t>(v_.by - (1u << shift_));
        const std::int64_t last = std::int64_t{v_.at & ((1u << shift_) - 1)} + std::int64_t{excess} * (n - 1);
        return last >= 0 && last >> shift_ == 0;
    }

  private:
    int shift_;
    CoordWalk<Cubic> v_;
};

/// T is a TextureFixed with Filter::nearest.
template <class T, int Unit, class Runs> struct NearestWalk : T {
    using N = typename T::System;
    static constexpr unsigned in = T::in & field_color, out = T::out;
    static constexpr bool runs = !std::is_same_v<Runs, NoRuns>;
    /// With lanes only whole rows of words gain from it.
    static constexpr bool rows = N::lanes == 1 || T::loads_words;
    static constexpr std::uint32_t lanes = N::lanes;
    /// Sprites: such a row is texel after texel.
    static constexpr bool in_order = is_packed<N>;
    TexelAxis<is_cubic<Runs>> s, t;
    const std::uint8_t* row_at;
    bool one_to_one;
    [[no_unique_address]] Runs run;

    SPANGLE_INLINE NearestWalk(const Span<Fixed>& span, std::int32_t x) : T(span, x), run(span, x) {
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
        const auto j = static_cast<std::int32_t>(t.index());
        if constexpr (in_order) {
            const auto i = static_cast<std::int32_t>(s.index());
            row_at = this->at(i, j);
            return s.one_to_one(static_cast<std::uint32_t>(n)) && i + n <= 1 << this->log2_width;
        }
        row_at = this->at(0, j);
        if constexpr (lanes > 1)
            one_to_one = s.one_to_one(static_cast<std::uint32_t>(n));
        return true;
    }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        if (p.row) {
            if constexpr (in_order)
                return this->combine(p, [&](std::uint32_t) { return row_at; });
            if constexpr (lanes > 1 && T::loads_words) {
                const std::uint32_t i = s.index();
                if (one_to_one && static_cast<std::int32_t>(i) + N::lanes <= 1 << this->log2_width)
                    return this->combine_words(p, N::L::load32(row_at + i * T::bytes));
            }
            return this->combine(
                p, [&](std::uint32_t k)
                       __attribute__((always_inline)) { return row_at + s.index(k) * T::bytes; });
        }
        return this->combine(
            p, [&](std::uint32_t k) __attribute__((always_inline)) {
                return this->at(static_cast<std::int32_t>(s.index(k)), static_cast<std::int32_t>(t.index(k)));
            });
    }
    SPANGLE_INLINE void step() {
        s.step(lanes);
        t.step(lanes);
    }
    SPANGLE_INLINE void step_row() {
        if constexpr (in_order)
            row_at += T::bytes;
        else
            s.step_straight(lanes);
    }
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
};

} // namespace spangle::raster
