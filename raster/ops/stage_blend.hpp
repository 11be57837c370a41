// Blends with the stored colour (GL 1.3, 4.1.7): C = Cs S + Cd D, clamped. Destination alpha is 1 in formats
// without alpha.
#pragma once

#include "raster/ops/component.hpp"
#include "raster/ops/number_packed.hpp"
#include "raster/ops/stage_store.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// The colour that is stored under a group of fragments. Its components are exactly k/31, k/63 or k/255.
template <class N, PixelFormat Format>
SPANGLE_INLINE typename N::Color load_color(const std::uint8_t* plane, std::int32_t i) {
    using L = typename N::L;
    if constexpr (is_565(Format)) {
        const typename L::U16 word = Words565<L, Format>::load(plane + 2 * i);
        return {N::from5(word >> 11), N::from6((word >> 5) & 63), N::from5(word & 31),
                N::from_units(color_one)};
    } else {
        constexpr int bytes = format_info(Format).bytes_per_pixel;
        const Components888<L, bytes> stored(plane + bytes * i);
        return {N::from8(stored.of(0)), N::from8(stored.of(1)), N::from8(stored.of(2)),
                bytes == 4 ? N::from8(stored.of(3)) : N::from_units(color_one)};
    }
}

/// Loads the colour with which a fragment blends, in a format that is known to the compiler.
template <class N, PixelFormat Format> struct Stored {
    static constexpr bool anywhere = true;
    SPANGLE_INLINE Stored(const Span<typename N::Policy>&, std::int32_t) {}
    SPANGLE_INLINE typename N::Color load(const Px<N>& p) const {
        return load_color<N, Format>(p.color_plane, p.i);
    }
    SPANGLE_INLINE void step() {}
};

/// Blends by SRC_ALPHA, ONE_MINUS_SRC_ALPHA.
template <class N, PixelFormat Format> struct BlendAlpha : StageBase {
    static constexpr unsigned in = field_color, out = field_color;
    static constexpr bool kill = true, anywhere = true;
    using L = typename N::L;
    template <class S> SPANGLE_INLINE BlendAlpha(const S&, std::int32_t) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        typename N::Color& s = p.color;
        const typename N::T a = s.a;
        // With alpha 0 the stored bits would be stored again: k/31, k/63 and k/255 come back as k, dithered
        // or not. The stage drops these fragments instead.
        if constexpr (N::lanes == 1) {
            if (a == 0)
                return false;
        } else if (!L::any_bits(a)) {
            return false;
        }
        if constexpr (is_565(Format)) {
            const typename L::U16 word = Words565<L, Format>::load(p.color_plane + p.bytes());
            s.r = N::template over<5>(s.r, a, word >> 11);
            s.g = N::template over<6>(s.g, a, (word >> 5) & 63);
            s.b = N::template over<5>(s.b, a, word & 31);
        } else {
            constexpr int bytes = format_info(Format).bytes_per_pixel;
            const Components888<L, bytes> stored(p.color_plane + bytes * p.i);
            s.r = N::template over<8>(s.r, a, stored.of(0));
            s.g = N::template over<8>(s.g, a, stored.of(1));
            s.b = N::template over<8>(s.b, a, stored.of(2));
            if constexpr (format_info(Format).alpha_bits != 0)
                s.a = N::template over<8>(a, a, stored.of(3));
        }
        return true;
    }
};

/// Blends by SRC_ALPHA, ONE_MINUS_SRC_ALPHA in the fast tier, into R5 G6 B5. The result is a whole number of
/// steps. Where dithering is on, the source colour is dithered.
template <class N, PixelFormat Format, bool Dither> struct BlendCoarse : StageBase {
    static_assert(is_balanced<N> && is_565(Format));
    static constexpr unsigned in = field_color, out = field_color;
    using L = typename N::L;
    using T = typename N::T;
    using Row = std::conditional_t<Dither, inner::DitherRow<L>, inner::NoThreshold>;
    [[no_unique_address]] Row dither;
    template <class S> SPANGLE_INLINE BlendCoarse(const S& s, std::int32_t x) : dither(s.x + x, s.y) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        typename N::Color& s = p.color;
        const T a = Coarse::alpha<T>(N::to8(s.a)),
                word = Words565<L, Format>::load(p.color_plane + p.bytes());
        s.r = N::from5(Coarse::over<T>(steps<5>(s.r), a, word >> 11));
        s.g = N::from6(Coarse::over<T>(steps<6>(s.g), a, (word >> 5) & 63));
        s.b = N::from5(Coarse::over<T>(steps<5>(s.b), a, word & 31));
        return true;
    }
    SPANGLE_INLINE void step() { dither.step(); }
    template <class S> SPANGLE_INLINE void start(const S& s, std::int32_t x) { dither = Row(s.x + x, s.y); }

  private:
    template <unsigned Bits> SPANGLE_INLINE T steps(T c) const {
        if constexpr (Dither)
            return Coarse::dithered<Bits, T>(N::to8(c), dither.threshold());
        else
            return N::to8(c) >> (8 - Bits);
    }
};

namespace inner {

/// Tables of N::Threshold, by y & 3 and by x, from each of the four columns of a period on.
template <class N> struct Thresholds {
    typename N::Threshold at[4][7];
    constexpr Thresholds() : at{} {
        for (std::int32_t y = 0; y < 4; ++y)
            for (std::int32_t x = 0; x < 7; ++x)
                at[y][x] = dither_threshold(dither_row(y), x);
    }
};
template <class N> inline constexpr Thresholds<N> thresholds_of;

/// The thresholds of a row, looked up by the index of a fragment. No step is needed.
template <class N> class ThresholdRow {
  public:
    SPANGLE_INLINE explicit ThresholdRow(const Span<Fixed>& s)
        : row_(numeric::factor32(thresholds_of<N>.at[s.y & 3] + s.dither_column)) {}
    SPANGLE_INLINE const typename N::Threshold& at(std::int32_t i) const { return row_[i & 3]; }

  private:
    const typename N::Threshold* row_;
};
struct NoThresholds {
    SPANGLE_INLINE explicit NoThresholds(const Span<Fixed>&) {}
};

} // namespace inner

/// Does what BlendAlpha followed by Store or StoreDithered does, for the packed number systems.
template <class N, PixelFormat Format, bool Dither> struct BlendPacked : StageBase {
    static_assert(is_packed<N>);
    static constexpr unsigned in = field_color;
    static constexpr bool kill = true, effect = true;
    using Words = Words565<Lanes<1>, Format>;
    using Row = std::conditional_t<Dither, inner::ThresholdRow<N>, inner::NoThresholds>;
    [[no_unique_address]] Row dither;
    SPANGLE_INLINE BlendPacked(const Span<Fixed>& s, std::int32_t) : dither(s) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        if constexpr (std::is_same_v<N, PackedCoarse>)
            return blend_coarse(p);
        else
            return blend(p);
    }
    SPANGLE_INLINE void start(const Span<Fixed>& s, std::int32_t) { dither = Row(s); }

  private:
    SPANGLE_INLINE bool blend(const Px<N>& p) const {
        if (N::clear(p.color))
            return false;
        std::uint8_t* const at = p.color_plane + p.bytes();
        // The asm statements keep compilers from moving the code after a branch before the branch.
        auto s = p.color;
        asm("" : "+r"(s.word));
        if constexpr (Dither) {
            Words::store(at, N::over(s, Words::load(at), dither.at(p.i)));
        } else if (N::is_opaque(s)) {
            auto copy = s;
            asm("" : "+r"(copy.word));
            Words::store(at, N::opaque(copy));
        } else {
            Words::store(at, N::over(s, Words::load(at)));
        }
        return true;
    }
    /// The source colour, dithered where dithering is on.
    SPANGLE_INLINE typename N::Color source(const Px<N>& p) const {
        if constexpr (Dither)
            return N::dithered(p.color, dither.at(p.i));
        else
            return p.color;
    }
    /// One test finds texels that are clear or solid. All other texels are last in the loop, which is the
    /// faster place.
    SPANGLE_INLINE bool blend_coarse(const Px<N>& p) const {
        const typename N::Color s = p.color;
        if (N::whole(s)) [[unlikely]] {
            if (N::clear(s))
                return false;
            numeric::begin_here();
            Words::store(p.color_plane + p.bytes(), N::opaque(source(p)));
        } else {
            numeric::begin_here();
            std::uint8_t* const at = p.color_plane + p.bytes();
            Words::store(at, N::over_both(source(p), N::weight(s), Words::load_both(at)));
        }
        return true;
    }
};

/// Does what BlendAlpha followed by StoreDithered does, for the number systems of Bytes.
template <class N, PixelFormat Format> struct BlendBytesDithered : StageBase {
    static constexpr unsigned in = field_color;
    static constexpr bool kill = true, effect = true;
    using L = typename N::L;
    using Words = Words565<L, Format>;
    inner::KeptThresholds<N> dither;
    SPANGLE_INLINE BlendBytesDithered(const Span<Fixed>& s, std::int32_t x) : dither(s.x + x, s.y) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        const typename N::Color& s = p.color;
        if (!L::any(L::negate(L::equal(s.a, L::splat(0)))))
            return false;
        std::uint8_t* const at = p.color_plane + p.bytes();
        const typename L::U16 under = Words::load(at);
        const typename L::U16 word = pack565<N>(N::template dithered<5>(s.r, s.a, under >> 11, dither),
                                                N::template dithered<6>(s.g, s.a, (under >> 5) & 63, dither),
                                                N::template dithered<5>(s.b, s.a, under & 31, dither));
        Words::store(at, L::select(p.live, word, under));
        return true;
    }
    SPANGLE_INLINE void start(const Span<Fixed>& s, std::int32_t x) {
        dither = inner::KeptThresholds<N>(s.x + x, s.y);
    }
};

/// The blending of alpha. The factor SRC_ALPHA_SATURATE is 1 for alpha (GL 1.3, table 4.1).
inline Blending blending_of_alpha(const FragmentState& state) {
    Blending b = state.blend_alpha;
    if (b.src == BlendFactor::src_alpha_saturate)
        b.src = BlendFactor::one;
    return b;
}

/// The equations of blending for one fragment, in any format. PacketBlend has these equations for packets in
/// lanes.
template <class N> struct BlendEquations {
    static_assert(N::lanes == 1);
    using T = typename N::T;
    using Color = typename N::Color;
    const FragmentState& state;
    SPANGLE_INLINE explicit BlendEquations(const FragmentState& of) : state(of) {}

    /// The colour that results from the source colour s and the stored colour d.
    SPANGLE_INLINE Color blend(const Color& s, const Color& d) const {
        const std::uint32_t* const constant = state.blend_color;
        const auto rgb = [&](T cs, T cd, int i) {
            return combine(state.blend_rgb, s, d, cs, cd, N::from_units(constant[i]));
        };
        return {rgb(s.r, d.r, 0), rgb(s.g, d.g, 1), rgb(s.b, d.b, 2),
                combine(blending_of_alpha(state), s, d, s.a, d.a, N::from_units(constant[3]))};
    }

  private:
    /// One component of the result. MIN and MAX use no factors (GL 1.4, 4.1.7).
    [[gnu::noinline]] T combine(const Blending& by, const Color& s, const Color& d, T cs, T cd, T cc) const {
        if (by.equation == BlendEquation::min)
            return component::smaller<N>(cs, cd);
        if (by.equation == BlendEquation::max)
            return component::larger<N>(cs, cd);
        const T source = times(cs, by.src, s, d, cs, cd, cc), stored = times(cd, by.dst, s, d, cs, cd, cc);
        switch (by.equation) {
        case BlendEquation::add:
            return N::add(source, stored);
        case BlendEquation::subtract:
            return N::subtract(source, stored);
        case BlendEquation::reverse_subtract:
            return N::subtract(stored, source);
        case BlendEquation::min:
        case BlendEquation::max:
            break; // the function has returned above
        }
        return source;
    }
    /// The product value * factor; the factors 0 and 1 are exact (GL 1.3, 4.1.7).
    [[gnu::noinline]] T times(T value, BlendFactor factor, const Color& s, const Color& d, T cs, T cd,
                              T cc) const {
        const T one = N::from_units(color_one);
        switch (factor) {
        case BlendFactor::zero:
            return T{};
        case BlendFactor::one:
            return value;
        case BlendFactor::src_color:
            return N::mul(value, cs);
        case BlendFactor::one_minus_src_color:
            return N::mul(value, one - cs);
        case BlendFactor::src_alpha:
            return N::mul(value, s.a);
        case BlendFactor::one_minus_src_alpha:
            return N::mul(value, one - s.a);
        case BlendFactor::dst_alpha:
            return N::mul(value, d.a);
        case BlendFactor::one_minus_dst_alpha:
            return N::mul(value, one - d.a);
        case BlendFactor::dst_color:
            return N::mul(value, cd);
        case BlendFactor::one_minus_dst_color:
            return N::mul(value, one - cd);
        case BlendFactor::src_alpha_saturate:
            return N::mul(value, component::smaller<N>(s.a, one - d.a));
        case BlendFactor::constant_color:
            return N::mul(value, cc);
        case BlendFactor::one_minus_constant_color:
            return N::mul(value, one - cc);
        case BlendFactor::constant_alpha:
            return N::mul(value, N::from_units(state.blend_color[3]));
        case BlendFactor::one_minus_constant_alpha:
            return N::mul(value, one - N::from_units(state.blend_color[3]));
        }
        return value;
    }
};

/// Blending whose equations and factors are known only at run time. `From` loads the stored colour.
template <class N, class From> struct Blend : StageBase, BlendEquations<N> {
    static constexpr unsigned in = field_color, out = field_color;
    static constexpr bool anywhere = From::anywhere;
    using T = typename N::T;
    using Color = typename N::Color;
    From from;
    template <class S>
    SPANGLE_INLINE Blend(const S& s, std::int32_t x) : BlendEquations<N>(s.state->fragment), from(s, x) {}

    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.color = this->blend(p.color, from.load(p));
        return true;
    }
    SPANGLE_INLINE void step() { from.step(); }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
