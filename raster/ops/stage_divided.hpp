// Attributes that vary over 1/w along a row, where every fragment divides: one division serves all
// attributes. The bits are those of the chain's stages, each of which divides for itself. Only fused spans
// use this file.
#pragma once

#include "raster/ops/coord_runs.hpp"
#include "raster/ops/guarded_row.hpp"
#include "raster/ops/stage_color.hpp"
#include "raster/ops/stage_texture.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// A projective plane along a row. value(i) is the plane without guard bits (unguarded()) at fragment i from
/// the start. With words of 64 bits the ramp steps, and i is not read.
template <bool Numbered> class GuardedRampOf {
  public:
    SPANGLE_INLINE GuardedRampOf(const Span<Fixed>& span, std::int32_t x,
                                 const Span<Fixed>::Projective& plane)
        : step_(plane.dx << up) {
        start(span, x, plane);
    }
    SPANGLE_INLINE void start(const Span<Fixed>& span, std::int32_t x, const Span<Fixed>::Projective& plane) {
        at_ = span.at(x, plane) << up;
    }
    SPANGLE_INLINE std::int32_t value(std::int32_t) const {
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(at_ >> 32));
    }
    SPANGLE_INLINE void step() { at_ += step_; }

  private:
    static constexpr int up = 32 - guard_bits;
    std::uint64_t at_, step_;
};

/// A ramp with words of 32 bits. A step would load four words and store two, so the value and the guard bits
/// are multiplied by the fragment's number instead (GuardedWords). Rows from the anchor are below 2^14, as
/// columns are.
template <> class GuardedRampOf<true> {
  public:
    SPANGLE_INLINE GuardedRampOf(const Span<Fixed>& span, std::int32_t x,
                                 const Span<Fixed>::Projective& plane)
        : origin_(plane.value), step_(plane.dx), row_step_(plane.dy) {
        start(span, x, plane);
    }
    /// Starts at another place. The plane must be that of the constructor.
    SPANGLE_INLINE void start(const Span<Fixed>& span, std::int32_t x, const Span<Fixed>::Projective&) {
        const auto columns = static_cast<std::uint32_t>(x + (span.x - span.anchor_x)),
                   rows = static_cast<std::uint32_t>(span.y - span.anchor_y);
        const std::uint32_t guard = origin_.guard + columns * step_.guard + rows * row_step_.guard;
        at_.value = origin_.value + columns * step_.value + rows * row_step_.value +
                    static_cast<std::uint32_t>(static_cast<std::int32_t>(guard) >> guard_bits);
        at_.guard = guard & GuardedWords::guard_mask;
    }
    SPANGLE_INLINE std::int32_t value(std::int32_t i) const {
        return at_.after(static_cast<std::uint32_t>(i), step_);
    }
    SPANGLE_INLINE void step() {}

  private:
    GuardedWords at_, origin_, step_, row_step_;
};
using GuardedRamp = GuardedRampOf<!numeric::wide_words>;

/// Finds 1/w for the later stages of the list.
template <class N> struct Divide : StageBase {
    GuardedRamp q;
    SPANGLE_INLINE Divide(const Span<Fixed>& s, std::int32_t x) : q(s, x, s.q) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.inverse = Inverse(q.value(p.i));
        return true;
    }
    SPANGLE_INLINE void step() { q.step(); }
    SPANGLE_INLINE void start(const Span<Fixed>& s, std::int32_t x) { q.start(s, x, s.q); }
};

/// Does what GouraudGray does, with a colour that the shared 1/w divides.
template <class N> struct GouraudGrayDivided : StageBase {
    static constexpr unsigned out = field_color;
    GuardedRamp v;
    SPANGLE_INLINE GouraudGrayDivided(const Span<Fixed>& s, std::int32_t x) : v(s, x, s.color_q[0]) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        const typename N::T c = N::from_units(inner::projective_color(v.value(p.i), p.inverse));
        p.color = {c, c, c, N::from_units(color_one)};
        return true;
    }
    SPANGLE_INLINE void step() { v.step(); }
    SPANGLE_INLINE void start(const Span<Fixed>& s, std::int32_t x) { v.start(s, x, s.color_q[0]); }
};

/// Does what GouraudQ does, with the shared 1/w.
template <class N, bool Alpha> struct GouraudDivided : StageBase {
    static constexpr unsigned out = field_color;
    GuardedRamp r, g, b;
    [[no_unique_address]] std::conditional_t<Alpha, GuardedRamp, StageBase> a;

    SPANGLE_INLINE GouraudDivided(const Span<Fixed>& s, std::int32_t x)
        : r(s, x, s.color_q[0]), g(s, x, s.color_q[1]), b(s, x, s.color_q[2]), a(alpha(s, x)) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.color.r = N::from_units(inner::projective_color(r.value(p.i), p.inverse));
        p.color.g = N::from_units(inner::projective_color(g.value(p.i), p.inverse));
        p.color.b = N::from_units(inner::projective_color(b.value(p.i), p.inverse));
        if constexpr (Alpha)
            p.color.a = N::from_units(inner::projective_color(a.value(p.i), p.inverse));
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

/// Finds the fog coordinate as far as LINEAR can tell values apart. A coordinate below 0 becomes 0, and a
/// coordinate beyond 2 becomes some value above 1.
template <class N> struct FogCoordDivided : StageBase {
    static constexpr unsigned out = field_fog;
    GuardedRamp f;
    SPANGLE_INLINE FogCoordDivided(const Span<Fixed>& s, std::int32_t x) : f(s, x, s.fog_q) {}
    /// True where all fog coordinates of the primitive fit s7.24.
    SPANGLE_INLINE static bool serves(const Span<Fixed>& s) { return s.fog_exponent == exponent; }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.fog = coordinate(f.value(p.i), p.inverse);
        return true;
    }
    SPANGLE_INLINE void step() { f.step(); }
    SPANGLE_INLINE void start(const Span<Fixed>& s, std::int32_t x) { f.start(s, x, s.fog_q); }

  private:
    static constexpr int exponent = 6;
    SPANGLE_INLINE static std::uint32_t coordinate(std::int32_t over_w, const Inverse& inverse) {
        const auto most = static_cast<std::int32_t>(inverse.q >> (exponent - 1));
        const std::int32_t least = over_w < 0 ? 0 : over_w, v = least < most ? least : most;
        const std::uint32_t c =
            numeric::mul_high_u32(static_cast<std::uint32_t>(v) << inverse.zeros, inverse.mantissa);
        // Here v is at most q / 32, 2^(37 - zeros) is more than 32 v, and a mantissa is at most 2^31.
        if (c >> (32 - exponent) != 0)
            __builtin_unreachable();
        return c;
    }
};

/// NEAREST of one REPEAT image, with the shared 1/w. T is a TextureFixed.
template <class T, int Unit> class NearestDivided : public T {
  public:
    using N = typename T::System;
    static constexpr unsigned in = T::in & field_color, out = T::out;

    SPANGLE_INLINE NearestDivided(const Span<Fixed>& span, std::int32_t x)
        : T(span, x), s_(span, x, span.unit[Unit].s), t_(span, x, span.unit[Unit].t),
          coordinate_shift_(span.unit[Unit].exponent + 2),
          largest_near_shift_(19 -
                              (this->log2_width > this->log2_height ? this->log2_width : this->log2_height)),
          width_(numeric::factor32(1u << this->log2_width)), bias_{nearest_bias(this->log2_width),
                                                                   nearest_bias(this->log2_height)} {}
    /// True where q is 1/w for these coordinates, and each axis has more than one texel.
    SPANGLE_INLINE static bool serves(const Span<Fixed>& span) {
        return span.unit[Unit].shares_q && span.state->log2_width[Unit] != 0 &&
               span.state->log2_height[Unit] != 0;
    }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        const std::uint32_t at = place(s_.value(p.i), t_.value(p.i), p.inverse);
        return this->combine(p, [&](std::uint32_t) { return T::texel(this->texels, at); });
    }
    SPANGLE_INLINE void step() {
        s_.step();
        t_.step();
    }
    SPANGLE_INLINE void start(const Span<Fixed>& span, std::int32_t x) {
        s_.start(span, x, span.unit[Unit].s);
        t_.start(span, x, span.unit[Unit].t);
    }

  private:
    GuardedRamp s_, t_;
    /// `coordinate_shift_` is the shift of a coordinate without the zeros of 1/w. At shifts of up to
    /// `largest_near_shift_` the low word of a product does not count.
    int coordinate_shift_, largest_near_shift_;
    std::uint32_t width_, bias_[2];

    /// The number of the texel. It takes the high word of the product in repeat_fraction() alone. The shift
    /// would bring in no more than `up` bits of the low word, and these lie below the bias.
    SPANGLE_INLINE std::uint32_t place(std::int32_t s, std::int32_t t, const Inverse& inverse) const {
        const int up = inverse.zeros + coordinate_shift_;
        if (up > largest_near_shift_) [[unlikely]]
            return far_place(s, t, inverse.mantissa, inverse.zeros, coordinate_shift_ - 2, this->log2_width,
                             this->log2_height);
        const auto repeats = [&](std::int32_t v, int axis) {
            const std::int32_t high = numeric::mul_high_s32_u32(v, inverse.mantissa);
            return (static_cast<std::uint32_t>(high) << up) + bias_[axis];
        };
        const std::uint32_t row = repeats(t, 1) >> (32 - this->log2_height), column = repeats(s, 0);
        if constexpr (!numeric::long_products)
            return (row << this->log2_width) + (column >> (32 - this->log2_width));
        return row * width_ + numeric::mul_high_u32(column, width_);
    }
    /// The number of the texel where coordinates are many repeats, or where 1/w is small.
    [[gnu::noinline]] static std::uint32_t far_place(std::int32_t s, std::int32_t t, std::uint32_t mantissa,
                                                     int zeros, int exponent, int log2_width,
                                                     int log2_height) {
        Inverse inverse;
        inverse.mantissa = mantissa;
        inverse.zeros = zeros;
        const auto texel = [&](std::int32_t v, int log2_size) {
            return (inner::repeat_fraction(v, inverse, exponent) + nearest_bias(log2_size)) >>
                   (32 - log2_size);
        };
        return (texel(t, log2_height) << log2_width) + texel(s, log2_width);
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
