// NEAREST texels of one REPEAT image along a span: what Coord and TextureFixed do, as a walk over addresses.
// Fused spans only.
#pragma once

#include "raster/span/stage_coord.hpp"
#include "raster/span/stage_texture.hpp"

namespace spangle::raster {

/// Texel indices of one axis by one shift of a word that wraps as the texture does.
class TexelAxis {
  public:
    TexelAxis() = default;
    /// Along an axis of one texel there is nothing to walk.
    SPANGLE_INLINE TexelAxis(int log2_size, std::uint32_t v, std::uint32_t dv)
        : shift_(log2_size == 0 ? 31 : 32 - log2_size), at_(log2_size == 0 ? 0 : v + nearest_bias(log2_size)),
          step_(log2_size == 0 ? 0 : dv) {}
    SPANGLE_INLINE std::uint32_t index() const { return at_ >> shift_; }
    SPANGLE_INLINE std::uint32_t index(std::uint32_t steps) const { return (at_ + steps * step_) >> shift_; }
    SPANGLE_INLINE void step(std::uint32_t steps = 1) { at_ += steps * step_; }
    /// n steps stay in one texel: they go one way and not round the texture.
    SPANGLE_INLINE bool constant(std::uint32_t n) const {
        const auto slope = static_cast<std::int32_t>(step_);
        return numeric::mul_u32(numeric::abs_u32(slope), n) < 1u << 31 && index() == index(n);
    }
    /// Every step is one texel.
    SPANGLE_INLINE bool one_to_one() const { return step_ == 1u << shift_ && shift_ != 31; }

  private:
    int shift_;
    std::uint32_t at_, step_;
};

/// T is a TextureFixed with Filter::nearest.
template <class T, int Unit, bool Projective> struct NearestWalk : T {
    using N = typename T::System;
    static constexpr unsigned in = T::in & field_color, out = T::out;
    static constexpr bool runs = Projective;
    /// With lanes only whole rows of words gain from it.
    static constexpr bool rows = N::lanes == 1 || T::loads_words;
    static constexpr std::uint32_t lanes = N::lanes;
    TexelAxis s, t;
    const std::uint8_t* row_at;
    bool one_to_one;
    [[no_unique_address]] WalkRuns<Unit, Projective> run;

    SPANGLE_INLINE NearestWalk(const Span<Fixed>& span, std::int32_t x) : T(span, x), run(span, x) {
        if constexpr (!Projective)
            walk(span.at(x, span.s[Unit]), span.at(x, span.t[Unit]), span.s[Unit].dx, span.t[Unit].dx);
    }
    SPANGLE_INLINE void start(const Span<Fixed>& span, std::int32_t x) {
        if constexpr (Projective)
            run = CoordRuns<Unit>(span, x);
        else
            walk(span.at(x, span.s[Unit]), span.at(x, span.t[Unit]), span.s[Unit].dx, span.t[Unit].dx);
    }
    SPANGLE_INLINE std::int32_t begin(std::int32_t x) {
        const std::int32_t end = run.begin(x);
        walk(run.s, run.t, run.ds, run.dt);
        return end;
    }
    SPANGLE_INLINE bool row(std::int32_t n) {
        if (!t.constant(static_cast<std::uint32_t>(n) - 1))
            return false;
        row_at = this->at(0, static_cast<std::int32_t>(t.index()));
        one_to_one = lanes > 1 && s.one_to_one();
        return true;
    }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        if (p.row) {
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
    SPANGLE_INLINE void step_row() { s.step(lanes); }
    SPANGLE_INLINE void jump(std::int32_t pixels) {
        s.step(static_cast<std::uint32_t>(pixels));
        t.step(static_cast<std::uint32_t>(pixels));
    }

  private:
    SPANGLE_INLINE void walk(std::uint32_t s0, std::uint32_t t0, std::uint32_t ds, std::uint32_t dt) {
        s = TexelAxis(this->log2_width, s0, ds);
        t = TexelAxis(this->log2_height, t0, dt);
    }
};

} // namespace spangle::raster
