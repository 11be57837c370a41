// The primary colour of a fragment, and the colour sum (GL 1.3, 3.9).
#pragma once

#include "raster/ops/guarded_row.hpp"
#include "raster/ops/stage.hpp"
#include "raster/span/draw_state.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// A colour that is affine in the window (or constant). Alpha: some stage reads alpha.
template <class N, bool Alpha> struct Gouraud : StageBase {
    static constexpr unsigned out = field_color;
    Ramp<typename N::L> r, g, b;
    [[no_unique_address]] std::conditional_t<Alpha, Ramp<typename N::L>, StageBase> a;

    template <class S>
    SPANGLE_INLINE Gouraud(const S& s, std::int32_t x)
        : r(s, x, s.color_value[0]), g(s, x, s.color_value[1]), b(s, x, s.color_value[2]), a(alpha(s, x)) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.color.r = N::from_affine(r.at);
        p.color.g = N::from_affine(g.at);
        p.color.b = N::from_affine(b.at);
        if constexpr (Alpha)
            p.color.a = N::from_affine(a.at);
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
    template <class S> SPANGLE_INLINE void start(const S& s, std::int32_t x) {
        r.start(s, x, s.color_value[0]);
        g.start(s, x, s.color_value[1]);
        b.start(s, x, s.color_value[2]);
        if constexpr (Alpha)
            a.start(s, x, s.color_value[3]);
    }

  private:
    template <class S> SPANGLE_INLINE static auto alpha(const S& s, std::int32_t x) {
        if constexpr (Alpha)
            return Ramp<typename N::L>(s, x, s.color_value[3]);
        else
            return StageBase{};
    }
};

/// A colour whose red, green and blue are one plane and whose alpha is 1, as white light makes it.
template <class N> struct GouraudGray : StageBase {
    static constexpr unsigned out = field_color;
    Ramp<typename N::L> v;
    template <class S> SPANGLE_INLINE GouraudGray(const S& s, std::int32_t x) : v(s, x, s.color_value[0]) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        const typename N::T c = N::from_affine(v.at);
        p.color = {c, c, c, N::from_units(color_one)};
        return true;
    }
    SPANGLE_INLINE void step() { v.step(); }
    template <class S> SPANGLE_INLINE void start(const S& s, std::int32_t x) {
        v.start(s, x, s.color_value[0]);
    }
};

/// Takes the place of a primary colour that no later stage needs, because a texture replaces it.
template <class N> struct White : StageBase {
    static constexpr unsigned out = field_color;
    static constexpr bool anywhere = true;
    template <class S> SPANGLE_INLINE White(const S&, std::int32_t) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        const typename N::T one = N::from_units(color_one);
        p.color = {one, one, one, one};
        return true;
    }
};

/// An affine colour of which only the top bits are stored, as R5 G6 B5.
template <int Count> struct Gouraud<Raw565<Count>, false> : StageBase {
    static constexpr unsigned out = field_color;
    using N = Raw565<Count>;
    Ramp<typename N::L> r, g, b;

    template <class S>
    SPANGLE_INLINE Gouraud(const S& s, std::int32_t x)
        : r(s, x, s.color_value[0]), g(s, x, s.color_value[1]), b(s, x, s.color_value[2]) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.color = N::from_affine(r.at, g.at, b.at);
        return true;
    }
    SPANGLE_INLINE void step() {
        r.step_aside();
        g.step_aside();
        b.step_aside();
    }
    SPANGLE_INLINE void next_row() {
        r.next_row();
        g.next_row();
        b.next_row();
    }
    template <class S> SPANGLE_INLINE void start(const S& s, std::int32_t x) {
        r.start(s, x, s.color_value[0]);
        g.start(s, x, s.color_value[1]);
        b.start(s, x, s.color_value[2]);
    }
};

namespace inner {

/// A colour in colour units from colour * q and 1/q. A negative colour becomes 0. A colour that rounding has
/// made more than 1 becomes the largest number below 1.
SPANGLE_INLINE std::uint32_t projective_color(std::int32_t over_w, const Inverse& inverse) {
    // The quotient has 28 fraction bits. A colour of 1 is 255/256 of 2^28, so 255/256 of q stand for it.
    const auto most = static_cast<std::int32_t>(inverse.q - (inverse.q >> 8) - 1);
    const std::int32_t least = over_w < 0 ? 0 : over_w, v = least < most ? least : most;
    // The result is v / q 2^28 = v mantissa 2^(zeros - 34). The shifted v fits 32 bits, because v < 2^(32 -
    // zeros).
    return numeric::mul_high_u32(static_cast<std::uint32_t>(v) << inverse.zeros, inverse.mantissa) >> 2;
}

} // namespace inner

/// Perspective-correct colour, divided at every fragment (GL 1.3, equation 3.6).
template <class N, bool Alpha> struct GouraudQ : StageBase {
    static constexpr unsigned out = field_color;
    static constexpr int channels = Alpha ? 4 : 3;
    GuardedRow q, c[channels];
    std::int32_t x;

    SPANGLE_INLINE GouraudQ(const Span<Fixed>& s, std::int32_t first) : q(s, s.q), x(first) {
        for (int i = 0; i < channels; ++i)
            c[i] = {s, s.color_q[i]};
    }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        const Inverse inverse(q.value(x));
        p.color.r = N::from_units(inner::projective_color(c[0].value(x), inverse));
        p.color.g = N::from_units(inner::projective_color(c[1].value(x), inverse));
        p.color.b = N::from_units(inner::projective_color(c[2].value(x), inverse));
        if constexpr (Alpha)
            p.color.a = N::from_units(inner::projective_color(c[3].value(x), inverse));
        else
            p.color.a = N::from_units(color_one);
        return true;
    }
    SPANGLE_INLINE void step() { ++x; }
};

/// Adds the secondary colour to the primary colour; each sum is clamped to 1.
template <class N, bool Projective> struct ColorSum : StageBase {
    static constexpr unsigned in = field_color, out = field_color;
    using Word = std::conditional_t<Projective, std::uint64_t, std::uint32_t>;
    Word q{}, dq{}, c[3], dc[3];

    SPANGLE_INLINE ColorSum(const Span<Fixed>& s, std::int32_t x) {
        for (int i = 0; i < 3; ++i) {
            if constexpr (Projective)
                c[i] = s.at(x, s.secondary_q[i]), dc[i] = s.secondary_q[i].dx;
            else
                c[i] = s.at(x, s.secondary[i]), dc[i] = s.secondary[i].dx;
        }
        if constexpr (Projective)
            q = s.at(x, s.q), dq = s.q.dx;
    }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        if constexpr (Projective) {
            const Inverse inverse(unguarded(q));
            sum(p, N::from_units(inner::projective_color(unguarded(c[0]), inverse)),
                N::from_units(inner::projective_color(unguarded(c[1]), inverse)),
                N::from_units(inner::projective_color(unguarded(c[2]), inverse)));
        } else {
            sum(p, N::from_affine(c[0]), N::from_affine(c[1]), N::from_affine(c[2]));
        }
        return true;
    }
    SPANGLE_INLINE void step() {
        if constexpr (Projective)
            q += dq;
        for (int i = 0; i < 3; ++i)
            c[i] += dc[i];
    }

  private:
    SPANGLE_INLINE static void sum(Px<N>& p, typename N::T r, typename N::T g, typename N::T b) {
        p.color.r = N::add(p.color.r, r);
        p.color.g = N::add(p.color.g, g);
        p.color.b = N::add(p.color.b, b);
    }
};

namespace inner {

/// The fog coordinate (s7.24) from coordinate * q and 1/q. The scale is 2^exponent.
inline std::uint32_t projective_fog(std::int32_t over_w, int exponent, const Inverse& inverse) {
    const std::int64_t product = numeric::mul_s32_u32(over_w, inverse.mantissa); // f/q 2^(62 - zeros)
    const int down = 38 - inverse.zeros - exponent;
    return static_cast<std::uint32_t>(down >= 0 ? numeric::saturate_i32(numeric::times_two_to(product, -down))
                                                : numeric::scale_saturate(product, -down));
}

} // namespace inner

/// Finds the fog coordinate c (FogConstants) of each fragment, s7.24.
template <class N, bool Projective> struct FogCoord;

template <class N> struct FogCoord<N, false> : StageBase {
    static constexpr unsigned out = field_fog;
    Ramp<typename N::L> v;
    template <class S> SPANGLE_INLINE FogCoord(const S& s, std::int32_t x) : v(s, x, s.fog) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.fog = v.at;
        return true;
    }
    SPANGLE_INLINE void step() { v.step(); }
    template <class S> SPANGLE_INLINE void start(const S& s, std::int32_t x) { v.start(s, x, s.fog); }
};

template <class N> struct FogCoord<N, true> : StageBase {
    static_assert(N::lanes == 1);
    static constexpr unsigned out = field_fog;
    GuardedRow q, f;
    int exponent;
    std::int32_t x;
    SPANGLE_INLINE FogCoord(const Span<Fixed>& s, std::int32_t first)
        : q(s, s.q), f(s, s.fog_q), exponent(s.fog_exponent), x(first) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.fog = inner::projective_fog(f.value(x), exponent, Inverse(q.value(x)));
        return true;
    }
    SPANGLE_INLINE void step() { ++x; }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
