// Walks over the texels of one REPEAT image along a span. It takes the place of coordinates and of what the
// chain computes from them. NEAREST and LINEAR share this part. Only fused spans use it.
#pragma once

#include "raster/ops/stage_coord.hpp"
#include "raster/ops/stage_texture.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// The position along one axis, in 2^-FractionBits texels. It is one shift of a word that wraps as the
/// texture does. Lanes compute their positions as scalars, because addresses are scalars.
template <bool Cubic, int FractionBits, bool Aside> class TexelAxis {
  public:
    using Step = decltype(CoordWalk<Cubic>::by);
    TexelAxis() = default;
    /// Position 0 lies `origin` inside of the texture. An axis of one texel has only one position in whole
    /// texels.
    SPANGLE_INLINE TexelAxis(int log2_size, std::uint32_t v, std::uint32_t origin, const Step& dv)
        : log2_size_(log2_size), shift_(32 - FractionBits - log2_size), coordinate_{v - origin, dv} {
        if (FractionBits == 0 && log2_size == 0) {
            shift_ = 31;
            coordinate_ = {};
        }
    }
    SPANGLE_INLINE std::uint32_t position(std::uint32_t lane = 0) const {
        return coordinate_.value_after(static_cast<std::int32_t>(lane)) >> shift_;
    }
    /// The number of lane 0's texel in the image. This axis gives the row, and `column` gives the column.
    SPANGLE_INLINE std::uint32_t place(const TexelAxis& column) const {
        static_assert(FractionBits == 0);
        return numeric::joined_aside(coordinate_.at, shift_, column.log2_size_, column.coordinate_.at,
                                     column.shift_);
    }
    /// Does what texel() does for lane 0, by a product with `size`, which is a factor32(). Positions must
    /// have no fraction bits.
    SPANGLE_INLINE std::uint32_t texel_of(std::uint32_t size) const {
        static_assert(FractionBits == 0 && numeric::long_products);
        return static_cast<std::uint32_t>(std::uint64_t{coordinate_.at} * size >> 32);
    }
    SPANGLE_INLINE std::uint32_t texel(std::uint32_t lane = 0) const {
        return position(lane) >> FractionBits;
    }
    SPANGLE_INLINE std::uint32_t next_texel(std::uint32_t lane = 0) const {
        return (texel(lane) + 1) & ((1u << log2_size_) - 1);
    }
    /// The fraction of the position of every lane.
    template <class L> SPANGLE_INLINE typename L::U16 fractions() const {
        constexpr std::uint32_t mask = (1u << FractionBits) - 1;
        if constexpr (L::count == 1)
            return position() & mask;
        else if constexpr (Cubic)
            return L::generate([&](std::uint32_t lane) __attribute__((always_inline)) {
                return static_cast<std::uint16_t>(position(lane) & mask);
            });
        else
            return L::low_half(L::ramp(coordinate_.at, coordinate_.by) >> shift_) & mask;
    }
    /// This axis as a straight line. straight() must hold.
    SPANGLE_INLINE TexelAxis<false, FractionBits, Aside> line() const {
        return {log2_size_, shift_, {coordinate_.at, coordinate_.slope()}};
    }
    SPANGLE_INLINE void step(std::int32_t pixels) {
        if constexpr (Aside && !Cubic)
            coordinate_.at =
                numeric::sum_aside(coordinate_.at, static_cast<std::uint32_t>(pixels) * coordinate_.by);
        else
            coordinate_.step(pixels);
    }
    SPANGLE_INLINE void step_straight(std::uint32_t pixels) { coordinate_.step_straight(pixels); }
    SPANGLE_INLINE bool straight() const { return coordinate_.straight(); }
    /// True where n steps stay at one position.
    SPANGLE_INLINE bool constant(std::uint32_t n) const { return coordinate_.constant(n, shift_); }
    /// True where n pixels have consecutive positions, one each. The step is one texel, or so nearly one that
    /// no position is met twice.
    SPANGLE_INLINE bool one_to_one(std::uint32_t n) const {
        static_assert(!Cubic);
        const auto excess = static_cast<std::int32_t>(coordinate_.by - (1u << shift_));
        if (excess == 0) // sprites have a step of one texel, for which no product is needed
            return true;
        const std::int64_t last =
            std::int64_t{coordinate_.at & ((1u << shift_) - 1)} + std::int64_t{excess} * (n - 1);
        return last >= 0 && last >> shift_ == 0;
    }

  private:
    template <bool, int, bool> friend class TexelAxis;
    int log2_size_, shift_;
    CoordWalk<Cubic> coordinate_;
    SPANGLE_INLINE TexelAxis(int log2_size, int shift, const CoordWalk<Cubic>& v)
        : log2_size_(log2_size), shift_(shift), coordinate_(v) {}
};

/// The walk over the texels of T, a TextureFixed. Positions have F::fraction_bits fraction bits. Position 0
/// lies F::origin(log2 of the size) inside of the texture.
template <class T, int Unit, class Runs, class F> class TexelWalk : public T {
  public:
    using N = typename T::System;
    static constexpr unsigned in = T::in & field_color, out = T::out;
    static constexpr bool runs = !std::is_same_v<Runs, NoRuns>;

    SPANGLE_INLINE TexelWalk(const Span<Fixed>& span, std::int32_t x) : T(span, x), run_(span, x, Unit) {
        if constexpr (!runs)
            walk(span, x);
    }
    SPANGLE_INLINE void start(const Span<Fixed>& span, std::int32_t x) {
        if constexpr (runs)
            run_ = Runs(span, x, Unit);
        else
            walk(span, x);
    }
    SPANGLE_INLINE std::int32_t begin(std::int32_t x) {
        const std::int32_t end = run_.begin(x);
        walk(run_.s, run_.t, run_.ds, run_.dt);
        return end;
    }
    SPANGLE_INLINE void step() { jump(N::lanes); }
    SPANGLE_INLINE void jump(std::int32_t pixels) {
        s.step(pixels);
        t.step(pixels);
    }
    SPANGLE_INLINE void step_row() { s.step_straight(N::lanes); }

  protected:
    /// True where shifts can use few registers, and little is done with a texel besides fetching it.
    /// Coordinates then leave these registers to addresses.
    static constexpr bool aside = !numeric::long_products && is_raw<N> && N::lanes == 1;
    using Axis = TexelAxis<is_cubic<Runs>, F::fraction_bits, aside>;
    Axis s, t;

    /// True where the next n pixels lie in one row of texels.
    SPANGLE_INLINE bool in_row(std::int32_t n) const {
        return s.straight() && t.constant(static_cast<std::uint32_t>(n) - 1);
    }

  private:
    [[no_unique_address]] Runs run_;

    SPANGLE_INLINE void walk(const Span<Fixed>& span, std::int32_t x) {
        walk(span.at(x, span.s[Unit]), span.at(x, span.t[Unit]), span.s[Unit].dx, span.t[Unit].dx);
    }
    template <class Step>
    SPANGLE_INLINE void walk(std::uint32_t s0, std::uint32_t t0, const Step& ds, const Step& dt) {
        s = Axis(this->log2_width, s0, F::origin(this->log2_width), ds);
        t = Axis(this->log2_height, t0, F::origin(this->log2_height), dt);
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
