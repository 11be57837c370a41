// Lit textures of the exact tier, eight fragments at a time: what is divided is exact, and what is made of it
// is guessed in 16 bits, as far as these decide the bits that are stored. The others, one in eighty, are
// redone with one lane. Fused spans only.
#pragma once

#include "raster/span/lanes_divide.hpp"
#include "raster/span/rows.hpp"
#include "raster/span/stage_lanes.hpp"
#include "raster/span/stage_store.hpp"

namespace spangle::raster {

/// Number system of these: components and fog are Exact's.
struct ExactLanes {
    using Policy = Fixed;
    static constexpr int lanes = 8;
    using L = Lanes<8>;
    using T = L::U32;
    using Color = Rgba<T>;
    using Coord = TexCoords<std::uint32_t, 8>;
    using Fog = L::U32;
};

/// What was interpolated of fragments, side by side. Groups of eight are stored whole.
struct LitValues {
    static constexpr std::int32_t most = 96, size = most + 16; ///< what they hold between two groups
    alignas(16) std::uint32_t q[size], s[size], t[size], fog[size], color[3][size];
};

/// The planes of a row. Full: colours are projective; Gray: red stands for all three.
template <bool Full, bool Gray, bool Fog> class LitPlanes {
    using Color = PlaneLanes<std::conditional_t<Full, Fixed::Projective, Fixed::Affine>>;
    using Projective = PlaneLanes<Fixed::Projective>;
    static constexpr int unit = 0;

  public:
    SPANGLE_INLINE LitPlanes(const PlaneRow& row, std::int32_t x)
        : q_(row, x, row.q), s_(row, x, row.unit[unit].s), t_(row, x, row.unit[unit].t), fog_(fog(row, x)),
          r_(row, x, color(row, 0)), g_(other(row, x, 1)), b_(other(row, x, 2)) {}
    SPANGLE_INLINE void start(const PlaneRow& row, std::int32_t x) {
        q_.start(row, x, row.q);
        s_.start(row, x, row.unit[unit].s);
        t_.start(row, x, row.unit[unit].t);
        if constexpr (Fog)
            fog_.start(row, x, row.fog_q);
        r_.start(row, x, color(row, 0));
        if constexpr (!Gray) {
            g_.start(row, x, color(row, 1));
            b_.start(row, x, color(row, 2));
        }
    }
    SPANGLE_INLINE void step() {
        each(
            [](auto& plane, std::uint32_t*) __attribute__((always_inline)) { plane.step(); }, nullptr, 0);
    }
    SPANGLE_INLINE void store(LitValues& to, std::int32_t i) {
        each(
            [](auto& plane, std::uint32_t* at) __attribute__((always_inline)) { plane.store(at); }, &to, i);
    }
    /// Fragments behind the last one are anything.
    SPANGLE_INLINE void pad(LitValues& to, std::int32_t i) {
        each(
            [](auto&, std::uint32_t* at) __attribute__((always_inline)) { __builtin_memset(at, 0, 32); }, &to,
            i);
    }

  private:
    SPANGLE_INLINE static const auto& color(const PlaneRow& row, int i) {
        if constexpr (Full)
            return row.color_q[i];
        else
            return row.color_value[i];
    }
    SPANGLE_INLINE static auto other(const PlaneRow& row, std::int32_t x, int i) {
        if constexpr (Gray)
            return StageBase{};
        else
            return Color(row, x, color(row, i));
    }
    SPANGLE_INLINE static auto fog(const PlaneRow& row, std::int32_t x) {
        if constexpr (Fog)
            return Projective(row, x, row.fog_q);
        else
            return StageBase{};
    }
    /// Each plane and its place.
    template <class F> SPANGLE_INLINE void each(F f, LitValues* to, std::int32_t i) {
        const auto at = [&](std::uint32_t(LitValues::*of)[LitValues::size]) {
            return to == nullptr ? nullptr : (to->*of) + i;
        };
        f(q_, at(&LitValues::q));
        f(s_, at(&LitValues::s));
        f(t_, at(&LitValues::t));
        if constexpr (Fog)
            f(fog_, at(&LitValues::fog));
        const auto colors = [&](int of) { return to == nullptr ? nullptr : to->color[of] + i; };
        f(r_, colors(0));
        if constexpr (!Gray) {
            f(g_, colors(1));
            f(b_, colors(2));
        }
    }

    Projective q_, s_, t_;
    [[no_unique_address]] std::conditional_t<Fog, Projective, StageBase> fog_;
    Color r_;
    [[no_unique_address]] std::conditional_t<Gray, StageBase, Color> g_, b_;
};

/// What is guessed of a component, and by how much that may be wrong.
///
/// In 256ths of 255ths: the colour, rounded to these, is off by 1/2; a factor F of 16 bits stands for (F + e)
/// / 2^16, 0 <= e <= 1, and products are rounded down, so the modulated colour is up to 1/2 less than the
/// guess and up to 5/2 more. Fog adds two products, again with factors whose sum is one less than 2^16: up to
/// 3 more. What the exact tier rounds away is less than 2^-10. 1/2 is added to round to 255ths.
template <bool Fog> struct LitGuess { static constexpr std::uint32_t under = 1, over = Fog ? 5 : 2; };

/// MODULATE, fog and truncation of what a packet holds.
template <class T, bool Full, bool Gray, bool HasFog> class LitFragments : public TexelLanes<T> {
  public:
    using N = ExactLanes;
    using L = N::L;
    static constexpr int unit = 0, usual_fog = 6;

    SPANGLE_INLINE explicit LitFragments(const PlaneRow& row)
        : TexelLanes<T>(row, 0), exponent_(row.unit[unit].exponent),
          fog_color_(row.state->fragment.fog_color) {
        for (int i = 0; i < 3; ++i)
            fog_[i] = L::splat((fog_color_[i] + (1u << 11)) >> 12);
    }
    /// There are lanes for fragments of the primitive with so many leading zeros of 1/w: bits of texels, and
    /// of NEAREST's bias, are those of high halves of products.
    SPANGLE_INLINE static bool takes(const Span<Fixed>& s, int zeros) {
        const int down = 30 - zeros - s.unit[unit].exponent, w = s.state->log2_width[unit],
                  h = s.state->log2_height[unit];
        return down - (w > h ? w : h) >= nearest_bias_bits && down <= 31;
    }
    /// The colours of fragments [0, count). One thing of all, then the next: chains of operations are long,
    /// and those of many fragments go on at a time.
    SPANGLE_INLINE void finish(const LitValues& v, std::int32_t count, int zeros) {
        const std::int32_t n = (count + 7) / 8;
        for (std::int32_t i = 0; i < n; ++i)
            mantissa_[i] = InverseLanes(load(v.q, i), zeros).mantissa;
        const int down = 30 - zeros - exponent_;
        const int w = this->log2_width, h = this->log2_height;
        for (std::int32_t i = 0; i < n; ++i)
            texels_[i] = this->words_of((texel(load(v.t, i), mantissa_[i], down - h, h) << w) |
                                        texel(load(v.s, i), mantissa_[i], down - w, w));
        for (std::int32_t i = 0; i < n; ++i)
            color(v, i, zeros);
    }
    SPANGLE_INLINE L::U16 words(std::int32_t first) const {
        return L::load(reinterpret_cast<const std::uint8_t*>(words_ + first));
    }

  private:
    static constexpr bool is_565 = T::texel_format == TexelFormat::rgb565;
    static constexpr int groups = LitValues::size / 8;
    using Words = std::conditional_t<is_565, L::U16, L::U32>;

    /// Fragments 0 to 3 are the even lanes, 4 to 7 the odd ones; `in_order` puts them right.
    SPANGLE_INLINE static L::U32 load(const std::uint32_t* v, std::int32_t group) {
        L::U32 r;
        __builtin_memcpy(&r.even, v + 8 * group, 16);
        __builtin_memcpy(&r.odd, v + 8 * group + 4, 16);
        return r;
    }
    SPANGLE_INLINE static L::U16 in_order(L::U16 v) {
        return __builtin_shufflevector(v, v, 0, 2, 4, 6, 1, 3, 5, 7);
    }
    /// floor(s / q + bias) in texels: a product less its low half, whose bits the bias has none of (takes).
    SPANGLE_INLINE static L::U32 texel(const L::U32& v, const L::U32& mantissa, int shift, int log2_size) {
        const L::U32 unsigned_high = detail::mul_high(v, mantissa),
                     position = unsigned_high - detail::where_negative(v, mantissa);
        return ((position + L::splat32(1u << (shift - nearest_bias_bits))) >> shift) &
               ((1u << log2_size) - 1);
    }
    /// detail::projective_color or Exact::from_affine, of which what is below 2^15 is 0.
    SPANGLE_INLINE static N::T component(const L::U32& v, const L::U32& q, const L::U32& mantissa,
                                         int zeros) {
        if constexpr (Full) {
            const N::T most = q - (q >> 8) - L::splat32(1);
            return detail::mul_high(detail::clamped(v, most) << (zeros - 1), mantissa) >> 1;
        } else {
            const auto one = [](L::Words w) {
                const auto some = std::bit_cast<L::Words>(w >> 15 != 0);
                return ((w - (1u << 15)) >> (24 - color_fraction_bits)) & some;
            };
            return detail::clamped({one(v.even), one(v.odd)}, L::splat32(color_one));
        }
    }
    SPANGLE_INLINE void color(const LitValues& v, std::int32_t i, int zeros) {
        const L::U32 q = load(v.q, i), mantissa = mantissa_[i];
        const auto channel = [&](int c) { return component(load(v.color[c], i), q, mantissa, zeros); };
        const L::U16 r = rounded(channel(0)), g = Gray ? r : rounded(channel(1)),
                     b = Gray ? r : rounded(channel(2));
        L::U16 fog{};
        if constexpr (HasFog) // FogCoordDivided
            fog = L::clamped_24_to_16(
                detail::mul_high(detail::clamped(load(v.fog, i), q >> (usual_fog - 1)) << zeros, mantissa));
        const Words texels = texels_[i];
        const auto factors = [&] {
            if constexpr (is_565)
                return Rgba<L::U16>{
                    factor5(texels >> 11), factor6((texels >> 5) & 63), factor5(texels & 31), {}};
            else
                return Rgba<L::U16>{factor8(L::byte(texels, 0)),
                                    factor8(L::byte(texels, 1)),
                                    factor8(L::byte(texels, 2)),
                                    {}};
        }();
        Guess guess;
        const L::U16 word = (guess.bits(lit(r, factors.r, fog, 0), 0xF800) & 0xF800) |
                            ((guess.bits(lit(g, factors.g, fog, 1), 0xFC00) >> 5) & 0x07E0) |
                            (guess.bits(lit(b, factors.b, fog, 2), 0xF800) >> 11);
        L::store(reinterpret_cast<std::uint8_t*>(words_ + 8 * i), in_order(word));
        const L::Mask open = ~L::equal(guess.open, L::splat(0));
        if (L::any(open)) [[unlikely]]
            redo(v, i, open, zeros);
    }
    /// Top bits of components, and whether an error could change any.
    struct Guess {
        L::U16 open{};
        SPANGLE_INLINE L::U16 bits(L::U16 v, std::uint32_t mask) {
            constexpr std::uint32_t half = 128, from = half - LitGuess<HasFog>::under,
                                    range = LitGuess<HasFog>::under + LitGuess<HasFog>::over;
            const L::U16 least = v + L::splat(from);
            open |= ((least + L::splat(range)) ^ least) & L::splat(mask);
            return least;
        }
    };
    SPANGLE_INLINE static L::U16 rounded(const N::T& c) {
        return L::low_half((c + L::splat32(1u << 11)) >> 12);
    }
    /// k / 31, k / 63 and k / 255 (LitGuess).
    SPANGLE_INLINE static L::U16 factor5(L::U16 k) { return k * 2114 + (k >> 4); }
    SPANGLE_INLINE static L::U16 factor6(L::U16 k) { return k * 1040 + (k >> 2); }
    SPANGLE_INLINE static L::U16 factor8(L::U16 k) { return k * 257; }
    SPANGLE_INLINE L::U16 lit(L::U16 c, L::U16 factor, L::U16 fog, int i) const {
        const L::U16 v = L::mul_high(c, factor);
        return HasFog ? L::mul_high(fog_[i], ~fog) + L::mul_high(v, fog) : v;
    }
    /// What the chain does.
    [[gnu::noinline]] void redo(const LitValues& v, std::int32_t group, L::Mask open, int zeros) {
        for (int lane = 0; lane < 8; ++lane) {
            if (!L::lane(open, lane))
                continue;
            const std::int32_t i = 8 * group + 4 * (lane & 1) + (lane >> 1);
            Inverse inverse;
            inverse.q = v.q[i];
            inverse.zeros = zeros;
            std::uint32_t texel;
            lane_of(mantissa_[group], lane, inverse.mantissa);
            lane_of(texels_[group], lane, texel);
            const auto component = [&](int c) {
                const std::uint32_t at = v.color[Gray ? 0 : c][i];
                if constexpr (Full)
                    return detail::projective_color(static_cast<std::int32_t>(at), inverse);
                else
                    return Exact::from_affine(at);
            };
            Exact::Color c = {component(0), component(1), component(2), color_one};
            apply_env<Exact>(TexEnv::modulate, BaseFormat::rgb, c,
                             TexelColors<Exact, is_565, false>::unpack(texel), Exact::Color{});
            if constexpr (HasFog) {
                const Exact::T f = Exact::clamped_fraction(
                    detail::projective_fog(static_cast<std::int32_t>(v.fog[i]), usual_fog, inverse));
                c = {Exact::mix(fog_color_[0], c.r, f), Exact::mix(fog_color_[1], c.g, f),
                     Exact::mix(fog_color_[2], c.b, f), c.a};
            }
            words_[i] = static_cast<std::uint16_t>(truncated565<Exact>(c));
        }
    }

    int exponent_;
    const std::uint32_t* fog_color_;
    L::U16 fog_[3];
    L::U32 mantissa_[groups];
    Words texels_[groups];
    alignas(16) std::uint16_t words_[LitValues::size + 8];
};

} // namespace spangle::raster
